# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""BitingDelaunay3D as a script in pvpython sees it."""

import os
import unittest

from paraview import simple


class TestBitingDelaunay3DProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())

    def test_properties_have_their_documented_names_and_defaults(self):
        proxy = BitingDelaunay3D(Input=simple.Sphere())
        self.assertEqual(proxy.Alpha, 0.0)
        self.assertEqual(set(proxy.ListProperties()), {'Input', 'Alpha'})
        self.assertEqual(proxy.GetXMLLabel(), 'Biting Delaunay 3D')

    def test_a_ball_is_filled(self):
        sphere = simple.Sphere(ThetaResolution=24, PhiResolution=24)
        ball = BitingDelaunay3D(Input=sphere)
        ball.UpdatePipeline()
        grid = simple.FetchData(ball)[0]
        self.assertEqual(grid.GetClassName(), 'vtkUnstructuredGrid')
        self.assertGreater(grid.GetNumberOfCells(), 500)
        self.assertEqual({grid.GetCellType(k) for k in range(grid.GetNumberOfCells())}, {10})
        self.assertEqual(grid.GetNumberOfPoints(), sphere.GetDataInformation().GetNumberOfPoints())
        self.assertIsNotNone(grid.GetPointData().GetArray('Normals'))

    def test_alpha_bounds_the_radius(self):
        grid = simple.UnstructuredCellTypes(BlocksDimensions=[6, 6, 6])
        everything = BitingDelaunay3D(Input=grid)
        nothing = BitingDelaunay3D(Input=grid, Alpha=1e-6)
        for proxy in (everything, nothing):
            proxy.UpdatePipeline()
        self.assertGreater(everything.GetDataInformation().GetNumberOfCells(), 500)
        self.assertEqual(nothing.GetDataInformation().GetNumberOfCells(), 0)


if __name__ == '__main__':
    unittest.main()
