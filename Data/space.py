# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""A surface that is judged, and points that are connected: pvpython space.py BitingMesh.so OUTPUT_FOLDER

Left: two spheres that cross, of which one is open, with what Biting Surface Check finds: holes and
crossings. Right: a ring of points by Biting Delaunay 3D with an Alpha, cut open, coloured by the smallest
dihedral angle, from Mesh Conformity. The picture of this folder has 64 colours:
convert space.png -dither None -colors 64 PNG8:space.png
"""

import math
import os
import sys

from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkMinimalStandardRandomSequence, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

import views

SIZE = [500, 400]


def main(plugin, folder):
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
    views.save_row([view_of_check(), view_of_points()], SIZE, os.path.join(folder, 'space.png'))


def view_of_check():
    closed = Sphere(Radius=1, ThetaResolution=24, PhiResolution=16)
    opened = Sphere(Radius=0.8, Center=[1.1, 0.2, 0.3], ThetaResolution=24, PhiResolution=16,
        StartTheta=0, EndTheta=300)
    check = BitingSurfaceCheck(Input=AppendGeometry(Input=[closed, opened]))
    check.UpdatePipeline()
    check.UpdatePropertyInformation()
    print(check.Summary)
    view = views.space_view([-0.5, -4, 2], [0.5, 0.1, 0.1], 1.25, SIZE)
    views.show_surface(check, view)
    Show(OutputPort(check, 1), view, ColorArrayName=[None, ''], LineWidth=3,
        AmbientColor=[0, 0, 0], DiffuseColor=[0, 0, 0])
    Show(OutputPort(check, 2), view, ColorArrayName=[None, ''], PointSize=9,
        RenderPointsAsSpheres=1, AmbientColor=[1, 0.1, 0.1], DiffuseColor=[1, 0.1, 0.1])
    return view


def view_of_points():
    solid = BitingDelaunay3D(Input=ring_of_points(3000), Alpha=0.25)
    judged = MeshConformity(Input=solid)
    half = Clip(Input=judged, ClipType='Plane', Crinkleclip=1)
    half.ClipType.Origin, half.ClipType.Normal = [0, 0.1, 0], [0, -1, 0]
    view = views.space_view([0.6, -4, 2.6], [0, 0.3, 0], 1.3, SIZE)
    shown = Show(half, view, Representation='Surface With Edges', EdgeColor=[0.3, 0.3, 0.35])
    ColorBy(shown, ('CELLS', 'MinimumDihedralAngle'))
    shown.SetScalarBarVisibility(view, False)
    return view


def ring_of_points(count):
    """Within a torus of radii 1 and 0.4, made at random, and the same each time."""
    random, points, data = vtkMinimalStandardRandomSequence(), vtkPoints(), vtkPolyData()
    points.SetDataTypeToDouble()

    def between(low, high):
        random.Next()
        return random.GetRangeValue(low, high)
    while points.GetNumberOfPoints() < count:
        x, y, z = between(-1.4, 1.4), between(-1.4, 1.4), between(-0.4, 0.4)
        if math.hypot(math.hypot(x, y) - 1, z) < 0.4:
            points.InsertNextPoint(x, y, z)
    data.SetPoints(points)
    producer = TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    return producer


if __name__ == '__main__':
    main(*sys.argv[1:])
