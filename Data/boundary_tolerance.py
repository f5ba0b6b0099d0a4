# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Drawings finer than the mesh: pvpython boundary_tolerance.py BitingMesh.so OUTPUT_FOLDER

The outline of bright pixels and the shores of Shetland, without a boundary tolerance and at three.
Prints a table of the figures; draws the meshes. The picture of this folder has 32 colours, to be small:
convert boundary_tolerance.png -dither None -colors 32 PNG8:boundary_tolerance.png
"""

import os
import sys

from paraview.simple import *

import views

HERE = os.path.dirname(os.path.abspath(__file__))
TOLERANCES = [0.0, 0.1, 0.2, 0.5]
CASES = {  # spacing, smallest loops, middle and height of the view
    'pixels': (9.0, 0.5, [100.0, 104.0], 212.0),
    'shetland': (2500.0, 0.5, [0.0, 6e3], 156e3),
}
SIZE = [300, 330]


def main(plugin, folder):
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
    layout = CreateLayout('Boundary tolerance')
    cells = grid(layout)
    for name, (spacing, loops, center, height) in CASES.items():
        drawing = LegacyVTKReader(FileNames=[os.path.join(HERE, name + '.vtk')])
        for tolerance in TOLERANCES:
            mesh = BitingMesher(Input=drawing, UniformSpacing=spacing, BoundaryTolerance=tolerance,
                MinimumLoopSize=loops if tolerance > 0 else 0)
            title = report(name, tolerance, mesh)
            AssignViewToLayout(view_of(mesh, drawing, title, center, height), layout, next(cells))
    size = [len(TOLERANCES) * SIZE[0], 2 * SIZE[1]]
    layout.SetSize(*size)
    SaveScreenshot(os.path.join(folder, 'boundary_tolerance.png'), layout, ImageResolution=size,
        CompressionLevel='9')


def grid(layout):
    """The cells of two rows of four."""
    layout.SplitVertical(0, 0.5)
    for row in (1, 2):
        left, right = 2 * row + 1, 2 * row + 2
        layout.SplitHorizontal(row, 0.5)
        for half in (left, right):
            layout.SplitHorizontal(half, 0.5)
    return iter([cell for row in (1, 2) for half in (2 * row + 1, 2 * row + 2)
        for cell in (2 * half + 1, 2 * half + 2)])


def report(name, tolerance, mesh):
    mesh.UpdatePipeline()
    data = servermanager.Fetch(mesh).GetFieldData()
    figure = lambda key: data.GetArray(key).GetValue(0)
    print(f'{name:9} tolerance {tolerance}: {figure("NumberOfVertices"):6} vertices, smallest angle '
          f'{figure("SmallestAngle"):.1f}, {figure("RemovedVertices")} points and '
          f'{figure("LeftOutLoops")} loops gone')
    return f'{tolerance:g}: {figure("NumberOfVertices")} vertices'


def view_of(mesh, drawing, title, center, height):
    view = views.plane_view(center, height, SIZE)
    views.show_mesh(mesh, view)
    views.show_lines(drawing, view, [0.8, 0.3, 0.1])
    Show(Text(Text=title), view, Color=[0, 0, 0], FontSize=14, WindowLocation='Upper Center')
    return view


if __name__ == '__main__':
    main(*sys.argv[1:])
