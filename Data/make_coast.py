#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes coast.vtk: the seas around Britain and Ireland, for a model of tides.

Source: GSHHG 2.3.7, intermediate resolution, as packed by Debian (gmt-gshhg-low). The shorelines
are projected, cut at a rectangle, freed of what the tide does not see, and given a spacing: fine at
the coast and in straits, coarse offshore.
"""

import bisect
import itertools
import math

from grading import edge_lengths, graded
from gshhg import shoreline_rings
from legacy_vtk import write_polydata

SOURCE = "/usr/share/gmt-gshhg/binned_GSHHS_i.nc"
CENTER = (-4.0, 54.6)  # degrees east and north, origin of the map
EARTH_RADIUS = 6371007.2  # metres, of the sphere with the area of the ellipsoid
LOW, HIGH = (-640e3, -690e3), (460e3, 715e3)  # metres, corners of the rectangle
CORNERS = [(LOW[0], LOW[1]), (HIGH[0], LOW[1]), (HIGH[0], HIGH[1]), (LOW[0], HIGH[1])]
SMALLEST_ISLAND = 20e6  # square metres
SHARPEST_INLET = 45.0  # degrees
SHORTEST_EDGE, NARROWEST = 2e3, 1.5e3  # metres
ROUNDS = 3  # of mending
COASTAL, OFFSHORE = 8e3, 45e3  # metres, largest spacing at the coast and on the open boundary
SLOPE = 0.15  # of the spacing
COAST, ISLAND, OPEN_SEA = 1, 2, 3  # values of Tag


def main():
    rings = [list(reversed(project(ring))) for ring in shoreline_rings(SOURCE)]
    islands, coasts = cut_at_rectangle(rings)
    islands = [ring for ring in islands if area(ring) < -SMALLEST_ISLAND]
    shores = freed_of_detail([join_along_border(coasts), *islands])
    shores.report()
    write(*spaced(shores))


def freed_of_detail(loops):
    """Without short edges, sharp inlets and narrow straits; mending one may make another."""
    for _ in range(ROUNDS):
        shores = Shores([generalised(loop, loops) for loop in loops])
        shores.widen_straits()
        loops = [shores.loop_points(loop) for loop in shores.Loops]
    return Shores([generalised(loop, loops) for loop in loops])


def project(ring):
    """Lambert's azimuthal equal-area projection, from degrees to metres."""
    middle = math.radians(CENTER[1])
    result = []
    for longitude, latitude in ring:
        turn, height = math.radians(longitude - CENTER[0]), math.radians(latitude)
        east = math.cos(height) * math.sin(turn)
        out, up = math.cos(height) * math.cos(turn), math.sin(height)
        north = math.cos(middle) * up - math.sin(middle) * out
        towards = math.sin(middle) * up + math.cos(middle) * out
        scale = EARTH_RADIUS * math.sqrt(2 / (1 + towards))
        result.append((scale * east, scale * north))
    return result


def cut_at_rectangle(rings):
    """The rings inside, and the chains inside of the rings that cross the border."""
    whole, chains = [], []
    for ring in rings:
        if all(is_inside(point) for point in ring):
            whole.append(ring)
        else:
            chains += chains_inside(ring)
    return whole, chains


def is_inside(point):
    return all(low < value < high for low, value, high in zip(LOW, point, HIGH))


def chains_inside(ring):
    """Starts outside, so that every chain is met from its beginning."""
    first = next(i for i, point in enumerate(ring) if not is_inside(point))
    turned = ring[first:] + ring[:first + 1]
    chains = []
    for start, end in zip(turned, turned[1:]):
        piece = piece_inside(start, end)
        if piece and is_inside(start):
            chains[-1].append(piece[1])
        elif piece:
            chains.append(list(piece))
    return chains


def piece_inside(start, end):
    """The part of a segment inside the rectangle, ends on the border exactly there; or nothing."""
    first, last = (0.0, start), (1.0, end)
    for axis in (0, 1):
        for border in (LOW[axis], HIGH[axis]):
            if (start[axis] < border) != (end[axis] < border):
                t, point = crossing(start, end, axis, border)
                enters = (start[axis] < border) == (border == LOW[axis])
                if enters and t > first[0]:
                    first = (t, point)
                elif not enters and t < last[0]:
                    last = (t, point)
    middle = [(a + b) / 2 for a, b in zip(first[1], last[1])]
    return (first[1], last[1]) if first[0] < last[0] and is_inside(middle) else None


