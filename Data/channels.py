# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""A river into a lake, at 1, 2 and 4 CellsAcross: pvpython channels.py BitingMesh.so OUTPUT_FOLDER

Prints the numbers of vertices; draws the meshes. The picture of this folder has 32 colours:
convert channels.png -dither None -colors 32 PNG8:channels.png
"""

import math
import os
import sys

from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import views

NUMBERS = [1, 2, 4]
SIZE = [400, 210]


def main(plugin, folder):
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
    layout = CreateLayout('Channels')
    layout.SplitHorizontal(0, 1 / 3)
    layout.SplitHorizontal(2, 0.5)
    shore = river_and_lake()
    for number, cell in zip(NUMBERS, (1, 5, 6)):
        mesh = BitingMesher(Input=shore, UniformSpacing=0.6, CellsAcross=number, MinimumSpacing=0.02)
        mesh.UpdatePipeline()
        count = mesh.GetDataInformation().GetNumberOfPoints()
        print(f'{number} cells across: {count} vertices')
        view = views.plane_view([4.5, -0.1], 6.0, SIZE)
        views.show_mesh(mesh, view)
        views.show_lines(shore, view, [0.8, 0.3, 0.1])
        Show(Text(Text=f'{number}: {count} vertices'), view, Color=[0, 0, 0], FontSize=14,
            WindowLocation='Upper Center')
        AssignViewToLayout(view, layout, cell)
    size = [len(NUMBERS) * SIZE[0], SIZE[1]]
    layout.SetSize(*size)
    SaveScreenshot(os.path.join(folder, 'channels.png'), layout, ImageResolution=size)


def river_and_lake():
    """A river 0.4 high that follows y = sin x from x = -1 to 6, and a lake about (8, sin 6)."""
    along = [-1 + 7 * k / 28 for k in range(29)]
    right = [(x, math.sin(x) - 0.2) for x in along]
    left = [(x, math.sin(x) + 0.2) for x in reversed(along)]
    middle = (8, math.sin(6))
    start = math.atan2(right[-1][1] - middle[1], right[-1][0] - middle[0])
    end = math.atan2(left[0][1] - middle[1], left[0][0] - middle[0])
    turn = (end - start) % (2 * math.pi)
    radius = math.dist(right[-1], middle)
    lake = [(middle[0] + radius * math.cos(start + turn * k / 16),
             middle[1] + radius * math.sin(start + turn * k / 16)) for k in range(1, 16)]
    data, points, lines = vtkPolyData(), vtkPoints(), vtkCellArray()
    places = right + lake + left
    lines.InsertNextCell(len(places) + 1)
    for x, y in places:
        lines.InsertCellPoint(points.InsertNextPoint(x, y, 0))
    lines.InsertCellPoint(0)
    data.SetPoints(points)
    data.SetLines(lines)
    producer = TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    return producer


if __name__ == '__main__':
    main(*sys.argv[1:])
