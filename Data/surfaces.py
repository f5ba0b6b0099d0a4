# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces meshed anew: pvpython surfaces.py BitingMesh.so OUTPUT_FOLDER

Above what is given, below its mesh by Biting Surface Mesher: a plate with holes as a CAD program leaves it,
written as STL; a contour of a volume; a terrain, finer where it is low. The picture of this folder has 64
colours: convert surfaces.png -dither None -colors 64 PNG8:surfaces.png
"""

import os
import sys
import tempfile

from paraview.simple import *

import views

SIZE = [460, 360]


def main(plugin, folder):
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
    cases = [part(), contour(), terrain()]
    layout = CreateLayout('Surfaces')
    layout.SplitVertical(0, 0.5)
    columns = []
    for row in (1, 2):
        second = layout.SplitHorizontal(row, 1 / 3)
        third = layout.SplitHorizontal(second + 1, 0.5)
        columns.append((second, third, third + 1))
    for row, cells in enumerate(columns):
        for (surfaces, eye, middle, scale), cell in zip(cases, cells):
            AssignViewToLayout(view_of(surfaces[row], eye, middle, scale), layout, cell)
    size = [3 * SIZE[0], 2 * SIZE[1]]
    layout.SetSize(*size)
    SaveScreenshot(os.path.join(folder, 'surfaces.png'), layout, ImageResolution=size)


def part():
    """STL in, triangles as long as 1.5 units out."""
    path = os.path.join(tempfile.mkdtemp(), 'part.stl')
    plate = BitingMesher(Input=drawing_of_plate(), UniformSpacing=100, LimitByFeatureSize=0,
                         Relaxation=0)
    solid = LinearExtrusion(Input=plate, Vector=[0, 0, 1], ScaleFactor=6)
    SaveData(path, Triangulate(Input=ExtractSurface(Input=solid)))
    given = STLReader(FileNames=[path])
    mesh = BitingSurfaceMesher(Input=given, UniformSpacing=1.5)
    return (given, mesh), [30, -50, 45], [0, 0, 3], 19


def drawing_of_plate():
    """A rectangle with three round holes."""
    rectangle = Plane(Origin=[-20, -12, 0], Point1=[20, -12, 0], Point2=[-20, 12, 0],
                      XResolution=1, YResolution=1)
    outline = FeatureEdges(Input=rectangle, FeatureEdges=0, ManifoldEdges=0, NonManifoldEdges=0)
    holes = [Ellipse(Center=[x, 0, 0], MajorRadiusVector=[radius, 0, 0], Ratio=1, Resolution=48)
             for x, radius in ((0, 7), (-14, 3), (14, 3))]
    return AppendGeometry(Input=[outline, *holes])


def contour():
    """Of a volume: slivers and all."""
    volume = Wavelet(XFreq=12, YFreq=9, ZFreq=10, XMag=25, YMag=40, ZMag=15)
    given = Contour(Input=volume, ContourBy='RTData', Isosurfaces=[157.0], ComputeScalars=0)
    mesh = BitingSurfaceMesher(Input=given, UniformSpacing=0.9)
    return (given, mesh), [30, -50, 30], [0, 0, 0], 15.5


def terrain():
    """Heights on a grid; edges from 0.1 where it is low to 0.4 where it is high."""
    grid = Plane(Origin=[-4, -4, 0], Point1=[4, -4, 0], Point2=[-4, 4, 0], XResolution=40,
                 YResolution=40)
    heights = Calculator(Input=grid, ResultArrayName='height',
                         Function='sin(1.1*coordsX+0.3)*cos(0.9*coordsY)+0.3*sin(2.3*coordsX*coordsY/4)')
    raised = WarpByScalar(Input=heights, Scalars=['POINTS', 'height'])
    given = Calculator(Input=raised, ResultArrayName='Spacing', Function='0.25+0.12*height')
    mesh = BitingSurfaceMesher(Input=given, SpacingSource=given)
    return (given, mesh), [5, -9, 8], [0, 0, 0], 4.4


def view_of(surface, eye, middle, scale):
    view = views.space_view(eye, middle, scale, SIZE)
    views.show_surface(surface, view)
    return view


if __name__ == '__main__':
    main(*sys.argv[1:])
