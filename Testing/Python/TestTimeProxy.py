# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Drawings and spacings that change with time. A module of its own, because programmable sources put
names of numpy, such as max, in the place of Python's."""

import os
import unittest

from paraview import simple
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

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
# A spacing of a tenth of the time, wherever the square may be.
GROWING_SPACING = '''
from vtkmodules.vtkCommonCore import vtkDoubleArray
time = self.GetOutputInformation(0).Get(self.GetExecutive().UPDATE_TIME_STEP())
spacing = vtkDoubleArray()
spacing.SetName('Spacing')
for _ in range(4):
    spacing.InsertNextValue(time / 10)
self.GetImageDataOutput().SetDimensions(2, 2, 1)
self.GetImageDataOutput().SetSpacing(4, 4, 1)
self.GetImageDataOutput().GetPointData().SetScalars(spacing)
'''
EXTENT = '''
info.Set(self.GetExecutive().WHOLE_EXTENT(), [0, 1, 0, 1, 0, 0], 6)
'''


def growing_square():
    return simple.ProgrammableSource(OutputDataSetType='vtkPolyData', Script=GROWING_SQUARE,
                                     ScriptRequestInformation=TIMES)


def growing_spacing():
    return simple.ProgrammableSource(OutputDataSetType='vtkImageData', Script=GROWING_SPACING,
                                     ScriptRequestInformation=TIMES + EXTENT)


def times_of(proxy):
    proxy.UpdatePipelineInformation()
    information = proxy.GetClientSideObject().GetOutputInformation(0)
    return list(information.Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS()))


class TestTimeProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())

    def test_a_drawing_that_changes_is_meshed_at_each_time(self):
        mesher = BitingMesher(Input=growing_square(), UniformSpacing=0.25)
        self.assertEqual(times_of(mesher), [1.0, 2.0, 3.0])
        for time in (3.0, 1.0, 2.0):
            mesher.UpdatePipeline(time)
            found = mesher.GetDataInformation()
            self.assertEqual(found.GetBounds()[:4], (0.0, time, 0.0, time))
            self.assertGreater(found.GetNumberOfCells(), 20 * time * time)

    def test_a_spacing_that_changes_makes_all_filters_run_anew(self):
        image = growing_spacing()
        drawing = simple.Disk(InnerRadius=0.0, OuterRadius=1.0, CircumferentialResolution=16)
        at = simple.Transform(Input=drawing)
        at.Transform.Translate = [2.0, 2.0, 0.0]
        old = BitingMesher(Input=at, UniformSpacing=0.2)
        asked = {'SpacingSource': image, 'SourceSpacingArray': ['POINTS', 'Spacing']}
        for over in (BitingMesher(Input=at, LimitByFeatureSize=0, **asked),
                     BitingRemesher(Input=old, LimitByFeatureSize=0, **asked),
                     MeshConformity(Input=old, **asked)):
            self.assertEqual(times_of(over), [1.0, 2.0, 3.0])
            for time in (3.0, 1.0, 2.0):
                over.UpdatePipeline(time)
                found = over.GetPointDataInformation().GetArray('Spacing').GetRange()
                self.assertAlmostEqual(found[1], time / 10)

    def test_times_are_those_of_all_inputs(self):
        early = growing_square()
        late = simple.ProgrammableSource(
            OutputDataSetType='vtkImageData', Script=GROWING_SPACING,
            ScriptRequestInformation=TIMES.replace('[1.0, 2.0, 3.0]', '[2.5, 3.0]') + EXTENT)
        mesher = BitingMesher(Input=early, SpacingSource=late)
        self.assertEqual(times_of(mesher), [1.0, 2.0, 2.5, 3.0])


if __name__ == '__main__':
    unittest.main()
