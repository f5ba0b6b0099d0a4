# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""A cut surface with an edge a pixel as a user meshes it: how far is the mesh from the drawing?

Distances are sampled here, in both directions, from the points and lines of the data alone.
"""

import math
import os
import unittest

from paraview import simple

SPACING = 20.0
TOLERANCE = 0.2
REACH = TOLERANCE * SPACING
SAMPLE = 0.5  # length: half a pixel
ROUNDING = 1e-9
VERTICES_OF_DENSITY = 2.0 / math.sqrt(3.0)  # of equilateral triangles


def drawing_of_pixels():
    """The outline of where the wavelet is high."""
    wavelet = simple.Wavelet(WholeExtent=[-200, 200, -200, 200, 0, 0])
    high = simple.IsoVolume(
        Input=wavelet, InputScalars=['POINTS', 'RTData'], ThresholdRange=[150.0, 300.0])
    surface = simple.ExtractSurface(Input=high)
    return simple.FeatureEdges(Input=surface, BoundaryEdges=1, FeatureEdges=0,
        NonManifoldEdges=0, ManifoldEdges=0)


def output_of(proxy, port):
    proxy.UpdatePipeline()
    return simple.FetchData(simple.OutputPort(proxy, port))[0]


def lines_of(data):
    """Pairs of places."""
    lines = []
    for cell in range(data.GetNumberOfCells()):
        ids = data.GetCell(cell).GetPointIds()
        places = [data.GetPoint(ids.GetId(k))[:2] for k in range(ids.GetNumberOfIds())]
        lines += zip(places[:-1], places[1:])
    return lines


def samples_of(lines):
    for (ax, ay), (bx, by) in lines:
        count = max(1, math.ceil(math.hypot(bx - ax, by - ay) / SAMPLE))
        for k in range(count + 1):
            yield ax + (bx - ax) * k / count, ay + (by - ay) * k / count


def distance_to(x, y, line):
    (ax, ay), (bx, by) = line
    squared = (bx - ax) ** 2 + (by - ay) ** 2
    share = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / squared
    share = max(0.0, min(1.0, share))
    return math.hypot(ax + share * (bx - ax) - x, ay + share * (by - ay) - y)


def boxes_of(lines):
    """Lines by the squares, as large as the reach, near which they pass."""
    boxes = {}
    for line in lines:
        squares = [[math.floor(c / REACH) for c in place] for place in line]
        for i in range(min(s[0] for s in squares) - 1, max(s[0] for s in squares) + 2):
            for j in range(min(s[1] for s in squares) - 1, max(s[1] for s in squares) + 2):
                boxes.setdefault((i, j), []).append(line)
    return boxes


def largest_distance(lines, others):
    """Of places on lines to the nearest of the others; infinite where it is above twice the reach."""
    boxes = boxes_of(others)
    return max(min((distance_to(x, y, line) for line in
        boxes.get((math.floor(x / REACH), math.floor(y / REACH)), [])), default=math.inf)
        for x, y in samples_of(lines))


def length_of(lines):
    return math.fsum(math.dist(*line) for line in lines)


def area_of(mesh):
    return math.fsum(mesh.GetCell(k).ComputeArea() for k in range(mesh.GetNumberOfCells()))


class TestBoundaryToleranceProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())
        pixels = drawing_of_pixels()
        mesher = BitingMesher(
            Input=pixels, UniformSpacing=SPACING, BoundaryTolerance=TOLERANCE)
        whole = BitingMesher(Input=pixels, UniformSpacing=SPACING)
        cls.drawing = lines_of(output_of(pixels, 0))
        cls.mesh = output_of(mesher, 0)
        cls.boundary = lines_of(output_of(mesher, 1))
        cls.whole = output_of(whole, 0)

    def test_the_boundary_is_within_the_tolerance_of_the_drawing(self):
        self.assertLessEqual(largest_distance(self.boundary, self.drawing), REACH + ROUNDING)

    def test_the_drawing_is_within_the_tolerance_of_the_boundary(self):
        self.assertLessEqual(largest_distance(self.drawing, self.boundary), REACH + ROUNDING)

    def test_the_area_is_that_of_the_drawing_as_far_as_the_tolerance_tells(self):
        most = REACH * length_of(self.boundary)
        self.assertLess(abs(area_of(self.mesh) - area_of(self.whole)), most)

    def test_vertices_are_as_many_as_the_spacing_asks_for(self):
        asked = VERTICES_OF_DENSITY * area_of(self.mesh) / SPACING ** 2
        self.assertGreater(self.whole.GetNumberOfPoints(), 20 * asked)
        self.assertLess(self.mesh.GetNumberOfPoints(), 1.5 * asked)

    def test_angles_are_those_of_a_coarse_drawing(self):
        smallest = self.mesh.GetFieldData().GetArray('SmallestAngle').GetValue(0)
        self.assertGreater(smallest, 30.0)


if __name__ == '__main__':
    unittest.main()
