# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Watches the front move inwards: pvpython watch.py BitingMesh.so OUTPUT_FOLDER [FRAMES]

Where there is no display, as for all scripts that draw: xvfb-run -a pvpython watch.py ... (Debian's
ParaView draws on an X server only: with --force-offscreen-rendering it ends at its first picture.)

Animates MaximumNumberOfBites on the plate from the first bite to the last, writes the pictures of a
film, and a state file that ParaView's window opens and plays. The picture of the help, of 21 frames:
montage watch_003.png watch_006.png watch_009.png watch_020.png -tile 2x2 -geometry 500x280 watch.png
"""

import os
import sys

from paraview.simple import *

plugin, folder = sys.argv[1:3]
os.makedirs(folder, exist_ok=True)
frames = int(sys.argv[3]) if len(sys.argv) > 3 else 60
here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, here)
import views

LoadPlugin(os.path.abspath(plugin), remote=False, ns=globals())
plate = LegacyVTKReader(FileNames=[os.path.join(here, 'plate.vtk')])
mesher = BitingMesher(Input=plate, UniformSpacing=0.3, Relaxation=0, GenerateBites=1)
bites = OutputPort(mesher, 2)
mesher.UpdatePipeline()
last = bites.GetDataInformation().GetNumberOfCells()

# The bites by their phases; the front that is left, in red, comes with them.
bounds = plate.GetDataInformation().GetBounds()
center = [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2]
height = 1.15 * (bounds[3] - bounds[2])
view = views.plane_view(center, height, [1000, 560])
AssignViewToLayout(view, CreateLayout('Watch'))
shown = Show(bites, view, Representation='Surface With Edges', Opacity=1, LineWidth=3, Ambient=1,
    Diffuse=0, EdgeColor=[0.3, 0.3, 0.3])
ColorBy(shown, ('CELLS', 'Phase'))
views.show_lines(plate, view, [0, 0, 0])

track = GetAnimationTrack('MaximumNumberOfBites', index=0, proxy=mesher)
track.KeyFrames = [CompositeKeyFrame(KeyTime=0, KeyValues=[0]),
    CompositeKeyFrame(KeyTime=1, KeyValues=[last])]
scene = GetAnimationScene()
scene.PlayMode, scene.NumberOfFrames, scene.StartTime, scene.EndTime = 'Sequence', frames, 0, 1
SaveState(os.path.join(folder, 'watch.pvsm'))
for frame in range(frames):
    scene.AnimationTime = frame / (frames - 1)
    SaveScreenshot(os.path.join(folder, f'watch_{frame:03}.png'), view, ImageResolution=[1000, 560])
