# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""The filters on pieces that lie on ranks in many ways: for TestRanksProxy.py, by mpiexec pvbatch.

Writes to the file of BITING_ANSWER, as JSON, what each filter gave: a digest of the bytes of all
outputs, and how many errors were said on the first rank.
"""

import hashlib
import json
import os
import sys

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow

# What every source begins with: rings of a drawing, and who has which of them.
PRELUDE = '''
global math, vtkCellArray, vtkDoubleArray, vtkImageData, vtkIntArray, vtkPoints, vtkPolyData
global rank, ranks, rings, Ring, Drawing, Image, Spread
import math
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
rank = controller.GetLocalProcessId() if controller else 0
ranks = controller.GetNumberOfProcesses() if controller else 1

def Ring(size, radius, x, y):
    angles = [2 * math.pi * k / size for k in range(size)]
    return [(x + radius * math.cos(a), y + radius * math.sin(a), 0.0) for a in angles]

rings = [Ring(60, 10, 0, 0), Ring(30, 3, 2, 1), Ring(25, 2, -5, 0), Ring(12, 1, 2, 1)]

def Drawing(which, form='Polylines'):
    points, lines, polygons, tags = vtkPoints(), vtkCellArray(), vtkCellArray(), vtkIntArray()
    points.SetDataTypeToDouble()
    tags.SetName('Tag')
    for ring in which:
        ids = [points.InsertNextPoint(*place) for place in rings[ring]]
        cells = [ids + ids[:1]]
        if form == 'Segments':
            cells = [[a, b] for a, b in zip(ids, ids[1:] + ids[:1])]
        elif form == 'Polygons':
            cells = [ids]
        for cell in cells:
            target = polygons if form == 'Polygons' else lines
            target.InsertNextCell(len(cell))
            for point in cell:
                target.InsertCellPoint(point)
            tags.InsertNextValue(ring)
    drawing = vtkPolyData()
    drawing.SetPoints(points)
    drawing.SetLines(lines)
    drawing.SetPolys(polygons)
    drawing.GetCellData().AddArray(tags)
    return drawing

def Spread(where):
    if where == 'First':
        return range(4) if rank == 0 else []
    if where == 'Last':
        return range(4) if rank == ranks - 1 else []
    if where == 'Everywhere':
        return range(4)
    return [ring for ring in range(4) if ring * ranks // 4 == rank]
'''


def producer(script, data_type='vtkPolyData', information=''):
    return simple.ProgrammableSource(
        OutputDataSetType=data_type, Script=PRELUDE + script,
        ScriptRequestInformation=PRELUDE + information if information else '')


def add_array(digest, array):
    if array is not None and array.GetNumberOfTuples() > 0:
        digest.update(array.GetName().encode() if array.GetName() else b'')
        digest.update(vtk_to_numpy(array).tobytes())


def add_arrays(digest, data):
    for name in sorted(data.GetArrayName(k) for k in range(data.GetNumberOfArrays())):
        add_array(digest, data.GetArray(name))


def digest_of(data):
    digest = hashlib.sha256()
    if data.GetNumberOfPoints() > 0 and hasattr(data, 'GetPoints'):
        add_array(digest, data.GetPoints().GetData())
    for cells in ('GetPolys', 'GetLines', 'GetVerts', 'GetCells'):
        if hasattr(data, cells) and data.GetNumberOfCells() > 0:
            add_array(digest, getattr(data, cells)().GetConnectivityArray())
    add_arrays(digest, data.GetPointData())
    add_arrays(digest, data.GetCellData())
    return '%d points, %d cells, %s' % (
        data.GetNumberOfPoints(), data.GetNumberOfCells(), digest.hexdigest()[:16])


def run(algorithm, ports):
    errors = []
    window = vtkOutputWindow.GetInstance()
    tag = window.AddObserver('ErrorEvent', lambda *unused: errors.append(1))
    window.SetDisplayModeToNever()
    algorithm.UpdatePipeline()
    digests = [digest_of(servermanager.Fetch(algorithm, idx=port)) for port in ports]
    window.SetDisplayModeToDefault()
    window.RemoveObserver(tag)
    return {'digests': digests, 'errors': len(errors)}


def drawings(answer):
    for form in ('Polylines', 'Segments', 'Polygons'):
        for where in ('First', 'Last', 'Everywhere', 'Divided'):
            drawing = producer(
                "self.GetOutput().ShallowCopy(Drawing(Spread('%s'), '%s'))" % (where, form))
            mesher = BitingMesher(Input=drawing, UniformSpacing=1.0)
            answer['Drawing.%s.%s' % (form, where)] = run(mesher, (0, 1, 3))


def main():
    simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())
    answer = {}
    drawings(answer)
    with open(os.environ['BITING_ANSWER'], 'w', encoding='ascii') as file:
        json.dump(answer, file)


main()
