# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Drawings that change with time. A module of its own, because programmable sources put names of numpy,
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


if __name__ == '__main__':
    unittest.main()
