# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Arranges ParaView's window as in the picture of the README: paraview --script=window.py

The coast's mesh on the left, its bites on the right. window.sh starts it: the plugin is loaded, the
variable BITING_DATA names the folder of coast.vtk, BITING_WINDOW the file to write when all is drawn.
"""

import os
import sys

from paraview.simple import *

DATA = os.environ['BITING_DATA']
sys.path.insert(0, DATA)
import views

SEA, WEST = ([-85e3, 15e3], 1480e3, views.SAND), ([-130e3, 200e3], 300e3, views.SAND)
LENGTH_COLORS = [1e3, 1.0, 0.95, 0.65, 7e3, 0.55, 0.85, 0.8, 45e3, 0.3, 0.55, 0.85]
PHASE_COLORS = [0, 0.83, 0.42, 0.25, 1, 0.95, 0.77, 0.4, 2, 0.55, 0.75, 0.9]


def main():
    paraview.simple._DisableFirstRenderCameraReset()
    left = GetActiveViewOrCreate('RenderView')
    coast = LegacyVTKReader(registrationName='coast.vtk',
        FileNames=[os.path.join(DATA, 'coast.vtk')])
    mesher = BitingMesher(Input=coast, Gradation=0.15, GenerateBites=1)
    mesher.UpdatePipeline()
    show_mesh(mesher, left)
    GetLayout(left).SplitHorizontal(0, 0.5)
    right = CreateView('RenderView')
    AssignViewToLayout(right, GetLayout(left), 2)
    show_bites(mesher, right)
    SetActiveView(left)
    SetActiveSource(mesher)
    views.look_at(left, *SEA)
    views.look_at(right, *WEST)
    RenderAllViews()
    open(os.environ['BITING_WINDOW'], 'w', encoding='utf-8').close()


def show_mesh(mesher, view):
    shown = views.show_colored(mesher, view, ('POINTS', 'Spacing'), LENGTH_COLORS, [0.25, 0.3, 0.4])
    shown.LookupTable.UseLogScale = 1
    views.show_lines(OutputPort(mesher, 1), view, [0, 0, 0])


def show_bites(mesher, view):
    bites = OutputPort(mesher, 2)
    views.show_colored(bites, view, ('CELLS', 'Phase'), PHASE_COLORS, [0.3, 0.3, 0.3])
    views.show_lines(OutputPort(mesher, 1), view, [0, 0, 0])


main()
