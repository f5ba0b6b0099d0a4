#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes bracket.vtk: the closed surface of an angle bracket, in long thin triangles as of a CAD program."""

import math

from legacy_vtk import write_polydata

LONG, HIGH, WIDE, THICK, FILLET = 60.0, 50.0, 40.0, 8.0, 10.0  # mm
BOLTS, BOLT_RADIUS = [(44.0, 11.0), (44.0, 29.0)], 4.0  # in x and y
BEARING, BEARING_RADIUS = (20.0, 33.0), 10.0  # in y and z
BODY, BOLT, BEARING_WALL, FOOT = 1, 2, 3, 4  # values of Tag
STEPS = 24  # of a circle


class Surface:
    """Triangles between points, each place once."""

    def __init__(self):
        self.Numbers, self.Triangles, self.Tags = {}, [], []

    def add(self, corners, tag):
        numbers = [self.Numbers.setdefault(corner, len(self.Numbers)) for corner in corners]
        self.Triangles.append(tuple(numbers))
        self.Tags.append(tag)

    def add_wall(self, lower, upper, tag):
        """Between two rings of as many points."""
        for k in range(len(lower)):
            self.add((lower[k - 1], lower[k], upper[k]), tag)
            self.add((lower[k - 1], upper[k], upper[k - 1]), tag)

    def add_face(self, outline, holes, to_space, is_turned, tag):
        """A flat face: loops of points of its plane."""
        for triangle in triangles_of(bridged(outline, holes)):
            corners = [to_space(*corner) for corner in triangle]
            self.add(corners[::-1] if is_turned else corners, tag)


def ring(center, radius):
    angles = [2 * math.pi * k / STEPS for k in range(STEPS)]
    return [(round(center[0] + radius * math.cos(a), 6), round(center[1] + radius * math.sin(a), 6))
        for a in angles]


def side(a, b, c):
    """Above 0 where c is on the left of the way from a to b."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def cross(a, b, c, d):
    return side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0


def bridged(outline, holes):
    """One loop of outline and holes: each is joined at the nearest pair that sees each other."""
    loop = list(outline)
    for hole in holes:
        edges = list(zip(loop, loop[1:] + loop[:1])) + list(zip(hole, hole[1:] + hole[:1]))
        pairs = sorted((math.dist(a, b), i, j) for i, a in enumerate(loop) for j, b in enumerate(hole))
        at, start = next((i, j) for _, i, j in pairs
            if not any(cross(loop[i], hole[j], *edge) for edge in edges))
        turned = hole[start::-1] + hole[:start:-1]
        loop[at:at + 1] = [loop[at], *turned, turned[0], loop[at]]
    return loop


def triangles_of(loop):
    """Cuts off ears: corners that turn left and have no other corner in their triangle."""
    rest, triangles = list(loop), []
    while len(rest) > 2:
        for k in range(len(rest)):
            a, b, c = rest[k - 1], rest[k], rest[(k + 1) % len(rest)]
            others = [p for p in rest if p not in (a, b, c)]
            is_free = not any(side(a, b, p) >= 0 and side(b, c, p) >= 0 and side(c, a, p) >= 0
                for p in others)
            if side(a, b, c) > 0 and is_free:
                break
        triangles.append((a, b, c))
        del rest[k]
    return triangles


def profile():
    """In x and z, counterclockwise."""
    middle, radius = THICK + FILLET, FILLET
    steps = STEPS // 4
    angles = [-math.pi / 2 - math.pi / 2 * k / steps for k in range(steps + 1)]
    fillet = [(round(middle + radius * math.cos(a), 6), round(middle + radius * math.sin(a), 6))
        for a in angles]
    return [(0.0, 0.0), (LONG, 0.0), (LONG, THICK), *fillet, (THICK, HIGH), (0.0, HIGH)]


def rectangle(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def main():
    surface, outline = Surface(), profile()
    for y, is_turned in ((0.0, False), (WIDE, True)):
        surface.add_face(outline, [], lambda x, z, y=y: (x, y, z), is_turned, BODY)
    bolts = [ring(center, BOLT_RADIUS) for center in BOLTS]
    bearing = ring(BEARING, BEARING_RADIUS)
    inner = THICK + FILLET
    for z, low in ((0.0, 0.0), (THICK, inner)):
        surface.add_face(rectangle(low, 0.0, LONG, WIDE), bolts, lambda x, y, z=z: (x, y, z), z == 0.0,
            FOOT if z == 0.0 else BODY)
    for x, low in ((0.0, 0.0), (THICK, inner)):
        surface.add_face(rectangle(0.0, low, WIDE, HIGH), [bearing], lambda y, z, x=x: (x, y, z),
            x == 0.0, BODY)
    strip = [outline[1], outline[2]], [outline[-2], outline[-1]], outline[3:-2]
    for line in strip:
        for (x0, z0), (x1, z1) in zip(line, line[1:]):
            a, b, c, d = (x0, 0.0, z0), (x0, WIDE, z0), (x1, WIDE, z1), (x1, 0.0, z1)
            surface.add((a, b, c), BODY)
            surface.add((a, c, d), BODY)
    for hole in bolts:
        surface.add_wall([(x, y, THICK) for x, y in hole], [(x, y, 0.0) for x, y in hole], BOLT)
    surface.add_wall([(THICK, y, z) for y, z in bearing], [(0.0, y, z) for y, z in bearing],
        BEARING_WALL)
    write_polydata("bracket.vtk", "Angle bracket with two bolt holes and a bearing",
        list(surface.Numbers), polygons=surface.Triangles, cell_arrays={"Tag": surface.Tags})


if __name__ == "__main__":
    main()
