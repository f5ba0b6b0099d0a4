# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Takes the help's pictures of the ParaView window:

xvfb-run -a -s '-screen 0 1400x1000x24' python3 help_pictures.py PLUGIN_FOLDER OUTPUT_FOLDER

Makes first.png, bites.png, conformity.png, problems.png and refused.png. Drives ParaView as the tests
of the window do, with ImageMagick's import and convert.
"""

import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, '..', 'Testing', 'Application')]
import paraview_window as window

MESSAGES = window.MAIN + '/outputWidgetDock'
HEADER = '# vtk DataFile Version 3.0\ndrawing\nASCII\nDATASET POLYDATA\n'
CROSSED = HEADER + '''POINTS 8 double
0 0 0  10 0 0  10 10 0  0 10 0  3 -1 0  8 10 0  12 4 0  14 6 0
LINES 3 12
5 0 1 2 3 0
2 4 5
2 6 7
'''
OPEN = HEADER + '''POINTS 6 double
0 0 0  10 0 0  10 6 0  6 4 0  4 8 0  0 6 0
LINES 2 8
4 0 1 2 3
2 4 5
'''


def main(plugin_folder, folder):
    session = new_session(plugin_folder, folder, 'plate')
    session.open(os.path.join(HERE, 'plate.vtk'))
    session.choose_filter('BitingMesher')
    session.apply()
    session.check(take, os.path.join(folder, 'first.png'))
    session.check(show_bites, 1)
    session.check(take, os.path.join(folder, 'bites.png'))
    session.check(show_bites, 0)
    session.choose_filter('MeshConformity')
    session.apply()
    session.check(take, os.path.join(folder, 'conformity.png'))
    session.run()
    take_problems(plugin_folder, folder, 'problems', CROSSED,
        ['Crossing segments', 'Interfaces outside'])
    take_problems(plugin_folder, folder, 'refused', OPEN, ['There is no closed loop'])


def take_problems(plugin_folder, folder, name, drawing, messages):
    session = new_session(plugin_folder, folder, name)
    path = os.path.join(session.output, 'drawing.vtk')
    with open(path, 'w', encoding='ascii') as file:
        file.write(drawing)
    session.open(path)
    session.choose_filter('BitingMesher')
    session.apply()
    session.event(window.MAIN, 'pause', '1000')
    session.event(MESSAGES + '/qt_dockwidget_closebutton', 'activate')  # the view is under it
    session.check(take, os.path.join(folder, name + '.png'))
    session.run(expected=messages)


def new_session(plugin_folder, folder, name):
    return window.Window('help_pictures', plugin_folder, os.path.join(folder, 'session_' + name))


def show_bites(_output, are_shown):
    from paraview import simple
    mesher = simple.FindSource('BitingMesher1')
    mesher.GenerateBites = are_shown
    mesher.UniformSpacing = 0.45 if are_shown else 0  # so that squares are seen
    mesher.UpdatePipeline()


def take(_output, path):
    subprocess.run(['import', '-window', 'root', '-trim', path], check=True)
    subprocess.run(['convert', path, '+repage', '-resize', '1000x', '-colors', '96', path],
        check=True)


if __name__ == '__main__':
    main(os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]))
