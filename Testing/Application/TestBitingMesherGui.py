# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Drives the real ParaView window: plugin, menu, panel, Apply; looks at the state and the screen.

Runs on the display it is given (xvfb-run), with the folder of the plugin and an output folder as
arguments.
"""

import os
import shutil
import subprocess
import sys
import time
from xml.etree import ElementTree

HERE = os.path.dirname(os.path.abspath(__file__))
PATIENCE = 150.0  # seconds, for a machine without a graphics card


def main(plugin_folder, output_folder):
    shutil.rmtree(output_folder, ignore_errors=True)
    os.makedirs(output_folder)
    with open(os.path.join(output_folder, 'paraview.log'), 'w', encoding='utf-8') as log:
        window = start_paraview(plugin_folder, output_folder, log)
        try:
            wait_for(os.path.join(output_folder, 'state.pvsm'), window)
            time.sleep(2.0)
            take_picture(os.path.join(output_folder, 'screen.png'))
            window.wait(PATIENCE)
        finally:
            window.kill()
    check_log(os.path.join(output_folder, 'paraview.log'), window.returncode)
    check_state(os.path.join(output_folder, 'state.pvsm'))
    check_picture(os.path.join(output_folder, 'screen.png'))


def start_paraview(plugin_folder, output_folder, log):
    command = [
        'paraview', '--disable-registry', '--plugins=BitingMesh',
        '--plugin-search-paths=' + plugin_folder,
        '--data-directory=' + os.path.join(HERE, '..', '..', 'Data'),
        '--test-directory=' + output_folder,
        '--test-script=' + os.path.join(HERE, 'BitingMesher.xml'), '--exit',
    ]
    environment = dict(os.environ, HOME=output_folder)
    return subprocess.Popen(command, env=environment, stdout=log, stderr=subprocess.STDOUT)


def wait_for(path, window):
    end = time.monotonic() + PATIENCE
    while not (os.path.exists(path) and os.path.getsize(path) > 0):
        if window.poll() is not None:
            raise SystemExit('ParaView ended before the filter was applied: see paraview.log')
        if time.monotonic() > end:
            raise SystemExit('no state was saved in time: see paraview.log')
        time.sleep(0.2)


def take_picture(path):
    subprocess.run(['import', '-window', 'root', path], check=True)


def check_log(path, code):
    with open(path, encoding='utf-8', errors='replace') as log:
        text = log.read()
    complaints = [line for line in text.splitlines()
                  if any(sign in line for sign in ('ERR|', 'WARN|', 'Could not find'))]
    if code != 0 or complaints:
        raise SystemExit('ParaView ended with %s and said:\n%s' % (code, '\n'.join(complaints)))


def check_state(path):
    """What the window shows: visible representations of each output, their kinds, and the chart."""
    proxies = {proxy.get('id'): proxy for proxy in ElementTree.parse(path).iter('Proxy')}
    mesher = only(proxies, 'BitingMesher')
    only(proxies, 'MeshConformity')
    views = [proxy for proxy in proxies.values() if proxy.get('type') == 'XYChartView']
    if not views:
        raise SystemExit('the histograms are not in a chart')
    shown = {}
    for proxy in proxies.values():
        source = proxy.find("Property[@name='Input']/Proxy")
        if proxy.get('group') == 'representations' and source is not None:
            if source.get('value') == mesher.get('id'):
                shown[int(source.get('output_port'))] = (proxy.get('type'), value(proxy, 'Visibility'))
    expected = {1: ('BitingEdgesRepresentation', '1'), 2: ('BitingBitesRepresentation', '1'),
                3: ('BitingProblemsRepresentation', '0')}
    for port, look in expected.items():
        if shown.get(port) != look:
            raise SystemExit(f'output {port} is shown as {shown.get(port)}, not as {look}')
    chart = only(proxies, 'BitingHistogramsRepresentation')
    if value(chart, 'XArrayName') != 'Angle' or value(chart, 'UseIndexForXAxis') != '0':
        raise SystemExit('the chart does not show angles against their bins')


def only(proxies, kind):
    found = [proxy for proxy in proxies.values() if proxy.get('type') == kind]
    if len(found) != 1:
        raise SystemExit(f'{len(found)} of {kind} in the state, not one')
    return found[0]


def value(proxy, name):
    return proxy.find(f"Property[@name='{name}']/Element").get('value')


def check_picture(path):
    """The middle of the screen shows a mesh: many pixels of more than the background's colours."""
    middle = ['-gravity', 'center', '-crop', '30%x40%+150+0', '+repage']
    found = subprocess.run(['convert', path] + middle + ['-format', '%[fx:standard_deviation]', 'info:'],
                           check=True, capture_output=True, text=True)
    if float(found.stdout) < 0.02:
        raise SystemExit('the view is empty: standard deviation ' + found.stdout)


if __name__ == '__main__':
    main(sys.argv[1], os.path.abspath(sys.argv[2]))
