#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes plate.vtk: a plate with holes, an interface across it and two embedded points."""

import math

from legacy_vtk import write_polydata

WIDTH, HEIGHT = 12.0, 6.0
BOLT_HOLES = [((1.2, 1.2), 0.45), ((1.2, 4.8), 0.45), ((10.8, 1.2), 0.45), ((10.8, 4.8), 0.45)]
SLOT_CENTER, SLOT_HALF_LENGTH, SLOT_RADIUS = (4.2, 3.0), 1.1, 0.7
HEXAGON_CENTER, HEXAGON_RADIUS = (8.6, 2.2), 1.0
LOAD_POINTS = [(6.1, 1.3), (7.6, 4.6)]
OUTLINE, HOLE, WELD, LOAD = 1, 2, 3, 4  # values of Tag


class Drawing:
    """Points and cells with their tags, in the order in which they are drawn."""

    def __init__(self):
        self.Points, self.Lines, self.LineTags = [], [], []

    def add_loop(self, loop, tag):
        first = len(self.Points)
        self.Points += loop
        self.Lines.append((*range(first, first + len(loop)), first))
        self.LineTags.append(tag)

    def add_weld(self, inner_points, first, last):
        """A chain between two points that exist."""
        middle = range(len(self.Points), len(self.Points) + len(inner_points))
        self.Points += inner_points
        self.Lines.append((first, *middle, last))
        self.LineTags.append(WELD)


def arc(center, radius, first_degree, last_degree, steps):
    angles = [math.radians(first_degree + (last_degree - first_degree) * i / steps)
        for i in range(steps + 1)]
    return [(center[0] + radius * math.cos(a), center[1] + radius * math.sin(a)) for a in angles]


def slot():
    right = (SLOT_CENTER[0] + SLOT_HALF_LENGTH, SLOT_CENTER[1])
    left = (SLOT_CENTER[0] - SLOT_HALF_LENGTH, SLOT_CENTER[1])
    return arc(right, SLOT_RADIUS, -90, 90, 12) + arc(left, SLOT_RADIUS, 90, 270, 12)


def weld():
    """An S across the plate, without its ends on the outline."""
    heights = [HEIGHT * i / 16 for i in range(1, 16)]
    return [(6.6 + 0.35 * math.sin(2 * math.pi * y / HEIGHT), y) for y in heights]


def main():
    drawing = Drawing()
    lower, upper = [(0, 0), (6.6, 0), (WIDTH, 0)], [(WIDTH, HEIGHT), (6.6, HEIGHT), (0, HEIGHT)]
    drawing.add_loop(lower + upper, OUTLINE)
    for center, radius in BOLT_HOLES:
        drawing.add_loop(arc(center, radius, 0, 360, 20)[:-1], HOLE)
    drawing.add_loop(slot(), HOLE)
    drawing.add_loop(arc(HEXAGON_CENTER, HEXAGON_RADIUS, 0, 360, 6)[:-1], HOLE)
    drawing.add_weld(weld(), 1, 4)
    loads = range(len(drawing.Points), len(drawing.Points) + len(LOAD_POINTS))
    write_polydata("plate.vtk", "Plate with holes, a weld and two load points",
        drawing.Points + LOAD_POINTS, drawing.Lines, loads,
        cell_arrays={"Tag": [LOAD] * len(loads) + drawing.LineTags})


if __name__ == "__main__":
    main()
