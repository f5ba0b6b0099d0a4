# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Polygons over each other, and sizes by tag: pvpython regions.py BitingMesh.so OUTPUT_FOLDER

Draws domain_rules.png, the same three polygons by each DomainRule, and size_by_tag.png, a drawing and its
mesh. The pictures of the help have 32 colours:
convert domain_rules.png -dither None -colors 32 PNG8:domain_rules.png
"""

import os
import sys

from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import views

RULES = ['Even-Odd', 'Outer Minus Others', 'Union']
SIZE = [400, 300]
SEA, LAND, HARBOUR = 1, 2, 3
COLORS = [SEA, 0.75, 0.87, 0.98, LAND, 0.98, 0.86, 0.62, HARBOUR, 0.96, 0.66, 0.6]
RED, EDGES = [0.8, 0.1, 0], [0.45, 0.5, 0.55]


def main(plugin, folder):
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
    draw_rules(os.path.join(folder, 'domain_rules.png'))
    draw_sizes(os.path.join(folder, 'size_by_tag.png'))


def draw_rules(path):
    """A sea, land that leaves it, and a harbour within: their tags are on the triangles."""
    drawing = source_of([box(0, 0, 8, 6), box(5, 2.5, 4, 3), box(1, 1, 2.5, 2)],
        Tag=[SEA, LAND, HARBOUR])
    pictures = []
    for rule in RULES:
        mesh = BitingMesher(Input=drawing, UniformSpacing=0.5, RegionArray='Tag', DomainRule=rule)
        view = views.plane_view([4.5, 3], 7.2, SIZE)
        views.show_colored(mesh, view, ('CELLS', 'Tag'), COLORS, EDGES)
        views.show_lines(FeatureEdges(Input=drawing), view, RED)
        pictures.append((view, rule))
    save(path, pictures)


def draw_sizes(path):
    """An array of polygons: short edges in the harbour, longer ones on the land."""
    drawing = source_of([box(0, 0, 8, 6), box(5, 2.5, 4, 3), box(1, 1, 2.5, 2)],
        Tag=[SEA, LAND, HARBOUR])
    pictures = []
    for text, tag, size in (('no sizes', 0, 0), ('Tag 3: 0.15', HARBOUR, 0.15),
                            ('Tag 2: 0.2', LAND, 0.2)):
        sizes = Calculator(Input=drawing, AttributeType='Cell Data', ResultArrayName='Size',
            Function=f'if (Tag == {tag}, {size}, 0)')
        mesh = BitingMesher(Input=sizes, UniformSpacing=0.8, RegionArray='Tag', DomainRule='Union',
            BoundarySpacingArray=['CELLS', 'Size'])
        view = views.plane_view([4.5, 3], 7.2, SIZE)
        views.show_colored(mesh, view, ('CELLS', 'Tag'), COLORS, EDGES)
        pictures.append((view, text))
    save(path, pictures)


def save(path, pictures):
    """Views with a line of text each, side by side."""
    layout = CreateLayout(os.path.basename(path))
    layout.SplitHorizontal(0, 1 / 3)
    layout.SplitHorizontal(2, 0.5)
    for (view, text), cell in zip(pictures, (1, 5, 6)):
        Show(Text(Text=text), view, Color=[0, 0, 0], FontSize=14, WindowLocation='Upper Center')
        AssignViewToLayout(view, layout, cell)
    size = [len(pictures) * SIZE[0], SIZE[1]]
    layout.SetSize(*size)
    SaveScreenshot(path, layout, ImageResolution=size)


def box(x, y, width, height):
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


def source_of(polygons, **arrays):
    data, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    for polygon in polygons:
        cells.InsertNextCell(len(polygon))
        for x, y in polygon:
            cells.InsertCellPoint(points.InsertNextPoint(x, y, 0))
    data.SetPoints(points)
    data.SetPolys(cells)
    for name, values in arrays.items():
        array = vtkIntArray()
        array.SetName(name)
        for value in values:
            array.InsertNextValue(value)
        data.GetCellData().AddArray(array)
    producer = TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    return producer


if __name__ == '__main__':
    main(*sys.argv[1:])
