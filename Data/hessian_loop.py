# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Adapts a mesh to a sharp layer: pvpython hessian_loop.py BitingMesh.so OUTPUT_FOLDER

Mesh, solution, spacing, mesh: the loop of HessianSpacing and BitingMesher. A known function stands for
the solver. Prints the interpolation error of each turn, and that of a uniform mesh of as many
vertices; draws both meshes.
"""

import os
import sys

import numpy
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

import views

HERE = os.path.dirname(os.path.abspath(__file__))
LAYER = 'tanh(20*(sqrt(coordsX^2+coordsY^2)-6))'
TOLERANCE = 0.2
TURNS = 5
COLORS = [-1, 0.75, 0.87, 0.95, 0, 1, 1, 1, 1, 1, 0.85, 0.7]


def main(plugin, folder):
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
    square = LegacyVTKReader(FileNames=[os.path.join(HERE, 'square_9x9.vtk')])
    mesh = BitingMesher(Input=square, UniformSpacing=0.3)
    report('first mesh', mesh)
    for turn in range(TURNS):
        mesh = adapted(square, mesh)
        report(f'turn {turn + 1}', mesh)
    uniform = uniform_like(square, mesh)
    report('uniform', uniform)
    judge(mesh)
    draw(os.path.join(folder, 'hessian_loop.png'), [uniform, mesh])


def adapted(square, mesh):
    """The next mesh: that for the spacing which the solution on this one asks for."""
    spacing = HessianSpacing(Input=solve(mesh), ScalarArray=['POINTS', 'u'],
        ErrorTolerance=TOLERANCE, MaximumSpacing=1.0)
    return BitingMesher(Input=square, SpacingSource=spacing)


def solve(mesh):
    """What a solver would do: the mesh with values at its vertices."""
    return Calculator(Input=mesh, ResultArrayName='u', Function=LAYER)


def uniform_like(square, mesh):
    """A uniform mesh with at least as many vertices."""
    wanted = count_vertices(mesh)
    uniform = BitingMesher(Input=square, UniformSpacing=11 / wanted**0.5)
    while count_vertices(uniform) < wanted:
        uniform.UniformSpacing *= 0.99
    return uniform


def count_vertices(mesh):
    mesh.UpdatePipeline()
    return mesh.GetDataInformation().GetNumberOfPoints()


def report(title, mesh):
    largest, mean_square = interpolation_errors(mesh)
    print(f'{title:10} {count_vertices(mesh):6} vertices, error: largest {largest:.4f}, '
          f'root mean square {mean_square:.5f}')


def interpolation_errors(mesh, steps=6):
    """Of linear interpolation between the vertices: the largest, and the root of the mean square."""
    points, triangles = arrays_of(mesh)
    corners = points[triangles]
    sides = corners[:, 1:] - corners[:, :1]
    areas = 0.5 * abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])
    largest, squares = 0.0, numpy.zeros(len(triangles))
    samples = [((i + 1 / 3) / steps, (j + 1 / 3) / steps)
               for i in range(steps) for j in range(steps - i)]
    for a, b in samples:
        weights = numpy.array([a, b, 1 - a - b])
        errors = abs(layer(corners) @ weights - layer(numpy.einsum('k,tkx->tx', weights, corners)))
        largest = max(largest, errors.max())
        squares += errors**2 / len(samples)
    return largest, ((squares * areas).sum() / areas.sum())**0.5


def layer(places):
    """The function of LAYER."""
    return numpy.tanh(20 * (numpy.hypot(places[..., 0], places[..., 1]) - 6))


def arrays_of(mesh):
    data = servermanager.Fetch(mesh)
    points = numpy.array(vtk_to_numpy(data.GetPoints().GetData()))[:, :2]
    corners = numpy.array(vtk_to_numpy(data.GetPolys().GetConnectivityArray()))
    return points, corners.reshape(-1, 3)


def judge(mesh):
    """The last mesh against the spacing that its own solution asks for.

    Edges are shorter than that beside the layer, where Gradation lets them grow only slowly.
    """
    spacing = HessianSpacing(Input=solve(mesh), ScalarArray=['POINTS', 'u'],
        ErrorTolerance=TOLERANCE, MaximumSpacing=1.0)
    conformity = MeshConformity(Input=mesh, SpacingSource=spacing)
    summary = servermanager.Fetch(conformity).GetFieldData()
    for name in ('SmallestAngle', 'MeanConformity', 'MeanRelativeLength', 'ShareOfEdgesInBand'):
        print(f'{name:20} {summary.GetArray(name).GetValue(0):.4g}')


def draw(path, meshes):
    layout = CreateLayout('Hessian loop')
    layout.SplitHorizontal(0, 0.5)
    for cell, mesh in enumerate(meshes):
        view = views.plane_view([4.5, 4.5], 9.4, [500, 500])
        AssignViewToLayout(view, layout, cell + 1)
        views.show_colored(solve(mesh), view, ('POINTS', 'u'), COLORS, [0.2, 0.25, 0.35])
    layout.SetSize(1000, 500)
    SaveScreenshot(path, layout, ImageResolution=[1000, 500], CompressionLevel='9')


if __name__ == '__main__':
    main(*sys.argv[1:3])