def crossing(start, end, axis, border):
    t = (border - start[axis]) / (end[axis] - start[axis])
    across = start[1 - axis] + t * (end[1 - axis] - start[1 - axis])
    return t, (border, across) if axis == 0 else (across, border)


def join_along_border(chains):
    """The largest loop of chains, sea on the left, joined counterclockwise along the border."""
    starts = {border_place(chain[0]): chain for chain in chains}
    loops = []
    while starts:
        place, loop = min(starts), []
        while place in starts:
            chain = starts.pop(place)
            loop += chain
            place, corners = way_to_next(border_place(chain[-1]), [*starts, border_place(loop[0])])
            loop += corners
        loops.append(loop)
    return max(loops, key=area)


def border_place(point):
    """Where on the border, from 0 at the south-west corner, counterclockwise, one a side."""
    x, y = [(value - low) / (high - low) for low, value, high in zip(LOW, point, HIGH)]
    if point[1] == LOW[1]:
        return x
    if point[0] == HIGH[0]:
        return 1 + y
    return 3 - x if point[1] == HIGH[1] else 4 - y


def way_to_next(place, goals):
    """The first goal met counterclockwise from a place, and the corners on the way."""
    goal = min(goals, key=lambda other: (other - place) % 4)
    last = goal if goal > place else goal + 4
    return goal, [CORNERS[side % 4] for side in range(math.ceil(place), math.ceil(last))]


def area(loop):
    """Positive where the loop is counterclockwise."""
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(loop, loop[1:] + loop[:1])) / 2


def generalised(loop, loops):
    """Drops ends of short edges and tips of inlets where no other shore is in the way."""
    loop, at = list(loop), 0
    while at < len(loop):
        corner = loop[at - 1], loop[at], loop[(at + 1) % len(loop)]
        is_short = math.dist(corner[0], corner[1]) < SHORTEST_EDGE
        if (is_short or sea_angle(*corner) < SHARPEST_INLET) and can_be_cut(corner, loops):
            del loop[at]
            at = max(at - 1, 0)
        else:
            at += 1
    return loop


def can_be_cut(corner, loops):
    """Not on the border, and no shore inside the triangle that is cut off."""
    a, b, c = corner if is_left(*corner) else reversed(corner)
    return is_inside(corner[1]) and not any(
        is_left(a, b, p) and is_left(b, c, p) and is_left(c, a, p) for loop in loops for p in loop)


def sea_angle(before, point, after):
    """Degrees, on the left of the way."""
    back = math.atan2(before[1] - point[1], before[0] - point[0])
    forth = math.atan2(after[1] - point[1], after[0] - point[0])
    return math.degrees(back - forth) % 360


class Shores:
    """All loops as points and edges; the first loop is the outline."""

    def __init__(self, loops):
        self.Points = [point for loop in loops for point in loop]
        self.Loops, first = [], 0
        for loop in loops:
            self.Loops.append(range(first, first + len(loop)))
            first += len(loop)
        edges = [(loop[i - 1], loop[i]) for loop in self.Loops for i in range(len(loop))]
        self.Edges = [edge for edge in edges if not is_open(*self.ends(edge))]
        self.NearEdges = [self._near_edges(i) for i in range(len(self.Points))]

    def ends(self, edge):
        return self.Points[edge[0]], self.Points[edge[1]]

    def loop_points(self, loop):
        return [self.Points[i] for i in loop]

    def nearest_shore(self, i):
        """Distance and place of the shore nearest to a point, its own two edges apart."""
        places = [foot(self.Points[i], *self.ends(edge)) for edge in self.NearEdges[i]]
        return min(((math.dist(self.Points[i], place), place) for place in places),
            default=(COASTAL, self.Points[i]))

    def widen_straits(self):
        """Moves shores that are too close to each other apart, a little at a time."""
        for _ in range(ROUNDS):
            for i, point in enumerate(self.Points):
                if is_inside(point):
                    self._move_away(i)

    def report(self):
        widths = [self.nearest_shore(i)[0] for i in range(len(self.Points))]
        crossings = sum(do_cross(*self.ends(edge), *self.ends(other))
            for edge in self.Edges for other in self.NearEdges[edge[0]] if edge[1] not in other)
        loops = [self.loop_points(loop) for loop in self.Loops]
        angles = [sea_angle(loop[i - 2], loop[i - 1], loop[i])
            for loop in loops for i in range(len(loop))]
        print(f"coast.vtk: {len(self.Loops) - 1} islands, {len(self.Points)} points on shores, "
            f"sharpest inlet {min(angles):.0f} degrees, narrowest water {min(widths):.0f} m, "
            f"{crossings} crossings")

    def _near_edges(self, i):
        x, y = self.Points[i]
        result = []
        for edge in self.Edges:
            start, end = self.ends(edge)
            reach = COASTAL + math.dist(start, end)
            if abs(start[0] - x) < reach and abs(start[1] - y) < reach and i not in edge:
                result.append(edge)
        return result

    def _move_away(self, i):
        width, place = self.nearest_shore(i)
        if 0 < width < NARROWEST:
            stretch = (0.6 * NARROWEST - 0.5 * width) / width
            self.Points[i] = tuple(p + stretch * (p - q) for p, q in zip(self.Points[i], place))


