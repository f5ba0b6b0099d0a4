# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Files for solvers, as Save Data writes them: read back and compared with the mesh."""

import math
import os
import tempfile
import unittest

from biting.vtkBitingFilters import vtkBitingMesher, vtkBitingMeshWriter
from paraview import simple
from vtkmodules.vtkCommonCore import (
    vtkDoubleArray, vtkIdTypeArray, vtkIntArray, vtkLongLongArray, vtkOutputWindow, vtkPoints,
    vtkStringArray, vtkUnsignedCharArray)
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkIONetCDF import vtkNetCDFUGRIDReader

PLATE = os.path.join(os.environ['BITING_SOURCE_DIR'], 'Data', 'plate.vtk')


def turned(corners):
    """The same triangle, the smallest of its corners first: equal only for equal orientation."""
    first = corners.index(min(corners))
    return tuple(corners[first:] + corners[:first])


def triangles_of(mesh):
    region = mesh.GetCellData().GetArray('RegionId')
    cells = range(mesh.GetNumberOfCells())
    return {turned([mesh.GetCell(c).GetPointId(k) for k in range(3)]): int(region.GetValue(c))
            for c in cells}


def edges_of(edges, tags):
    ids, kinds = edges.GetPointData().GetArray('MeshPointId'), edges.GetCellData().GetArray('Kind')
    values = edges.GetCellData().GetArray(tags)
    found = {}
    for c in range(edges.GetNumberOfCells()):
        ends = frozenset(int(ids.GetValue(edges.GetCell(c).GetPointId(k))) for k in range(2))
        found[ends] = (int(values.GetValue(c)), int(kinds.GetValue(c)))
    return found


def points_of(mesh):
    return [mesh.GetPoint(point) for point in range(mesh.GetNumberOfPoints())]


def area_of(points, triangles):
    """Of triangles in the plane z = 0, all turned the same way."""
    total = 0.0
    for triangle in triangles:
        a, b, c = (points[corner] for corner in triangle)
        total += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
    return total


def read_gmsh(path):
    """Points in the order of their numbers; triangles and edges with their physical numbers."""
    with open(path, encoding='ascii') as file:
        lines = iter(file.read().splitlines())
    points, triangles, edges, physical = {}, {}, {}, {}
    for line in lines:
        if line == '$Entities':
            _, curves, surfaces, _ = map(int, next(lines).split())
            for dimension, count in ((1, curves), (2, surfaces)):
                for _ in range(count):
                    words = next(lines).split()
                    physical[dimension, int(words[0])] = int(words[8])
        elif line == '$Nodes':
            for _ in range(int(next(lines).split()[0])):
                count = int(next(lines).split()[3])
                numbers = [int(next(lines)) for _ in range(count)]
                for number in numbers:
                    points[number] = tuple(map(float, next(lines).split()))
        elif line == '$Elements':
            for _ in range(int(next(lines).split()[0])):
                dimension, entity, _, count = map(int, next(lines).split())
                for _ in range(count):
                    ids = [int(word) - 1 for word in next(lines).split()[1:]]
                    if dimension == 2:
                        triangles[turned(ids)] = physical[2, entity]
                    else:
                        edges[frozenset(ids)] = physical[1, entity]
    return [points[number] for number in sorted(points)], triangles, edges


def read_su2(path):
    with open(path, encoding='ascii') as file:
        lines = iter(file.read().splitlines())
    points, triangles, edges = [], set(), {}
    for line in lines:
        key, value = line.split('=')
        if key == 'NELEM':
            for _ in range(int(value)):
                triangles.add(turned([int(word) for word in next(lines).split()[1:4]]))
        elif key == 'NPOIN':
            points = [tuple(map(float, next(lines).split()[:2])) for _ in range(int(value))]
        elif key == 'MARKER_TAG':
            for _ in range(int(next(lines).split('=')[1])):
                edges[frozenset(map(int, next(lines).split()[1:]))] = value.strip()
    return points, triangles, edges


