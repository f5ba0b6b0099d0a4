# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""What ParaView's sources and filters hand over, with the noise of its coordinates, is meshed."""

import os
import unittest

from paraview import servermanager, simple


def figure(mesh, name):
    return mesh.GetFieldData().GetArray(name).GetValue(0)


def slice_of(producer, origin, normal):
    cut = simple.Slice(Input=producer)
    cut.SliceType.Origin = list(origin)
    cut.SliceType.Normal = list(normal)
    return cut


def in_doubles(producer):
    return simple.Calculator(Input=producer, Function='coords*1.0', CoordinateResults=1)


class TestParaViewProducersProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())

    def mesh(self, producer, **parameters):
        mesher = BitingMesher(Input=producer, **parameters)
        mesher.UpdatePipeline()
        return servermanager.Fetch(mesher)

    def test_slices_of_closed_surfaces_have_no_slivers_of_noise(self):
        planes = (((0, 0, 0), (0, 0, 1)), ((0, 0, 0), (0, 1, 0)), ((.03, .01, .02), (1, 2, 3)))
        for shape in (simple.Superquadric(), simple.Cylinder(Resolution=50),
                      simple.Sphere(ThetaResolution=40, PhiResolution=37)):
            for producer in (shape, in_doubles(shape)):
                for origin, normal in planes:
                    mesh = self.mesh(slice_of(producer, origin, normal))
                    self.assertGreater(figure(mesh, 'SmallestAngle'), 20, (shape, origin, normal))

    def test_slices_of_surfaces_with_seams_have_no_slivers_of_noise(self):
        shapes = simple.PartitionedDataSetCollectionSource()
        for producer in (shapes, in_doubles(shapes)):
            for origin, normal in (((0, 0, 0), (0, 0, 1)), ((0, 0, 0), (1, 0, 0)),
                                   ((.1, .2, .3), (1, 1, .2)), ((.03, .01, .02), (3, 2, 1))):
                mesh = self.mesh(slice_of(producer, origin, normal))
                self.assertGreater(figure(mesh, 'SmallestAngle'), 20, (origin, normal))

    def test_slices_that_pass_close_to_vertices_have_good_triangles(self):
        for roundness in ({'ThetaRoundness': .3}, {'ThetaRoundness': .3, 'PhiRoundness': .3}):
            shape = simple.Superquadric(**roundness)
            for producer in (shape, in_doubles(shape)):
                mesh = self.mesh(slice_of(producer, (0, 0, 0), (0, 0, 1)))
                self.assertGreater(figure(mesh, 'SmallestAngle'), 30, roundness)

    def test_points_of_a_superquadric_within_rounding_are_merged_with_a_word(self):
        cut = slice_of(simple.Superquadric(), (0, 0, 0), (0, 1, 0))
        mesher = BitingMesher(Input=cut)
        mesher.UpdatePipeline()
        mesh = servermanager.Fetch(mesher)
        self.assertGreater(figure(mesh, 'SmallestAngle'), 40)
        merged = figure(mesh, 'RepairedNearPoints')
        problems = servermanager.Fetch(mesher, idx=3)
        self.assertGreater(merged, 0)
        self.assertEqual(problems.GetNumberOfPoints(), merged)
        messages = problems.GetPointData().GetAbstractArray('Message')
        self.assertIn('Points too near', messages.GetValue(0))

    def test_tiny_sections_of_a_cone_are_planar(self):
        for place in (.499, .4999, .49999):
            cut = slice_of(simple.Cone(Resolution=12), (place, 0, 0), (1, .1, .05))
            self.assertGreater(figure(self.mesh(cut), 'SmallestAngle'), 20, place)

    def test_contours_of_a_slice_are_meshed(self):
        for normal in ((0, 0, 1), (1, 2, 3)):
            lines = simple.Contour(Input=slice_of(simple.Wavelet(), (0, 0, 0), normal))
            lines.ContourBy = ['POINTS', 'RTData']
            lines.Isosurfaces = [200.5]
            self.assertGreater(figure(self.mesh(lines), 'SmallestAngle'), 10, normal)

    def test_a_merge_tolerance_takes_the_short_segments_of_a_drawing(self):
        shape = simple.Sphere(ThetaResolution=40, PhiResolution=37)
        cut = slice_of(shape, (.03, .01, .02), (1, 2, 3))
        exact = self.mesh(cut)
        merged = self.mesh(cut, MergeTolerance=0.01)
        self.assertEqual(figure(exact, 'RepairedNearPoints'), 0)
        self.assertGreater(figure(merged, 'RepairedNearPoints'), 0)
        self.assertGreater(figure(merged, 'NumberOfTriangles'), 100)

    def test_of_spacing_sources_that_overlap_the_smallest_value_counts(self):
        def plane(left, right, value):
            flat = simple.Plane(Origin=[left, -1, 0], Point1=[right, -1, 0], Point2=[left, 2, 0],
                XResolution=7, YResolution=7)
            return simple.Calculator(Input=flat, ResultArrayName='Spacing',
                Function=f'{value} + 0 * coordsX')

        coarse, fine = plane(.3, 2, .4), plane(-1, 2, .1)
        ball = simple.Sphere(Radius=3, ThetaResolution=30, PhiResolution=30)
        folded = simple.Calculator(Input=ball, ResultArrayName='Spacing',
            Function='if (coordsZ > 0, 0.4, 0.1)')
        for source in (simple.AppendDatasets(Input=[coarse, fine]),
                       simple.AppendDatasets(Input=[fine, coarse]),
                       simple.GroupDatasets(Input=[coarse, fine]), folded):
            mesh = self.mesh(simple.Plane(), SpacingSource=source)
            low, high = mesh.GetPointData().GetArray('Spacing').GetRange()
            self.assertAlmostEqual(low, .1, places=12)
            self.assertAlmostEqual(high, .1, places=12)

    def test_points_where_a_resampling_found_nothing_are_no_spacing(self):
        flat = simple.Plane(Origin=[-1, -1, 0], Point1=[1, -1, 0], Point2=[-1, 1, 0])
        small = simple.Calculator(Input=flat, ResultArrayName='Spacing', Function='0.3')
        image = simple.FastUniformGrid(WholeExtent=[-5, 5, -5, 5, 0, 0])
        source = simple.ResampleWithDataset(SourceDataArrays=small, DestinationMesh=image)
        for blanks in (0, 1):
            source.MarkBlankPointsAndCells = blanks
            mesh = self.mesh(simple.Disk(OuterRadius=3), SpacingSource=source,
                LimitByFeatureSize=0)
            low, high = mesh.GetPointData().GetArray('Spacing').GetRange()
            self.assertAlmostEqual(low, .3, places=12)
            self.assertAlmostEqual(high, .3, places=12)

    def test_a_polygon_with_a_hole_through_a_slit_is_a_spacing_source(self):
        script = """
import vtkmodules.all as vtk
output = self.GetOutput()
places = [(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1), (-.1, -.1), (-.1, .1), (.1, .1), (.1, -.1),
    (-.1, -.1), (1, -1), (2, -1), (2, 1)]
points = vtk.vtkPoints()
spacing = vtk.vtkDoubleArray()
spacing.SetName('Spacing')
for k, (x, y) in enumerate(places):
    points.InsertNextPoint(x, y, 0)
    spacing.InsertNextValue(.05 if k < 10 else .2)
polygons = vtk.vtkCellArray()
polygons.InsertNextCell(10, list(range(10)))
polygons.InsertNextCell(3, [10, 11, 12])
output.SetPoints(points)
output.SetPolys(polygons)
output.GetPointData().AddArray(spacing)
"""
        source = simple.ProgrammableSource(OutputDataSetType='vtkPolyData', Script=script)
        mesh = self.mesh(simple.Plane(), SpacingSource=source)
        low, high = mesh.GetPointData().GetArray('Spacing').GetRange()
        self.assertAlmostEqual(low, .05, places=12)
        self.assertAlmostEqual(high, .05, places=12)


if __name__ == '__main__':
    unittest.main()
