# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Help > Biting Mesh in the real ParaView window: the pages are there, with their pictures, and lead
to each other.

Runs on the display it is given (xvfb-run), with the folder of the plugin and an output folder as
arguments.
"""

import glob
import os
import re
import subprocess
import sys

import paraview_window as window

PAGES = window.MAIN + '/BitingMeshHelpPages'
FOLDER = os.path.join(os.path.dirname(window.DATA), 'Plugin', 'doc')


def main(plugin_folder, output):
    every_link_leads_somewhere()
    session = window.Window('TestHelpGui', plugin_folder, output)
    session.event(window.MAIN + '/menubar/menu_Help', 'activate', 'actionBitingMeshHelp')
    session.check(the_pages_are_shown)
    session.run()


def every_link_leads_somewhere():
    pages = glob.glob(os.path.join(FOLDER, '*.html'))
    with open(os.path.join(FOLDER, '..', 'BitingMesh.qrc'), encoding='utf-8') as file:
        embedded = set(re.findall('<file>doc/(.*)</file>', file.read()))
    named = {os.path.basename(page) for page in pages}
    for page in pages:
        with open(page, encoding='utf-8') as file:
            named |= set(re.findall('(?:href|src)="([^"#:]+)"', file.read()))
    if not pages or named != embedded:
        raise SystemExit(f'the plugin has {embedded}, the pages ask for {named}')


def the_pages_are_shown(output):
    """A window called as the first page; its text covers little, its first picture much of it."""
    picture = os.path.join(output, 'help.png')
    found = subprocess.run(['xdotool', 'search', '--onlyvisible', '--name', '^Biting Mesh$'],
                           check=True, capture_output=True, text=True)
    subprocess.run(['import', '-window', found.stdout.split()[-1], picture], check=True)
    share = subprocess.run(['convert', picture, '-fill', 'black', '+opaque', 'white',
                            '-format', '%[fx:1-mean]', 'info:'],
                           check=True, capture_output=True, text=True)
    assert 0.25 < float(share.stdout) < 0.75, f'{share.stdout} of {picture} is not white'


if __name__ == '__main__':
    main(sys.argv[1], os.path.abspath(sys.argv[2]))
