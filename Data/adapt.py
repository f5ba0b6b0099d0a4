# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Follows a layer that moves: pvpython adapt.py BitingMesh.so OUTPUT_FOLDER [STEPS]

The loop of a simulation: solution, HessianSpacing, BitingRemesher, solution on the new mesh. A known
function stands for the solver; a second field is only transferred, from mesh to mesh, to see what that
costs. Prints for each step the vertices, the share of them that was kept, the error of interpolation
of the solution, and that of the transferred field; writes them to adapt.csv, a picture of each step to
adapt_NN.png, and the last pipeline to adapt.pvsm, to be opened in ParaView.
"""

import os
import sys

import numpy
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

import views
from hessian_loop import arrays_of, count_vertices

HERE = os.path.dirname(os.path.abspath(__file__))
STEPS = 20
WAY = 0.18  # of the layer in a step; the square is 9 wide
TOLERANCE = 0.2
LARGEST = 0.5
COLORS = [-1, 0.75, 0.87, 0.95, 0, 1, 1, 1, 1, 1, 0.85, 0.7]


def main(plugin, folder, steps=STEPS):
    os.makedirs(folder, exist_ok=True)
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
    square = LegacyVTKReader(FileNames=[os.path.join(HERE, 'square_9x9.vtk')])
    mesh = first_mesh(square)
    rows = [row_of(0, mesh, mesh)]
    for step in range(1, int(steps) + 1):
        mesh = frozen(remeshed(mesh, step))
        rows.append(row_of(step, mesh, None))
        draw(os.path.join(folder, f'adapt_{step:02}.png'), mesh, step)
    with open(os.path.join(folder, 'adapt.csv'), 'w', encoding='ascii') as table:
        table.write('step,vertices,kept,error,transferred\n')
        table.writelines(','.join(f'{value:.6g}' for value in row) + '\n' for row in rows)
    SaveState(os.path.join(folder, 'adapt.pvsm'))


def first_mesh(square):
    """Fitted to the layer where it starts, with the field that is transferred from then on."""
    mesh = BitingMesher(Input=square, UniformSpacing=LARGEST)
    for _ in range(4):
        mesh = BitingMesher(Input=square, SpacingSource=spacing_on(mesh, 0))
    field = Calculator(Input=mesh, ResultArrayName='carried', Function='sin(coordsX)*cos(coordsY)')
    return frozen(field)


def layer(step):
    return f'tanh(10*(coordsX-{2 + WAY * step}-0.4*sin(coordsY)))'


def spacing_on(mesh, step):
    """The mesh with the spacing that the solution of this step asks for."""
    solution = Calculator(Input=mesh, ResultArrayName='u', Function=layer(step))
    return HessianSpacing(Input=solution, ScalarArray=['POINTS', 'u'],
        ErrorTolerance=TOLERANCE, MaximumSpacing=LARGEST)


def remeshed(mesh, step):
    return BitingRemesher(Input=spacing_on(mesh, step), RegionArray='None')


def frozen(mesh):
    """The mesh as data without its history, so that the next step does not repeat all before it."""
    mesh.UpdatePipeline()
    return TrivialProducerOf(servermanager.Fetch(mesh))


def TrivialProducerOf(data):
    producer = TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    producer.UpdatePipeline()
    return producer


def row_of(step, mesh, same):
    vertices = count_vertices(mesh)
    kept = 1.0 if same else kept_share(mesh)
    row = [step, vertices, kept, error_of_layer(mesh, step), error_of_carried(mesh)]
    print(f'step {step:2} {vertices:6} vertices, {100 * kept:5.1f} % of the old ones kept, error of the '
          f'layer {row[3]:.4f}, of what was carried {row[4]:.5f}')
    return row


def kept_share(mesh):
    counts = servermanager.Fetch(mesh).GetFieldData()
    kept = counts.GetArray('KeptVertices').GetValue(0)
    return kept / (kept + counts.GetArray('RemovedVertices').GetValue(0))


def error_of_layer(mesh, step):
    """Of linear interpolation of the layer, at the middles of the triangles: root mean square."""
    points, triangles = arrays_of(mesh)
    corners = points[triangles]
    errors = exact_layer(corners, step).mean(axis=1) - exact_layer(corners.mean(axis=1), step)
    return mean_square(errors, corners)


def exact_layer(places, step):
    x, y = places[..., 0], places[..., 1]
    return numpy.tanh(10 * (x - 2 - WAY * step - 0.4 * numpy.sin(y)))


def mean_square(errors, corners):
    sides = corners[:, 1:] - corners[:, :1]
    areas = abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])
    return ((errors**2 * areas).sum() / areas.sum())**0.5


def error_of_carried(mesh):
    """Of the field that was carried from mesh to mesh, at the vertices: root mean square."""
    points, _ = arrays_of(mesh)
    carried = vtk_to_numpy(servermanager.Fetch(mesh).GetPointData().GetArray('carried'))
    exact = numpy.sin(points[:, 0]) * numpy.cos(points[:, 1])
    return ((carried - exact)**2).mean()**0.5


def draw(path, mesh, step):
    view = views.plane_view([4.5, 4.5], 9.4, [500, 500])
    solution = Calculator(Input=mesh, ResultArrayName='u', Function=layer(step))
    views.show_colored(solution, view, ('POINTS', 'u'), COLORS, [0.2, 0.25, 0.35])
    SaveScreenshot(path, view, ImageResolution=[500, 500], CompressionLevel='9')
    Delete(view)


if __name__ == '__main__':
    main(*sys.argv[1:4])
