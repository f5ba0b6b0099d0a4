# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws bites: pvpython pictures.py BitingMesh.so OUTPUT_FOLDER"""

import os
import sys

from paraview.simple import *

import views

BLACK = [0, 0, 0]
HERE = os.path.dirname(os.path.abspath(__file__))
PHASE_COLORS = [0, 0.88, 0.45, 0.25, 1, 0.95, 0.75, 0.35, 2, 0.55, 0.75, 0.9]


def main(plugin, folder):
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
    draw_bites(os.path.join(folder, 'bites.png'))


def draw_bites(path):
    """The plate after the bites at vertices, after those on edges, half way inside; its mesh."""
    plate = read('plate.vtk')
    whole = BitingMesher(Input=plate, UniformSpacing=0.4, GenerateBites=1)
    phases = bite_phases(whole)
    first, second, last = phases.count(0), phases.count(0) + phases.count(1), len(phases)
    shown = []
    for bites in (first, second, (second + last) // 2):
        stopped = BitingMesher(Input=plate, UniformSpacing=0.4, GenerateBites=1,
            MaximumNumberOfBites=bites)
        shown.append(views.plane_view([6, 3], 6.9, [750, 400]))
        show_bites(stopped, shown[-1])
    shown.append(views.plane_view([6, 3], 6.9, [750, 400]))
    views.show_mesh(whole, shown[-1])
    views.show_lines(OutputPort(whole, 1), shown[-1], BLACK)
    save(path, shown, 2)


def read(name):
    return LegacyVTKReader(FileNames=[os.path.join(HERE, name)])


def bite_phases(mesher):
    """Phases of the bites, without the front."""
    mesher.UpdatePipeline()
    phases = FetchData(OutputPort(mesher, 2))[0].GetCellData().GetArray('Phase')
    values = [int(phases.GetValue(i)) for i in range(phases.GetNumberOfTuples())]
    return [phase for phase in values if phase < 3]


def show_bites(mesher, view):
    """Earlier bites lie above later ones: what a bite takes is what was left."""
    ordered = CellDatatoPointData(Input=phases_between(mesher, 0, 2), PassCellData=1)
    stacked = WarpByScalar(Input=ordered, Scalars=['POINTS', 'BiteOrder'], ScaleFactor=-1e-3)
    bites = views.show_colored(stacked, view, ('CELLS', 'Phase'), PHASE_COLORS, [0.3, 0.3, 0.3])
    bites.Position = [0, 0, -0.1]
    views.show_lines(phases_between(mesher, 3, 3), view, [0.8, 0, 0.1])
    views.show_lines(OutputPort(mesher, 1), view, BLACK)


def phases_between(mesher, first, last):
    return Threshold(Input=OutputPort(mesher, 2), Scalars=['CELLS', 'Phase'], LowerThreshold=first,
        UpperThreshold=last)


def save(path, shown, columns):
    """All views in one picture, from the upper left, row by row."""
    layout, rows = CreateLayout(os.path.basename(path)), len(shown) // columns
    rest = 0
    for row in range(rows):
        cell = rest
        if row < rows - 1:
            layout.SplitVertical(rest, 1 / (rows - row))
            cell, rest = 2 * rest + 1, 2 * rest + 2
        layout.SplitHorizontal(cell, 0.5)
        for column in range(columns):
            AssignViewToLayout(shown[row * columns + column], layout, 2 * cell + 1 + column)
    size = [shown[0].ViewSize[0] * columns, shown[0].ViewSize[1] * rows]
    layout.SetSize(*size)
    SaveScreenshot(path, layout, ImageResolution=size)


if __name__ == '__main__':
    main(*sys.argv[1:3])
