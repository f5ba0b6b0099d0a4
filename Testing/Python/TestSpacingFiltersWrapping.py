# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""vtkHessianSpacing and vtkMeshConformity as Python sees them, without ParaView's proxies."""

import math
import unittest

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import (
    VTK_TRIANGLE, vtkDataObject, vtkDataSetAttributes, vtkImageData, vtkMultiBlockDataSet,
    vtkTable, vtkUnstructuredGrid)
from vtkmodules.vtkCommonExecutionModel import vtkCompositeDataPipeline
from biting.vtkBitingFilters import (
    vtkBitingMesher, vtkBitingRemesher, vtkHessianSpacing, vtkMeshConformity)
from TestBitingMesherWrapping import square

DEFAULTS = {
    vtkHessianSpacing: {'ErrorTolerance': 0.0, 'MinimumSpacing': 0.0, 'MaximumSpacing': 0.0},
    vtkMeshConformity: {'NumberOfBins': 60},
}


def image_of(function, nodes):
    """The function of x and y as the array `u` over the square of side 2."""
    image = vtkImageData()
    image.SetDimensions(nodes, nodes, 1)
    image.SetSpacing(2.0 / (nodes - 1), 2.0 / (nodes - 1), 1.0)
    values = vtkDoubleArray()
    values.SetName('u')
    for point in range(image.GetNumberOfPoints()):
        values.InsertNextValue(function(*image.GetPoint(point)[:2]))
    image.GetPointData().SetScalars(values)
    return image


def level(low, high, nodes, value):
    """A constant spacing over a square."""
    image = vtkImageData()
    image.SetDimensions(nodes, nodes, 1)
    image.SetOrigin(low, low, 0.0)
    image.SetSpacing((high - low) / (nodes - 1), (high - low) / (nodes - 1), 1.0)
    values = vtkDoubleArray()
    values.SetName('Spacing')
    values.SetNumberOfValues(nodes * nodes)
    values.Fill(value)
    image.GetPointData().SetScalars(values)
    return image


def two_triangles(last_corner=3):
    """A unit square, with a level spacing."""
    grid, points, spacing = vtkUnstructuredGrid(), vtkPoints(), vtkDoubleArray()
    spacing.SetName('Spacing')
    for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
        points.InsertNextPoint(x, y, 0)
        spacing.InsertNextValue(0.2)
    grid.SetPoints(points)
    grid.GetPointData().SetScalars(spacing)
    grid.InsertNextCell(VTK_TRIANGLE, 3, [0, 1, 2])
    grid.InsertNextCell(VTK_TRIANGLE, 3, [0, 2, last_corner])
    return grid


def errors_of(algorithm):
    said = []
    def listen(_, __, text):
        said.append(text)
    listen.CallDataType = 'string0'
    algorithm.AddObserver('ErrorEvent', listen)
    algorithm.Update()
    return said


def spacing_by_place(images):
    """The spacing at the vertices of a mesh whose source has these blocks."""
    blocks = vtkMultiBlockDataSet()
    for number, image in enumerate(images):
        blocks.SetBlock(number, image)
    mesher = vtkBitingMesher()
    mesher.SetInputData(square(2.0))
    mesher.SetSpacingSourceData(blocks)
    mesher.SetLimitByFeatureSize(False)
    mesher.Update()
    mesh = mesher.GetOutput()
    values = mesh.GetPointData().GetArray('Spacing')
    return {mesh.GetPoint(k)[:2]: values.GetValue(k) for k in range(mesh.GetNumberOfPoints())}


