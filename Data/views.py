# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts that draw pictures share: views of plane and space, meshes in them, histograms."""

from paraview.simple import *

WHITE, SAND = [1, 1, 1], [0.86, 0.84, 0.78]
PALE, EDGES = [0.9, 0.95, 1], [0.4, 0.46, 0.55]  # of surfaces in space


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


def space_view(eye, middle, scale, size):
    """A new view of space, with z upwards; `scale` is half of its height."""
    view = CreateView('RenderView', ViewSize=size)
    view.UseColorPaletteForBackground, view.Background = 0, WHITE
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection, view.CameraParallelScale = 1, scale
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = eye, middle, [0, 0, 1]
    return view


def show_surface(surface, view):
    """Of space, in one pale colour."""
    return Show(OutputPort(surface, 0), view, Representation='Surface With Edges',
        ColorArrayName=[None, ''], DiffuseColor=PALE, EdgeColor=EDGES)


def save_row(shown, size, path):
    """Views beside each other, each `size` pixels large, as one picture."""
    layout = CreateLayout('Row')
    cell = 0
    for k in range(1, len(shown)):
        cell = layout.SplitHorizontal(cell, 1 / (len(shown) + 1 - k))
        AssignViewToLayout(shown[k - 1], layout, cell)
        cell += 1
    AssignViewToLayout(shown[-1], layout, cell)
    whole = [len(shown) * size[0], size[1]]
    layout.SetSize(*whole)
    SaveScreenshot(path, layout, ImageResolution=whole)


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
