# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""HessianSpacing and MeshConformity as a script in pvpython sees them."""

import os
import unittest

from paraview import simple

PROPERTIES = {
    'HessianSpacing': {
        'ErrorTolerance': 0.0, 'MinimumSpacing': 0.0, 'MaximumSpacing': 0.0,
        'ScalarArray': ['POINTS', 'RTData'], 'Coordinates': 'Plane',
    },
    'MeshConformity': {
        'SpacingArray': ['POINTS', 'Spacing'], 'SourceSpacingArray': ['POINTS', 'Spacing'],
        'NumberOfBins': 60, 'Coordinates': 'Plane',
    },
}
OTHERS = {'HessianSpacing': {'Input'}, 'MeshConformity': {'Input', 'SpacingSource', 'Summary'}}
OUTPUTS = {'HessianSpacing': ['Spacing'], 'MeshConformity': ['Mesh', 'Histograms']}
LABELS = {'HessianSpacing': 'Hessian Spacing', 'MeshConformity': 'Mesh Conformity'}


def wave():
    source = simple.Wavelet(WholeExtent=[0, 20, 0, 20, 0, 0])
    source.UpdatePipeline()
    return source


def triangles():
    return simple.Triangulate(Input=simple.ExtractSurface(Input=wave()))


def new_filter(name):
    kind = {'HessianSpacing': HessianSpacing, 'MeshConformity': MeshConformity}[name]
    return kind(Input=wave() if name == 'HessianSpacing' else triangles())


def summary_of(conformity, name):
    conformity.UpdatePipeline()
    data = simple.FetchData(simple.OutputPort(conformity, 0))[0]
    return data.GetFieldData().GetArray(name).GetValue(0)


class TestSpacingFiltersProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())

    def test_properties_have_their_documented_names_and_defaults(self):
        for kind, properties in PROPERTIES.items():
            proxy = new_filter(kind)
            for name, value in properties.items():
                found = getattr(proxy, name)
                self.assertEqual(list(found) if isinstance(value, list) else found, value, name)
            self.assertEqual(set(proxy.ListProperties()), set(properties) | OTHERS[kind])

    def test_a_filter_made_before_its_input_is_known_takes_the_active_scalars(self):
        values_of_both = []
        for early in (True, False):
            image = simple.Wavelet(WholeExtent=[0, 20, 0, 20, 0, 0])
            if not early:
                image.UpdatePipeline()
            spacing = HessianSpacing(Input=image)
            spacing.UpdatePipeline()
            values = simple.FetchData(spacing)[0].GetPointData().GetArray('Spacing')
            values_of_both.append([values.GetValue(k) for k in range(values.GetNumberOfValues())])
        self.assertEqual(len(values_of_both[0]), 441)
        self.assertEqual(values_of_both[0], values_of_both[1])

    def test_labels_are_the_spaced_names(self):
        for kind, properties in PROPERTIES.items():
            proxy = new_filter(kind).SMProxy
            self.assertEqual(proxy.GetXMLLabel(), LABELS[kind])
            for name in list(properties):
                label = proxy.GetProperty(name).GetXMLLabel()
                self.assertEqual(label.replace(' ', ''), name)

    def test_everything_is_explained(self):
        for kind, properties in PROPERTIES.items():
            proxy = new_filter(kind).SMProxy
            self.assertGreater(len(proxy.GetDocumentation().GetLongHelp()), 40)
            for name in properties:
                text = proxy.GetProperty(name).GetDocumentation().GetDescription()
                self.assertGreater(len(text.split()), 8, name)

    def test_outputs_have_names(self):
        for kind, names in OUTPUTS.items():
            proxy = new_filter(kind).SMProxy
            found = [proxy.GetOutputPortName(port) for port in range(len(names))]
            self.assertEqual(found, names)

    def test_a_mesh_is_judged_against_a_spacing_from_a_hessian(self):
        spacing = HessianSpacing(Input=wave(), ErrorTolerance=20.0)
        conformity = MeshConformity(Input=triangles(), SpacingSource=spacing)
        self.assertEqual(summary_of(conformity, 'NumberOfTriangles'), 800)
        self.assertGreater(summary_of(conformity, 'MeanConformity'), 0.1)

    def test_an_array_of_another_name_can_be_chosen(self):
        sized = simple.Calculator(Input=triangles(), ResultArrayName='h', Function='1')
        conformity = MeshConformity(Input=sized, SpacingArray=['POINTS', 'h'])
        self.assertEqual(summary_of(conformity, 'SmallestConformity'), 1.0)

    def test_histograms_are_shown_as_a_chart(self):
        conformity = MeshConformity(Input=triangles(), SpacingSource=HessianSpacing(Input=wave()))
        conformity.UpdatePipeline()
        histograms = simple.OutputPort(conformity, 1)
        self.assertEqual(histograms.GetDataInformation().GetDataSetTypeAsString(), 'vtkTable')
        display = simple.Show(histograms, simple.CreateView('XYChartView'))
        self.assertIn('ConformityPercent', list(display.GetProperty('SeriesVisibility').Available))
        self.assertEqual((display.UseIndexForXAxis, display.XArrayName), (0, 'Angle'))
        self.assertEqual(list(display.SeriesVisibility), ['AnglePercent'])

    def test_a_mesh_is_shown_by_its_conformity(self):
        conformity = MeshConformity(Input=triangles(), SpacingSource=HessianSpacing(Input=wave()))
        shown = simple.Show(conformity, simple.CreateView('RenderView'))
        self.assertEqual(shown.Representation, 'Surface With Edges')
        self.assertEqual(list(shown.ColorArrayName), ['POINTS', 'Conformity'])


if __name__ == '__main__':
    unittest.main()
