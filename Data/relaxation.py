# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""What relaxation does: pvpython relaxation.py BitingMesh.so OUTPUT_FOLDER

The plate, bitten by squares and left as it is (the paper's mesh), by squares and relaxed (the defaults),
and by circles and relaxed. Prints a table of the figures; draws the meshes, and the histograms of their
angles and conformities.
"""

import os
import sys

import numpy
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

import views

HERE = os.path.dirname(os.path.abspath(__file__))
SPACING = 0.22
BINS = 36
CENTER, HEIGHT = [6.0, 3.35], 8.0

# By title: color of the histograms, and what differs from the defaults.
MESHES = {
    'raw squares': ((0.85, 0.37, 0.1), {'Placement': 'Corners', 'Relaxation': 0}),
    'squares, relaxed': ((0.1, 0.4, 0.7), {}),
    'circles, relaxed': ((0.2, 0.6, 0.3), {'BiteShape': 'Circle'}),
}


def main(plugin, folder):
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
    plate = LegacyVTKReader(FileNames=[os.path.join(HERE, 'plate.vtk')])
    meshes = {title: BitingMesher(Input=plate, UniformSpacing=SPACING, **settings)
              for title, (_, settings) in MESHES.items()}
    for title, mesh in meshes.items():
        report(title, mesh)
    draw(os.path.join(folder, 'relaxation.png'), meshes)


def report(title, mesh):
    data = servermanager.Fetch(mesh)
    smallest = numpy.array(vtk_to_numpy(data.GetCellData().GetArray('MinimumAngle')))
    figures = {name: data.GetFieldData().GetArray(name).GetValue(0)
               for name in ('NumberOfVertices', 'MeanConformity', 'ShareOfEdgesInBand')}
    print(f'{title:16}  {figures["NumberOfVertices"]} vertices, smallest angle {smallest.min():.1f}, '
          f'mean of the smallest {smallest.mean():.1f}, mean conformity '
          f'{figures["MeanConformity"]:.3f}, edges in band {100 * figures["ShareOfEdgesInBand"]:.2f} %')


def draw(path, meshes):
    """The meshes above, the histograms below."""
    layout = CreateLayout('Relaxation')
    layout.SplitVertical(0, 0.45)
    layout.SplitHorizontal(1, 1 / 3)
    layout.SplitHorizontal(4, 0.5)
    layout.SplitHorizontal(2, 0.5)
    for cell, (title, mesh) in zip((3, 9, 10), meshes.items()):
        AssignViewToLayout(view_of_mesh(title, mesh), layout, cell)
    judged = {title: MeshConformity(Input=mesh, NumberOfBins=BINS)
              for title, mesh in meshes.items()}
    AssignViewToLayout(chart(judged, 'Angle', 'angles [degrees]', [20, 120]), layout, 5)
    AssignViewToLayout(chart(judged, 'Conformity', 'conformity of vertices', [0.5, 1]), layout, 6)
    layout.SetSize(1200, 580)
    SaveScreenshot(path, layout, ImageResolution=[1200, 580], CompressionLevel='9')


def view_of_mesh(title, mesh):
    view = views.plane_view(CENTER, HEIGHT, [400, 260])
    views.show_mesh(mesh, view)
    Show(Text(Text=title), view, Color=[0, 0, 0], FontSize=16, WindowLocation='Upper Center')
    return view


def chart(judged, column, title, extent):
    colors = {name: color for name, (color, _) in MESHES.items()}
    view = views.histograms(judged, colors, column, title, extent, [600, 320])
    view.LegendLocation = 'TopLeft'
    return view


if __name__ == '__main__':
    main(*sys.argv[1:3])
