#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes pixels.vtk: the outline of the bright pixels of an image, one edge a pixel.

As a segmented image gives it: loops around blobs and holes, specks of a few pixels among them.
"""

import math

from legacy_vtk import write_polydata

SIZE = 200  # pixels along a side
BLOBS = [  # middle, radius, brightness; in pixels
    (70, 75, 62, 1.0), (128, 118, 55, 1.0), (140, 60, 34, 0.9), (88, 98, 17, -1.6),
    (139, 124, 13, -1.5), (60, 150, 24, 0.8), (170, 165, 8, 0.9)]
THRESHOLD = 0.38


def main():
    ways = outline()
    ids = {corner: i for i, corner in enumerate(sorted(ways))}
    loops = loops_of(ways)
    write_polydata("pixels.vtk", "Outline of the bright pixels of an image", list(ids),
        [tuple(ids[corner] for corner in loop) for loop in loops])
    print(f"pixels.vtk: {len(loops)} loops, {sum(len(loop) - 1 for loop in loops)} edges")


def is_bright(column, row):
    """Blobs with soft rims, and a ripple that frays them."""
    if not (0 < column < SIZE - 1 and 0 < row < SIZE - 1):
        return False
    value = sum(height * math.exp(-((column - x) ** 2 + (row - y) ** 2) / radius ** 2)
        for x, y, radius, height in BLOBS)
    return value + 0.05 * math.sin(0.9 * column) * math.cos(0.7 * row + 0.2 * column) > THRESHOLD


def outline():
    """From each corner of pixels the corners that follow, bright pixels on the left."""
    ways = {}
    for row in range(SIZE):
        for column in range(SIZE):
            if is_bright(column, row):
                x, y = column, row
                for beside, start, end in (
                        ((x, y - 1), (x, y), (x + 1, y)), ((x + 1, y), (x + 1, y), (x + 1, y + 1)),
                        ((x, y + 1), (x + 1, y + 1), (x, y + 1)), ((x - 1, y), (x, y + 1), (x, y))):
                    if not is_bright(*beside):
                        ways.setdefault(start, []).append(end)
    return ways


def loops_of(ways):
    """Chains back to their beginning; where two bright pixels meet at a corner, two ways go on."""
    rest = {start: list(ends) for start, ends in ways.items()}
    loops = []
    for first in sorted(ways):
        while rest[first]:
            loop = [first]
            while True:
                loop.append(rest[loop[-1]].pop())
                if loop[-1] == first:
                    break
            loops.append(loop)
    return loops


if __name__ == "__main__":
    main()
