#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes shetland.vtk: the sea around Shetland, every point of the shorelines kept.

Source: GSHHG 2.3.7, high resolution, as packed by Debian (gmt-gshhg-high): a point every 200 m. For
what a boundary tolerance does with shorelines that are finer than the mesh.
"""

import math

from gshhg import shoreline_rings
from legacy_vtk import write_polydata

SOURCE = "/usr/share/gmt-gshhg/binned_GSHHS_h.nc"
CENTER = (-1.3, 60.35)  # degrees east and north, origin of the map
METRES_PER_DEGREE = 111194.9
HALF_WIDTH, HALF_HEIGHT = 45e3, 70e3  # metres, of the rectangle
SHORE, OPEN_SEA = 1, 2  # values of Tag


def main():
    islands = [ring for ring in map(project, shoreline_rings(SOURCE)) if is_inside(ring)]
    frame = [(-HALF_WIDTH, -HALF_HEIGHT), (HALF_WIDTH, -HALF_HEIGHT), (HALF_WIDTH, HALF_HEIGHT),
        (-HALF_WIDTH, HALF_HEIGHT)]
    points, lines = [], []
    for ring in (frame, *islands):
        first = len(points)
        points += ring
        lines.append((*range(first, len(points)), first))
    write_polydata("shetland.vtk", "Sea around Shetland, in metres; from GSHHG 2.3.7 (LGPL-3+)",
        points, lines, cell_arrays={"Tag": [OPEN_SEA] + [SHORE] * len(islands)})
    print(f"shetland.vtk: {len(islands)} islands, {len(points)} points")


def project(ring):
    """Equidistant along the meridians and the middle parallel, in whole metres."""
    east = METRES_PER_DEGREE * math.cos(math.radians(CENTER[1]))
    return [(round(east * (((longitude - CENTER[0]) + 180) % 360 - 180)),
        round(METRES_PER_DEGREE * (latitude - CENTER[1]))) for longitude, latitude in ring]


def is_inside(ring):
    return all(abs(x) < HALF_WIDTH and abs(y) < HALF_HEIGHT for x, y in ring)


if __name__ == "__main__":
    main()
