# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts that draw pictures share: views of the plane, meshes in them, histograms."""

from paraview.simple import *

WHITE, SAND = [1, 1, 1], [0.86, 0.84, 0.78]


def plane_view(center, height, size, background=WHITE):
    """A new view from above on `height` units of the plane about `center`, `size` pixels large."""
    view = CreateView('RenderView', ViewSize=size)
    look_at(view, center, height, background)
    return view


def look_at(view, center, height, background=WHITE):
    view.UseColorPaletteForBackground, view.Background = 0, background
    view.OrientationAxesVisibility, view.InteractionMode = 0, '2D'
    view.CameraParallelProjection, view.CameraParallelScale = 1, height / 2
    view.CameraPosition, view.CameraFocalPoint = [*center, 10 * height], [*center, 0]


def show_mesh(mesh, view):
    """Triangles in one pale colour."""
    fill = [0.9, 0.95, 1]
    Show(mesh, view, Representation='Surface With Edges', ColorArrayName=[None, ''], Ambient=1,
        Diffuse=0, AmbientColor=fill, DiffuseColor=fill, EdgeColor=[0.5, 0.56, 0.65])


def show_colored(surface, view, array, colors, edge_color):
    """Faces coloured by an array; `colors` are its values, each with red, green and blue."""
    shown = Show(surface, view, Representation='Surface With Edges', Ambient=1, Diffuse=0,
        EdgeColor=edge_color)
    ColorBy(shown, array)
    function = GetColorTransferFunction(array[1])
    function.RGBPoints, function.ColorSpace = colors, 'RGB'
    shown.SetScalarBarVisibility(view, False)
    return shown


def show_lines(lines, view, color):
    Show(lines, view, ColorArrayName=[None, ''], LineWidth=2, AmbientColor=color,
        DiffuseColor=color)


def histograms(judged, colors, column, title, extent, size):
    """A chart with a line for each name of `judged`, from the tables of MeshConformity, in percent."""
    view = CreateView('XYChartView', ViewSize=size)
    view.BottomAxisTitle, view.LeftAxisTitle = title, 'percent'
    view.BottomAxisUseCustomRange, view.BottomAxisRangeMinimum, view.BottomAxisRangeMaximum = (
        1, *extent)
    values = f'{column}Percent'
    for name, conformity in judged.items():
        lines = Show(OutputPort(conformity, 1), view, 'XYChartRepresentation')
        lines.UseIndexForXAxis, lines.XArrayName = 0, column
        lines.SeriesVisibility = [values]
        lines.SeriesLabel = [values, name]
        lines.SeriesColor = [values, *(str(part) for part in colors[name])]
        lines.SeriesLineThickness = [values, '3']
    return view
