# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Ctrl, Shift and Alt, held down in the real ParaView window, stop a mesher that would run for
long; applied again with the same settings it runs again, and after a change it meshes. A picture of
the progress, which tells of the keys, is taken for those who look.

Runs on the display it is given (xvfb-run), with the folder of the plugin and an output folder as
arguments; needs xdotool.
"""

import os
import subprocess
import sys
import time

import paraview_window as window

KEYS = ('ctrl', 'shift', 'alt')
STOPPED = 'Stopped, as was asked for'
LONG, SHORT = 0.003, 0.2  # spacings: eight million vertices, and a thousand
RUNS = 2  # with the same settings
ENOUGH = 30.0  # seconds within which a stopped mesher has ended, on a busy machine


def main(plugin_folder, output):
    session = window.Window('TestStopGui', plugin_folder, output)
    session.open(os.path.join(window.DATA, 'plate.vtk'))
    session.choose_filter('BitingMesher')
    session.check(prepare)
    for run in range(RUNS):
        session.check(begin, run)
        session.apply()
        session.check(it_was_stopped, run)
    session.check(it_meshes_after_a_change)
    session.run(expected=[STOPPED], meanwhile=hold_keys)


def hold_keys(output):
    for run in range(RUNS):
        wait_until(lambda: os.path.exists(begin_of(output, run)))
        time.sleep(4.0)
        window.take_screen(os.path.join(output, f'progress{run}.png'))
        press('keydown')
        wait_until(lambda: number_of_stops(output) > run)
        press('keyup')


def press(how):
    subprocess.run(['xdotool'] + [word for key in KEYS for word in (how, key)], check=True)


def wait_until(condition):
    end = time.monotonic() + window.PATIENCE
    while not condition() and time.monotonic() < end:
        time.sleep(0.1)


def number_of_stops(output):
    path = os.path.join(output, 'paraview.log')
    with open(path, encoding='utf-8', errors='replace') as file:
        return sum('ERR|' in line and STOPPED in line for line in file)


def begin_of(output, run):
    return os.path.join(output, f'begin{run}')


def prepare(_output):
    from paraview import simple
    simple.GetActiveSource().UniformSpacing = LONG


def begin(output, run):
    assert window.widgets('Accept', 'enabled') == ['true'], 'nothing can be applied'
    with open(begin_of(output, run), 'w', encoding='ascii') as file:
        file.write(str(time.time()))


def it_was_stopped(output, run):
    from paraview import simple
    mesher = simple.GetActiveSource()
    assert window.widgets('SummaryText', 'text')[0].startswith('Error: ' + STOPPED)
    with open(begin_of(output, run), encoding='ascii') as file:
        seconds = time.time() - float(file.read())
    assert mesher.GetDataInformation().GetNumberOfCells() == 0
    assert seconds < ENOUGH, f'it ended after {seconds} s only'
    shown = simple.GetRepresentation(mesher.Input, simple.GetActiveView())
    assert shown.Visibility == 1, 'the drawing is hidden'


def it_meshes_after_a_change(_output):
    from paraview import simple
    mesher = simple.GetActiveSource()
    mesher.UniformSpacing = SHORT
    mesher.UpdatePipeline()
    assert mesher.GetDataInformation().GetNumberOfCells() > 1000


if __name__ == '__main__':
    main(sys.argv[1], os.path.abspath(sys.argv[2]))
