# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes the seas around Britain and Ireland: pvpython demo.py BitingMesh.so OUTPUT_FOLDER

A script to copy from: load the plugin, read a boundary, mesh it, look at the mesh, save it.
"""

import os
import sys

from paraview.simple import *

plugin, folder = sys.argv[1:3]
here = os.path.dirname(os.path.abspath(__file__))
picture_size = [1500, 950]

# The filter: the array "Spacing" of the coast says how long edges are, from 1 to 45 kilometres; it
# grows by 0.15 metres a metre offshore.
LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
coast = LegacyVTKReader(FileNames=[os.path.join(here, 'coast.vtk')])
mesh = BitingMesher(Input=coast, Gradation=0.15)
mesh.UpdatePipeline()
shores = OutputPort(mesh, 1)

SaveData(os.path.join(folder, 'coast_mesh.vtk'), proxy=mesh)
SaveData(os.path.join(folder, 'coast_shores.vtk'), proxy=shores)


# The picture: the whole sea on the left, Scotland's west on the right, coloured by edge length.
def show_mesh(layout, cell, center, height):
    view = CreateView('RenderView', ViewSize=[picture_size[0] // 2, picture_size[1]])
    AssignViewToLayout(view, layout, cell)
    view.UseColorPaletteForBackground = 0
    view.Background = [0.86, 0.84, 0.78]
    view.OrientationAxesVisibility = 0
    view.InteractionMode = '2D'
    view.CameraParallelProjection = 1
    view.CameraPosition, view.CameraFocalPoint = [*center, 1e6], [*center, 0]
    view.CameraParallelScale = height / 2
    surface = Show(mesh, view, Representation='Surface With Edges', Ambient=1, Diffuse=0,
        EdgeColor=[0.25, 0.3, 0.4])
    ColorBy(surface, ('POINTS', 'Spacing'))
    Show(shores, view, ColorArrayName=[None, ''], LineWidth=2, DiffuseColor=[0, 0, 0])
    return view, surface


layout = CreateLayout('Coast')
layout.SplitHorizontal(0, 0.5)
show_mesh(layout, 1, [-85e3, 15e3], 1450e3)
view, surface = show_mesh(layout, 2, [-130e3, 200e3], 240e3)
layout.SetSize(*picture_size)
colors = GetColorTransferFunction('Spacing')
colors.RGBPoints = [1e3, 1.0, 0.95, 0.65, 7e3, 0.55, 0.85, 0.8, 45e3, 0.3, 0.55, 0.85]
colors.ColorSpace = 'Lab'
colors.UseLogScale = 1
legend = GetScalarBar(colors, view)
legend.Title, legend.ComponentTitle = 'Edge length [m]', ''
legend.TitleColor = legend.LabelColor = [0, 0, 0]
legend.AutomaticLabelFormat, legend.LabelFormat, legend.RangeLabelFormat = 0, '%.0f', '%.0f'
legend.WindowLocation, legend.Position = 'Any Location', [0.84, 0.62]
surface.SetScalarBarVisibility(view, True)
SaveScreenshot(os.path.join(folder, 'coast_mesh.png'), layout, ImageResolution=picture_size)

summary = servermanager.Fetch(mesh).GetFieldData()
for title, name, unit in (
        ('vertices', 'NumberOfVertices', ''), ('triangles', 'NumberOfTriangles', ''),
        ('smallest angle', 'SmallestAngle', ' degrees'), ('mean conformity', 'MeanConformity', '')):
    print(f'{title:16} {summary.GetArray(name).GetValue(0):.6g}{unit}')
