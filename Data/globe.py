# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Seas in longitude and latitude: pvpython globe.py BitingMesh.so OUTPUT_FOLDER

The sea around Chukotka, across the 180th meridian, as it is in degrees, and the Arctic Ocean, over
the pole, as a Calculator puts it on the globe. Prints the summaries; draws globe.png. The picture of
the help has 64 colours: convert globe.png -dither None -colors 64 PNG8:globe.png
Source: GSHHG 2.3.7 (Debian's package gmt-gshhg-low, or the folder in GSHHG).
"""

import math
import os
import sys

from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import views
from gshhg import shoreline_rings

FOLDER = os.environ.get('GSHHG', '/usr/share/gmt-gshhg')
SIZE = [600, 500]
COAST = [0.8, 0.3, 0.1]
# In the units of the mesh, whose x and y are degrees; 1000 km are one unit.
ON_GLOBE = '6.371*({0}*iHat + {1}*jHat + {2}*kHat)'.format(
    'cos(coordsY*acos(-1)/180)*cos(coordsX*acos(-1)/180)',
    'cos(coordsY*acos(-1)/180)*sin(coordsX*acos(-1)/180)', 'sin(coordsY*acos(-1)/180)')


def main(plugin, folder):
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
    layout = CreateLayout('Globe')
    layout.SplitHorizontal(0, 0.5)
    chukotka = mesh_sea('l', box(170, 62, 198, 73), 61, (169, 199), 20e3)
    view = views.plane_view([184, 67.5], 25, SIZE)
    views.show_mesh(chukotka, view)
    views.show_lines(OutputPort(chukotka, 1), view, COAST)
    views.show_lines(Line(Point1=[180, 61, 0], Point2=[180, 74, 0]), view, [0.3, 0.3, 0.3])
    add_text('Around Chukotka: 170 to 198 degrees, and the 180th meridian', view)
    AssignViewToLayout(view, layout, 1)
    arctic = mesh_sea('c', [(5 * k, 66) for k in range(72)], 58, None, 70e3)
    view = views.plane_view([0, 0], 5.6, SIZE)
    for port in (0, 1):
        globe = Calculator(Input=OutputPort(arctic, port), CoordinateResults=1, Function=ON_GLOBE)
        if port == 0:
            views.show_mesh(globe, view)
        else:
            views.show_lines(globe, view, COAST)
    add_text('The Arctic Ocean, from above the pole', view)
    AssignViewToLayout(view, layout, 2)
    size = [2 * SIZE[0], SIZE[1]]
    layout.SetSize(*size)
    SaveScreenshot(os.path.join(folder, 'globe.png'), layout, ImageResolution=size)


def mesh_sea(resolution, outline, southernmost, longitudes, spacing):
    """The sea within an outline: that less the land, which may leave it."""
    shores = shores_north_of(southernmost, longitudes, resolution)
    mesh = BitingMesher(Input=drawing([outline] + shores), Coordinates='Longitude Latitude',
        DomainRule='Outer Minus Others', UniformSpacing=spacing, BoundaryTolerance=0.2,
        MinimumLoopSize=1.5)
    mesh.UpdatePipeline()
    mesh.UpdatePropertyInformation()
    print(mesh.Summary)
    return mesh


def shores_north_of(southernmost, longitudes, resolution):
    """The land beyond a parallel, cut there, and between two meridians."""
    shores = []
    for ring in shoreline_rings(os.path.join(FOLDER, f'binned_GSHHS_{resolution}.nc')):
        ring = cut(continued(ring), lambda p: p[1] - southernmost)
        if longitudes:
            ring = cut(ring, lambda p: p[0] - longitudes[0])
            ring = cut(ring, lambda p: longitudes[1] - p[0])
        if len(ring) > 2:
            shores.append(with_steps(ring))
    return shores


def continued(ring):
    """Without jumps at Greenwich."""
    result = [ring[0]]
    for longitude, latitude in ring[1:]:
        turns = round((result[-1][0] - longitude) / 360)
        result.append((longitude + 360 * turns, latitude))
    return result


def cut(ring, inside):
    """The part of a polygon where `inside` is not negative."""
    result = []
    for a, b in zip(ring, ring[1:] + ring[:1]):
        da, db = inside(a), inside(b)
        if da >= 0:
            result.append(a)
        if (da >= 0) != (db >= 0):
            share = da / (da - db)
            result.append((a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])))
    return result


def with_steps(ring, step=5):
    """With points every five degrees: a line goes the shorter way around the globe."""
    result = []
    for a, b in zip(ring, ring[1:] + ring[:1]):
        count = max(1, math.ceil(abs(b[0] - a[0]) / step))
        result += [(a[0] + k / count * (b[0] - a[0]), a[1] + k / count * (b[1] - a[1]))
                   for k in range(count)]
    return result


def box(west, south, east, north):
    return [(west, south), (east, south), (east, north), (west, north)]


def drawing(rings):
    data, points, lines = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for ring in rings:
        first = points.GetNumberOfPoints()
        lines.InsertNextCell(len(ring) + 1)
        for longitude, latitude in ring:
            longitude = (longitude + 180) % 360 - 180
            lines.InsertCellPoint(points.InsertNextPoint(longitude, latitude, 0))
        lines.InsertCellPoint(first)
    data.SetPoints(points)
    data.SetLines(lines)
    producer = TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    return producer


def add_text(text, view):
    Show(Text(Text=text), view, Color=[0, 0, 0], FontSize=14, WindowLocation='Upper Center')


if __name__ == '__main__':
    main(*sys.argv[1:])
