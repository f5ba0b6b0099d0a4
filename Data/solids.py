# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Closed surfaces filled with tetrahedra: pvpython solids.py BitingMesh.so OUTPUT_FOLDER

Makes solids.png, by Biting Tetrahedralizer, cut open: the bracket of this folder, by smallest dihedral
angles; a shell of two materials around a cavity; a ball whose edges a field in space makes short. And
united.png: three bodies that cross, as given, with a sphere at each crossing, and their union, cut open.
The pictures have 96 colours: convert solids.png -dither None -colors 96 PNG8:solids.png
"""

import os
import sys

from paraview.simple import *

import examples
import views

HERE = os.path.dirname(os.path.abspath(__file__))
SIZE = [420, 380]
ANGLES = [0, 0.5, 0, 0.15, 15, 0.85, 0.1, 0.1, 30, 0.98, 0.75, 0.35, 50, 0.95, 0.97, 0.88,
    70, 0.6, 0.82, 0.92]  # the colours of the plugin


def main(plugin, folder):
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=vars(examples))
    shown = [bracket(), shell(folder), graded(folder)]
    views.save_row(shown, SIZE, os.path.join(folder, 'solids.png'))
    views.save_row(crossing_bodies(), SIZE, os.path.join(folder, 'united.png'))


def bracket():
    given = LegacyVTKReader(FileNames=[os.path.join(HERE, 'bracket.vtk')])
    mesh = BitingTetrahedralizer(Input=given, UniformSpacing=2.5)
    view = views.space_view([150, -130, 110], [28, 20, 23], 39, SIZE)
    show_half(mesh, view, [0, 11, 0], [0, 1, 0])
    return view


def shell(folder):
    view = views.space_view([1.5, -4, 2.4], [0, 0, 0], 1.12, SIZE)
    shown = show_half(examples.shell_of_two_materials(folder), view, [0, 0, 0], [0, 1, 0])
    ColorBy(shown, ('CELLS', 'RegionId'))
    shown.SetScalarBarVisibility(view, False)
    colors = GetColorTransferFunction('RegionId')
    colors.ColorSpace, colors.RGBPoints = 'RGB', [0, 0.93, 0.76, 0.45, 1, 0.62, 0.75, 0.88]
    return view


def graded(folder):
    view = views.space_view([1.5, -4, 2.4], [0, 0, 0], 1.12, SIZE)
    show_half(examples.ball_with_a_spacing_field(folder), view, [0, 0, 0], [0, 1, 0])
    return view


def crossing_bodies():
    """A plate, a bar through it, a ball that sticks out of it: as given with crossings, and united."""
    plate = Box(XLength=5, YLength=3, ZLength=0.8)
    bar = Transform(Input=Cylinder(Radius=0.6, Height=4, Resolution=48))
    bar.Transform.Rotate, bar.Transform.Translate = [90, 0, 0], [-0.9, 0, 0]
    ball = Sphere(Radius=1, Center=[2, 0, 0.2], ThetaResolution=48, PhiResolution=32)
    given = AppendGeometry(Input=[plate, bar, ball])
    mesh = BitingTetrahedralizer(Input=given, UniformSpacing=0.25)
    seen = [[3, -9, 5], [0.2, 0, 0], 2.9, SIZE]
    before, after = views.space_view(*seen), views.space_view(*seen)
    views.show_surface(given, before)
    Show(OutputPort(mesh, 3), before, ColorArrayName=[None, ''], PointSize=7,
        RenderPointsAsSpheres=1, AmbientColor=[1, 0.1, 0.1], DiffuseColor=[1, 0.1, 0.1])
    show_half(mesh, after, [0, 0, 0], [0, 1, 0])
    return [before, after]


def show_half(mesh, view, origin, normal):
    """The tetrahedra on one side of a plane, whole, by smallest dihedral angles."""
    half = Clip(Input=OutputPort(mesh, 0), ClipType='Plane', Crinkleclip=1, Invert=0)
    half.ClipType.Origin, half.ClipType.Normal = origin, normal
    shown = Show(half, view, Representation='Surface With Edges', EdgeColor=views.EDGES)
    ColorBy(shown, ('CELLS', 'MinimumDihedralAngle'))
    shown.SetScalarBarVisibility(view, False)
    colors = GetColorTransferFunction('MinimumDihedralAngle')
    colors.ColorSpace, colors.RGBPoints = 'RGB', ANGLES
    return shown


if __name__ == '__main__':
    main(*sys.argv[1:])
