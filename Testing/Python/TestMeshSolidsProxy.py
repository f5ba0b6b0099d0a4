# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Files of tetrahedra and of surfaces in space: written, read by us and, where they are installed
(Debian: python3-meshio, gmsh), by meshio and Gmsh; and what is refused."""

import math
import os
import shutil
import subprocess
import tempfile
import unittest

from biting.vtkBitingFilters import vtkBitingMeshReader, vtkBitingMeshWriter
from paraview import simple
from vtkmodules.vtkCommonCore import vtkIdTypeArray, vtkIntArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    VTK_TETRA, VTK_TRIANGLE, vtkImageData, vtkPolyData, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter

try:
    import meshio
except ImportError:
    meshio = None
GMSH = shutil.which('gmsh')


def corners_of(data, cell):
    ids = data.GetCell(cell).GetPointIds()
    return [data.GetPoint(ids.GetId(k)) for k in range(ids.GetNumberOfIds())]


def cells_of(data, array, shift=0):
    """Each cell by the places of its corners, to nine digits, with its value."""
    values = data.GetCellData().GetAbstractArray(array)
    return sorted((sorted(tuple(round(x, 9) for x in place) for place in corners_of(data, cell)),
                   str(values.GetVariantValue(cell).ToInt() + shift) if shift
                   else values.GetVariantValue(cell).ToString())
                  for cell in range(data.GetNumberOfCells()))


def middle(data, cell):
    return [sum(axis) / len(axis) for axis in zip(*corners_of(data, cell))]


def brick():
    """A brick of tetrahedra with two regions, and its boundary with texts as tags."""
    image = vtkImageData()
    image.SetDimensions(4, 3, 5)
    image.SetSpacing(0.1, 1 / 3, 0.7)
    divide = vtkDataSetTriangleFilter()
    divide.SetInputData(image)
    surface = vtkGeometryFilter()
    surface.SetInputConnection(divide.GetOutputPort())
    surface.PassThroughPointIdsOn()
    surface.Update()
    grid, boundary = divide.GetOutput(), surface.GetOutput()
    regions, tags, ids = vtkIntArray(), vtkStringArray(), vtkIdTypeArray()
    for cell in range(grid.GetNumberOfCells()):
        regions.InsertNextValue(0 if middle(grid, cell)[2] < 1.4 else 6)
    for cell in range(boundary.GetNumberOfCells()):
        height = middle(boundary, cell)[2]
        tags.InsertNextValue('the floor' if height == 0 else 'lid' if height > 2.79 else 'walls')
    ids.DeepCopy(boundary.GetPointData().GetArray('vtkOriginalPointIds'))
    for array, name in ((regions, 'RegionId'), (tags, 'Wall'), (ids, 'MeshPointId')):
        array.SetName(name)
    grid.GetCellData().AddArray(regions)
    boundary.GetCellData().Initialize()
    boundary.GetCellData().AddArray(tags)
    boundary.GetPointData().AddArray(ids)
    return grid, boundary


class TestMeshSolidsProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())
        cls.folder = tempfile.TemporaryDirectory()
        cls.grid, cls.boundary = brick()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def write(self, name, mesh=None, boundary=None, **settings):
        """The path, and the texts of errors and warnings."""
        writer = vtkBitingMeshWriter()
        writer.SetFileName(os.path.join(self.folder.name, name))
        writer.SetInputDataObject(mesh or self.grid)
        writer.SetInputDataObject(1, boundary or self.boundary)
        for setting, value in settings.items():
            getattr(writer, 'Set' + setting)(value)
        said = []
        for event in ('ErrorEvent', 'WarningEvent'):
            writer.AddObserver(event, lambda _, kind: said.append(kind))
        writer.Write()
        return writer.GetFileName(), said

    def refuse(self, name, mesh=None, boundary=None, **settings):
        path, said = self.write(name, mesh, boundary, **settings)
        self.assertEqual(said, ['ErrorEvent'])
        self.assertFalse(os.path.exists(path))

    def read(self, path):
        reader = vtkBitingMeshReader()
        reader.SetFileName(path)
        reader.Update()
        return reader.GetOutputDataObject(0), reader.GetOutputDataObject(1)

    def test_gmsh_gives_tetrahedra_and_boundary_back(self):
        path, said = self.write('brick.msh')
        self.assertEqual(said, [])
        mesh, sides = self.read(path)
        self.assertEqual(mesh.GetClassName(), 'vtkUnstructuredGrid')
        self.assertEqual(cells_of(mesh, 'RegionId'), cells_of(self.grid, 'RegionId'))
        self.assertEqual(cells_of(sides, 'TagName'), cells_of(self.boundary, 'Wall'))
        path, said = self.write('again.msh', mesh, sides, TagArray='TagName')
        self.assertEqual(said, [])
        again, sides = self.read(path)
        self.assertEqual(cells_of(again, 'RegionId'), cells_of(self.grid, 'RegionId'))
        self.assertEqual(cells_of(sides, 'TagName'), cells_of(self.boundary, 'Wall'))

    def test_su2_gives_tetrahedra_and_markers_back(self):
        path, said = self.write('brick.su2')
        self.assertEqual(said, ['WarningEvent'])  # of a blank in the name of a marker
        mesh, sides = self.read(path)
        self.assertEqual([mesh.GetPoint(k) for k in range(mesh.GetNumberOfPoints())],
                         [self.grid.GetPoint(k) for k in range(mesh.GetNumberOfPoints())])
        self.assertEqual(mesh.GetNumberOfCells(), self.grid.GetNumberOfCells())
        self.assertEqual(cells_of(sides, 'TagName'), [
            (places, name.replace(' ', '_')) for places, name in cells_of(self.boundary, 'Wall')])

    def test_in_paraview_files_open_as_tetrahedra_whose_tags_come_along(self):
        path, _ = self.write('opened.msh')
        reader = simple.OpenDataFile(path)
        reader.UpdatePipeline()
        self.assertEqual(reader.GetDataInformation().GetDataSetTypeAsString(),
                         'vtkUnstructuredGrid')
        saved = os.path.join(self.folder.name, 'saved.su2')
        simple.SaveData(saved, proxy=simple.Calculator(Input=reader, Function='1'),
                        TagArray='TagName')
        _, sides = self.read(saved)
        self.assertEqual({name for _, name in cells_of(sides, 'TagName')},
                         {'the_floor', 'lid', 'walls'})

    def test_a_boundary_without_arrays_is_one_marker(self):
        bare = vtkPolyData()
        bare.CopyStructure(self.boundary)
        bare.GetPointData().AddArray(self.boundary.GetPointData().GetArray('MeshPointId'))
        for name in ('bare.msh', 'bare.su2'):
            _, sides = self.read(self.write(name, boundary=bare)[0])
            self.assertEqual(sides.GetNumberOfCells(), self.boundary.GetNumberOfCells())
            self.assertEqual({tag for _, tag in cells_of(sides, 'TagName')}, {'boundary'})

    def test_a_boundary_of_another_mesh_is_a_warning_and_no_tags(self):
        other = vtkPolyData()
        other.DeepCopy(self.boundary)
        other.GetPolys().ReplaceCellAtId(3, 3, (0, 1, other.GetNumberOfPoints() - 1))
        path, said = self.write('other.msh', boundary=other)
        self.assertEqual(said, ['WarningEvent'])
        self.assertEqual([data.GetNumberOfCells() for data in self.read(path)],
                         [self.grid.GetNumberOfCells(), 0])

    def test_what_would_be_a_wrong_file_is_an_error_and_no_file(self):
        self.refuse('tag.msh', TagArray='Nothing')
        self.refuse('region.msh', RegionArray='Nothing')
        for name in ('brick.14', 'brick.gr3', 'brick.2dm', 'brick.nc'):
            self.refuse(name)
        for kind, ids in ((VTK_TRIANGLE, (0, 1, 2)), (VTK_TETRA, (0, 1, 2, 3)),
                          (VTK_TETRA, (0, 1, 0, 17))):  # beside others, without volume
            mesh = vtkUnstructuredGrid()
            mesh.DeepCopy(self.grid)
            mesh.GetCellData().Initialize()
            mesh.InsertNextCell(kind, len(ids), ids)
            self.refuse('cells.msh', mesh)
            self.refuse('cells.su2', mesh)
        mesh = vtkUnstructuredGrid()
        mesh.DeepCopy(self.grid)
        mesh.GetCellData().Initialize()
        mesh.InsertNextCell(VTK_TETRA, 4, [mesh.GetCell(0).GetPointId(k) for k in range(4)])
        self.refuse('twice.msh', mesh)
        wavelet = simple.Wavelet(WholeExtent=[0, 2, 0, 2, 0, 2])
        self.refuse('boxes.msh', simple.FetchData(wavelet)[0])

    def test_a_surface_in_space_has_its_lines_of_features(self):
        mesher = BitingSurfaceMesher(Input=simple.Box(), UniformSpacing=0.3)
        path = os.path.join(self.folder.name, 'box.msh')
        simple.SaveData(path, proxy=mesher)
        mesh, edges = self.read(path)
        lengths = [math.dist(*corners_of(edges, cell)) for cell in range(edges.GetNumberOfCells())]
        self.assertAlmostEqual(sum(lengths), 12.0)
        expected = simple.FetchData(mesher)[0]
        self.assertEqual(cells_of(mesh, 'RegionId'), cells_of(expected, 'RegionId'))

    def test_bodies_have_the_tags_of_their_surfaces_or_are_one_marker(self):
        tagged = simple.Calculator(Input=simple.Box(), AttributeType='Cell Data',
                                   ResultArrayName='Wall', Function='10')
        for source, name in ((tagged, '10'), (simple.Box(), 'boundary')):
            body = BitingTetrahedralizer(Input=source, UniformSpacing=0.4)
            mesh, sides = (simple.FetchData(simple.OutputPort(body, port))[0] for port in (0, 1))
            for end in ('msh', 'su2'):
                path = os.path.join(self.folder.name, 'body.' + end)
                simple.SaveData(path, proxy=body)
                found, found_sides = self.read(path)
                self.assertEqual(found.GetNumberOfCells(), mesh.GetNumberOfCells())
                self.assertEqual(
                    cells_of(found_sides, 'TagName'),
                    [(places, name) for places, _ in cells_of(sides, 'MeshCellId')])

    def expect_groups(self, path):
        """What meshio reads of a file of Gmsh."""
        found = meshio.read(path)
        names = {tuple(pair): name for name, pair in found.field_data.items()}
        for kind, dimension, data, array in (('tetra', 3, self.grid, 'RegionId'),
                                             ('triangle', 2, self.boundary, 'Wall')):
            cells = []
            for block, physical in zip(found.cells, found.cell_data['gmsh:physical']):
                for corners, number in zip(block.data, physical):
                    if block.type == kind:
                        name = names[int(number), dimension].replace('Region ', '')
                        cells.append((sorted(tuple(round(float(x), 9) for x in found.points[k])
                                             for k in corners), name))
            self.assertEqual(sorted(cells), cells_of(data, array))

    @unittest.skipUnless(meshio, 'meshio is not installed')
    def test_meshio_reads_groups_of_tetrahedra_and_triangles(self):
        self.expect_groups(self.write('meshio.msh')[0])

    @unittest.skipUnless(meshio, 'meshio is not installed')
    def test_meshio_reads_markers_of_tetrahedra(self):
        found = meshio.read(self.write('meshio.su2')[0])
        counts = {block.type: len(block.data) for block in found.cells}
        self.assertEqual(counts['tetra'], self.grid.GetNumberOfCells())
        self.assertEqual(sum(len(block.data) for block in found.cells if block.type == 'triangle'),
                         self.boundary.GetNumberOfCells())

    @unittest.skipUnless(meshio and GMSH, 'meshio or Gmsh is not installed')
    def test_gmsh_keeps_all_of_it_when_it_reads_and_writes(self):
        path = self.write('through.msh')[0]
        for version in ('msh41', 'msh22'):
            written = os.path.join(self.folder.name, version + '.msh')
            done = subprocess.run([GMSH, path, '-save', '-format', version, '-o', written],
                                  check=True, capture_output=True, timeout=100, text=True)
            self.assertNotIn('Warning', done.stdout + done.stderr)
            self.expect_groups(written)
            mesh, sides = self.read(written)
            self.assertEqual(cells_of(mesh, 'RegionId'), cells_of(self.grid, 'RegionId'))
            self.assertEqual(cells_of(sides, 'TagName'), cells_of(self.boundary, 'Wall'))


if __name__ == '__main__':
    unittest.main()
