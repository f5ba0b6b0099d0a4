# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""The filter as a script in pvpython sees it: the names that scripts and state files keep."""

import os
import tempfile
import unittest

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkOutputWindow

DEFAULTS = {
    'UniformSpacing': 0.0,
    'BoundarySpacingArray': ['POINTS', 'Spacing'],
    'SourceSpacingArray': ['POINTS', 'Spacing'],
    'SpacingScale': 1.0,
    'MinimumSpacing': 0.0,
    'MaximumSpacing': 0.0,
    'Gradation': 0.3,
    'LimitByFeatureSize': 1,
    'CellsAcross': 1,
    'PeriodicTranslation': [0.0, 0.0, 0.0],
    'PeriodicTranslation2': [0.0, 0.0, 0.0],
    'SplitInterfaces': 'None',
    'RepairInput': 1,
    'MergeTolerance': 0.0,
    'EndTolerance': 0.01,
    'DomainRule': 'Even-Odd',
    'RegionArray': 'None',
    'KeepCellEdges': 0,
    'MeshBlocksSeparately': 0,
    'PreserveBoundary': 0,
    'Coordinates': 'Plane',
    'BoundaryTolerance': 0.0,
    'CornerAngle': 45.0,
    'MinimumLoopSize': 0.0,
    'BiteShape': 'Square',
    'BitingConstant': 0.0,
    'Placement': 'Bisectors',
    'FrontOrder': 'Layers',
    'MaximumNumberOfBites': -1,
    'Phi': 1.0,
    'Relaxation': 1,
    'MaximumNumberOfVertices': 20000000,
    'VerticesPerBlock': 64000,
    'NumberOfThreads': 0,
    'TransferSourceArrays': 1,
    'GenerateBites': 0,
}

ON_THE_PANEL = {
    'UniformSpacing', 'BoundarySpacingArray', 'SourceSpacingArray', 'SpacingScale', 'Gradation',
    'BoundaryTolerance', 'Relaxation', 'GenerateBites',
}

SQUARE = '# vtk DataFile Version 3.0\nsquare\nASCII\nDATASET POLYDATA\n' \
    'POINTS 4 double\n0 0 0 9 0 0 9 9 0 0 9 0\nLINES 1 6\n5 0 1 2 3 0\n'
SQUARE_SPACING = 'POINT_DATA 4\nSCALARS {name} double 1\nLOOKUP_TABLE default\n1 1 1 1\n'
OPEN_CHAIN = SQUARE.replace('LINES 1 6\n5 0 1 2 3 0', 'LINES 1 5\n4 0 1 2 3')
SQUARE_WITH_STRAY_POINT = SQUARE.replace('POINTS 4', 'POINTS 5').replace(
    '0 9 0\nLINES', '0 9 0 20 5 0\nVERTICES 1 2\n1 4\nLINES')
IMAGE = '# vtk DataFile Version 3.0\nimage\nASCII\nDATASET STRUCTURED_POINTS\n' \
    'DIMENSIONS 2 2 1\nORIGIN 0 0 0\nSPACING 9 9 1\nPOINT_DATA 4\n' \
    'SCALARS {name} double 1\nLOOKUP_TABLE default\n0.5 0.5 0.5 0.5\n'


SIDES = '''# vtk DataFile Version 3.0
the sides of a square
ASCII
DATASET POLYDATA
POINTS 4 double
0 0 0 10 0 0 10 10 0 0 10 0
LINES 4 12
2 0 1 2 1 2 2 2 3 2 3 0
CELL_DATA 4
SCALARS Size double 1
LOOKUP_TABLE default
0.05 0 0 0
'''


def triangles(mesher):
    mesher.UpdatePipeline()
    return mesher.GetDataInformation().GetNumberOfCells()


class TestBitingMesherProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())
        cls.folder = tempfile.TemporaryDirectory()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def read(self, name, text):
        path = os.path.join(self.folder.name, name)
        with open(path, 'w', encoding='ascii') as file:
            file.write(text)
        return simple.LegacyVTKReader(FileNames=[path])

    def square(self, array=None):
        text = SQUARE if array is None else SQUARE + SQUARE_SPACING.format(name=array)
        return self.read('square_%s.vtk' % array, text)

    def image(self, array):
        return self.read('image_%s.vtk' % array, IMAGE.format(name=array))

    def test_properties_have_their_documented_names_and_defaults(self):
        mesher = BitingMesher(Input=self.square())
        for name, value in DEFAULTS.items():
            found = getattr(mesher, name)
            self.assertEqual(list(found) if isinstance(value, list) else found, value, name)
        self.assertEqual(set(mesher.ListProperties()),
                         set(DEFAULTS) | {'Input', 'SpacingSource', 'Summary'})

    def test_relaxation_makes_the_smallest_angle_larger(self):
        mesher = BitingMesher(Input=self.square(), UniformSpacing=0.4, Relaxation=0)
        angles = []
        for relaxation in (0, 1):
            mesher.Relaxation = relaxation
            mesher.UpdatePipeline()
            summary = servermanager.Fetch(mesher).GetFieldData()
            angles.append(summary.GetArray('SmallestAngle').GetValue(0))
        self.assertGreater(angles[1], angles[0] + 3)

    def test_arrays_of_the_source_come_along_where_wanted(self):
        wavelet = simple.Wavelet(WholeExtent=[0, 9, 0, 6, 0, 0])
        mesher = BitingMesher(Input=self.square(), UniformSpacing=0.7, SpacingSource=wavelet,
                              SourceSpacingArray=['POINTS', 'None'])
        mesher.UpdatePipeline()
        mesh = servermanager.Fetch(mesher)
        mask = mesh.GetPointData().GetArray('vtkValidPointMask')
        for point in range(mesh.GetNumberOfPoints()):
            self.assertEqual(mask.GetValue(point), int(mesh.GetPoint(point)[1] <= 6))
        low, high = wavelet.PointData['RTData'].GetRange()
        found = mesh.GetPointData().GetArray('RTData').GetRange()
        self.assertTrue(low - 1e-3 <= found[0] < found[1] <= high + 1e-3)
        mesher.TransferSourceArrays = 0
        mesher.UpdatePipeline()
        self.assertIsNone(servermanager.Fetch(mesher).GetPointData().GetArray('RTData'))

    def test_labels_are_the_spaced_names(self):
        proxy = BitingMesher(Input=self.square()).SMProxy
        self.assertEqual(proxy.GetXMLLabel(), 'Biting Mesher')
        for name in list(DEFAULTS) + ['SpacingSource']:
            label = proxy.GetProperty(name).GetXMLLabel()
            self.assertEqual(label.replace(' ', ''), name)

    def test_every_property_is_explained(self):
        proxy = BitingMesher(Input=self.square()).SMProxy
        for name in DEFAULTS:
            text = proxy.GetProperty(name).GetDocumentation().GetDescription()
            self.assertGreater(len(text.split()), 8, name)
        self.assertGreater(len(proxy.GetDocumentation().GetShortHelp()), 20)
        self.assertGreater(len(proxy.GetDocumentation().GetLongHelp()), 40)

    def test_the_panel_shows_the_everyday_properties(self):
        proxy = BitingMesher(Input=self.square()).SMProxy
        shown = {name for name in DEFAULTS
                 if proxy.GetProperty(name).GetPanelVisibility() == 'default'}
        self.assertEqual(shown, ON_THE_PANEL)

    def test_explanations_are_plain_words(self):
        proxy = BitingMesher(Input=self.square()).SMProxy
        for name in list(DEFAULTS) + ['SpacingSource', 'Summary']:
            self.assertNotIn('`', proxy.GetProperty(name).GetDocumentation().GetDescription(), name)

    def test_every_property_is_of_a_kind_that_gets_a_widget(self):
        proxy = BitingMesher(Input=self.square()).SMProxy
        for name in DEFAULTS:
            self.assertNotEqual(proxy.GetProperty(name).GetClassName(), 'vtkSMIdTypeVectorProperty')

    def test_the_number_of_bites_can_be_animated(self):
        proxy = BitingMesher(Input=self.square()).SMProxy
        self.assertTrue(proxy.GetProperty('MaximumNumberOfBites').GetAnimateable())

    def test_a_summary_tells_size_and_quality(self):
        mesher = BitingMesher(Input=self.square(), UniformSpacing=1.0)
        mesher.UpdatePipeline()
        mesher.UpdatePipelineInformation()
        for part in ('vertices', 'triangles', 'Smallest angle', 'conformity', 'spacings'):
            self.assertIn(part, mesher.Summary)

    def test_without_a_mesh_the_summary_says_why(self):
        mesher = BitingMesher(Input=self.read('open.vtk', OPEN_CHAIN))
        window = vtkOutputWindow.GetInstance()
        mode = window.GetDisplayMode()
        window.SetDisplayModeToNever()
        mesher.UpdatePipeline()
        window.SetDisplayMode(mode)
        mesher.UpdatePipelineInformation()
        self.assertTrue(mesher.Summary.startswith('Error: There is no closed loop'), mesher.Summary)

    def test_the_mesh_is_shown_by_its_angles_with_edges_and_bad_ones_are_red(self):
        mesher = BitingMesher(Input=self.square())
        shown = simple.Show(mesher, simple.CreateView('RenderView'))
        self.assertEqual(shown.Representation, 'Surface With Edges')
        self.assertEqual(list(shown.ColorArrayName), ['CELLS', 'MinimumAngle'])
        value, red, green, blue = list(simple.GetColorTransferFunction('MinimumAngle').RGBPoints)[4:8]
        self.assertLess(value, 20.0)
        self.assertGreater(red, 3 * max(green, blue))

    def test_problems_are_spheres_and_boundary_edges_thick(self):
        mesher = BitingMesher(Input=self.square())
        view = simple.CreateView('RenderView')
        edges, problems = (simple.Show(simple.OutputPort(mesher, port), view) for port in (1, 3))
        self.assertGreater(edges.LineWidth, 1.0)
        self.assertEqual(problems.RenderPointsAsSpheres, 1)
        self.assertGreater(problems.PointSize, 5.0)

    def test_figures_of_the_whole_are_not_offered_to_colour_by(self):
        mesher = BitingMesher(Input=self.square())
        shown = simple.Show(mesher, simple.CreateView('RenderView'))
        domain = shown.SMProxy.GetProperty('ColorArrayName').GetDomain('array_list')
        offered = {domain.GetString(k) for k in range(domain.GetNumberOfStrings())}
        self.assertIn('Conformity', offered)
        self.assertNotIn('NumberOfVertices', offered)
        self.assertLess(len(offered), 12)

    def test_outputs_have_names(self):
        proxy = BitingMesher(Input=self.square()).SMProxy
        names = [proxy.GetOutputPortName(port) for port in range(proxy.GetNumberOfOutputPorts())]
        self.assertEqual(names, ['Mesh', 'Boundary Edges', 'Bites', 'Problems'])

    def test_without_any_number_the_mesh_is_neither_coarse_nor_huge(self):
        count = triangles(BitingMesher(Input=self.square()))
        self.assertGreater(count, 1000)
        self.assertLess(count, 20000)

    def test_after_an_error_the_mesh_before_it_is_gone(self):
        mesher = BitingMesher(Input=self.square(), UniformSpacing=1.0)
        view = simple.CreateRenderView()
        shown = simple.Show(mesher, view)
        view.Update()
        self.assertGreater(shown.GetRepresentedDataInformation().GetNumberOfCells(), 0)
        mesher.MaximumNumberOfVertices = 3
        errors = []
        output = vtkOutputWindow.GetInstance()
        output.SetDisplayModeToNever()
        tag = output.AddObserver('ErrorEvent', lambda *unused: errors.append(1))
        view.Update()
        output.RemoveObserver(tag)
        output.SetDisplayModeToDefault()
        self.assertEqual(len(errors), 1)
        self.assertEqual(shown.GetRepresentedDataInformation().GetNumberOfCells(), 0)
        self.assertEqual(servermanager.Fetch(mesher).GetNumberOfCells(), 0)
        simple.Delete(view)

    def test_half_the_scale_gives_about_four_times_the_triangles(self):
        square = self.square()
        coarse = triangles(BitingMesher(Input=square, UniformSpacing=1.0))
        fine = triangles(BitingMesher(Input=square, UniformSpacing=1.0, SpacingScale=0.5))
        self.assertGreater(fine, 2.5 * coarse)

    def test_arrays_named_spacing_are_chosen_by_default(self):
        coarse = triangles(BitingMesher(Input=self.square('Spacing')))
        self.assertLess(coarse, 400)
        fine = triangles(BitingMesher(Input=self.square('Spacing'),
                                      SpacingSource=self.image('Spacing')))
        self.assertGreater(fine, 2.5 * coarse)

    def test_arrays_of_other_names_can_be_chosen(self):
        by_array = triangles(BitingMesher(Input=self.square('h'),
                                          BoundarySpacingArray=['POINTS', 'h']))
        self.assertLess(by_array, 400)
        by_source = triangles(BitingMesher(Input=self.square(), SpacingSource=self.image('h'),
                                           SourceSpacingArray=['POINTS', 'h']))
        self.assertGreater(by_source, 2.5 * by_array)

    def test_cell_arrays_are_read_as_they_are(self):
        # The lower side 0.05, elsewhere nothing: as points ParaView would have zeros, or means.
        square = self.read('sides.vtk', SIDES)
        counts = []
        for association in ('CELLS', 'POINTS'):
            mesher = BitingMesher(Input=square, UniformSpacing=1.0,
                                  BoundarySpacingArray=[association, 'Size'])
            counts.append(triangles(mesher))
            edges = servermanager.Fetch(mesher, idx=1)
            names = [edges.GetPointData().GetArrayName(k)
                     for k in range(edges.GetPointData().GetNumberOfArrays())]
            self.assertEqual(names, ['MeshPointId'])
        self.assertEqual(counts[0], counts[1])
        without = triangles(BitingMesher(Input=square, UniformSpacing=1.0))
        self.assertGreater(counts[0], 2 * without)

    def test_the_panel_offers_arrays_of_points_and_of_cells(self):
        mesher = BitingMesher(Input=self.read('sides.vtk', SIDES))
        mesher.UpdatePipeline()
        domain = mesher.SMProxy.GetProperty('BoundarySpacingArray').FindDomain(
            'vtkSMArrayListDomain')
        found = {(domain.GetFieldAssociation(k), domain.GetString(k))
                 for k in range(domain.GetNumberOfStrings())}
        self.assertIn((1, 'Size'), found)

    def test_none_leaves_the_array_out(self):
        mesher = BitingMesher(Input=self.square('Spacing'), UniformSpacing=3.0)
        mesher.BoundarySpacingArray = ['POINTS', 'None']
        self.assertLess(triangles(mesher), 60)

    def test_the_source_can_be_taken_away(self):
        mesher = BitingMesher(Input=self.square('Spacing'), SpacingSource=self.image('Spacing'))
        fine = triangles(mesher)
        mesher.SpacingSource = None
        self.assertGreater(fine, 2.5 * triangles(mesher))

    def test_bites_and_boundary_are_outputs(self):
        mesher = BitingMesher(Input=self.square(), UniformSpacing=1.0, GenerateBites=1,
                              FrontOrder='Largest Y')
        mesher.UpdatePipeline()
        for port in (1, 2):
            self.assertGreater(mesher[port].GetDataInformation().GetNumberOfCells(), 0, port)

    def test_problems_of_a_refused_input_reach_the_client_and_the_next_filter(self):
        mesher = BitingMesher(Input=self.read('open.vtk', OPEN_CHAIN))
        output = vtkOutputWindow.GetInstance()
        output.SetDisplayModeToNever()
        try:
            mesher.UpdatePipeline()
        except RuntimeError:
            pass
        problems = servermanager.Fetch(mesher, idx=3)
        glyphs = simple.Glyph(Input=simple.OutputPort(mesher, 3), GlyphType='Sphere')
        glyphs.UpdatePipeline()
        output.SetDisplayModeToDefault()
        self.assertEqual(triangles(mesher), 0)
        self.assertEqual(problems.GetNumberOfPoints(), 2)
        messages = problems.GetPointData().GetAbstractArray('Message')
        self.assertIn('open end at point 3', messages.GetValue(1))
        self.assertGreater(glyphs.GetDataInformation().GetNumberOfCells(), 20)

    def test_the_legend_of_problems_names_every_kind(self):
        mesher = BitingMesher(Input=self.read('outside.vtk', SQUARE_WITH_STRAY_POINT))
        output = vtkOutputWindow.GetInstance()
        output.SetDisplayModeToNever()
        problems = servermanager.Fetch(mesher, idx=3)
        output.SetDisplayModeToDefault()
        kinds = problems.GetFieldData().GetAbstractArray('ProblemKindNames').GetNumberOfValues()
        colors = simple.GetColorTransferFunction('ProblemKind')
        self.assertEqual(list(colors.Annotations)[::2], [str(kind) for kind in range(kinds)])
        self.assertEqual(len(colors.IndexedColors), 3 * kinds)

    def test_problems_of_a_repaired_input_have_places_and_kinds(self):
        mesher = BitingMesher(Input=self.read('outside.vtk', SQUARE_WITH_STRAY_POINT))
        output = vtkOutputWindow.GetInstance()
        output.SetDisplayModeToNever()
        problems = servermanager.Fetch(mesher, idx=3)
        output.SetDisplayModeToDefault()
        self.assertGreater(triangles(mesher), 0)
        self.assertEqual(problems.GetNumberOfPoints(), 1)
        self.assertEqual(problems.GetPoint(0), (20.0, 5.0, 0.0))
        kind = problems.GetPointData().GetArray('ProblemKind').GetValue(0)
        names = problems.GetFieldData().GetAbstractArray('ProblemKindNames')
        self.assertEqual(names.GetValue(kind), 'OutsidePoints')

    def test_a_state_gives_the_same_mesh(self):
        mesher = BitingMesher(registrationName='Mesher', Input=self.square(), UniformSpacing=0.7)
        before = triangles(mesher)
        path = os.path.join(self.folder.name, 'state.pvsm')
        servermanager.SaveState(path)
        simple.ResetSession()
        simple.LoadState(path)
        self.assertEqual(triangles(simple.FindSource('Mesher')), before)


if __name__ == '__main__':
    unittest.main()
