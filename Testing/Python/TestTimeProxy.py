# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Drawings and spacing sources that change with time. A module of its own, because programmable sources put names of numpy,
such as max, in the place of Python's."""

import os
import unittest

from paraview import simple

# A source that has three times; its square is as wide as the time.
TIMES = '''
steps = [1.0, 2.0, 3.0]
info = self.GetOutputInformation(0)
info.Set(self.GetExecutive().TIME_STEPS(), steps, len(steps))
info.Set(self.GetExecutive().TIME_RANGE(), [steps[0], steps[-1]], 2)
'''
GROWING_SQUARE = '''
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
width = self.GetOutputInformation(0).Get(self.GetExecutive().UPDATE_TIME_STEP())
points, lines = vtkPoints(), vtkCellArray()
points.SetDataTypeToDouble()
for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
    points.InsertNextPoint(x * width, y * width, 0)
lines.InsertNextCell(5)
for k in (0, 1, 2, 3, 0):
    lines.InsertCellPoint(k)
self.GetPolyDataOutput().SetPoints(points)
self.GetPolyDataOutput().SetLines(lines)
'''

# Two triangles over the unit square; their spacing is a tenth of the time.
GROWING_SPACING = '''
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
time = self.GetOutputInformation(0).Get(self.GetExecutive().UPDATE_TIME_STEP())
points, triangles, spacing = vtkPoints(), vtkCellArray(), vtkDoubleArray()
spacing.SetName('Spacing')
for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)):
    points.InsertNextPoint(x, y, 0)
    spacing.InsertNextValue(0.1 * time)
for corners in ((0, 1, 2), (0, 2, 3)):
    triangles.InsertNextCell(3, corners)
self.GetPolyDataOutput().SetPoints(points)
self.GetPolyDataOutput().SetPolys(triangles)
self.GetPolyDataOutput().GetPointData().AddArray(spacing)
'''


class TestTimeProxy(unittest.TestCase):
    def test_a_drawing_that_changes_is_meshed_at_each_time(self):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())
        growing = simple.ProgrammableSource(OutputDataSetType='vtkPolyData',
            Script=GROWING_SQUARE, ScriptRequestInformation=TIMES)
        mesher = BitingMesher(Input=growing, UniformSpacing=0.25)
        mesher.UpdatePipelineInformation()
        times = list(simple.GetTimeKeeper().TimestepValues)
        self.assertEqual(times, [1.0, 2.0, 3.0])
        for time in (3.0, 1.0, 2.0):
            mesher.UpdatePipeline(time)
            found = mesher.GetDataInformation()
            self.assertEqual(found.GetBounds()[:4], (0.0, time, 0.0, time))
            self.assertGreater(found.GetNumberOfCells(), 20 * time * time)

    def test_a_steady_drawing_is_meshed_anew_where_its_spacing_changes(self):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())
        spacing = simple.ProgrammableSource(OutputDataSetType='vtkPolyData',
            Script=GROWING_SPACING, ScriptRequestInformation=TIMES)
        mesher = BitingMesher(Input=simple.Plane(), SpacingSource=spacing)
        remesher = BitingRemesher(Input=BitingMesher(Input=simple.Plane(), UniformSpacing=0.2),
            SpacingSource=spacing)
        for filter in (mesher, remesher):
            counts = []
            for time in (3.0, 1.0, 2.0):
                filter.UpdatePipeline(time)
                counts.append(filter.GetDataInformation().GetNumberOfCells())
            self.assertGreater(counts[1], 2 * counts[2])
            self.assertGreater(counts[2], 1.5 * counts[0])


if __name__ == '__main__':
    unittest.main()
