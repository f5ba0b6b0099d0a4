# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""The first look at mesh and bites, against pictures; and a state that is saved and loaded in the
real ParaView window, which looks the same.

Runs on the display it is given (xvfb-run), with the folder of the plugin and an output folder as
arguments.

The pictures of `Baseline` are compared in 30 by 20 parts (see paraview_window.py). Measured: meshes
of other spacings, so with other triangles everywhere, differ by 0.07 to 0.10 from the first picture;
the mesh without its edges by 0.30, in one colour by 0.20, with colours scaled to its own angles by
0.19, without the drawing by 0.20, and a hidden mesh by 0.47. BASELINE is between these.
"""

import os
import sys

import paraview_window as window

BASELINE, SAME = 0.15, 0.02
PICTURES = ('first.png', 'bites.png')


def main(plugin_folder, output):
    state, state_of_body = (os.path.join(output, name) for name in ('state.pvsm', 'body.pvsm'))
    session = window.Window('TestStatesGui', plugin_folder, output)
    session.check(draw)
    session.choose_filter('BitingMesher')
    session.apply()
    session.check(picture, 'first.png')
    session.check(make_bites)
    session.check(picture, 'bites.png')
    save(session, state)
    session.check(draw_a_ball)
    session.choose_filter('BitingTetrahedralizer')
    session.apply()
    save(session, state_of_body)
    session.run()
    again = window.Window('TestStatesGui', plugin_folder, os.path.join(output, 'again'))
    again.load_state(state)
    again.check(picture, 'bites.png')
    again.check(choose_the_mesher)
    again.check(the_panel_is_that_of_the_state)
    again.run()
    body = window.Window('TestStatesGui', plugin_folder, os.path.join(output, 'body'))
    body.load_state(state_of_body)
    body.check(picture, 'body.png')
    body.check(the_body_is_shown)
    body.run()
    for name in PICTURES:
        baseline = os.path.join(window.HERE, 'Baseline', name)
        window.expect_same(os.path.join(output, name), baseline, BASELINE)
    loaded = os.path.join(again.output, 'bites.png')
    window.expect_same(loaded, os.path.join(output, 'bites.png'), SAME)


def save(session, state):
    session.event(window.MAIN + '/menubar/menu_File', 'activate', 'actionFileSaveServerState')
    session.event(window.MAIN + '/FileSaveServerStateDialog', 'filesSelected', state)


def draw(_output):
    """No file: ParaView would ask whether its name is right, and test events do not reach that."""
    from paraview import simple
    ellipse = simple.Ellipse(MajorRadiusVector=[3, 0, 0], Ratio=0.6, Resolution=40)
    simple.Show(ellipse, simple.GetActiveView())
    simple.ResetCamera()
    simple.SetActiveSource(ellipse)


def draw_a_ball(_output):
    from paraview import simple
    simple.HideAll(simple.GetActiveView())
    ball = simple.Sphere()
    simple.Show(ball, simple.GetActiveView())
    simple.SetActiveSource(ball)


def the_body_is_shown(_output):
    from paraview import simple
    body = simple.FindSource('BitingTetrahedralizer1')
    shown = simple.GetRepresentation(body, simple.GetActiveView())
    assert shown.Visibility == 1, 'nothing is seen'
    assert body.GetDataInformation().GetNumberOfCells() > 1000


def picture(output, name):
    window.take_picture(os.path.join(output, name))


def make_bites(_output):
    from paraview import simple
    simple.GetActiveSource().GenerateBites = 1
    simple.GetActiveSource().UpdatePipeline()


def choose_the_mesher(_output):
    from paraview import simple
    mesher = simple.FindSource('BitingMesher1')
    assert mesher.GenerateBites == 1
    simple.SetActiveSource(mesher)


def the_panel_is_that_of_the_state(_output):
    summary = window.widgets('SummaryText', 'text')
    assert ' vertices, ' in summary[0], summary


if __name__ == '__main__':
    main(sys.argv[1], os.path.abspath(sys.argv[2]))
