# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Longitude and latitude in pvpython: lengths on the globe by formulas of this test."""

import math
import os
import unittest

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

RADIUS = 6371008.8  # metres
DEGREES = 'Longitude Latitude'


def rectangle(west, south, east, north):
    data, points, lines = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    lines.InsertNextCell(5)
    for x, y in ((west, south), (east, south), (east, north), (west, north)):
        lines.InsertCellPoint(points.InsertNextPoint(x, y, 0))
    lines.InsertCellPoint(0)
    data.SetPoints(points)
    data.SetLines(lines)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    return source


def haversine(a, b):
    (x, y), (u, v) = ([math.radians(angle) for angle in place[:2]] for place in (a, b))
    h = math.sin((v - y) / 2) ** 2 + math.cos(y) * math.cos(v) * math.sin((u - x) / 2) ** 2
    return 2 * RADIUS * math.asin(math.sqrt(h))


def mean_length(mesh):
    lengths = []
    for k in range(mesh.GetNumberOfCells()):
        ids = [mesh.GetCell(k).GetPointId(corner) for corner in range(3)]
        places = [mesh.GetPoint(corner) for corner in ids]
        lengths += [haversine(places[j], places[j - 1]) for j in range(3)]
    return sum(lengths) / len(lengths)


class TestGlobeProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())

    def test_edges_are_as_long_in_metres_wherever_they_are(self):
        for west, east in ((-5, 5), (175, -175)):
            mesher = BitingMesher(Input=rectangle(west, 65, east, 70), Coordinates=DEGREES,
                UniformSpacing=25e3)
            mesh = servermanager.Fetch(mesher)
            self.assertAlmostEqual(mean_length(mesh) / 25e3, 1, delta=0.02)
            self.assertLess(mesh.GetBounds()[1] - mesh.GetBounds()[0], 10.001)

    def test_the_other_filters_have_it_too(self):
        mesher = BitingMesher(Input=rectangle(175, 65, -175, 70), Coordinates=DEGREES,
            UniformSpacing=25e3)
        judged = MeshConformity(Input=mesher, Coordinates=DEGREES)
        self.assertGreater(self.figure(judged, 'MeanConformity'), 0.85)
        self.assertGreater(self.figure(judged, 'SmallestAngle'), 30)
        finer = BitingRemesher(Input=mesher, Coordinates=DEGREES, UniformSpacing=12.5e3)
        self.assertAlmostEqual(mean_length(servermanager.Fetch(finer)) / 12.5e3, 1, delta=0.1)
        depth = simple.Calculator(Input=mesher, ResultArrayName='Depth', Function='coordsY^2')
        spacing = HessianSpacing(Input=depth, ScalarArray=['POINTS', 'Depth'], Coordinates=DEGREES)
        spacing.UpdatePipeline()
        low, high = spacing.PointData['Spacing'].GetRange()
        self.assertTrue(1e3 < low <= high < 1e6)

    def test_latitudes_beyond_the_pole_are_refused(self):
        mesher = BitingMesher(Input=rectangle(0, 80, 10, 95), Coordinates=DEGREES)
        mesher.UpdatePipeline()
        mesher.UpdatePropertyInformation()
        self.assertIn('Latitudes', mesher.Summary)

    def figure(self, proxy, name):
        proxy.UpdatePipeline()
        return servermanager.Fetch(proxy).GetFieldData().GetArray(name).GetValue(0)


if __name__ == '__main__':
    unittest.main()
