#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes square_9x9.vtk and section6_spacing.vtk: the experiment of the paper's section 6."""

from legacy_vtk import write_polydata, write_rectilinear_grid

SIDE = 9.0
STEPS = 180  # steps of 0.05: the kinks at 2, 4.5 and 7 are nodes, linear in between within 0.1 %


def spacing(y):
    """The paper's f with its misprints mended: continuous; 1, 0.05, 1, 0.2, 1 at its kinks."""
    if y <= 2:
        return 1 - 0.95 * y / 2
    if y <= 4.5:
        return 0.05 * 20 ** ((y - 2) / 2.5)
    if y <= 7:
        return 0.2 ** ((y - 4.5) / 2.5)
    return 0.2 + 0.8 * ((y - 7) / 2) ** 4


def largest_interpolation_error(nodes):
    """Relative, seen at 20 places between every two nodes."""
    worst = 0.0
    for low, high in zip(nodes, nodes[1:]):
        for step in range(1, 20):
            t = step / 20
            linear = (1 - t) * spacing(low) + t * spacing(high)
            worst = max(worst, abs(linear / spacing(low + t * (high - low)) - 1))
    return worst


def main():
    write_polydata("square_9x9.vtk", "Square of the paper's section 6",
        [(0, 0), (SIDE, 0), (SIDE, SIDE), (0, SIDE)], [(0, 1, 2, 3, 0)])
    nodes = [SIDE * step / STEPS for step in range(STEPS + 1)]
    values = [spacing(y) for y in nodes for _ in range(2)]
    write_rectilinear_grid("section6_spacing.vtk", "Spacing of the paper's section 6",
        [0.0, SIDE], nodes, {"Spacing": values})
    print(f"section6_spacing.vtk: within {100 * largest_interpolation_error(nodes):.3f} % of f")


if __name__ == "__main__":
    main()