def read_adcirc(path):
    """Points with depths, triangles, and lists of node strings: open, and land with their types."""
    with open(path, encoding='ascii') as file:
        lines = iter(file.read().splitlines()[1:])
    elements, nodes = map(int, next(lines).split())
    points = [tuple(map(float, next(lines).split()[1:])) for _ in range(nodes)]
    triangles = {turned([int(word) - 1 for word in next(lines).split()[2:]])
                 for _ in range(elements)}
    strings = []
    for _ in range(2):
        count, total = int(next(lines).split()[0]), int(next(lines).split()[0])
        group = []
        for _ in range(count):
            words = next(lines).split()
            group.append((words[1:], [int(next(lines)) - 1 for _ in range(int(words[0]))]))
        assert total == sum(len(string) for _, string in group)
        strings.append(group)
    return points, triangles, strings


def write_square(path, tags, open_tags=None):
    """The mesh of a square whose four sides have these tags, in the file."""
    square = vtkPolyData()
    square.SetPoints(vtkPoints())
    for place in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)):
        square.GetPoints().InsertNextPoint(place)
    square.SetLines(vtkCellArray())
    for side in range(4):
        square.GetLines().InsertNextCell(2, [side, (side + 1) % 4])
    tags.SetName('Tag')
    square.GetCellData().AddArray(tags)
    mesher = vtkBitingMesher()
    mesher.SetInputData(square)
    mesher.SetUniformSpacing(0.3)
    writer = vtkBitingMeshWriter()
    writer.SetFileName(path)
    writer.SetOpenTags(open_tags)
    writer.SetInputConnection(mesher.GetOutputPort(0))
    writer.SetBoundaryEdgesConnection(mesher.GetOutputPort(1))
    writer.Write()


def in_two_pieces(mesh):
    """As two ranks save it: each has every other cell, some of the other's as ghosts, and their
    points."""
    spread, points, polys = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    cell_ids, point_ids = vtkIdTypeArray(), vtkIdTypeArray()
    ghosts, regions = vtkUnsignedCharArray(), vtkIntArray()
    for array, name in ((cell_ids, 'GlobalCellIds'), (point_ids, 'GlobalPointIds'),
                        (ghosts, 'vtkGhostType'), (regions, 'RegionId')):
        array.SetName(name)
    for piece in (1, 0):
        numbers = {}
        for cell in reversed(range(mesh.GetNumberOfCells())):
            if cell % 2 == piece or cell % 7 == 0:
                corners = mesh.GetCell(cell).GetPointIds()
                ids = [corners.GetId(k) for k in range(3)]
                for point in ids:
                    if point not in numbers:
                        numbers[point] = points.InsertNextPoint(mesh.GetPoint(point))
                        point_ids.InsertNextValue(point)
                polys.InsertNextCell(3, [numbers[point] for point in ids])
                cell_ids.InsertNextValue(cell)
                is_own = cell % 2 == piece
                ghosts.InsertNextValue(0 if is_own else vtkDataSetAttributes.DUPLICATECELL)
                regions.InsertNextValue(int(mesh.GetCellData().GetArray('RegionId').GetValue(cell)))
    spread.SetPoints(points)
    spread.SetPolys(polys)
    spread.GetPointData().SetGlobalIds(point_ids)
    spread.GetCellData().SetGlobalIds(cell_ids)
    spread.GetCellData().AddArray(ghosts)
    spread.GetCellData().AddArray(regions)
    return spread


class TestMeshWritersProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())
        cls.folder = tempfile.TemporaryDirectory()
        cls.mesher = BitingMesher(Input=simple.LegacyVTKReader(FileNames=[PLATE]))
        cls.mesher.UpdatePipeline()
        cls.mesh = simple.FetchData(simple.OutputPort(cls.mesher, 0))[0]
        cls.edges = simple.FetchData(simple.OutputPort(cls.mesher, 1))[0]

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def save(self, name, proxy=None, **settings):
        path = os.path.join(self.folder.name, name)
        simple.SaveData(path, proxy=proxy or self.mesher, **settings)
        return path

    def test_gmsh_has_the_same_points_triangles_regions_and_tags(self):
        points, triangles, edges = read_gmsh(self.save('plate.msh'))
        self.assertEqual(points, points_of(self.mesh))
        regions = {corners: region + 1 for corners, region in triangles_of(self.mesh).items()}
        self.assertEqual(triangles, regions)
        tags = {ends: tag for ends, (tag, _) in edges_of(self.edges, 'Tag').items()}
        self.assertEqual(edges, tags)

    def test_su2_has_the_same_points_triangles_and_tags_of_the_boundary(self):
        points, triangles, edges = read_su2(self.save('plate.su2'))
        self.assertEqual(points, [point[:2] for point in points_of(self.mesh)])
        self.assertEqual(triangles, set(triangles_of(self.mesh)))
        tags = {ends: str(tag) for ends, (tag, kind) in edges_of(self.edges, 'Tag').items()
                if kind == 0}
        self.assertEqual(edges, tags)

    def test_adcirc_has_the_same_points_and_triangles_and_every_boundary_edge_once(self):
        points, triangles, (opens, lands) = read_adcirc(self.save('plate.14', OpenTags='1'))
        self.assertEqual(points, [(*point[:2], 0.0) for point in points_of(self.mesh)])
        self.assertEqual(triangles, set(triangles_of(self.mesh)))
        boundary = {ends: tag for ends, (tag, kind) in edges_of(self.edges, 'Tag').items()
                    if kind == 0}
        found = {}
        for is_open, strings in ((True, opens), (False, lands)):
            for kind, string in strings:
                closed = string + string[:1] if kind == ['1'] else string
                for ends in zip(closed, closed[1:]):
                    self.assertNotIn(frozenset(ends), found)
                    found[frozenset(ends)] = is_open
        self.assertEqual(found, {ends: tag == 1 for ends, tag in boundary.items()})
        self.assertEqual(sum(kind == ['1'] for kind, _ in lands), 6)

    def test_tags_come_along_through_filters_that_keep_the_points(self):
        deep = simple.Calculator(Input=self.mesher, ResultArrayName='Depth', Function='10+coordsX')
        points, _, (opens, _) = read_adcirc(self.save('deep.14', deep, OpenTags='1'))
        self.assertEqual([point[2] for point in points], [10 + point[0] for point in points])
        self.assertTrue(opens)

    def test_ugrid_read_by_vtk_has_the_same_points_and_triangles(self):
        # That of VTK 9.2 reads one value of arrays that have no time: they are judged in C++.
        deep = simple.Calculator(Input=self.mesher, ResultArrayName='Depth', Function='10+coordsX')
        reader = vtkNetCDFUGRIDReader()
        reader.SetFileName(self.save('plate.nc', deep, Coordinates='Longitude Latitude'))
        reader.Update()
        back = reader.GetOutput()
        self.assertEqual(points_of(back), [(*point[:2], 0.0) for point in points_of(self.mesh)])
        self.assertEqual(set(triangles_of(self.mesh)), {
            turned([back.GetCell(cell).GetPointId(k) for k in range(3)])
            for cell in range(back.GetNumberOfCells())})
        self.assertTrue(back.GetCellData().HasArray('mesh2d_face_region'))
        self.assertTrue(back.GetPointData().HasArray('mesh2d_node_depth'))

    def test_a_mesh_made_anew_has_its_own_tags(self):
        finer = BitingRemesher(Input=self.mesher, TaggedLines=simple.OutputPort(self.mesher, 1),
                               SpacingScale=0.7)
        finer.UpdatePipeline()
        own = simple.FetchData(simple.OutputPort(finer, 1))[0]
        tags = {ends: tag for ends, (tag, _) in edges_of(own, 'Tag').items()}
        _, triangles, edges = read_gmsh(self.save('finer.msh', finer))
        self.assertEqual(edges, tags)
        self.assertTrue(all(any(ends < set(corners) for corners in triangles) for ends in edges))

    def test_edges_of_a_mesh_before_are_no_tags(self):
        finer = BitingRemesher(Input=self.mesher, SpacingScale=0.7)
        finer.UpdatePipeline()
        writer = vtkBitingMeshWriter()
        writer.SetFileName(os.path.join(self.folder.name, 'before.msh'))
        writer.SetInputConnection(finer.GetClientSideObject().GetOutputPort(0))
        writer.SetBoundaryEdgesConnection(self.mesher.GetClientSideObject().GetOutputPort(1))
        warnings = []
        writer.AddObserver('WarningEvent', lambda *_: warnings.append(1))
        writer.Write()
        self.assertEqual(len(warnings), 1)
        self.assertFalse(read_gmsh(writer.GetFileName())[2])

    def test_another_array_can_be_the_tag(self):
        _, _, edges = read_gmsh(self.save('cells.msh', TagArray='OriginalCellId'))
        self.assertEqual(len(set(edges.values())),
                         len({tag for tag, _ in edges_of(self.edges, 'OriginalCellId').values()}))

    def test_tags_that_differ_in_late_digits_only_stay_apart(self):
        path = os.path.join(self.folder.name, 'digits.su2')
        for array, values in ((vtkLongLongArray(), [1234567, 1234568, 2**60, 2**60 + 1]),
                              (vtkDoubleArray(), [0.5, 0.1234567, 0.1234568, 1234567.0])):
            for value in values:
                array.InsertNextValue(value)
            write_square(path, array)
            self.assertEqual(set(read_su2(path)[2].values()), set(map(
                lambda value: str(int(value) if value == int(value) else value), values)))

    def test_tags_that_differ_in_quotes_and_ends_of_lines_only_stay_apart(self):
        tags = vtkStringArray()
        for tag in ('a"', 'a_', 'a\n', 'a'):
            tags.InsertNextValue(tag)
        path = os.path.join(self.folder.name, 'quotes.su2')
        write_square(path, tags)
        self.assertEqual(set(read_su2(path)[2].values()), {'a', 'a_', 'a__', 'a___'})

    def test_a_tag_of_many_digits_can_be_open(self):
        tags = vtkIntArray()
        for tag in (1234567, 1234568, 3, 4):
            tags.InsertNextValue(tag)
        path = os.path.join(self.folder.name, 'open.14')
        write_square(path, tags, open_tags='1234567')
        self.assertEqual(len(read_adcirc(path)[2][0]), 1)

    def test_an_array_that_does_not_exist_is_an_error_and_no_file(self):
        window = vtkOutputWindow.GetInstance()
        mode = window.GetDisplayMode()
        window.SetDisplayModeToNever()
        path = self.save('none.msh', TagArray='Nothing')
        window.SetDisplayMode(mode)
        self.assertFalse(os.path.exists(path))

    def test_cells_of_hidden_points_are_not_written(self):
        mesh = vtkPolyData()
        mesh.CopyStructure(self.mesh)
        hidden = 5
        mesh.AllocatePointGhostArray().SetValue(hidden, vtkDataSetAttributes.HIDDENPOINT)
        writer = vtkBitingMeshWriter()
        writer.SetFileName(os.path.join(self.folder.name, 'hidden.msh'))
        writer.SetInputDataObject(mesh)
        writer.Write()
        points, triangles, _ = read_gmsh(writer.GetFileName())
        around = [triangle for triangle in triangles_of(self.mesh) if hidden in triangle]
        self.assertTrue(around)
        self.assertEqual(len(triangles), self.mesh.GetNumberOfCells() - len(around))
        self.assertEqual(len(points), self.mesh.GetNumberOfPoints() - 1)

    def test_triangles_without_a_region_number_are_a_group_of_their_own(self):
        mesh, regions = vtkPolyData(), vtkDoubleArray()
        mesh.CopyStructure(self.mesh)
        regions.SetName('RegionId')
        for cell in range(mesh.GetNumberOfCells()):
            regions.InsertNextValue((math.nan, 3.0, 1.0)[cell % 3])
        mesh.GetCellData().AddArray(regions)
        writer = vtkBitingMeshWriter()
        writer.SetFileName(os.path.join(self.folder.name, 'nan.msh'))
        writer.SetInputDataObject(mesh)
        writer.Write()
        _, triangles, _ = read_gmsh(writer.GetFileName())
        for cell in range(mesh.GetNumberOfCells()):
            corners = turned([mesh.GetCell(cell).GetPointId(k) for k in range(3)])
            self.assertEqual(triangles[corners], (5, 4, 2)[cell % 3])

    def refuse(self, name, mesh, **settings):
        """An error, and no file, or the one that was there."""
        writer = vtkBitingMeshWriter()
        writer.SetFileName(os.path.join(self.folder.name, name))
        writer.SetInputDataObject(mesh)
        for setting, value in settings.items():
            getattr(writer, 'Set' + setting)(value)
        errors = []
        writer.AddObserver('ErrorEvent', lambda *unused: errors.append(1))
        writer.Write()
        self.assertEqual(len(errors), 1)
        self.assertFalse(os.path.exists(writer.GetFileName()))
        with open(writer.GetFileName(), 'w', encoding='ascii') as file:
            file.write('before')
        writer.Write()
        with open(writer.GetFileName(), encoding='ascii') as file:
            self.assertEqual(file.read(), 'before')
        os.remove(writer.GetFileName())
        self.assertFalse([name for name in os.listdir(self.folder.name) if name.endswith('.part')])

    def test_depths_that_are_not_there_are_an_error_and_no_file(self):
        mesh = vtkPolyData()
        mesh.DeepCopy(self.mesh)
        for name, size, value in (('Depth', 1, math.nan), ('Far', 1, math.inf), ('Vectors', 3, 0)):
            depths = vtkDoubleArray()
            depths.SetName(name)
            depths.SetNumberOfComponents(size)
            depths.SetNumberOfTuples(mesh.GetNumberOfPoints())
            depths.Fill(0.0)
            depths.SetComponent(7, 0, value)
            mesh.GetPointData().AddArray(depths)
            self.refuse('depths.14', mesh, DepthArray=name)
        self.refuse('depths.14', mesh, DepthArray='Bathymetry')
        self.refuse('depths.gr3', mesh, DepthArray='Bathymetry')
        self.refuse('depths.2dm', mesh, DepthArray='Bathymetry')
        self.refuse('depths.nc', mesh, DepthArray='Bathymetry')

    def test_regions_that_are_not_there_are_an_error_and_no_file(self):
        self.refuse('regions.msh', self.mesh, RegionArray='Ground')

    def test_tags_that_no_edge_has_cannot_be_open(self):
        self.refuse('unknown.14', self.mesh, OpenTags='99')

    def test_triangles_that_overlap_are_an_error_and_no_file(self):
        mesh = vtkPolyData()
        mesh.DeepCopy(self.mesh)
        mesh.GetCellData().Initialize()
        mesh.GetPolys().InsertNextCell(self.mesh.GetCell(5).GetPointIds())
        mesh.BuildCells()
        for name in ('twice.su2', 'twice.14', 'twice.2dm', 'twice.nc'):
            self.refuse(name, mesh)

    def test_coordinates_that_are_not_finite_are_an_error_and_no_file(self):
        mesh = vtkPolyData()
        mesh.DeepCopy(self.mesh)
        mesh.GetPoints().SetPoint(3, math.nan, 0, 0)
        for name in ('nan.msh', 'nan.su2', 'nan.14'):
            self.refuse(name, mesh)

    def test_blanks_in_tags_are_no_blanks_in_names_of_markers_and_can_be_open(self):
        tags = vtkStringArray()
        for tag in ('open sea', 'open_sea', 'a,b', '50%'):
            tags.InsertNextValue(tag)
        path = os.path.join(self.folder.name, 'blanks.su2')
        write_square(path, tags)
        self.assertEqual(set(read_su2(path)[2].values()), {'open_sea', 'open_sea_', 'a_b', '50_'})
        path = os.path.join(self.folder.name, 'blanks.14')
        write_square(path, tags, open_tags='open sea 50% a,b')
        self.assertEqual(len(read_adcirc(path)[2][1]), 1)

    def test_cells_whose_points_do_not_exist_are_an_error_and_no_file(self):
        mesh = vtkPolyData()
        mesh.DeepCopy(self.mesh)
        mesh.GetPolys().ReplaceCellAtId(7, 3, (0, 1, mesh.GetNumberOfPoints()))
        for name in ('missing.msh', 'missing.su2', 'missing.14'):
            self.refuse(name, mesh)

    def test_cells_that_are_no_triangles_are_an_error_and_no_file(self):
        clip = simple.Clip(Input=self.mesher, ClipType='Plane')  # makes quads, too
        self.refuse('clip.msh', simple.FetchData(clip)[0])
        triangles = simple.Triangulate(Input=simple.ExtractSurface(Input=clip))
        self.assertTrue(read_gmsh(self.save('clip.msh', triangles))[1])

    def test_what_ranks_have_saved_together_is_written_as_the_mesh_of_one(self):
        whole, spread = vtkPolyData(), in_two_pieces(self.mesh)
        whole.CopyStructure(self.mesh)
        whole.GetCellData().AddArray(self.mesh.GetCellData().GetArray('RegionId'))
        texts = []
        for name, mesh in (('whole.msh', whole), ('spread.msh', spread)):
            writer = vtkBitingMeshWriter()
            writer.SetFileName(os.path.join(self.folder.name, name))
            writer.SetInputDataObject(mesh)
            writer.Write()
            with open(writer.GetFileName(), encoding='ascii') as file:
                texts.append(file.read())
        self.assertGreater(spread.GetNumberOfCells(), whole.GetNumberOfCells())
        self.assertEqual(texts[0], texts[1])

    def test_appended_meshes_with_the_same_ids_are_written_whole(self):
        append = vtkAppendPolyData()
        for shift in (0.0, 10.0):
            part = in_two_pieces(self.mesh)
            move = vtkTransform()
            move.Translate(shift, 0, 0)
            points = vtkPoints()
            points.SetDataTypeToDouble()
            move.TransformPoints(part.GetPoints(), points)
            part.SetPoints(points)
            append.AddInputData(part)
        append.Update()
        both = append.GetOutput()
        for data, name in ((both.GetPointData(), 'GlobalPointIds'),
                           (both.GetCellData(), 'GlobalCellIds')):
            data.SetActiveGlobalIds(name)
            self.assertTrue(data.GetGlobalIds())
        writer = vtkBitingMeshWriter()
        writer.SetFileName(os.path.join(self.folder.name, 'both.msh'))
        writer.SetInputDataObject(both)
        writer.Write()
        points, triangles, _ = read_gmsh(writer.GetFileName())
        self.assertEqual(len(triangles), 2 * self.mesh.GetNumberOfCells())
        self.assertAlmostEqual(area_of(points, triangles),
                               2.0 * area_of(points_of(self.mesh), triangles_of(self.mesh)))

    def test_a_mesh_of_any_program_is_written_without_tags(self):
        sphere = simple.Sphere()
        _, triangles, edges = read_gmsh(self.save('sphere.msh', sphere))
        self.assertEqual(len(triangles), 96)
        self.assertEqual(set(triangles.values()), {1})
        self.assertFalse(edges)


if __name__ == '__main__':
    unittest.main()
