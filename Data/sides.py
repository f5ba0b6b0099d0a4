# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""A periodic cell beside its copy, cracks, a fine mesh in a coarse one, houses:

pvpython sides.py BitingMesh.so OUTPUT_FOLDER

Prints the numbers of vertices; draws the meshes. The picture of this folder has 32 colours:
convert sides.png -dither None -colors 32 PNG8:sides.png
"""

import math
import os
import sys

from paraview import servermanager
from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import examples
import views

SIZE = [400, 400]
GAP = 0.4  # how far the sides of a crack are drawn apart, in sizes of triangles


def main(plugin, folder):
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
    examples.BitingMesher = BitingMesher
    layout = CreateLayout('Sides')
    layout.SplitHorizontal(0, 1 / 3)
    layout.SplitHorizontal(2, 0.5)
    for draw, cell in zip((draw_cell, draw_cracks, draw_fine_mesh), (1, 5, 6)):
        AssignViewToLayout(draw(), layout, cell)
    size = [3 * SIZE[0], SIZE[1]]
    layout.SetSize(*size)
    SaveScreenshot(os.path.join(folder, 'sides.png'), layout, ImageResolution=size)


def draw_cell():
    """A grain that crosses the sides, a hole beside one, and the cell once more at its period."""
    half = [(0.3 * math.cos(t), 0.45 + 0.3 * math.sin(t)) for t in turns(-0.5, 0.5, 16)]
    other = [(1 + 0.3 * math.cos(t), 0.45 + 0.3 * math.sin(t)) for t in turns(0.5, 1.5, 16)]
    half[0], half[-1], other[0], other[-1] = (0, 0.15), (0, 0.75), (1, 0.75), (1, 0.15)
    hole = [(0.93 + 0.03 * math.cos(t), 0.88 + 0.03 * math.sin(t)) for t in turns(0, 2, 12)]
    source = drawing([square(), half, other, hole])
    mesh = BitingMesher(Input=source, UniformSpacing=0.06, PeriodicTranslation=[1, 0, 0])
    copy = Transform(Input=mesh, Transform='Transform')
    copy.Transform.Translate = [1, 0, 0]
    view = views.plane_view([1, 0.5], 2.1, SIZE)
    for part in (mesh, copy):
        views.show_colored(part, view, ('CELLS', 'RegionId'),
            [0, 0.9, 0.95, 1, 1, 1, 0.86, 0.62, 2, 1, 0.86, 0.62], [0.5, 0.56, 0.65])
    views.show_lines(drawing([[(1, 0), (1, 1)]]), view, [0.8, 0.3, 0.1])
    return titled('Periodic sides', mesh, view)


def draw_cracks():
    """Cracks that meet, one of them up to the side, opened by moving points towards their triangles."""
    source = drawing([square(), [(0, 0.4), (0.35, 0.5), (0.8, 0.45)], [(0.35, 0.5), (0.6, 0.8)]],
        [0, 1, 1])
    mesh = BitingMesher(Input=source, UniformSpacing=0.07, SplitInterfaces='Crack')
    mesh.UpdatePipeline()
    data = vtkPolyData()
    data.DeepCopy(servermanager.Fetch(mesh, idx=0))
    open_cracks(data)
    view = views.plane_view([0.5, 0.5], 1.2, SIZE)
    views.show_mesh(producer(data), view)
    return titled('Cracks, drawn open', mesh, view)


def open_cracks(data):
    """Moves points that are there several times towards the middle of their triangles."""
    places = {}
    for point in range(data.GetNumberOfPoints()):
        places.setdefault(data.GetPoint(point), []).append(point)
    moved = {point for points in places.values() for point in points if len(points) > 1}
    ways = {point: [] for point in moved}
    for cell in range(data.GetNumberOfCells()):
        ids = [data.GetCell(cell).GetPointId(k) for k in range(3)]
        middle = [sum(data.GetPoint(point)[k] for point in ids) / 3 for k in range(2)]
        for point in moved.intersection(ids):
            ways[point].append([middle[k] - data.GetPoint(point)[k] for k in range(2)])
    for point in moved:
        way = [GAP * sum(step[k] for step in ways[point]) / len(ways[point]) for k in range(2)]
        x, y, z = data.GetPoint(point)
        data.GetPoints().SetPoint(point, x + way[0], y + way[1], z)


def draw_fine_mesh():
    mesh = examples.fine_mesh_in_a_coarse_one('')
    view = views.plane_view([0, 0], 3.2, SIZE)
    views.show_colored(mesh, view, ('CELLS', 'RegionId'),
        [0, 0.9, 0.95, 1, 1, 1, 0.86, 0.62], [0.5, 0.56, 0.65])
    return titled('Triangles that stay', mesh, view)


def titled(title, mesh, view):
    mesh.UpdatePipeline()
    count = mesh.GetDataInformation().GetNumberOfPoints()
    print(f'{title}: {count} vertices')
    Show(Text(Text=title), view, Color=[0, 0, 0], FontSize=14, WindowLocation='Upper Center')
    return view


def turns(start, end, parts):
    return [math.pi * (start + (end - start) * k / parts) for k in range(parts + 1)]


def square():
    return [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)]


def drawing(chains, cracks=()):
    data, points, lines, crack = vtkPolyData(), vtkPoints(), vtkCellArray(), vtkIntArray()
    points.SetDataTypeToDouble()
    crack.SetName('Crack')
    for chain in chains:
        lines.InsertNextCell(len(chain))
        for x, y in chain:
            lines.InsertCellPoint(points.InsertNextPoint(x, y, 0))
    for value in cracks:
        crack.InsertNextValue(value)
    data.SetPoints(points)
    data.SetLines(lines)
    data.GetCellData().AddArray(crack)
    return producer(data)


def producer(data):
    source = TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    return source


if __name__ == '__main__':
    main(*sys.argv[1:])
