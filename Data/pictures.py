# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws bites: pvpython pictures.py BitingMesh.so OUTPUT_FOLDER"""

import os
import sys

from paraview.simple import *

HERE = os.path.dirname(os.path.abspath(__file__))
PHASE_COLORS = [0, 0.88, 0.45, 0.25, 1, 0.95, 0.75, 0.35, 2, 0.55, 0.75, 0.9]


def main(plugin, folder):
    LoadPlugin(plugin, remote=False, ns=globals())
    draw_bites(os.path.join(folder, 'bites.png'))


def draw_bites(path):
    """The plate after the bites at vertices, after those on edges, half way inside; its mesh."""
    plate = read('plate.vtk')
    whole = BitingMesher(Input=plate, UniformSpacing=0.4, GenerateBites=1)
    phases = bite_phases(whole)
    first, second, last = phases.count(0), phases.count(0) + phases.count(1), len(phases)
    views = []
    for bites in (first, second, (second + last) // 2):
        stopped = BitingMesher(Input=plate, UniformSpacing=0.4, GenerateBites=1,
            MaximumNumberOfBites=bites)
        views.append(new_view([6, 3], 6.9, [750, 400]))
        show_bites(stopped, views[-1])
    views.append(new_view([6, 3], 6.9, [750, 400]))
    show_mesh(whole, views[-1])
    save(path, views, 2)


def read(name):
    return LegacyVTKReader(FileNames=[os.path.join(HERE, name)])


def bite_phases(mesher):
    """Phases of the bites, without the front."""
    mesher.UpdatePipeline()
    phases = FetchData(OutputPort(mesher, 2))[0].GetCellData().GetArray('Phase')
    values = [int(phases.GetValue(i)) for i in range(phases.GetNumberOfTuples())]
    return [phase for phase in values if phase < 3]


def new_view(center, height, size):
    view = CreateView('RenderView', ViewSize=size)
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    view.InteractionMode = '2D'
    view.CameraParallelProjection = 1
    view.CameraPosition, view.CameraFocalPoint = [*center, 100], [*center, 0]
    view.CameraParallelScale = height / 2
    return view


def show_bites(mesher, view):
    """Earlier bites lie above later ones: what a bite takes is what was left."""
    ordered = CellDatatoPointData(Input=phases_between(mesher, 0, 2), PassCellData=1)
    stacked = WarpByScalar(Input=ordered, Scalars=['POINTS', 'BiteOrder'], ScaleFactor=-1e-3)
    bites = Show(stacked, view, Representation='Surface With Edges', Ambient=1, Diffuse=0,
        EdgeColor=[0.3, 0.3, 0.3], Position=[0, 0, -0.1])
    ColorBy(bites, ('CELLS', 'Phase'))
    colors = GetColorTransferFunction('Phase')
    colors.RGBPoints, colors.ColorSpace = PHASE_COLORS, 'RGB'
    bites.SetScalarBarVisibility(view, False)
    show_lines(phases_between(mesher, 3, 3), view, [0.8, 0, 0.1])
    show_lines(OutputPort(mesher, 1), view, [0, 0, 0])


def phases_between(mesher, first, last):
    return Threshold(Input=OutputPort(mesher, 2), Scalars=['CELLS', 'Phase'], LowerThreshold=first,
        UpperThreshold=last)


def show_mesh(mesher, view):
    fill = [0.9, 0.95, 1]
    Show(mesher, view, Representation='Surface With Edges', ColorArrayName=[None, ''], Ambient=1,
        Diffuse=0, AmbientColor=fill, DiffuseColor=fill, EdgeColor=[0.2, 0.25, 0.35])
    show_lines(OutputPort(mesher, 1), view, [0, 0, 0])


def show_lines(lines, view, color):
    Show(lines, view, ColorArrayName=[None, ''], LineWidth=2, AmbientColor=color,
        DiffuseColor=color)


def save(path, views, columns):
    """All views in one picture, from the upper left, row by row."""
    layout, rows = CreateLayout(os.path.basename(path)), len(views) // columns
    cells = [0]
    if rows > 1:
        layout.SplitVertical(0, 0.5)
        cells = [1, 2]
    for row, cell in enumerate(cells):
        layout.SplitHorizontal(cell, 0.5)
        for column in range(columns):
            AssignViewToLayout(views[row * columns + column], layout, 2 * cell + 1 + column)
    size = [views[0].ViewSize[0] * columns, views[0].ViewSize[1] * rows]
    layout.SetSize(*size)
    SaveScreenshot(path, layout, ImageResolution=size)


if __name__ == '__main__':
    main(*sys.argv[1:3])
