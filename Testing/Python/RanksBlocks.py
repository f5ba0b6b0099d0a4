# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes of blocks, which are spread over ranks: for TestRanksBlocksProxy.py, as RanksScenarios.py.

What filters gave is put together from the pieces: points and cells by their global ids, each as
the rank has it that owns it.
"""

import os
import sys
import tempfile

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import RanksScenarios as scenes

BLOCKS = {'UniformSpacing': 0.3, 'VerticesPerBlock': 400}

# Of the mesh: also where another rank owns a point they are right.
COPIED = ('Spacing', 'Conformity', 'OriginalPointId', 'Depth', 'RegionId', 'MinimumAngle', 'Tag')


def order_of(data):
    """Where the tuples of the whole are, by global id; None where this is the whole already."""
    ids = data.GetArray('Global%sIds' % ('Point' if data.IsA('vtkPointData') else 'Cell'))
    if ids is None:
        return None
    ids = vtk_to_numpy(ids)
    ghosts = data.GetArray('vtkGhostType')
    own = numpy.flatnonzero(vtk_to_numpy(ghosts) == 0) if ghosts else numpy.arange(len(ids))
    order = own[numpy.argsort(ids[own], kind='stable')]
    if not numpy.array_equal(ids[order], numpy.arange(len(order))):
        raise ValueError('not each id has one owner')
    for name in COPIED:
        values = data.GetArray(name) and vtk_to_numpy(data.GetArray(name))
        if values is not None and values[order][ids].tobytes() != values.tobytes():
            raise ValueError('copies differ: ' + name)
    return order


def copy_tuples(source, order, target):
    for k in range(source.GetNumberOfArrays()):
        if source.GetArrayName(k) not in scenes.ADDED:
            array = numpy_to_vtk(vtk_to_numpy(source.GetArray(k))[order], deep=True)
            array.SetName(source.GetArrayName(k))
            target.AddArray(array)


def united(data):
    points, cells = order_of(data.GetPointData()), order_of(data.GetCellData())
    if points is None:
        return data
    ids = vtk_to_numpy(data.GetPointData().GetArray('GlobalPointIds'))
    whole, places, triangles = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetData(numpy_to_vtk(vtk_to_numpy(data.GetPoints().GetData())[points], deep=True))
    corners = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    triangles.SetData(3, numpy_to_vtkIdTypeArray(ids[corners[cells]].ravel(), deep=True))
    whole.SetPoints(places)
    whole.SetPolys(triangles)
    copy_tuples(data.GetPointData(), points, whole.GetPointData())
    copy_tuples(data.GetCellData(), cells, whole.GetCellData())
    return whole


def digest_of(algorithm):
    return scenes.digests_of(united(servermanager.Fetch(algorithm)))


def result_of(mesher, *algorithms):
    """Of the mesh, of its boundary and problems, and of filters behind it."""
    result = scenes.run(mesher, (1, 3))
    both = [digest_of(algorithm) for algorithm in (mesher,) + algorithms]
    result['digests'] += [digest for digest, unused in both]
    result['ids'] += [ids for unused, ids in both]
    return result


def mesher_of(source, **parameters):
    return scenes.BitingMesher(Input=source, **dict(BLOCKS, **parameters))


def pieces(answer):
    """How many points each rank owns, and how many triangles."""
    ranked = simple.ProgrammableFilter(
        Input=mesher_of(scenes.drawing('First')), CopyArrays=1, Script=scenes.PRELUDE + '''
for data, count in ((self.GetOutput().GetPointData(), self.GetOutput().GetNumberOfPoints()),
                    (self.GetOutput().GetCellData(), self.GetOutput().GetNumberOfCells())):
    array = vtkIntArray()
    array.SetName('Rank')
    for k in range(count):
        array.InsertNextValue(rank)
    data.AddArray(array)
''')
    data = servermanager.Fetch(ranked)
    answer['Pieces'] = [own_of(data.GetPointData()), own_of(data.GetCellData())]


def own_of(data):
    ghosts = data.GetArray('vtkGhostType')
    ranks = vtk_to_numpy(data.GetArray('Rank'))
    return numpy.bincount(ranks[vtk_to_numpy(ghosts) == 0] if ghosts else ranks).tolist()


def drawings(answer):
    for where in ('First', 'Last', 'Everywhere', 'Divided', 'Dealt', 'Around'):
        answer['Polylines.' + where] = result_of(mesher_of(scenes.drawing(where)))
    answer['Tilted.Dealt'] = result_of(
        mesher_of(scenes.drawing('Dealt', tilt=0.3), UniformSpacing=0.35))


def sources(answer):
    """A spacing source in pieces, and on one rank only."""
    last = scenes.producer('''
if rank == ranks - 1:
    self.GetOutput().ShallowCopy(Field((0, 24, 0, 24, 0, 0)))
''', 'vtkImageData', scenes.WHOLE_IMAGE)
    triangles = simple.Triangulate(Input=simple.ExtractSurface(Input=scenes.image()))
    for name, source in (('Last', last), ('Divided', scenes.image()), ('Triangles', triangles)):
        answer['Source.' + name] = result_of(mesher_of(
            scenes.drawing('Dealt'), UniformSpacing=0.0, SpacingSource=source, SpacingScale=0.4,
            SourceSpacingArray=['POINTS', 'Spacing']))


def rules(answer):
    """Polygons over each other: ranks agree on which of them a region has."""
    for where in ('First', 'Divided'):
        for rule in ('Union', 'Even-Odd'):
            answer['Rule %s.%s' % (rule, where)] = result_of(mesher_of(
                scenes.drawing(where, 'Polygons'), DomainRule=rule, RegionArray='Tag',
                BoundaryTolerance=0.5))


def filters(answer):
    """What is behind the mesh gives on ranks what it gives in one process."""
    mesher = mesher_of(scenes.drawing('First'))
    gradient = simple.Gradient(Input=mesher, ScalarArray=['POINTS', 'NearestNeighborDistance'])
    conformity = scenes.MeshConformity(Input=mesher, SpacingArray=['POINTS', 'Spacing'])
    remesher = scenes.BitingRemesher(
        Input=gradient, TaggedLines=simple.OutputPort(mesher, 1), SpacingScale=0.7)
    calculator = simple.Calculator(Input=mesher, Function='Spacing * kHat', ResultArrayName='Lift')
    warp = simple.WarpByVector(Input=calculator, Vectors=['POINTS', 'Lift'])
    answer['Behind'] = result_of(mesher, gradient, conformity, remesher, warp)
    integral = servermanager.Fetch(simple.IntegrateVariables(Input=mesher))
    answer['Area'] = integral.GetCellData().GetArray('Area').GetValue(0)
    mesher.UpdatePropertyInformation()
    answer['Summary'] = [line for line in mesher.Summary.splitlines() if 'Made in' not in line]
    connectivity = simple.Connectivity(Input=mesher)
    connectivity.UpdatePipeline()
    answer['Regions'] = list(connectivity.PointData['RegionId'].GetRange())


def files(answer):
    """Written in pieces and read again."""
    mesher = mesher_of(scenes.drawing('First'))
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, 'mesh.pvtp')
        simple.SaveData(name, proxy=mesher)
        answer['File.pvtp'] = result_of(mesher, simple.OpenDataFile(name))


def errors(answer):
    """Said once, and nothing waits for ever; after that there is a mesh again."""
    mesher = mesher_of(scenes.drawing('Divided'), MaximumNumberOfVertices=3000)
    answer['Error.TooMany'] = scenes.run(mesher, (0, 1))
    mesher.MaximumNumberOfVertices = 20000000
    answer['Polylines.AfterError'] = result_of(mesher)
    mesher = mesher_of(scenes.drawing('Divided'))
    algorithm = mesher.GetClientSideObject()

    def stop(*unused):
        if algorithm.GetProgressText() == stage:
            algorithm.SetAbortExecute(1)

    tag = algorithm.AddObserver('ProgressEvent', stop)
    for stage in ('Reading the input', 'Biting', 'Relaxing', 'Writing the mesh'):
        mesher.SpacingScale *= 1.001
        answer['Abort.' + stage] = scenes.run(mesher, (0, 1, 3))
    algorithm.RemoveObserver(tag)
    mesher.SpacingScale = 1.0
    answer['Polylines.AfterAbort'] = result_of(mesher)


def killed(unused, seconds=0.0):
    """The last rank ends while the others wait for it; the test looks at what mpiexec says."""
    source = scenes.producer('''
import os, subprocess
if rank == ranks - 1:
    subprocess.Popen(['sh', '-c', 'sleep %s; kill -9 %%d' %% os.getpid()])
self.GetOutput().ShallowCopy(Drawing(Spread('Everywhere')))
''' % seconds)
    mesher = mesher_of(source, UniformSpacing=0.02, VerticesPerBlock=20000)
    for unused in range(10):
        mesher.UpdatePipeline()
        mesher.SpacingScale *= 1.01


def killed_at_work(answer):
    killed(answer, 0.5)


if __name__ == '__main__':
    scenes.answer_with(globals())
