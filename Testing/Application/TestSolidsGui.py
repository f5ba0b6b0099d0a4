# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""A body in the real ParaView window: its surface checked and meshed, filled with tetrahedra, judged.

Runs on the display it is given (xvfb-run), with the folder of the plugin and an output folder as
arguments.
"""

import os
import sys

import paraview_window as window


def main(plugin_folder, output):
    session = window.Window('TestSolidsGui', plugin_folder, output)
    for name, array in (('BitingSurfaceCheck', ''), ('BitingSurfaceMesher', 'MinimumAngle'),
                        ('BitingTetrahedralizer', 'MinimumDihedralAngle')):
        session.open(os.path.join(window.DATA, 'bracket.vtk'))
        session.choose_filter(name)
        session.apply()
        session.check(the_output_is_colored_by, array)
    session.choose_filter('MeshConformity')
    session.apply()
    session.check(the_chart_has_dihedral_angles)
    session.run()


def the_output_is_colored_by(output, array):
    """Not by a constant: a legend from 0 to 1.2e-38 helps nobody."""
    from paraview import simple
    source = simple.GetActiveSource()
    window.take_screen(os.path.join(output, type(source).__name__ + '.png'))
    shown = simple.GetRepresentation(simple.OutputPort(source, 0), simple.GetActiveView())
    assert (shown.ColorArrayName[1] or '') == array, list(shown.ColorArrayName)


def the_chart_has_dihedral_angles(output):
    from paraview import simple
    chart = simple.GetActiveView()
    window.take_screen(os.path.join(output, 'chart.png'))
    shown = simple.GetRepresentation(simple.OutputPort(simple.GetActiveSource(), 1), chart)
    assert shown.XArrayName == 'DihedralAngle', shown.XArrayName
    title = chart.BottomAxisTitle
    assert title == 'Dihedral angle of tetrahedra (degrees)', title


if __name__ == '__main__':
    main(sys.argv[1], os.path.abspath(sys.argv[2]))
