# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause
"""Spacing at the points of polylines."""

import math


def edge_lengths(loop):
    """Mean length of the two edges at each point of a closed loop."""
    lengths = [math.dist(a, b) for a, b in zip(loop, loop[1:] + loop[:1])]
    return [(before + after) / 2 for before, after in zip(lengths[-1:] + lengths[:-1], lengths)]


def graded(points, values, slope):
    """The largest function below the values with at most this slope between any two points."""
    return [min(value + slope * math.dist(point, other) for other, value in zip(points, values))
        for point in points]
