# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Files for solvers, read by other programs: meshio, and Gmsh, which writes them again. Skipped
where these programs (Debian: python3-meshio, gmsh) are not installed."""

import os
import shutil
import subprocess
import tempfile
import unittest

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

try:
    import meshio
except ImportError:
    meshio = None
GMSH = shutil.which('gmsh')
SIXTEEN_DIGITS = 1e-15
PLATE = os.path.join(os.environ['BITING_SOURCE_DIR'], 'Data', 'plate.vtk')


def rows(corners, values):
    """Cells with what belongs to them, in an order that does not depend on that of the file."""
    return sorted((*cell, value) for cell, value in zip(corners.tolist(), values))


def turned(corners):
    """Triangles with their smallest corner first: equal only for equal orientation."""
    return numpy.array([numpy.roll(cell, -numpy.argmin(cell)) for cell in corners])


def places(points):
    """Points by place, and the number that each has there: files have them in other orders."""
    order = numpy.lexsort(points.round(9).T)  # Gmsh writes one digit less than it needs
    numbers = numpy.empty_like(order)
    numbers[order] = numpy.arange(len(order))
    return points[order], numbers


def cells_of(mesh, kind, data):
    """Of a mesh of meshio: all cells of a kind, and what `data` has for them."""
    blocks = [k for k, block in enumerate(mesh.cells) if block.type == kind]
    return (numpy.concatenate([mesh.cells[k].data for k in blocks]),
            numpy.concatenate([mesh.cell_data[data][k] for k in blocks]))


@unittest.skipUnless(meshio, 'meshio is not installed')
class TestMeshRoundTripsProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())
        cls.folder = tempfile.TemporaryDirectory()
        cls.mesher = BitingMesher(Input=simple.LegacyVTKReader(FileNames=[PLATE]))
        cls.mesher.UpdatePipeline()
        mesh, edges = (simple.FetchData(simple.OutputPort(cls.mesher, port))[0] for port in (0, 1))
        cls.points, numbers = places(vtk_to_numpy(mesh.GetPoints().GetData()))
        corners = numbers[vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())].reshape(-1, 3)
        regions = vtk_to_numpy(mesh.GetCellData().GetArray('RegionId')) + 1
        cls.triangles = rows(turned(corners), regions)
        ids = vtk_to_numpy(edges.GetPointData().GetArray('MeshPointId'))
        lines = vtk_to_numpy(edges.GetLines().GetConnectivityArray()).reshape(-1, 2)
        ends = numpy.sort(numbers[ids[lines]])
        cls.tags = vtk_to_numpy(edges.GetCellData().GetArray('Tag'))
        cls.ends, cls.kinds = ends, vtk_to_numpy(edges.GetCellData().GetArray('Kind'))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def save(self, name):
        path = os.path.join(self.folder.name, name)
        simple.SaveData(path, proxy=self.mesher)
        return path

    def expect_all(self, path, tolerance=0.0):
        """Points, triangles with regions and orientation, edges with tags."""
        mesh = meshio.read(path)
        points, numbers = places(mesh.points)
        numpy.testing.assert_allclose(points, self.points, rtol=tolerance)
        corners, regions = cells_of(mesh, 'triangle', 'gmsh:physical')
        self.assertEqual(rows(turned(numbers[corners]), regions), self.triangles)
        ends, tags = cells_of(mesh, 'line', 'gmsh:physical')
        self.assertEqual(rows(numpy.sort(numbers[ends]), tags), rows(self.ends, self.tags))

    def gmsh(self, path, name, *arguments):
        written = os.path.join(self.folder.name, name)
        subprocess.run([GMSH, path, '-save', *arguments, '-o', written], check=True,
                       capture_output=True, timeout=100)
        return written

    def test_meshio_reads_a_gmsh_file_with_regions_and_tags(self):
        self.expect_all(self.save('plate.msh'))

    @unittest.skipUnless(GMSH, 'Gmsh is not installed')
    def test_gmsh_keeps_all_of_it_when_it_reads_and_writes(self):
        path = self.save('through.msh')
        for version in ('msh41', 'msh22'):
            written = self.gmsh(path, version + '.msh', '-format', version)
            self.expect_all(written, SIXTEEN_DIGITS)

    def test_through_meshio_the_mesh_comes_back_into_paraview(self):
        path = os.path.join(self.folder.name, 'back.vtu')
        meshio.write(path, meshio.read(self.save('back.msh')))
        back = simple.XMLUnstructuredGridReader(FileName=[path])
        judged = MeshConformity(Input=back)
        judged.UpdatePipeline()
        figures = [simple.FetchData(simple.OutputPort(proxy, 0))[0].GetFieldData()
                   for proxy in (judged, self.mesher)]
        for name in ('NumberOfTriangles', 'NumberOfVertices', 'SmallestAngle'):
            found, expected = (data.GetArray(name).GetTuple1(0) for data in figures)
            self.assertEqual(found, expected, name)
        regions = back.GetCellDataInformation().GetArray('gmsh:physical')
        self.assertEqual(regions.GetRange()[0], 1.0)
        finer = BitingRemesher(Input=back, UniformSpacing=0.1, RegionArray='gmsh:physical')
        finer.UpdatePipeline()
        self.assertGreater(finer.GetDataInformation().GetNumberOfCells(), 4 * len(self.triangles))

    def test_meshio_reads_a_su2_file_with_markers(self):
        mesh = meshio.read(self.save('plate.su2'))
        points, numbers = places(numpy.c_[mesh.points, numpy.zeros(len(mesh.points))])
        numpy.testing.assert_array_equal(points, self.points)
        corners, _ = cells_of(mesh, 'triangle', 'su2:tag')
        self.assertEqual(rows(turned(numbers[corners]), [0] * len(corners)),
                         sorted((*row[:3], 0) for row in self.triangles))
        ends, tags = cells_of(mesh, 'line', 'su2:tag')
        boundary = self.kinds == 0
        self.assertEqual(rows(numpy.sort(numbers[ends]), tags),
                         rows(self.ends[boundary], self.tags[boundary]))


if __name__ == '__main__':
    unittest.main()
