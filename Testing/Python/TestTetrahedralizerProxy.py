# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""The proxy of Biting Tetrahedralizer: closed surfaces that ParaView makes, and bodies of others."""

import os
import unittest

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkIntArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersGeneral import vtkDiscreteMarchingCubes

simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())

SHARED = os.path.join(os.path.dirname(__file__), '..', '..', '..', 'shared', 'surfaces')
BODIES = ('3torus.vtk', 'joint.vtk', 'bear.vtk')


def figure(mesh, name):
    return servermanager.Fetch(mesh, idx=0).GetFieldData().GetArray(name).GetValue(0)


def volume_of(surface):
    """By ParaView."""
    whole = simple.IntegrateVariables(Input=simple.OutputPort(surface, 0))
    return servermanager.Fetch(whole).GetCellData().GetArray('Volume').GetValue(0)


def bump(isovalue):
    """A closed contour of a wavelet."""
    volume = simple.Calculator(Input=simple.Wavelet(), ResultArrayName='Distance',
                               Function='coordsX^2+1.4*coordsY^2+2*coordsZ^2+8*sin(coordsX)')
    return simple.Contour(Input=volume, ContourBy=['POINTS', 'Distance'], Isosurfaces=[isovalue])


def label_contours():
    """Of a ball in two halves, which have each its own wall between them."""
    image, labels = vtkImageData(), vtkIntArray()
    image.SetDimensions(13, 13, 13)
    labels.SetName('Label')
    for k in range(13 ** 3):
        x, y, z = k % 13 - 6, k // 13 % 13 - 6, k // 169 - 6
        labels.InsertNextValue(0 if x * x + y * y + z * z > 20 else 3 if 2 * z > x else 8)
    image.GetPointData().SetScalars(labels)
    contours = vtkDiscreteMarchingCubes()
    contours.SetInputData(image)
    contours.SetValue(0, 3)
    contours.SetValue(1, 8)
    contours.Update()
    contours.GetOutput().GetCellData().GetScalars().SetName('Label')
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(contours.GetOutput())
    source.UpdatePipeline()
    return source


class TetrahedralizerProxy(unittest.TestCase):

    def test_the_panel_has_a_summary_and_the_defaults_are_those_of_the_filter(self):
        mesh = BitingTetrahedralizer(Input=simple.Sphere(ThetaResolution=30, PhiResolution=30))
        self.assertEqual([mesh.BiteShape, mesh.BitingConstant, mesh.MaximumNumberOfBites],
                         ['Sphere', 0, -1])
        self.assertEqual([mesh.FeatureAngle, mesh.BoundaryTolerance, mesh.Gradation], [40, 0.1, 0.3])
        mesh.UniformSpacing = 0.1
        mesh.UpdatePipeline()
        mesh.UpdatePropertyInformation()
        self.assertIn('Euler number of the boundary: 2', mesh.Summary)
        self.assertGreater(figure(mesh, 'SmallestDihedralAngle'), 25)
        self.assertAlmostEqual(figure(mesh, 'Volume'), volume_of(mesh), 6)

    def test_contours_that_are_closed_are_filled_and_clipped(self):
        mesh = BitingTetrahedralizer(Input=bump(50), UniformSpacing=1.2)
        self.assertGreater(figure(mesh, 'NumberOfTetrahedra'), 1000)
        self.assertAlmostEqual(figure(mesh, 'MeanRelativeLength'), 1, delta=0.1)
        half = simple.Clip(Input=simple.OutputPort(mesh, 0), Crinkleclip=1)
        half.UpdatePipeline()
        count = half.GetDataInformation().GetNumberOfCells()
        self.assertTrue(0 < count < figure(mesh, 'NumberOfTetrahedra'))

    def test_what_is_open_or_meets_the_border_is_refused_with_a_place(self):
        mesh = BitingTetrahedralizer(Input=bump(150))
        mesh.UpdatePipeline()
        mesh.UpdatePropertyInformation()
        self.assertIn('Error: Open edges', mesh.Summary)
        self.assertIn('near (', mesh.Summary)
        self.assertEqual(servermanager.Fetch(mesh, idx=0).GetNumberOfPoints(), 0)
        self.assertGreater(servermanager.Fetch(mesh, idx=3).GetNumberOfPoints(), 0)

    def test_materials_of_blocks_are_regions_with_tags_on_their_walls(self):
        balls = [simple.Calculator(Input=simple.Sphere(Radius=radius, ThetaResolution=30,
                                                       PhiResolution=30),
                                   AttributeType='Cell Data', ResultArrayName='Material',
                                   Function=str(material)) for radius, material in ((2, 4), (1, 9))]
        mesh = BitingTetrahedralizer(Input=simple.GroupDatasets(Input=balls), UniformSpacing=0.4,
                                     RegionArray='Material')
        mesh.UpdatePipeline()
        cells = mesh.GetDataInformation().GetCellDataInformation()
        self.assertEqual(cells.GetArrayInformation('RegionId').GetComponentRange(0), (0, 1))
        tags = simple.OutputPort(mesh, 1).GetDataInformation().GetCellDataInformation()
        self.assertEqual(tags.GetArrayInformation('Material').GetComponentRange(0), (4, 9))

    def test_contours_of_labels_are_filled_with_shared_walls(self):
        contours = label_contours()
        mesh = BitingTetrahedralizer(Input=contours, UniformSpacing=1.5, RegionArray='Label')
        mesh.UpdatePipeline()
        mesh.UpdatePropertyInformation()
        self.assertIn('Duplicate triangles', mesh.Summary)
        cells = servermanager.Fetch(mesh, idx=0)
        labels = cells.GetCellData().GetArray('Label')
        self.assertEqual(sorted({labels.GetValue(k) for k in range(cells.GetNumberOfCells())}), [3, 8])
        self.assertAlmostEqual(figure(mesh, 'Volume') / volume_of(mesh), 1, 6)

    def test_bodies_of_others_keep_their_volumes_and_holes(self):
        if not os.path.exists(SHARED):
            self.skipTest('the surfaces are not there')
        for name in BODIES:
            body = simple.OpenDataFile(os.path.join(SHARED, name))
            check = BitingSurfaceCheck(Input=body)
            mesh = BitingTetrahedralizer(Input=body)
            with self.subTest(name=name):
                self.assertEqual(figure(mesh, 'EulerNumber'), figure(check, 'EulerNumber'))
                self.assertAlmostEqual(figure(mesh, 'Volume') / figure(check, 'Volume'), 1, 1)
                self.assertGreater(figure(mesh, 'SmallestDihedralAngle'), 10)


if __name__ == '__main__':
    unittest.main()
