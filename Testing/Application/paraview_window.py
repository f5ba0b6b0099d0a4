# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""The ParaView window, driven by a test: a list of events, and checks that run within ParaView.

A test makes a Window, tells it what a user does, and runs it. A check is a function of the test's
module: ParaView's own Python imports the module and calls it at its turn, between the events, so that
it sees the session as it is then. Without a graphics card all this takes seconds.
"""

import ctypes
import importlib
import os
import shutil
import subprocess
import sys
import traceback
from xml.sax.saxutils import quoteattr

HERE = os.path.dirname(os.path.abspath(__file__))
DATA = os.path.abspath(os.path.join(HERE, '..', '..', 'Data'))
PATIENCE = 190.0  # seconds, for a machine without a graphics card
MAIN = 'pqClientMainWindow'
PANEL = MAIN + '/propertiesDock/propertiesPanel'
SHELL = MAIN + '/pythonShellDock/pythonShell/consoleWidget'
RESULTS = 'results.txt'


class Window:
    def __init__(self, module, plugin_folder, output_folder):
        self.module = module
        self.plugin_folder = plugin_folder
        self.output = output_folder
        self.events = []
        self.checks = []
        shutil.rmtree(output_folder, ignore_errors=True)
        os.makedirs(output_folder)

    def event(self, widget, command, arguments=''):
        values = [quoteattr(text) for text in (widget, command, arguments)]
        self.events.append('<pqevent object=%s command=%s arguments=%s />' % tuple(values))

    def open(self, path):
        self.event(MAIN + '/menubar/menu_File', 'activate', 'actionFileOpen')
        self.event(MAIN + '/FileOpenDialog', 'filesSelected', path)
        self.apply()

    def load_state(self, path):
        self.event(MAIN + '/menubar/menu_File', 'activate', 'actionFileLoadServerState')
        self.event(MAIN + '/FileLoadServerStateDialog', 'filesSelected', path)

    def choose_filter(self, name):
        self.event(MAIN + '/menubar/menuFilters/pqProxyGroupMenuManager0/' + name, 'activate')

    def apply(self):
        self.event(PANEL + '/Accept', 'activate')

    def check(self, function, *arguments):
        """Calls a function of the module within ParaView, after a pause for what comes later."""
        self.event(MAIN, 'pause', '500')
        self.checks.append(function.__name__)
        what = (self.module, function.__name__, self.output, arguments)
        call = f'paraview_window.within{what!r}'
        self.event(SHELL, 'executeCommand',
                   f'import sys; sys.path[:0] = {[HERE, DATA]!r}; import paraview_window; {call}')

    def run(self, expected=(), meanwhile=None):
        """Plays all; what ParaView complains of must be `expected`, each a part of a complaint."""
        script = os.path.join(self.output, 'events.xml')
        with open(script, 'w', encoding='utf-8') as file:
            events = '\n'.join(self.events)
            file.write(f'<?xml version="1.0" ?>\n<pqevents>\n{events}\n</pqevents>\n')
        with open(os.path.join(self.output, 'paraview.log'), 'w', encoding='utf-8') as log:
            paraview = self.start(script, log)
            try:
                if meanwhile:
                    meanwhile(self.output)
                paraview.wait(PATIENCE)
            finally:
                paraview.kill()
        self.judge_log(paraview.returncode, expected)
        self.judge_results()

    def start(self, script, log):
        command = [
            'paraview', '--disable-registry', '--plugins=BitingMesh',
            '--plugin-search-paths=' + self.plugin_folder, '--test-directory=' + self.output,
            '--test-script=' + script, '--exit',
        ]
        environment = dict(os.environ, HOME=self.output)
        return subprocess.Popen(command, env=environment, stdout=log, stderr=subprocess.STDOUT)

    def judge_log(self, code, expected):
        path = os.path.join(self.output, 'paraview.log')
        with open(path, encoding='utf-8', errors='replace') as log:
            lines = log.read().splitlines()
        signs = ('ERR|', 'WARN|', 'Could not')
        complaints = [line for line in lines if any(sign in line for sign in signs)]
        missing = [part for part in expected if not any(part in line for line in complaints)]
        surplus = [line for line in complaints if not any(part in line for part in expected)]
        if code != 0 or missing or surplus:
            raise SystemExit('ParaView ended with %s\ndid not say: %s\nbut said:\n%s'
                             % (code, missing, '\n'.join(surplus)))

    def judge_results(self):
        path = os.path.join(self.output, RESULTS)
        results = ''
        if os.path.exists(path):
            with open(path, encoding='utf-8') as file:
                results = file.read()
        if results.split('\n')[:-1] != ['passed ' + name for name in self.checks]:
            raise SystemExit('of the checks %s\n%s' % (self.checks, results))


def within(module, name, output, arguments):
    """Runs in ParaView: the name of the check, and what was wrong."""
    sys.dont_write_bytecode = True
    result = 'passed ' + name
    try:
        getattr(importlib.import_module(module), name)(output, *arguments)
    except BaseException:  # whatever it is, the test outside says it
        result = traceback.format_exc()
    with open(os.path.join(output, RESULTS), 'a', encoding='utf-8') as file:
        file.write(result + '\n')


def take_picture(path):
    """Within ParaView: the active view; and the whole screen beside it, for those who look."""
    from paraview import simple
    simple.SaveScreenshot(path, simple.GetActiveView(), ImageResolution=[600, 400])
    take_screen(path.replace('.png', '_screen.png'))


def take_screen(path):
    subprocess.run(['import', '-window', 'root', path], check=True)


def widgets(name, what):
    """Within ParaView: a property of each visible widget of this name, or the items of a list."""
    reader = ctypes.CDLL(os.environ['BITING_WIDGET_READER']).ReadWidgets
    reader.restype = ctypes.c_char_p
    return reader(name.encode(), what.encode()).decode().split('\n')


def largest_difference(path, other):
    """Of two pictures, from 0 to 1: the largest of any part that is a thirtieth of the width."""
    parts = []
    for k, picture in enumerate((path, other)):
        parts.append(f'{path}.{k}.png')
        subprocess.run(['convert', picture, '-alpha', 'off', '-resize', '30x20!', parts[-1]],
                       check=True)
    found = subprocess.run(['compare', '-metric', 'PAE', *parts, 'null:'], check=False,
                           capture_output=True, text=True)
    return float(found.stderr.split('(')[1].rstrip(')\n '))


def expect_same(path, other, tolerance):
    difference = largest_difference(path, other)
    if difference > tolerance:
        raise SystemExit(f'{path} differs from {other} by {difference}, more than {tolerance}')
