# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Figures 1 to 5 of the paper: pvpython figures.py BitingMesh.so OUTPUT_FOLDER

Where there is no display: xvfb-run -a pvpython figures.py ...

Writes figures.png, and figures.pvsm, a state that needs no other file: load the plugin in ParaView,
then File > Load State. Each view has a mesher of its own, which stops after the bites of its figure;
change Maximum Number Of Bites to see those between. The sixth is the mesh that they become.
"""

import os
import sys

from paraview.simple import *

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import pictures
import views

OUTER = [0, 0, 0, 7, 0, 0, 9, 2.4, 0, 8, 5.6, 0, 4.6, 5, 0, 1.4, 6, 0, 0.4, 3, 0]
HOLE = [3, 2, 0, 5.6, 1.8, 0, 6, 3.2, 0, 4.2, 3.8, 0]
CENTER, HEIGHT, SIZE, CAPTION = [4.5, 2.7], 8.2, [620, 460], [0, -1.1, 0]
SETTINGS = {'UniformSpacing': 0.6, 'Gradation': 0, 'Placement': 'Corners', 'Relaxation': 0,
    'GenerateBites': 1}


def main(plugin, folder):
    os.makedirs(folder, exist_ok=True)
    paraview.simple._DisableFirstRenderCameraReset()
    LoadPlugin(os.path.abspath(plugin), remote=False, ns=pictures.__dict__)
    drawing = AppendGeometry(registrationName='Drawing', Input=[
        PolyLineSource(registrationName='Outline', Points=OUTER, Closed=1),
        PolyLineSource(registrationName='Hole', Points=HOLE, Closed=1)])
    shown = [figure(drawing, *moment) for moment in moments(drawing)]
    shown.append(finished(drawing))
    pictures.save(os.path.join(folder, 'figures.png'), shown, 2)
    SaveState(os.path.join(folder, 'figures.pvsm'))


def moments(drawing):
    """Captions, and how many bites there are by then."""
    phases = pictures.bite_phases(mesher_of(drawing, 'All bites'))
    vertices, edges = phases.count(0), phases.count(0) + phases.count(1)
    return (('1: the domain', 0), ('2: its vertices are bitten', vertices),
        ('3: the first bite on an edge', vertices + 1), ('4: a layer of the boundary', edges),
        ('5: a layer in the interior', edges + (len(phases) - edges) // 2))


def mesher_of(drawing, name, **more):
    return pictures.BitingMesher(registrationName=name, Input=drawing, **SETTINGS, **more)


def figure(drawing, caption, bites):
    view = captioned_view(f'Figure {caption}')
    mesher = mesher_of(drawing, f'Figure {caption}', MaximumNumberOfBites=bites)
    if bites > 0:
        pictures.show_bites(mesher, view)
    views.show_lines(drawing, view, pictures.BLACK)
    return view


def finished(drawing):
    view = captioned_view('The mesh: centres of the bites, joined')
    mesher = mesher_of(drawing, 'Mesh of all bites')
    views.show_mesh(mesher, view)
    views.show_lines(OutputPort(mesher, 1), view, pictures.BLACK)
    return view


def captioned_view(text):
    view = views.plane_view(CENTER, HEIGHT, SIZE)
    caption = Show(a3DText(registrationName=text, Text=text), view, Ambient=1, Diffuse=0,
        ColorArrayName=[None, ''], AmbientColor=pictures.BLACK, DiffuseColor=pictures.BLACK)
    caption.Position, caption.Scale = CAPTION, [0.3, 0.3, 0.3]
    return view


if __name__ == '__main__':
    main(*sys.argv[1:3])
