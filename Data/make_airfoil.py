#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes naca_airfoil.vtk: a NACA 2412 section of chord 1, from its formula, in a far field."""

import math

from grading import edge_lengths, graded
from legacy_vtk import write_polydata

CAMBER, CAMBER_PLACE, THICKNESS = 0.02, 0.4, 0.12  # the digits 2, 4 and 12
POINTS_A_SIDE = 80
FAR_FIELD_RADIUS, FAR_FIELD_POINTS, FAR_FIELD_CENTER = 10.0, 64, (0.5, 0.0)
SLOPE = 0.2  # of the spacing along the wall
AIRFOIL, FAR_FIELD = 1, 2  # values of Tag

# Half thickness of the four-digit series over sqrt(x), x, x^2, x^3, x^4. The last number of the
# report, -0.1015, leaves a gap at the trailing edge; this one closes it: the sum is zero.
SERIES = (0.2969, -0.1260, -0.3516, 0.2843, -0.1036)


def half_thickness(x):
    terms = (math.sqrt(x), x, x**2, x**3, x**4)
    return 5 * THICKNESS * sum(factor * term for factor, term in zip(SERIES, terms))


def camber_line(x):
    """Height and slope of the mean line."""
    p = CAMBER_PLACE
    length = p if x < p else 1 - p
    start = 0.0 if x < p else 1 - 2 * p
    return CAMBER / length**2 * (start + 2 * p * x - x**2), 2 * CAMBER / length**2 * (p - x)


def surface(x, side):
    """Point of the upper (side 1) or lower (side -1) surface, normal to the mean line."""
    height, slope = camber_line(x)
    thickness = side * half_thickness(x)
    angle = math.atan(slope)
    return x - thickness * math.sin(angle), height + thickness * math.cos(angle)


def airfoil():
    """Counterclockwise from the trailing edge: back over the upper surface, forth below."""
    chord = [(1 - math.cos(math.pi * i / POINTS_A_SIDE)) / 2 for i in range(POINTS_A_SIDE + 1)]
    upper = [surface(x, 1) for x in reversed(chord[1:-1])]
    lower = [surface(x, -1) for x in chord[1:-1]]
    return [(1.0, 0.0), *upper, (0.0, 0.0), *lower]


def far_field():
    (x, y), radius = FAR_FIELD_CENTER, FAR_FIELD_RADIUS
    angles = [2 * math.pi * i / FAR_FIELD_POINTS for i in range(FAR_FIELD_POINTS)]
    return [(x + radius * math.cos(a), y + radius * math.sin(a)) for a in angles]


def closed(first, count):
    return (*range(first, first + count), first)


def main():
    wall, far = airfoil(), far_field()
    wall_spacing = graded(wall, edge_lengths(wall), SLOPE)
    write_polydata("naca_airfoil.vtk", "NACA 2412 in a far field of 10 chords", wall + far,
        [closed(0, len(wall)), closed(len(wall), len(far))],
        point_arrays={"Spacing": wall_spacing + edge_lengths(far)},
        cell_arrays={"Tag": [AIRFOIL, FAR_FIELD]})


if __name__ == "__main__":
    main()
