# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""The class as Python sees it, without ParaView's proxies: parameters, ports, a mesh, an error."""

import unittest

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from biting.vtkBitingFilters import vtkBitingMesher

DEFAULTS = {
    'UniformSpacing': 0.0,
    'SpacingScale': 1.0,
    'MinimumSpacing': 0.0,
    'MaximumSpacing': 0.0,
    'Gradation': 0.3,
    'LimitByFeatureSize': True,
    'CellsAcross': 1,
    'PeriodicTranslation': (0.0, 0.0, 0.0),
    'PeriodicTranslation2': (0.0, 0.0, 0.0),
    'SplitInterfaces': '',
    'RepairInput': True,
    'MergeTolerance': 0.0,
    'EndTolerance': 0.01,
    'DomainRule': 0,
    'PreserveBoundary': False,
    'Coordinates': 0,
    'BoundaryTolerance': 0.0,
    'CornerAngle': 45.0,
    'MinimumLoopSize': 0.0,
    'BiteShape': 0,
    'BitingConstant': 0.0,
    'Placement': 1,
    'FrontOrder': 0,
    'MaximumNumberOfBites': -1,
    'Phi': 1.0,
    'Relaxation': True,
    'MaximumNumberOfVertices': 20000000,
    'NumberOfThreads': 0,
    'GenerateBites': False,
}

OTHER_VALUES = {
    'UniformSpacing': 0.25,
    'SpacingScale': 0.5,
    'MinimumSpacing': 0.01,
    'MaximumSpacing': 2.0,
    'Gradation': 0.1,
    'LimitByFeatureSize': False,
    'CellsAcross': 3,
    'PeriodicTranslation': (1.0, 0.0, 0.0),
    'PeriodicTranslation2': (0.0, 2.0, 0.0),
    'SplitInterfaces': 'Crack',
    'RepairInput': False,
    'MergeTolerance': 0.001,
    'EndTolerance': 0.1,
    'DomainRule': 2,
    'PreserveBoundary': True,
    'Coordinates': 1,
    'BoundaryTolerance': 0.2,
    'CornerAngle': 30.0,
    'MinimumLoopSize': 1.0,
    'BitingConstant': 0.5,
    'FrontOrder': 1,
    'MaximumNumberOfBites': 7,
    'Phi': 0.75,
    'Relaxation': False,
    'MaximumNumberOfVertices': 1000,
    'NumberOfThreads': 2,
    'GenerateBites': True,
}


def polygon(corners):
    """A closed polyline through the corners, in the plane z = 0."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    lines = vtkCellArray()
    lines.InsertNextCell(len(corners) + 1)
    for x, y in corners:
        lines.InsertCellPoint(points.InsertNextPoint(x, y, 0.0))
    lines.InsertCellPoint(0)
    result = vtkPolyData()
    result.SetPoints(points)
    result.SetLines(lines)
    return result


def square(side):
    return polygon([(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)])


def area(mesh):
    """Sum of the signed areas of the triangles."""
    doubled = 0.0
    for cell in range(mesh.GetNumberOfCells()):
        corners = mesh.GetCell(cell).GetPointIds()
        a, b, c = (mesh.GetPoint(corners.GetId(corner)) for corner in range(3))
        doubled += (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return 0.5 * doubled


class TestBitingMesherWrapping(unittest.TestCase):
    def test_parameters_have_their_documented_defaults(self):
        mesher = vtkBitingMesher()
        for name, value in DEFAULTS.items():
            self.assertEqual(getattr(mesher, 'Get' + name)(), value, name)

    def test_parameters_keep_what_is_set(self):
        mesher = vtkBitingMesher()
        for name, value in OTHER_VALUES.items():
            getattr(mesher, 'Set' + name)(value)
            self.assertEqual(getattr(mesher, 'Get' + name)(), value, name)

    def test_choices_have_named_setters(self):
        mesher = vtkBitingMesher()
        mesher.SetFrontOrderToLargestY()
        self.assertEqual(mesher.GetFrontOrder(), 1)
        mesher.SetFrontOrderToLayers()
        mesher.SetBiteShapeToSquare()
        mesher.SetPlacementToCorners()
        self.assertEqual(mesher.GetFrontOrder(), 0)

    def test_there_are_two_inputs_and_four_outputs(self):
        mesher = vtkBitingMesher()
        self.assertEqual(mesher.GetNumberOfInputPorts(), 2)
        self.assertEqual(mesher.GetNumberOfOutputPorts(), 4)

    def test_a_square_is_covered_and_its_arrays_are_there(self):
        mesher = vtkBitingMesher()
        mesher.SetInputData(square(2.0))
        mesher.SetUniformSpacing(0.2)
        mesher.GenerateBitesOn()
        mesher.Update()
        mesh = mesher.GetOutput()
        self.assertGreater(mesh.GetNumberOfCells(), 100)
        self.assertAlmostEqual(area(mesh), 4.0, places=12)
        for name in ('Spacing', 'NearestNeighborDistance', 'Conformity', 'BiteOrder',
                     'VertexKind', 'OriginalPointId'):
            self.assertIsNotNone(mesh.GetPointData().GetArray(name), name)
        for name in ('RegionId', 'MinimumAngle', 'RadiusEdgeRatio', 'AspectRatio'):
            self.assertIsNotNone(mesh.GetCellData().GetArray(name), name)
        self.assertGreater(mesher.GetOutput(1).GetNumberOfLines(), 0)
        self.assertGreater(mesher.GetOutput(2).GetNumberOfPolys(), 0)

    def test_an_open_line_is_refused_once_and_gives_nothing(self):
        line = vtkPolyData()
        points = vtkPoints()
        lines = vtkCellArray()
        lines.InsertNextCell(2)
        lines.InsertCellPoint(points.InsertNextPoint(0.0, 0.0, 0.0))
        lines.InsertCellPoint(points.InsertNextPoint(1.0, 0.0, 0.0))
        line.SetPoints(points)
        line.SetLines(lines)
        errors = []
        mesher = vtkBitingMesher()
        mesher.AddObserver('ErrorEvent', lambda caller, event: errors.append(event))
        mesher.GetExecutive().AddObserver('ErrorEvent', lambda caller, event: None)
        mesher.SetInputData(line)
        mesher.Update()
        self.assertEqual(len(errors), 1)
        self.assertEqual(mesher.GetOutput().GetNumberOfPoints(), 0)
        problems = mesher.GetOutput(vtkBitingMesher.PROBLEMS)
        self.assertEqual(problems.GetNumberOfVerts(), 2)
        kinds = problems.GetPointData().GetArray('ProblemKind')
        self.assertEqual(kinds.GetValue(0), vtkBitingMesher.NO_CLOSED_LOOP)


if __name__ == '__main__':
    unittest.main()
