# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""The proxy of Biting Surface Mesher: sources of ParaView, and bodies of others."""

import os
import unittest

from paraview import servermanager, simple

simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())

SHARED = os.path.join(os.path.dirname(__file__), '..', '..', '..', 'shared', 'surfaces')
# Closed, of each kind: smooth, with holes, with edges, thin.
BODIES = ('3torus.vtk', 'knot1.vtk', 'joint.vtk', 'bear.vtk', 'ng_hinge.stl')


def figure(mesh, name):
    return servermanager.Fetch(mesh, idx=0).GetFieldData().GetArray(name).GetValue(0)


def open_edges(mesh):
    edges = simple.FeatureEdges(Input=mesh, FeatureEdges=0, ManifoldEdges=0)
    return edges.GetDataInformation().GetNumberOfCells() if not edges.UpdatePipeline() else -1


class SurfaceMesherProxy(unittest.TestCase):

    def test_the_panel_has_a_summary_and_the_defaults_are_those_of_the_filter(self):
        mesh = BitingSurfaceMesher(Input=simple.Sphere(ThetaResolution=40, PhiResolution=40))
        self.assertEqual([mesh.FeatureAngle, mesh.BoundaryTolerance, mesh.Gradation], [40, 0.1, 0.3])
        mesh.UpdatePipeline()
        mesh.UpdatePropertyInformation()
        self.assertIn('Euler number: 2', mesh.Summary)
        self.assertGreater(figure(mesh, 'SmallestAngle'), 25)

    def test_a_source_of_space_makes_the_mesh_finer(self):
        sphere = simple.Sphere(Radius=5, ThetaResolution=60, PhiResolution=60)
        coarse = BitingSurfaceMesher(Input=sphere, UniformSpacing=1)
        volume = simple.Calculator(Input=simple.Wavelet(), ResultArrayName='Size',
                                   Function='0.3+0.1*abs(coordsX)')
        fine = BitingSurfaceMesher(Input=sphere, UniformSpacing=1, SpacingSource=volume,
                                   SourceSpacingArray=['POINTS', 'Size'])
        counts = [figure(mesh, 'NumberOfVertices') for mesh in (coarse, fine)]
        self.assertGreater(counts[1], 2 * counts[0])
        fine.SourceSpacingArray = ['POINTS', 'Missing']
        self.assertEqual(servermanager.Fetch(fine, idx=0).GetNumberOfPoints(), 0)
        fine.UpdatePropertyInformation()
        self.assertIn('Missing', fine.Summary)

    def test_contours_and_clips_keep_their_borders(self):
        volume = simple.Wavelet(XFreq=12, YFreq=9, ZFreq=10, XMag=25, YMag=40, ZMag=15)
        contour = simple.Contour(Input=volume, ContourBy='RTData', Isosurfaces=[157.0])
        mesh = BitingSurfaceMesher(Input=contour, UniformSpacing=1.2)
        self.assertGreater(figure(mesh, 'NumberOfVertices'), 500)
        kinds = servermanager.Fetch(mesh, idx=1).GetCellData().GetArray('EdgeKind')
        borders = [kinds.GetValue(k) for k in range(kinds.GetNumberOfTuples())].count(1)
        self.assertGreater(borders, 30)
        self.assertEqual(open_edges(mesh), borders)

    def test_bodies_of_others_stay_closed_and_keep_their_holes(self):
        if not os.path.exists(SHARED):
            self.skipTest('the surfaces are not there')
        for name in BODIES:
            body = simple.OpenDataFile(os.path.join(SHARED, name))
            check = BitingSurfaceCheck(Input=body)
            mesh = BitingSurfaceMesher(Input=body)
            mesh.SpacingScale = 2  # 4 % of the diagonal
            with self.subTest(name=name):
                self.assertEqual(figure(mesh, 'EulerNumber'), figure(check, 'EulerNumber'))
                self.assertEqual(open_edges(mesh), 0)
                again = BitingSurfaceCheck(Input=mesh)
                self.assertEqual([figure(again, key) for key in ('SelfCrossings', 'Folds')], [0, 0])
                volumes = [figure(surface, 'Volume') for surface in (check, again)]
                self.assertAlmostEqual(volumes[1] / volumes[0], 1, 1)


if __name__ == '__main__':
    unittest.main()
