# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes from files of solvers: what our writers wrote, and small files as other programs write them."""

import math
import os
import tempfile
import unittest

from paraview import simple
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkOutputWindow

PLATE = os.path.join(os.environ['BITING_SOURCE_DIR'], 'Data', 'plate.vtk')

# A unit square of two triangles. Node numbers with gaps; physical groups with names.
GMSH_2 = '''$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
1 7 "100% wall"
2 3 "the water"
$EndPhysicalNames
$Nodes
4
10 0 0 0
20 1 0 0
30 1 1 0
50 0 1 0
$EndNodes
$Elements
5
1 15 2 0 1 10
2 1 2 7 1 10 20
3 1 2 7 2 20 30
4 2 2 3 1 10 20 30
5 2 2 3 1 10 30 50
$EndElements
'''
# Without physical groups; a node block of a curve with parameters, and an empty section.
GMSH_4 = '''$MeshFormat
4.1 0 8
$EndMeshFormat
$Comments
none
$EndComments
$Entities
0 1 1 0
5 0 0 0 1 0 0 0 0
9 0 0 0 1 1 0 0 1 5
$EndEntities
$Nodes
2 4 1 4
1 5 1 2
1
2
0 0 0 0
1 0 0 1
2 9 0 2
3
4
1 1 0
0 1 0
$EndNodes
$Elements
2 3 1 3
1 5 1 1
1 1 2
2 9 2 2
2 1 2 3
3 1 3 4
$EndElements
'''
SU2 = '''% a comment
NDIME= 2
NELEM=2   % two triangles
5 0 1 2
5 0 2 3
NPOIN= 4 4
0 0 0
1 0 1
1 1 2
0 1 3
NMARK= 2
MARKER_TAG= inlet
MARKER_ELEMS= 1
3 3 0
MARKER_TAG= wall
MARKER_ELEMS= 2
3 0 1
3 1 2
'''
ADCIRC = '''a square   % of two triangles
2 4
1 0 0 5.5
2 1 0 6
3 1 1 7
4 0 1 -1
1 3 1 2 3
2 3 1 3 4
1 = number of open boundaries
2 = number of their nodes
2
4
1
1 = number of land boundaries
3 = number of their nodes
3 0 = a land boundary
1
2
3
'''
SMS = '''MESH2D
E3T 1 1 2 3 5
E3T 2 1 3 4 5
ND 1 0 0 -5.5
ND 2 1 0 -6
ND 3 1 1 -7
ND 4 0 1 1
NS 4 -1 1
NS 1 2 -3
'''
FILES = {'old.msh': GMSH_2, 'new.msh': GMSH_4, 'square.su2': SU2, 'square.14': ADCIRC,
         'square.gr3': ADCIRC, 'square.2dm': SMS}
# A square within another.
POLYGONS = '''
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray
points, polygons, names = vtkPoints(), vtkCellArray(), vtkStringArray()
names.SetName('Ground')
for low, high, name in ((0, 1, 'sand'), (0.25, 0.75, 'hard rock')):
    ids = [points.InsertNextPoint(x, y, 0)
           for x, y in ((low, low), (high, low), (high, high), (low, high))]
    polygons.InsertNextCell(4, ids)
    names.InsertNextValue(name)
output.SetPoints(points)
output.SetPolys(polygons)
output.GetCellData().AddArray(names)
'''


def cells_of(data, array):
    """Each cell by its points, with its value."""
    values = data.GetCellData().GetAbstractArray(array)
    found = []
    for c in range(data.GetNumberOfCells()):
        cell = data.GetCell(c)
        places = tuple(data.GetPoint(cell.GetPointId(k)) for k in range(cell.GetNumberOfPoints()))
        found.append((places, values.GetVariantValue(c).ToString()))
    return found


class TestMeshReaderProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())
        cls.folder = tempfile.TemporaryDirectory()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def path_of(self, name, text):
        path = os.path.join(self.folder.name, name)
        with open(path, 'w', encoding='ascii') as file:
            file.write(text)
        return path

    def read(self, path):
        """The mesh and its edges, as File > Open reads them."""
        self.reader = simple.OpenDataFile(path)
        self.assertEqual(self.reader.GetXMLName(), 'BitingMeshReader')
        self.reader.UpdatePipeline()
        return [simple.FetchData(simple.OutputPort(self.reader, port))[0] for port in range(2)]

    def test_what_our_writers_write_comes_back(self):
        mesher = BitingMesher(Input=simple.LegacyVTKReader(FileNames=[PLATE]))
        mesher.UpdatePipeline()
        mesh, edges = (simple.FetchData(simple.OutputPort(mesher, port))[0] for port in range(2))
        kind = edges.GetCellData().GetArray('Kind')
        for end in ('msh', '2dm', 'su2', '14', 'gr3'):
            path = os.path.join(self.folder.name, 'plate.' + end)
            simple.SaveData(path, proxy=mesher)
            found, found_edges = self.read(path)
            regions = 'RegionId' if end in ('msh', '2dm') else None
            self.assertEqual([places for places, _ in sorted(cells_of(found, 'RegionId'))],
                             [places for places, _ in sorted(cells_of(mesh, 'RegionId'))])
            if regions:
                self.assertEqual(sorted(cells_of(found, regions)), sorted(cells_of(mesh, regions)))
            if end not in ('14', 'gr3'):
                tags = {frozenset(places): tag for k, (places, tag)
                        in enumerate(cells_of(edges, 'Tag')) if regions or kind.GetValue(k) == 0}
                self.assertEqual({frozenset(places): tag
                                  for places, tag in cells_of(found_edges, 'Tag')}, tags)

    def test_texts_of_polygons_are_names_of_groups_and_come_back(self):
        cells = simple.ProgrammableSource(OutputDataSetType='vtkPolyData', Script=POLYGONS)
        mesher = BitingMesher(Input=cells, UniformSpacing=0.3, RegionArray='Ground',
                              DomainRule='Union')
        mesher.UpdatePipeline()
        mesh = simple.FetchData(simple.OutputPort(mesher, 0))[0]
        for end in ('msh', '2dm'):
            path = os.path.join(self.folder.name, 'ground.' + end)
            simple.SaveData(path, proxy=mesher, RegionArray='Ground')
            found, _ = self.read(path)
            self.assertEqual(sorted(cells_of(found, 'RegionName')), sorted(cells_of(mesh, 'Ground')))
            finer = BitingRemesher(Input=self.reader, UniformSpacing=0.15, RegionArray='RegionName')
            finer.UpdatePipeline()
            inside = {name for places, name in cells_of(simple.FetchData(finer)[0], 'RegionName')
                      if all([0.25 < x < 0.75 and 0.25 < y < 0.75 for x, y, _ in places])}
            self.assertEqual(inside, {'hard rock'})

    def test_files_as_other_programs_write_them(self):
        a, b, c, d = (0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)
        expected = {
            'old.msh': ('2', [((a, b), '7'), ((b, c), '7')]),
            'new.msh': ('8', [((a, b), '5')]),
            'square.su2': ('0', [((d, a), '1'), ((a, b), '2'), ((b, c), '2')]),
            'square.14': ('0', [((d, a), '1'), ((a, b), '2'), ((b, c), '2')]),
            'square.gr3': ('0', [((d, a), '1'), ((a, b), '2'), ((b, c), '2')]),
            'square.2dm': ('4', [((d, a), '1'), ((a, b), '2'), ((b, c), '2')]),
        }
        for name, text in FILES.items():
            mesh, edges = self.read(self.path_of(name, text))
            region, tags = expected[name]
            self.assertEqual(cells_of(mesh, 'RegionId'), [((a, b, c), region), ((a, c, d), region)])
            self.assertEqual(cells_of(edges, 'Tag'), tags)

    def test_names_and_depths(self):
        mesh, edges = self.read(self.path_of('old.msh', GMSH_2))
        self.assertEqual(cells_of(mesh, 'RegionName')[0][1], 'the water')
        self.assertEqual(cells_of(edges, 'TagName')[0][1], '100% wall')
        _, edges = self.read(self.path_of('square.su2', SU2))
        self.assertEqual([tag for _, tag in cells_of(edges, 'TagName')], ['inlet', 'wall', 'wall'])
        for name, text in (('square.2dm', SMS), ('square.gr3', ADCIRC), ('square.14', ADCIRC)):
            mesh, edges = self.read(self.path_of(name, text))
            depths = mesh.GetPointData().GetArray('Depth')
            self.assertEqual([depths.GetValue(k) for k in range(4)], [5.5, 6, 7, -1])
        self.assertEqual(cells_of(edges, 'TagName')[-1][1], 'land, type 0')

    def test_what_the_mesh_has_not_of_a_file_is_said_in_warnings(self):
        quad = SU2.replace('NELEM=2 ', 'NELEM=1 ').replace('5 0 1 2\n5 0 2 3', '9 0 1 2 3')
        weir = ADCIRC.replace('3 0 = a land boundary\n1\n2\n3', '3 23\n1 2 1\n2 2 1\n3 2 1')
        twice = GMSH_2.replace('Elements\n5', 'Elements\n6').replace(
            '$EndElements', '6 2 2 4 1 10 20 30\n$EndElements')
        for name, text, words in (('quad.su2', quad, 'quad is divided'), ('weir.14', weir, 'heights'),
                                  ('twice.msh', twice, 'triangles in 4 (1)')):
            warnings = []

            @calldata_type(VTK_STRING)
            def note(_reader, _event, text, warnings=warnings):
                warnings.append(text)

            reader = simple.OpenDataFile(self.path_of(name, text))
            reader.GetClientSideObject().AddObserver('WarningEvent', note)
            reader.UpdatePipeline()
            self.assertEqual(len(warnings), 1, name)
            self.assertIn(words, warnings[0])
            self.assertEqual(simple.FetchData(reader)[0].GetNumberOfCells(), 2)

    def test_an_edge_among_elements_of_SU2_has_no_name(self):
        text = SU2.replace('NELEM=2 ', 'NELEM=3 ').replace('5 0 2 3', '5 0 2 3\n3 2 3')
        _, edges = self.read(self.path_of('edge.su2', text))
        self.assertEqual([tag for _, tag in cells_of(edges, 'TagName')],
                         ['', 'inlet', 'wall', 'wall'])

    def test_sections_of_SU2_that_are_not_of_the_mesh_are_passed_over(self):
        for place in ('NPOIN=', 'MARKER_TAG= wall'):
            text = SU2.replace(place, 'FFD_CORNER_POINTS= 2\n0.5 0.5\n1 2.5\n' + place)
            mesh, edges = self.read(self.path_of('box.su2', text))
            self.assertEqual([mesh.GetNumberOfCells(), edges.GetNumberOfCells()], [2, 3])

    def test_the_sign_of_a_physical_group_is_an_orientation(self):
        text = GMSH_4.replace('5 0 0 0 1 0 0 0 0', '5 0 0 0 1 0 0 1 -7 0')
        text = text.replace('9 0 0 0 1 1 0 0 1 5', '9 0 0 0 1 1 0 1 -4 1 5')
        mesh, edges = self.read(self.path_of('turned.msh', text))
        self.assertEqual([region for _, region in cells_of(mesh, 'RegionId')], ['3', '3'])
        self.assertEqual([tag for _, tag in cells_of(edges, 'Tag')], ['7'])

    def test_tags_go_on_to_the_remesher_and_back_into_a_file(self):
        self.read(self.path_of('square.su2', SU2))
        finer = BitingRemesher(Input=self.reader, TaggedLines=simple.OutputPort(self.reader, 1),
                               UniformSpacing=0.2)
        path = os.path.join(self.folder.name, 'finer.su2')
        simple.SaveData(path, proxy=finer, TagArray='TagName')
        mesh, edges = self.read(path)
        self.assertGreater(mesh.GetNumberOfCells(), 30)
        lengths = {'inlet': 0.0, 'wall': 0.0, 'boundary': 0.0}
        for (a, b), tag in cells_of(edges, 'TagName'):
            lengths[tag] += math.dist(a, b)
        for tag, length in (('inlet', 1), ('wall', 2), ('boundary', 1)):
            self.assertAlmostEqual(lengths[tag], length)

    def test_a_file_that_cannot_be_read_is_one_error_with_its_line(self):
        for name, text, reason in (
                ('few.su2', SU2.replace('5 0 2 3', '5 0 2'), 'Line 5 is not'),
                ('far.su2', SU2.replace('5 0 2 3', '5 0 2 9'), 'vertex 9'),
                ('solid.su2', SU2.replace('NDIME= 2', 'NDIME= 3'), 'Line 14 is not'),
                ('hyper.su2', SU2.replace('NDIME= 2', 'NDIME= 4'), 'Line 2 is not'),
                ('key.su2', SU2.replace('MARKER_TAG= wall', 'MARKER_TAGS= wall'), 'Line 17 is not'),
                ('short.14', ADCIRC[:ADCIRC.index('3 1 1 7')], 'The file ends'),
                ('binary.msh', GMSH_4.replace('4.1 0 8', '4.1 1 8'), 'Line 2 is not'),
                ('twice.msh', GMSH_2.replace('50 0 1', '10 0 1'), 'Line 14 is not'),
                ('points.msh', GMSH_2[:GMSH_2.index('$Elements')], 'no triangles'),
                ('empty.msh', '', 'a mesh of Gmsh')):
            errors = []

            @calldata_type(VTK_STRING)
            def note(_reader, _event, text, errors=errors):
                errors.append(text)

            reader = simple.OpenDataFile(self.path_of(name, text))
            reader.GetClientSideObject().AddObserver('ErrorEvent', note)
            window = vtkOutputWindow.GetInstance()
            mode = window.GetDisplayMode()
            window.SetDisplayModeToNever()
            reader.UpdatePipeline()
            window.SetDisplayMode(mode)
            self.assertEqual(len(errors), 1, name)
            self.assertIn(reason, errors[0])
            self.assertEqual(reader.GetDataInformation().GetNumberOfPoints(), 0)


if __name__ == '__main__':
    unittest.main()
