# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""What remeshing keeps: pvpython remeshing.py BitingMesh.so OUTPUT_FOLDER

A fine layer moves by .18 in a square of 9. Draws the mesh before, and after it, with what is unchanged in
blue; and for each Preference, and for the mesher, the share of vertices that are kept against the mean of
the smallest angles.
"""

import os
import sys

import numpy
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

import views

HERE = os.path.dirname(os.path.abspath(__file__))
PREFERENCES = ['Keeping', 'Balanced', 'Shape']
COLORS_OF_PARTS = [0, 1, 0.85, 0.7, 1, 0.7, 0.84, 1]
COLORS = {'Keeping': (0.2, 0.6, 0.3), 'Balanced': (0.1, 0.4, 0.7), 'Shape': (0.5, 0.3, 0.7),
          'meshed anew': (0.85, 0.37, 0.1)}


def main(plugin, folder):
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
    square = LegacyVTKReader(FileNames=[os.path.join(HERE, 'square_9x9.vtk')])
    before = mesh_of(square, 4.0)
    wanted = layer(before, 4.18)
    after = {name: BitingRemesher(Input=wanted, SpacingArray=['POINTS', 'Wanted'], Preference=name,
                 RegionArray='None') for name in PREFERENCES}
    points = {name: figures_of(name, mesh) for name, mesh in after.items()}
    points['meshed anew'] = figures_of('meshed anew', mesh_of(square, 4.18))
    draw(os.path.join(folder, 'remeshing.png'), before, after['Balanced'], points)


def mesh_of(square, place):
    """Fitted to the layer, which its vertices must be near enough to see."""
    mesh = BitingMesher(Input=square, UniformSpacing=0.45)
    for _ in range(3):
        mesh = BitingMesher(Input=square, SpacingSource=layer(mesh, place),
            SourceSpacingArray=['POINTS', 'Wanted'])
    return mesh


def layer(mesh, place):
    """The mesh with an array `Wanted`: .08 on a curve, and more with the distance from it."""
    distance = f'abs(coordsX-{place}-0.6*sin(0.8*coordsY))'
    return Calculator(Input=mesh, ResultArrayName='Wanted',
        Function=f'min(0.45,0.08+0.25*{distance})')


def figures_of(name, mesh):
    """The share of vertices that are kept, and the mean of the smallest angles."""
    data = servermanager.Fetch(mesh)
    angle = numpy.mean(vtk_to_numpy(data.GetCellData().GetArray('MinimumAngle')))
    counts = data.GetFieldData()
    kept = 0.0
    if counts.GetArray('KeptVertices'):
        kept = counts.GetArray('KeptVertices').GetValue(0)
        kept *= 100.0 / (kept + counts.GetArray('RemovedVertices').GetValue(0))
    smallest = counts.GetArray('SmallestAngle').GetValue(0)
    print(f'{name:12} {data.GetNumberOfPoints()} vertices, {kept:.1f} % kept, smallest angle '
          f'{smallest:.1f}, mean of the smallest {angle:.1f}')
    return kept, angle


def draw(path, before, after, points):
    layout = CreateLayout('Remeshing')
    layout.SplitHorizontal(0, 1 / 3)
    layout.SplitHorizontal(2, 0.5)
    AssignViewToLayout(view_of('before', before, views.show_mesh), layout, 1)
    AssignViewToLayout(view_of('after: what is unchanged in blue', after, show_unchanged), layout, 5)
    AssignViewToLayout(curve(points), layout, 6)
    layout.SetSize(1080, 370)
    SaveScreenshot(path, layout, ImageResolution=[1080, 370], CompressionLevel='9')


def view_of(title, mesh, shows):
    view = views.plane_view([4.5, 4.7], 10.2, [360, 370])
    shows(mesh, view)
    Show(Text(Text=title), view, Color=[0, 0, 0], FontSize=16, WindowLocation='Upper Center')
    return view


def show_unchanged(mesh, view):
    marked = Calculator(Input=mesh, AttributeType='Cell Data', ResultArrayName='unchanged',
        Function='if(OriginalCellId<0,0,1)')
    views.show_colored(marked, view, ('CELLS', 'unchanged'), COLORS_OF_PARTS, [0.2, 0.25, 0.35])


def curve(points):
    """A dot for each mesh."""
    view = CreateView('XYChartView', ViewSize=[360, 370])
    view.BottomAxisTitle, view.LeftAxisTitle = 'vertices kept [percent]', 'mean smallest angle'
    view.BottomAxisUseCustomRange, view.BottomAxisRangeMinimum, view.BottomAxisRangeMaximum = (
        1, -5, 105)
    view.LegendLocation = 'BottomLeft'
    for name, place in points.items():
        dot = Show(table(place), view, 'XYChartRepresentation')
        dot.UseIndexForXAxis, dot.XArrayName = 0, 'kept'
        dot.SeriesVisibility, dot.SeriesLabel = ['angle'], ['angle', name]
        dot.SeriesColor = ['angle', *(str(part) for part in COLORS[name])]
        dot.SeriesMarkerStyle, dot.SeriesMarkerSize = ['angle', '4'], ['angle', '12']
        dot.SeriesLineStyle = ['angle', '0']
    return view


def table(place):
    script = ('import vtk\n'
              f'for name, value in (("kept", {place[0]!r}), ("angle", {place[1]!r})):\n'
              '    column = vtk.vtkDoubleArray()\n'
              '    column.SetName(name)\n'
              '    column.InsertNextValue(value)\n'  # twice: a chart draws no line of one point
              '    column.InsertNextValue(value)\n'
              '    self.GetTableOutput().AddColumn(column)\n')
    return ProgrammableSource(OutputDataSetType='vtkTable', Script=script)


if __name__ == '__main__':
    main(*sys.argv[1:3])
