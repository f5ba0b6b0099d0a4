# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""The examples that users copy from make meshes without complaints, and the files they say."""

import glob
import importlib.util
import math
import os
import tempfile
import unittest
from unittest import mock

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkStringOutputWindow, vtkOutputWindow

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'Data')
SMALLEST_ANGLES = {'contour_to_mesh': 30, 'coast_with_spacing_by_depth': 15,
                   'courant_number_of_a_coast': 15, 'adcirc_grid_with_depths': 15, 'airfoil': 35,
                   'plate_with_regions': 30, 'export_with_tags': 30, 'size_by_tag': 30,
                   'judge_a_mesh': 0, 'mesh_for_a_solution': 35,
                   'nested_refinement_regions': 30, 'a_town_of_houses': 25, 'periodic_cell': 35,
                   'fine_mesh_in_a_coarse_one': 25, 'stl_to_tetrahedra': 20,
                   'body_with_tags_for_a_solver': 20, 'shell_of_two_materials': 30,
                   'ball_with_a_spacing_field': 30}
FILES = ['airfoil.su2', 'bolts.vtk', 'bracket.msh', 'bracket.su2', 'bracket.vtu', 'coast.14',
         'courant_number.vtp', 'left_of_the_weld.vtk', 'plate.msh', 'plate.su2']


class TestExamplesProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        spec = importlib.util.spec_from_file_location('examples', os.path.join(DATA, 'examples.py'))
        cls.examples = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(cls.examples)
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], remote=False, ns=cls.examples.__dict__)
        cls.folder = tempfile.TemporaryDirectory()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_each_task_makes_a_mesh_without_complaints(self):
        self.assertEqual({task.__name__ for task in self.examples.tasks}, set(SMALLEST_ANGLES))
        for task in self.examples.tasks:
            with self.subTest(task.__name__):
                self.check(task)
        for name in FILES:
            self.assertGreater(os.path.getsize(os.path.join(self.folder.name, name)), 1000, name)

    def test_the_folder_of_the_output_need_not_be_there(self):
        folder = os.path.join(self.folder.name, 'a', 'b')
        with mock.patch.object(self.examples, 'tasks', []):
            self.examples.main(os.environ['BITING_PLUGIN'], folder)
        self.assertTrue(os.path.isdir(folder))

    def test_scripts_load_the_plugin_by_its_whole_path_as_paraview_5_13_needs_it(self):
        for path in glob.glob(os.path.join(DATA, '*.py')):
            with open(path, encoding='utf-8') as file:
                for line in file:
                    if 'LoadPlugin(' in line:
                        self.assertIn('os.path.abspath(', line, path)

    def test_nested_regions_and_a_town_have_their_areas(self):
        mesh = self.examples.nested_refinement_regions(self.folder.name)
        halves = [64, 32, 16, 8, 4, 2, 1]
        expected = [4.0 * (a * a - b * b) for a, b in zip(halves, halves[1:] + [0])]
        self.assertEqual(sorted(self.areas(mesh)), sorted(expected))
        mesh = self.examples.a_town_of_houses(self.folder.name)
        self.assertAlmostEqual(sum(self.areas(mesh)), 240 * 160 - 60 * (9 * 12 + 3 * 4), delta=1e-8)

    def areas(self, mesh):
        """Of the regions, rounded to what the sum of coordinates leaves."""
        mesh.UpdatePipeline()
        data = servermanager.Fetch(mesh, idx=0)
        regions, areas = data.GetCellData().GetArray('RegionId'), {}
        for k in range(data.GetNumberOfCells()):
            a, b, c = (data.GetPoint(data.GetCell(k).GetPointId(i)) for i in range(3))
            twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            areas.setdefault(regions.GetValue(k), []).append(0.5 * twice)
        return [round(math.fsum(parts), 9) for parts in areas.values()]

    def check(self, task):
        window = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(window)
        mesh = task(self.folder.name)
        mesh.UpdatePipeline()
        vtkOutputWindow.SetInstance(None)
        self.assertEqual(window.GetOutput(), '')
        self.assertGreater(mesh.GetDataInformation().GetNumberOfCells(), 300)
        cells = servermanager.Fetch(mesh, idx=0).GetCellData()
        angles = cells.GetArray('MinimumAngle') or cells.GetArray('MinimumDihedralAngle')
        self.assertGreaterEqual(angles.GetRange()[0], SMALLEST_ANGLES[task.__name__])


if __name__ == '__main__':
    unittest.main()