def foot(point, start, end):
    """The point of a segment nearest to a point."""
    along = [b - a for a, b in zip(start, end)]
    to_point = [p - a for a, p in zip(start, point)]
    t = (to_point[0] * along[0] + to_point[1] * along[1]) / (along[0] ** 2 + along[1] ** 2)
    t = min(1.0, max(0.0, t))
    return tuple(a + t * b for a, b in zip(start, along))


def do_cross(a, b, c, d):
    return is_left(a, b, c) != is_left(a, b, d) and is_left(c, d, a) != is_left(c, d, b)


def is_left(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0])


def is_open(start, end):
    """Along one side of the rectangle."""
    return any(
        start[axis] == end[axis] and start[axis] in (LOW[axis], HIGH[axis]) for axis in (0, 1))


def spaced(shores):
    """Runs of points with their tags, and the spacing at every point; divides the open sides."""
    loops = [shores.loop_points(loop) for loop in shores.Loops]
    lengths = [length for loop in loops for length in edge_lengths(loop)]
    wanted = [OFFSHORE if point in CORNERS else min(COASTAL, length, shores.nearest_shore(i)[0])
        for i, (point, length) in enumerate(zip(shores.Points, lengths))]
    spacing = dict(zip(shores.Points, graded(shores.Points, wanted, SLOPE)))
    runs = [(ISLAND, ring + ring[:1]) for ring in loops[1:]]
    for start, end in zip(loops[0], loops[0][1:] + loops[0][:1]):
        if is_open(start, end):
            runs.append((OPEN_SEA, divided(start, end, spacing)))
        elif runs[-1][0] == COAST:
            runs[-1][1].append(end)
        else:
            runs.append((COAST, [start, end]))
    return runs, spacing


def divided(start, end, spacing):
    """Points on a straight way by equal integrals of 1 / f; enters their spacing."""
    length = math.dist(start, end)
    steps = math.ceil(length / 500)
    ways = [tuple(a + i / steps * (b - a) for a, b in zip(start, end)) for i in range(steps + 1)]
    ways[0], ways[-1] = start, end
    values = [min(OFFSHORE, *(f + SLOPE * math.dist(way, shore) for shore, f in spacing.items()))
        for way in ways]
    sums = list(itertools.accumulate(length / steps / value for value in values[:-1]))
    count = max(1, round(sums[-1]))
    inner = [bisect.bisect(sums, sums[-1] * i / count) + 1 for i in range(1, count)]
    for way in (0, *inner, steps):
        spacing[ways[way]] = min(values[way], spacing.get(ways[way], OFFSHORE))
    return [ways[way] for way in (0, *inner, steps)]


def write(runs, spacing):
    ids = {point: i for i, point in enumerate(dict.fromkeys(p for _, run in runs for p in run))}
    title = "Seas around Britain and Ireland, in metres; from GSHHG 2.3.7 (LGPL-3+)"
    lines = [tuple(ids[point] for point in run) for _, run in runs]
    write_polydata("coast.vtk", title, list(ids), lines,
        point_arrays={"Spacing": [spacing[point] for point in ids]},
        cell_arrays={"Tag": [tag for tag, _ in runs]})


if __name__ == "__main__":
    main()
