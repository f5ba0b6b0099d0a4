# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Drawings that cannot be meshed, in the real ParaView window: the panel says why, the drawing is
shown with a sphere at each place; and all is as after a first Apply when the drawing is mended.

Runs on the display it is given (xvfb-run), with the folder of the plugin and an output folder as
arguments.
"""

import math
import os
import struct
import sys

import paraview_window as window

HEADER = '# vtk DataFile Version 3.0\ndrawing\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n'
SQUARE = '0 0 0  1 0 0  1 1 0  0 1 0\n'
CLOSED = 'LINES 1 6\n5 0 1 2 3 0\n'
SPACING = 'POINT_DATA 4\nSCALARS Spacing double 1\nLOOKUP_TABLE default\n'

# Name, drawing, what the message begins with, number of spheres.
REFUSALS = (
    ('OpenEnds', SQUARE + 'LINES 1 5\n4 0 1 2 3\n', 'There is no closed loop', 2),
    ('TooLarge', '0 0 0  1e300 0 0  1 1 0  0 1 0\n' + CLOSED, 'Coordinates that are too large', 1),
    ('NotPlanar', '0 0 0  1 0 .5  1 1 0  0 1 .5\n' + CLOSED, 'The input is not planar', 4),
    ('BadSpacing', SQUARE + CLOSED + SPACING + '.1 .1 0 .1\n',
     'The spacing array Spacing has values', 1),
    ('NoCells', SQUARE, 'The input has points, but no cells', 0),
    ('TooMany', SQUARE + CLOSED + SPACING + '1e-9 1e-9 1e-9 1e-9\n',
     'The mesh would be too large', 0),
)

# Files that are no ASCII polydata: with a point that is no number, and with a volume.
NOT_A_NUMBER = (
    b'# vtk DataFile Version 3.0\ndrawing\nBINARY\nDATASET POLYDATA\nPOINTS 4 double\n'
    + struct.pack('>12d', 0, 0, 0, math.nan, 0, 0, 1, 1, 0, 0, 1, 0)
    + b'\nLINES 1 6\n' + struct.pack('>6i', 5, 0, 1, 2, 3, 0))
VOLUME = (
    b'# vtk DataFile Version 3.0\ndrawing\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n'
    b'0 0 0  1 0 0  0 1 0  0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n')
OTHERS = (
    ('NotANumber', NOT_A_NUMBER, 'Coordinates that are not finite', 1),
    ('Volume', VOLUME, 'Cell 0 is a vtkTetra: cells with a volume are not meshed', 0),
)


def main(plugin_folder, output):
    session = window.Window('TestErrorsGui', plugin_folder, output)
    for name, drawing, message, spheres in OTHERS + REFUSALS:
        path = os.path.join(output, name + '.vtk')
        with open(path, 'wb') as file:
            file.write(drawing if isinstance(drawing, bytes) else (HEADER + drawing).encode())
        session.open(path)
        session.choose_filter('BitingMesher')
        session.apply()
        session.check(the_refusal_is_shown, message, spheres)
    session.check(mend)
    session.check(the_mesh_is_shown)
    session.run(expected=[message for _, _, message, _ in OTHERS + REFUSALS])


def is_visible(source):
    """Of a source or output, in the active view."""
    from paraview import simple
    shown = simple.GetRepresentation(source, simple.GetActiveView())
    return shown.Visibility == 1


def outputs(mesher):
    from paraview import simple
    return [simple.OutputPort(mesher, port) for port in range(4)]


def the_refusal_is_shown(output, message, spheres):
    from paraview import simple
    mesher = simple.GetActiveSource()
    window.take_picture(os.path.join(output, message.replace(' ', '_') + '.png'))
    summary = window.widgets('SummaryText', 'text')
    assert summary[0].startswith('Error: ' + message), summary
    mesh, _, bites, problems = outputs(mesher)
    assert problems.GetDataInformation().GetNumberOfPoints() == spheres
    assert is_visible(mesher.Input), 'the drawing is hidden'
    assert is_visible(problems) == (spheres > 0), 'spheres'
    assert not is_visible(mesh) and not is_visible(bites)


def mend(_output):
    from paraview import simple
    simple.GetActiveSource().BoundarySpacingArray = ['POINTS', 'None']
    simple.GetActiveSource().UpdatePipeline()


def the_mesh_is_shown(output):
    from paraview import simple
    window.take_picture(os.path.join(output, 'mended.png'))
    mesher = simple.GetActiveSource()
    mesh, edges, bites, problems = outputs(mesher)
    assert mesh.GetDataInformation().GetNumberOfCells() > 1000
    summary = window.widgets('SummaryText', 'text')
    assert ' vertices, ' in summary[0] and not any('Error' in line for line in summary), summary
    assert is_visible(mesh) and is_visible(edges)
    assert not is_visible(bites) and not is_visible(problems)
    assert not is_visible(mesher.Input), 'the drawing hides the mesh'
    shown = simple.GetRepresentation(mesh, simple.GetActiveView())
    assert shown.Representation == 'Surface With Edges'
    assert list(shown.ColorArrayName) == ['CELLS', 'MinimumAngle'], list(shown.ColorArrayName)


if __name__ == '__main__':
    main(sys.argv[1], os.path.abspath(sys.argv[2]))
