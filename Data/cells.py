# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""What two-dimensional cells and lines beside them mean: pvpython cells.py BitingMesh.so OUTPUT_FOLDER

Inputs above, meshes below: a polygon in a polygon; neighbors of any size; regions; overlaps; tagged lines.
"""

import os
import sys

from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import views

BLACK, RED = [0, 0, 0], [0.8, 0, 0.1]
REGION_COLORS = [0, 0.8, 0.88, 0.97, 1, 0.98, 0.86, 0.7]
SIZE = [300, 240]


def box(x, y, width, height):
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


# Faces with their regions, and lines: the inputs.
SQUARES = [(box(x, y, 1, 1), 0) for x in (0, 1) for y in (0, 1, 2)]
INPUTS = (
    ([(box(0, 0, 4, 3), 0), (box(1, 1, 1.5, 1), 0)], []),
    (SQUARES + [(box(2, 0, 2, 3), 0)], []),
    (SQUARES + [(box(2, 0, 2, 3), 1)], []),
    ([(box(0, 0, 3, 2), 0), (box(1.5, 1, 2.5, 2), 0)], []),
    (SQUARES + [(box(2, 0, 2, 3), 0)], [[(0, 3), (0, 0), (2, 0)], [(2.6, 2.4), (3.4, 0.6)]]),
)


def main(plugin, folder):
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
    layout = CreateLayout('cells')
    layout.SplitVertical(0, 0.5)
    places = [split(layout, cell) for cell in (1, 2)]
    for column, (faces, lines) in enumerate(INPUTS):
        drawing = source_of(faces, lines)
        for row, draw in enumerate((draw_input, draw_mesh)):
            view = views.plane_view([2, 1.5], 3.4, SIZE)
            draw(drawing, view)
            AssignViewToLayout(view, layout, places[row][column])
    size = [SIZE[0] * len(INPUTS), SIZE[1] * 2]
    layout.SetSize(*size)
    SaveScreenshot(os.path.join(folder, 'cells.png'), layout, ImageResolution=size)


def split(layout, cell):
    """Five cells of equal width; each split leaves its left part and goes on with the right one."""
    places = []
    for rest in range(len(INPUTS), 1, -1):
        layout.SplitHorizontal(cell, 1 / rest)
        places.append(2 * cell + 1)
        cell = 2 * cell + 2
    return places + [cell]


def source_of(faces, lines):
    data, points = vtkPolyData(), vtkPoints()
    data.SetPoints(points)
    region, tag = vtkIntArray(), vtkIntArray()
    region.SetName('Region')
    tag.SetName('Tag')
    for chains, insert, is_line in ((lines, data.SetLines, 1), (faces, data.SetPolys, 0)):
        cells = vtkCellArray()
        for chain in chains:
            places, number = (chain, 0) if is_line else chain
            cells.InsertNextCell(len(places))
            for x, y in places:
                cells.InsertCellPoint(points.InsertNextPoint(x, y, 0))
            region.InsertNextValue(number)
            tag.InsertNextValue(is_line)
        insert(cells)
    data.GetCellData().AddArray(region)
    data.GetCellData().AddArray(tag)
    producer = TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    return producer


def draw_input(drawing, view):
    shown = views.show_colored(drawing, view, ('CELLS', 'Region'), REGION_COLORS, BLACK)
    shown.Representation = 'Surface'
    Show(raised(drawing, 0.005), view, Representation='Wireframe', ColorArrayName=[None, ''],
        LineWidth=2, AmbientColor=BLACK, DiffuseColor=BLACK)
    show_tagged(drawing, view)


def draw_mesh(drawing, view):
    mesher = BitingMesher(Input=drawing, UniformSpacing=0.35, RegionArray='Region')
    views.show_colored(mesher, view, ('CELLS', 'RegionId'), REGION_COLORS, [0.6, 0.65, 0.7])
    views.show_lines(OutputPort(mesher, 1), view, BLACK)
    show_tagged(OutputPort(mesher, 1), view)


def show_tagged(lines, view):
    """Lines, and what carries their tag, in red."""
    tagged = Threshold(Input=lines, Scalars=['CELLS', 'Tag'], LowerThreshold=1, UpperThreshold=1)
    Show(raised(tagged, 0.01), view, ColorArrayName=[None, ''], LineWidth=5, AmbientColor=RED,
        DiffuseColor=RED)


def raised(source, height):
    """Above the others, so that it is seen."""
    moved = Transform(Input=source)
    moved.Transform.Translate = [0, 0, height]
    return moved


if __name__ == '__main__':
    main(*sys.argv[1:3])
