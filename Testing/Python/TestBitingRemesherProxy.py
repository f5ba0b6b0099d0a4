# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""BitingRemesher as a script in pvpython sees it."""

import math
import os
import unittest

from paraview import simple

PROPERTIES = {
    'UniformSpacing': 0.0, 'SpacingScale': 1.0, 'MinimumSpacing': 0.0, 'MaximumSpacing': 0.0,
    'Gradation': 0.3, 'LimitByFeatureSize': 1, 'Preference': 'Balanced', 'EdgePolicy': 'Free',
    'BoundaryTolerance': 0.0, 'FeatureAngle': 30.0,
    'RegionArray': 'RegionId', 'FrozenArray': 'None', 'TransferData': 1, 'Relaxation': 1, 'Rings': 2,
    'Coordinates': 'Plane',
    'RelaxAll': 0, 'MaximumNumberOfVertices': 20000000, 'NumberOfThreads': 0, 'GenerateBites': 0,
    'SpacingArray': ['POINTS', 'Spacing'], 'SourceSpacingArray': ['POINTS', 'Spacing'],
}
OTHERS = {'Input', 'SpacingSource', 'TaggedLines', 'Summary'}
OUTPUTS = ['Mesh', 'Boundary Edges', 'Bites', 'Problems']


def mesh(spacing=0.05):
    square = simple.Rectangle() if hasattr(simple, 'Rectangle') else simple.Plane()
    return BitingMesher(Input=square, UniformSpacing=spacing)


def figure(proxy, name):
    proxy.UpdatePipeline()
    data = simple.FetchData(simple.OutputPort(proxy, 0))[0]
    return data.GetFieldData().GetArray(name).GetValue(0)


class TestBitingRemesherProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())

    def test_properties_have_their_documented_names_and_defaults(self):
        proxy = BitingRemesher(Input=mesh())
        for name, value in PROPERTIES.items():
            found = getattr(proxy, name)
            self.assertEqual(list(found) if isinstance(value, list) else found, value, name)
        self.assertEqual(set(proxy.ListProperties()), set(PROPERTIES) | OTHERS)

    def test_labels_are_the_spaced_names(self):
        proxy = BitingRemesher(Input=mesh()).SMProxy
        self.assertEqual(proxy.GetXMLLabel(), 'Biting Remesher')
        for name in list(PROPERTIES) + ['SpacingSource', 'TaggedLines']:
            self.assertEqual(proxy.GetProperty(name).GetXMLLabel().replace(' ', ''), name)

    def test_everything_is_explained(self):
        proxy = BitingRemesher(Input=mesh()).SMProxy
        self.assertGreater(len(proxy.GetDocumentation().GetLongHelp()), 40)
        for name in set(PROPERTIES) | OTHERS:
            text = proxy.GetProperty(name).GetDocumentation().GetDescription()
            self.assertGreater(len(text.split()), 8, name)

    def test_outputs_have_names(self):
        proxy = BitingRemesher(Input=mesh()).SMProxy
        self.assertEqual([proxy.GetOutputPortName(port) for port in range(4)], OUTPUTS)

    def test_a_mesh_of_its_own_spacing_passes_through(self):
        remesher = BitingRemesher(Input=mesh())
        self.assertEqual(figure(remesher, 'NewVertices'), 0)
        remesher.UpdatePropertyInformation()
        self.assertIn('0 removed, 0 new', remesher.Summary)

    def test_relax_all_makes_a_mesh_anew_that_fits(self):
        remesher = BitingRemesher(Input=mesh(), RelaxAll=1)
        self.assertGreater(figure(remesher, 'NewVertices'), 100)

    def kept_with_rings(self, spacing):
        kept = []
        for rings in (0, 2):
            disc = simple.Calculator(
                Input=mesh(0.03), ResultArrayName='Spacing', Function=spacing)
            kept.append(figure(BitingRemesher(Input=disc, Rings=rings), 'KeptTriangles'))
        return kept

    def test_more_rings_keep_less_where_vertices_have_to_go(self):
        few, more = self.kept_with_rings(
            'max(0.03, 0.06-0.3*sqrt(coordsX*coordsX+coordsY*coordsY))')
        self.assertGreater(few, more)

    def test_more_rings_keep_no_more_where_all_that_fits_stays(self):
        few, more = self.kept_with_rings(
            'max(0.015, min(0.03, 0.3*sqrt(coordsX*coordsX+coordsY*coordsY)))')
        self.assertGreaterEqual(few, more)

    def test_a_bent_boundary_gets_coarser_within_the_tolerance(self):
        spacing, tolerance = 0.25, 0.2
        disc = BitingMesher(
            Input=simple.Disk(InnerRadius=0.4, OuterRadius=1, CircumferentialResolution=90),
            UniformSpacing=0.06)
        field = simple.Calculator(Input=disc, ResultArrayName='field', Function='coordsX')
        counts = []
        for wanted in (0.0, tolerance):
            remesher = BitingRemesher(
                Input=field, UniformSpacing=spacing, BoundaryTolerance=wanted)
            remesher.UpdatePipeline()
            mesh_made = simple.FetchData(simple.OutputPort(remesher, 0))[0]
            edges = simple.FetchData(simple.OutputPort(remesher, 1))[0]
            counts.append(edges.GetNumberOfCells())
        self.assertLess(3 * counts[1], counts[0])
        # Numbers of cells differ from line to line, and are no tags.
        tagged = BitingRemesher(Input=disc, TaggedLines=simple.OutputPort(disc, 1),
                                UniformSpacing=spacing, BoundaryTolerance=tolerance)
        tagged.UpdatePipeline()
        self.assertEqual(
            simple.OutputPort(tagged, 1).GetDataInformation().GetNumberOfCells(), counts[1])
        inner, outer = 0.4 * math.cos(math.pi / 90), math.cos(math.pi / 90)
        values = mesh_made.GetPointData().GetArray('field')
        for point in range(mesh_made.GetNumberOfPoints()):
            x, y, _ = mesh_made.GetPoint(point)
            self.assertGreater(math.hypot(x, y), inner - tolerance * spacing)
            # Of the nearest place of the old mesh, where it does not hold the point.
            off = max(0.4 - math.hypot(x, y), 0.0)
            self.assertLess(abs(values.GetValue(point) - x), 1e-6 + off)
        for cell in range(edges.GetNumberOfCells()):
            ends = edges.GetCell(cell).GetPoints()
            middle = [0.5 * (ends.GetPoint(0)[k] + ends.GetPoint(1)[k]) for k in (0, 1)]
            radius = math.hypot(*middle)
            off = min(max(inner - radius, radius - 0.4), max(outer - radius, radius - 1))
            self.assertLess(off, tolerance * spacing + 1e-6)

    def test_a_scale_of_a_half_keeps_vertices_and_adds_others(self):
        old = mesh()
        remesher = BitingRemesher(Input=old, SpacingScale=0.5)
        count = figure(old, 'NumberOfVertices')
        self.assertGreater(figure(remesher, 'KeptVertices'), 0.9 * count)
        self.assertGreater(figure(remesher, 'NewVertices'), 2 * count)

    def test_a_hessian_is_followed(self):
        wave = simple.Calculator(Input=mesh(), ResultArrayName='wave', Function='sin(9*coordsX)')
        spacing = HessianSpacing(
            Input=wave, ScalarArray=['POINTS', 'wave'], MinimumSpacing=0.01, MaximumSpacing=0.1)
        remesher = BitingRemesher(Input=wave, SpacingSource=spacing)
        self.assertGreater(figure(remesher, 'MeanConformity'), 0.85)
        data = simple.FetchData(simple.OutputPort(remesher, 0))[0]
        self.assertTrue(data.GetPointData().HasArray('wave'))

    def test_tags_come_from_the_boundary_edges_of_the_mesher(self):
        old = mesh()
        old.UpdatePipeline()
        remesher = BitingRemesher(
            Input=old, TaggedLines=simple.OutputPort(old, 1), UniformSpacing=0.03)
        remesher.UpdatePipeline()
        edges = simple.FetchData(simple.OutputPort(remesher, 1))[0]
        self.assertGreater(edges.GetNumberOfCells(), 100)

    def test_tags_of_a_mesh_of_ours_come_along_by_themselves(self):
        square = simple.Plane()
        sides = simple.Calculator(Input=simple.FeatureEdges(Input=square), ResultArrayName='Side',
            AttributeType='Cell Data', Function='7')
        old = BitingMesher(Input=sides, UniformSpacing=0.05)
        between = simple.Calculator(Input=old, ResultArrayName='Spacing', Function='0.03')
        for source, tags in [(between, [7]), (simple.Transform(Input=between), []), (old, [7])]:
            if hasattr(source, 'Transform'):
                source.Transform.Translate = [1.0, 0.0, 0.0]
            remesher = BitingRemesher(Input=source, MaximumSpacing=0.03)
            remesher.UpdatePipeline()
            edges = simple.FetchData(simple.OutputPort(remesher, 1))[0].GetCellData()
            array = edges.GetArray('Side')
            self.assertEqual(array is not None, bool(tags), source)
            if array:
                self.assertEqual(list(array.GetRange()), [7.0, 7.0])


if __name__ == '__main__':
    unittest.main()
