# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Arranges ParaView's window as in the picture of the README: paraview --script=window.py

The coast's mesh on the left, its bites on the right. window.sh starts it: the plugin is loaded, the
variable BITING_DATA names the folder of coast.vtk, BITING_WINDOW the file to write when all is drawn.
"""

import os

from paraview.simple import *

SEA, WEST = ([-85e3, 15e3], 1480e3), ([-130e3, 200e3], 300e3)
PHASE_COLORS = [0, 0.83, 0.42, 0.25, 1, 0.95, 0.77, 0.4, 2, 0.55, 0.75, 0.9]


def main():
    paraview.simple._DisableFirstRenderCameraReset()
    left = GetActiveViewOrCreate('RenderView')
    coast = LegacyVTKReader(registrationName='coast.vtk',
        FileNames=[os.path.join(os.environ['BITING_DATA'], 'coast.vtk')])
    mesher = BitingMesher(Input=coast, Gradation=0.15, GenerateBites=1)
    mesher.UpdatePipeline()
    show_mesh(mesher, left)
    GetLayout(left).SplitHorizontal(0, 0.5)
    right = CreateView('RenderView')
    AssignViewToLayout(right, GetLayout(left), 2)
    show_bites(mesher, right)
    SetActiveView(left)
    SetActiveSource(mesher)
    look_at(left, *SEA)
    look_at(right, *WEST)
    RenderAllViews()
    open(os.environ['BITING_WINDOW'], 'w', encoding='utf-8').close()


def show_mesh(mesher, view):
    surface = Show(mesher, view, Representation='Surface With Edges', Ambient=1, Diffuse=0,
        EdgeColor=[0.25, 0.3, 0.4])
    ColorBy(surface, ('POINTS', 'Spacing'))
    colors = GetColorTransferFunction('Spacing')
    colors.RGBPoints = [1e3, 1.0, 0.95, 0.65, 7e3, 0.55, 0.85, 0.8, 45e3, 0.3, 0.55, 0.85]
    colors.UseLogScale = 1
    surface.SetScalarBarVisibility(view, False)
    show_lines(mesher, view)


def show_bites(mesher, view):
    bites = Show(OutputPort(mesher, 2), view, Representation='Surface With Edges', Ambient=1, Diffuse=0,
        EdgeColor=[0.3, 0.3, 0.3])
    ColorBy(bites, ('CELLS', 'Phase'))
    colors = GetColorTransferFunction('Phase')
    colors.RGBPoints, colors.ColorSpace = PHASE_COLORS, 'RGB'
    bites.SetScalarBarVisibility(view, False)
    show_lines(mesher, view)


def look_at(view, center, height):
    view.UseColorPaletteForBackground = 0
    view.Background = [0.86, 0.84, 0.78]
    view.OrientationAxesVisibility = 0
    view.InteractionMode = '2D'
    view.CameraParallelProjection = 1
    view.CameraPosition, view.CameraFocalPoint = [*center, 1e6], [*center, 0]
    view.CameraParallelScale = height / 2


def show_lines(mesher, view):
    Show(OutputPort(mesher, 1), view, ColorArrayName=[None, ''], LineWidth=2,
        AmbientColor=[0, 0, 0], DiffuseColor=[0, 0, 0])


main()