class TestSpacingFiltersWrapping(unittest.TestCase):
    def test_cells_whose_points_do_not_exist_are_refused_by_all_filters(self):
        for corner in (4, -1, 10**9):
            for kind in (vtkMeshConformity, vtkBitingRemesher, vtkHessianSpacing):
                algorithm = kind()
                algorithm.SetInputData(two_triangles(corner))
                said = errors_of(algorithm)
                self.assertEqual(len(said), 1, kind)
                self.assertIn('Cell 1 of the input refers to point %d,' % corner, said[0])
            mesher = vtkBitingMesher()
            mesher.SetInputData(square(1.0))
            mesher.SetSpacingSourceData(two_triangles(corner))
            said = errors_of(mesher)
            self.assertEqual(len(said), 1)
            self.assertIn('Cell 1 of the spacing source refers to point %d,' % corner, said[0])

    def test_ghost_arrays_of_another_type_or_length_say_nothing(self):
        for kind, size in ((vtkUnsignedCharArray, 1), (vtkDoubleArray, 2)):
            marks = kind()
            marks.SetName(vtkDataSetAttributes.GhostArrayName())
            for _ in range(size):
                marks.InsertNextValue(vtkDataSetAttributes.HIDDENCELL)
            mesh = two_triangles()
            mesh.GetCellData().AddArray(marks)
            conformity = vtkMeshConformity()
            conformity.SetInputData(mesh)
            conformity.Update()
            angles = conformity.GetOutputDataObject(0).GetCellData().GetArray('MinimumAngle')
            for cell in range(2):
                self.assertAlmostEqual(angles.GetValue(cell), 45.0)
            mesher = vtkBitingMesher()
            mesher.SetInputData(mesh)
            mesher.Update()
            bounds = mesher.GetOutput().GetBounds()
            self.assertEqual(bounds[:4], (0.0, 1.0, 0.0, 1.0))

    def test_blocks_that_are_tables_are_passed_over(self):
        for kind in (vtkMeshConformity, vtkBitingRemesher):
            blocks = vtkMultiBlockDataSet()
            blocks.SetBlock(0, two_triangles())
            blocks.SetBlock(1, vtkTable())
            algorithm = kind()
            algorithm.SetExecutive(vtkCompositeDataPipeline())
            said = []
            algorithm.GetExecutive().AddObserver('ErrorEvent', lambda *_: said.append(1))
            algorithm.SetInputDataObject(blocks)
            self.assertEqual(errors_of(algorithm), [])
            self.assertEqual(said, [])
            self.assertGreater(algorithm.GetOutputDataObject(0).GetNumberOfCells(), 1)

    def test_triangles_with_a_hidden_point_are_not_measured(self):
        mesh = two_triangles()
        mesh.AllocatePointGhostArray().SetValue(3, vtkDataSetAttributes.HIDDENPOINT)
        conformity = vtkMeshConformity()
        conformity.SetInputData(mesh)
        conformity.Update()
        angles = conformity.GetOutputDataObject(0).GetCellData().GetArray('MinimumAngle')
        self.assertAlmostEqual(angles.GetValue(0), 45.0)
        self.assertTrue(math.isnan(angles.GetValue(1)))

    def test_where_blocks_of_a_source_overlap_the_smallest_value_counts_and_f_grows_from_it(self):
        coarse, fine = level(0.0, 2.0, 5, 0.2), level(0.8, 1.2, 5, 0.05)
        spacing = spacing_by_place([coarse, fine])
        self.assertEqual(spacing, spacing_by_place([fine, coarse]))
        self.assertGreater(len(spacing), 200)
        for (x, y), value in spacing.items():
            distance = math.hypot(max(0.8 - x, 0.0, x - 1.2), max(0.8 - y, 0.0, y - 1.2))
            wanted = min(0.2, 0.05 + 0.3 * distance)
            self.assertAlmostEqual(value / wanted, 1.0, delta=0.05, msg=str((x, y)))

    def test_parameters_have_their_documented_defaults_and_keep_what_is_set(self):
        for kind, defaults in DEFAULTS.items():
            instance = kind()
            for name, value in defaults.items():
                self.assertEqual(getattr(instance, 'Get' + name)(), value, name)
                getattr(instance, 'Set' + name)(value + 3)
                self.assertEqual(getattr(instance, 'Get' + name)(), value + 3, name)

    def test_ports_are_as_documented(self):
        conformity, hessian = vtkMeshConformity(), vtkHessianSpacing()
        self.assertEqual(conformity.GetNumberOfInputPorts(), 2)
        self.assertEqual(conformity.GetNumberOfOutputPorts(), 2)
        self.assertEqual(hessian.GetNumberOfInputPorts(), 1)
        self.assertEqual(hessian.GetNumberOfOutputPorts(), 1)

    def test_the_loop_of_solution_spacing_mesh_and_judgement_closes(self):
        hessian = vtkHessianSpacing()
        hessian.SetInputData(image_of(lambda x, y: math.sin(2.0 * x) + y * y, 41))
        hessian.SetInputArrayToProcess(
            0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, 'u')
        hessian.SetErrorTolerance(0.05)
        mesher = vtkBitingMesher()
        mesher.SetInputData(square(2.0))
        mesher.SetSpacingSourceConnection(hessian.GetOutputPort())
        conformity = vtkMeshConformity()
        conformity.SetInputConnection(mesher.GetOutputPort())
        conformity.SetSpacingSourceConnection(hessian.GetOutputPort())
        conformity.SetNumberOfBins(20)
        conformity.Update()
        summary = conformity.GetOutput().GetFieldData()
        self.assertGreater(summary.GetArray('MeanConformity').GetValue(0), 0.5)
        self.assertAlmostEqual(summary.GetArray('MeanRelativeLength').GetValue(0), 1.0, delta=0.2)
        table = conformity.GetHistograms()
        self.assertEqual(table.GetNumberOfRows(), 20)
        names = [table.GetColumnName(column) for column in range(table.GetNumberOfColumns())]
        self.assertEqual(names, ['Angle', 'AnglePercent', 'Conformity', 'ConformityPercent',
                                 'RelativeLength', 'RelativeLengthPercent'])


if __name__ == '__main__':
    unittest.main()
