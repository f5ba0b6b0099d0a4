# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""What ParaView writes down of the filters, states and traces, makes the same meshes again."""

import os
import tempfile
import unittest

from paraview import servermanager, simple, smstate, smtrace
from vtkmodules.util.numpy_support import vtk_to_numpy

HERE = os.path.dirname(os.path.abspath(__file__))
VALUES = {'UniformSpacing': 0.1, 'Gradation': 0.2, 'BoundaryTolerance': 0.1, 'FrontOrder': 'Largest Y',
          'MaximumNumberOfVertices': 5000, 'GenerateBites': 1}
PIPELINE = '''
from paraview.simple import *
ellipse = Ellipse()
mesher = BitingMesher(registrationName='Mesher', Input=ellipse, **VALUES)
judge = MeshConformity(Input=OutputPort(mesher, 0))
'''


def output(name='Mesher', port=0):
    """Points and cells of an output, as bytes."""
    source = simple.FindSource(name)
    source.UpdatePipeline()
    data = servermanager.Fetch(source, idx=port)
    return [vtk_to_numpy(part).tobytes() for part in (
        data.GetPoints().GetData(), data.GetPolys().GetConnectivityArray())]


def start_anew():
    simple.ResetSession()
    simple.LoadPlugin(os.environ['BITING_PLUGIN'], remote=False, ns=simple.__dict__)


class TestStatesProxy(unittest.TestCase):
    def setUp(self):
        start_anew()

    def run_script(self, text):
        exec(compile(text, 'script', 'exec'), {'VALUES': VALUES, '__name__': '__main__'})

    def make(self):
        self.run_script(PIPELINE)
        return output()

    def check_values(self, mesher):
        for name, value in VALUES.items():
            self.assertEqual(mesher.GetPropertyValue(name), value, name)

    def test_a_state_that_is_loaded_makes_the_same_mesh(self):
        mesh = self.make()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'state.pvsm')
            simple.SaveState(path)
            start_anew()
            simple.LoadState(path)
        self.check_values(simple.FindSource('Mesher'))
        self.assertEqual(output(), mesh)

    def test_a_python_state_that_is_run_makes_the_same_mesh(self):
        mesh = self.make()
        text = smstate.get_state()
        start_anew()
        self.run_script(text)
        self.check_values(simple.FindSource('Mesher'))
        self.assertEqual(output(), mesh)

    def test_a_trace_that_is_replayed_makes_the_same_mesh(self):
        smtrace.start_trace()
        mesh = self.make()
        text = smtrace.stop_trace()
        start_anew()
        self.run_script(text)
        self.check_values(simple.FindSource('Mesher'))
        self.assertEqual(output(), mesh)

    def test_a_state_of_version_0_1_loads(self):
        simple.LoadState(os.path.join(HERE, 'version_0_1.pvsm'))
        mesher = simple.FindSource('Mesher')
        self.check_values(mesher)
        self.assertEqual(output(), self.make())
        judge = simple.FindSource('MeshConformity1')
        judge.UpdatePipeline()
        self.assertEqual(judge.GetDataInformation().GetNumberOfCells(),
                         mesher.GetDataInformation().GetNumberOfCells())


if __name__ == '__main__':
    unittest.main()
