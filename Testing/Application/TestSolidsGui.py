# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""A body in the real ParaView window: its surface checked and meshed, filled with tetrahedra, judged.
The panel can be read, and is that of the mesh, also after an error and after Undo.

Runs on the display it is given (xvfb-run), with the folder of the plugin and an output folder as
arguments.
"""

import os
import sys

import paraview_window as window

UNIFORM_SPACING = (window.PANEL + '/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/'
                   'PropertiesFrame/ProxyPanel/UniformSpacing/DoubleLineEdit0')
REFUSED = '-1'  # an error without a place: nothing of the filter is shown


def main(plugin_folder, output):
    session = window.Window('TestSolidsGui', plugin_folder, output)
    for name, array in (('BitingSurfaceCheck', ''), ('BitingSurfaceMesher', 'MinimumAngle'),
                        ('BitingTetrahedralizer', 'MinimumDihedralAngle')):
        session.open(os.path.join(window.DATA, 'bracket.vtk'))
        session.choose_filter(name)
        session.apply()
        session.check(the_output_is_colored_by, array)
        session.check(the_summary_ends_in_sight)
    for spacing in (REFUSED, '6', '5'):
        session.event(UNIFORM_SPACING, 'set_string', spacing)
        session.apply()
    session.event(window.MAIN + '/menubar/menu_Edit', 'activate', 'actionEditUndo')
    session.check(the_mesh_and_its_summary_are_of, 6)
    session.check(legends_lie_apart)
    session.check(make_bites)
    session.check(bites_are_shown_without_phases)
    session.choose_filter('MeshConformity')
    session.apply()
    session.check(the_chart_has_dihedral_angles)
    session.run(expected=['it must be finite, and 0 or more'])


def the_output_is_colored_by(output, array):
    """Not by a constant: a legend from 0 to 1.2e-38 helps nobody."""
    from paraview import simple
    source = simple.GetActiveSource()
    window.take_screen(os.path.join(output, type(source).__name__ + '.png'))
    shown = simple.GetRepresentation(simple.OutputPort(source, 0), simple.GetActiveView())
    assert (shown.ColorArrayName[1] or '') == array, list(shown.ColorArrayName)


def the_summary_ends_in_sight(_output):
    """Of a panel whose fields are wider than what is seen of it."""
    text, panel = (int(window.widgets(name, 'width')[0]) for name in ('SummaryText', 'scrollArea'))
    assert text < panel, f'the summary has {text} pixels, the panel {panel}'


def the_mesh_and_its_summary_are_of(_output, spacing):
    """After Undo, with no check before it: Python makes ParaView forget what can be undone."""
    from paraview import simple
    source = simple.GetActiveSource()
    assert source.UniformSpacing == spacing, source.UniformSpacing
    data = source.GetDataInformation()
    counts = f'{data.GetNumberOfPoints()} vertices, {data.GetNumberOfCells()} tetrahedra'
    summary = window.widgets('SummaryText', 'text')
    assert summary[0] == counts, (summary, counts)


def legends_lie_apart(_output):
    """Of the angles of triangles and of tetrahedra, in one view."""
    from paraview import simple
    bars = [simple.GetScalarBar(simple.GetColorTransferFunction(array), simple.GetActiveView())
            for array in ('MinimumAngle', 'MinimumDihedralAngle')]
    assert all(bar.Visibility for bar in bars)
    places = [bar.WindowLocation for bar in bars]
    assert places[0] != places[1], places


def make_bites(_output):
    from paraview import simple
    simple.GetActiveSource().GenerateBites = 1
    simple.GetActiveSource().UpdatePipeline()


def bites_are_shown_without_phases(output):
    from paraview import simple
    window.take_screen(os.path.join(output, 'bites.png'))
    bites = simple.OutputPort(simple.GetActiveSource(), 2)
    shown = simple.GetRepresentation(bites, simple.GetActiveView())
    assert shown.Visibility == 1 and shown.ColorArrayName[1] != 'Phase', list(shown.ColorArrayName)


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
