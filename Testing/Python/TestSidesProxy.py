# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Sides that belong together, as a script in pvpython sees them: of periodic cells, and of cracks."""

import os
import tempfile
import unittest

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

CRACKED = '''# vtk DataFile Version 3.0
a square and a crack from its left side
ASCII
DATASET POLYDATA
POINTS 6 double
0 0 0 1 0 0 1 1 0 0 1 0 0 0.5 0 0.5 0.5 0
LINES 2 9
5 0 1 2 3 0
2 4 5
CELL_DATA 2
SCALARS Crack int 1
LOOKUP_TABLE default
0 1
'''


class TestSidesProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())
        cls.folder = tempfile.TemporaryDirectory()
        path = os.path.join(cls.folder.name, 'cracked.vtk')
        with open(path, 'w', encoding='ascii') as file:
            file.write(CRACKED)
        cls.square = simple.LegacyVTKReader(FileNames=[path])

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def mesh(self, **parameters):
        mesher = BitingMesher(Input=self.square, UniformSpacing=0.1, **parameters)
        mesher.UpdatePipeline()
        return servermanager.Fetch(mesher, idx=0), servermanager.Fetch(mesher, idx=1)

    def test_points_of_periodic_sides_have_partners(self):
        mesh, _ = self.mesh(PeriodicTranslation=[1, 0, 0], PeriodicTranslation2=[0, 1, 0])
        for name, axis in (('PeriodicPartner', 0), ('PeriodicPartner2', 1)):
            partners = mesh.GetPointData().GetArray(name)
            pairs = [(k, partners.GetValue(k)) for k in range(partners.GetNumberOfTuples())
                     if partners.GetValue(k) >= 0]
            self.assertGreaterEqual(len(pairs), 20)
            for a, b in pairs:
                way = [q - p for p, q in zip(mesh.GetPoint(a), mesh.GetPoint(b))]
                self.assertAlmostEqual(abs(way[axis]), 1, delta=3e-16)
                self.assertAlmostEqual(way[1 - axis], 0, delta=3e-16)

    def test_a_wrong_period_is_refused_with_a_sentence(self):
        window = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(window)
        mesh, _ = self.mesh(PeriodicTranslation=[0.75, 0, 0])
        vtkOutputWindow.SetInstance(None)
        self.assertEqual(mesh.GetNumberOfCells(), 0)
        self.assertIn('Periodic Translation', window.GetOutput())

    def test_a_crack_opens_up_to_its_end(self):
        closed, edges = self.mesh()
        opened, both = self.mesh(SplitInterfaces='Crack')
        cracks = edges.GetNumberOfCells() - self.sides(edges)
        self.assertEqual(both.GetNumberOfCells(), edges.GetNumberOfCells() + cracks)
        self.assertEqual(opened.GetNumberOfPoints(), closed.GetNumberOfPoints() + cracks)
        self.assertEqual(opened.GetNumberOfCells(), closed.GetNumberOfCells())

    def sides(self, edges):
        kinds = edges.GetCellData().GetArray('Kind')
        return sum(kinds.GetValue(k) == 0 for k in range(kinds.GetNumberOfTuples()))


if __name__ == '__main__':
    unittest.main()
