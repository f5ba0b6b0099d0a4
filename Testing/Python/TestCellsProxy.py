# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""What ParaView's own sources and filters hand over: surfaces and composite data."""

import os
import unittest

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkOutputWindow

FLUID_AND_SOLID = '''# vtk DataFile Version 3.0
a channel with a square hole; its inflow is tagged, and the side of the hole
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 8 float
0 0 0  3 0 0  3 3 0  0 3 0  1 1 0  2 1 0  2 2 0  1 2 0
CELLS 10 38
2 3 0
2 4 5
3 0 1 5
3 0 5 4
3 1 2 6
3 1 6 5
3 2 3 7
3 2 7 6
3 3 0 4
3 3 4 7
CELL_TYPES 10
3 3 5 5 5 5 5 5 5 5
CELL_DATA 10
SCALARS physical int 1
LOOKUP_TABLE default
11 12 1 1 1 1 2 2 2 2
'''


class TestCellsProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())

    def mesh(self, source, **parameters):
        """Meshes the output of `source` and returns the mesher and the mesh; nothing may be said."""
        mesher = BitingMesher(Input=source, **parameters)
        window = vtkOutputWindow.GetInstance()
        said = []
        tag = window.AddObserver('WarningEvent', lambda *_: said.append('warning'))
        other = window.AddObserver('ErrorEvent', lambda *_: said.append('error'))
        mesher.UpdatePipeline()
        window.RemoveObserver(tag)
        window.RemoveObserver(other)
        self.assertEqual(said, [])
        return mesher, servermanager.Fetch(mesher)

    def area(self, source):
        sizes = simple.IntegrateVariables(Input=source)
        sizes.UpdatePipeline()
        return servermanager.Fetch(sizes).GetCellData().GetArray('Area').GetValue(0)

    def expect(self, source, area, regions, **parameters):
        mesher, mesh = self.mesh(source, **parameters)
        self.assertAlmostEqual(self.area(mesher) / area, 1.0, places=6)
        self.assertEqual(mesh.GetCellData().GetArray('RegionId').GetRange()[1] + 1, regions)
        return mesher

    def gmsh_mesh(self):
        path = os.path.join(os.environ.get('TMPDIR', '/tmp'), 'cells_proxy_%d.vtk' % os.getpid())
        with open(path, 'w', encoding='ascii') as file:
            file.write(FLUID_AND_SOLID)
        reader = simple.LegacyVTKReader(FileNames=[path])
        reader.UpdatePipeline()
        os.remove(path)
        return reader

    def test_arrays_of_polygons_are_on_the_triangles_of_their_area(self):
        mesher, mesh = self.mesh(self.gmsh_mesh(), RegionArray='physical', UniformSpacing=0.2)
        values = mesh.GetCellData().GetArray('physical')
        for cell in range(mesh.GetNumberOfCells()):
            places = [mesh.GetPoint(mesh.GetCell(cell).GetPointId(k)) for k in range(3)]
            x, y = (sum(place[axis] for place in places) / 3 for axis in (0, 1))
            self.assertEqual(values.GetValue(cell), 1 if x > y else 2)
        finer = BitingRemesher(Input=mesher, UniformSpacing=0.1)
        finer.UpdatePipeline()
        cells = servermanager.Fetch(finer).GetCellData()
        pairs = {(cells.GetArray('RegionId').GetValue(k), cells.GetArray('physical').GetValue(k))
                 for k in range(cells.GetArray('physical').GetNumberOfTuples())}
        self.assertEqual(len(pairs), 2)

    def tags(self, mesher, name):
        data = servermanager.Fetch(mesher, idx=1).GetCellData()
        array, kind = data.GetAbstractArray(name), data.GetArray('Kind')
        return {(array.GetVariantValue(k).ToString(), kind.GetValue(k))
                for k in range(array.GetNumberOfTuples())}

    def test_a_plane_is_one_region_with_the_points_of_its_outline(self):
        plane = simple.Plane(XResolution=20, YResolution=20)
        _, mesh = self.mesh(plane, UniformSpacing=0.05)
        originals = mesh.GetPointData().GetArray('OriginalPointId')
        count = sum(originals.GetValue(k) >= 0 for k in range(originals.GetNumberOfTuples()))
        self.assertEqual(count, 80)
        self.expect(plane, 1.0, 1, UniformSpacing=0.05)

    def test_a_plane_that_keeps_its_cell_edges_has_a_region_a_cell(self):
        plane = simple.Plane(XResolution=4, YResolution=3)
        self.expect(plane, 1.0, 12, UniformSpacing=0.1, KeepCellEdges=1)

    def test_a_threshold_of_an_image_is_its_pixels(self):
        wavelet = simple.Wavelet(WholeExtent=[-20, 20, -20, 20, 0, 0])
        chosen = simple.Threshold(Input=wavelet, Scalars=['POINTS', 'RTData'],
                                  LowerThreshold=150.0, UpperThreshold=300.0)
        chosen.UpdatePipeline()
        mesher, mesh = self.mesh(chosen, UniformSpacing=1.0)
        self.assertAlmostEqual(self.area(mesher) / self.area(chosen), 1.0, places=6)
        self.assertEqual({kind for _, kind in self.tags(mesher, 'OriginalCellId')}, {0})
        self.assertGreater(mesh.GetNumberOfCells(), 500)

    def test_overlapping_amr_is_the_area_of_the_cells_that_no_finer_ones_replace(self):
        pulse = simple.AMRGaussianPulseSource(Dimension=2)
        pulse.UpdatePipeline()
        low_x, high_x, low_y, high_y = pulse.GetDataInformation().GetBounds()[:4]
        self.expect(pulse, (high_x - low_x) * (high_y - low_y), 1, UniformSpacing=0.1)

    def test_a_hyper_tree_grid_is_refused_by_the_panel_and_taken_by_its_surface(self):
        trees = simple.HyperTreeGrid(Dimensions=[4, 4, 1], MaxDepth=3,
                                     Descriptor='R..R.....|....R...|....')
        trees.UpdatePipeline()
        surface = simple.HyperTreeGridGeometryFilter(Input=trees)
        surface.UpdatePipeline()
        cells = surface.GetDataInformation().GetNumberOfCells()
        self.assertGreater(cells, 9)
        mesher = self.expect(surface, 9.0, 1, UniformSpacing=0.2)
        self.expect(surface, 9.0, cells, UniformSpacing=0.2, KeepCellEdges=1)
        given = mesher.SMProxy.GetProperty('Input')
        given.SetUncheckedInputConnection(0, trees.SMProxy, 0)
        self.assertFalse(given.IsInDomains())
        given.SetUncheckedInputConnection(0, surface.SMProxy, 0)
        self.assertTrue(given.IsInDomains())

    def test_text_is_a_region_a_letter(self):
        text = simple.a3DText(Text='Biting')
        text.UpdatePipeline()
        mesher = self.expect(text, self.area(text), 8, UniformSpacing=0.05)
        self.assertEqual({kind for _, kind in self.tags(mesher, 'OriginalCellId')}, {0})

    def test_a_gmsh_mesh_is_the_area_of_its_triangles_with_the_tags_on_its_border(self):
        for source in self.gmsh_mesh(), simple.ExtractSurface(Input=self.gmsh_mesh()):
            mesher = self.expect(source, 8.0, 1, UniformSpacing=0.25)
            self.assertEqual(self.tags(mesher, 'physical'),
                             {('11', 0), ('12', 0), ('1', 0), ('2', 0)})

    def test_physical_groups_are_regions(self):
        mesher = self.expect(self.gmsh_mesh(), 8.0, 2, UniformSpacing=0.25, RegionArray='physical')
        self.assertEqual({kind for _, kind in self.tags(mesher, 'physical')}, {0, 1})

    def test_a_refinement_region_belongs_to_the_union(self):
        group = simple.AppendGeometry(Input=[
            simple.Plane(Origin=[0, 0, 0], Point1=[10, 0, 0], Point2=[0, 10, 0],
                         XResolution=1, YResolution=1),
            simple.Plane(Origin=[4, 4, 0], Point1=[6, 4, 0], Point2=[4, 6, 0],
                         XResolution=1, YResolution=1)])
        self.expect(group, 100.0, 2, UniformSpacing=1.0, DomainRule='Union')
        self.expect(group, 96.0, 1, UniformSpacing=1.0, DomainRule='Outer Minus Others')

    def test_the_region_arrays_on_offer_are_cell_arrays(self):
        mesher = BitingMesher(Input=self.gmsh_mesh())
        names = mesher.GetProperty('RegionArray').GetAvailable()
        self.assertIn('physical', names)
        self.assertIn('None', names)

    def test_grouped_loops_are_one_drawing(self):
        outer = simple.Disk(InnerRadius=0.0, OuterRadius=3.0, CircumferentialResolution=40)
        group = simple.GroupDatasets(Input=[self.loop(3.0), self.loop(1.0)])
        self.expect(group, 8.0 * 2.0, 1, UniformSpacing=0.5)
        self.expect(simple.GroupDatasets(Input=[outer]), self.area(outer), 1, UniformSpacing=0.5)
        mesher = BitingMesher(Input=group, UniformSpacing=0.5, MeshBlocksSeparately=1)
        mesher.UpdatePipeline()
        self.assertAlmostEqual(self.area(mesher), 20.0, places=6)

    def loop(self, radius):
        return simple.PolyLineSource(Points=[radius, 0, 0, 0, radius, 0, -radius, 0, 0,
                                             0, -radius, 0], Closed=1)

    def test_the_output_of_clip_is_accepted(self):
        plane = simple.Plane(XResolution=7, YResolution=9)
        clip = simple.Clip(Input=plane, ClipType='Plane')
        clip.ClipType.Normal = [1.0, 0.3, 0.0]
        clip.UpdatePipeline()
        self.expect(clip, self.area(clip), 1, UniformSpacing=0.05)

    def test_slices_and_curvilinear_grids_are_accepted(self):
        wavelet = simple.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5])
        cut = simple.Slice(Input=wavelet, SliceType='Plane')
        cut.SliceType.Normal = [1.0, 0.2, 0.3]
        cut.UpdatePipeline()
        self.expect(cut, self.area(cut), 1, UniformSpacing=0.5)
        image = simple.Wavelet(WholeExtent=[-5, 5, -5, 5, 0, 0])
        self.expect(simple.Transform(Input=image), 100.0, 1, UniformSpacing=1.0)

    def test_volumes_are_refused_with_a_way_out(self):
        mesher = BitingMesher(Input=simple.Wavelet(WholeExtent=[0, 2, 0, 2, 0, 2]))
        window = vtkOutputWindow.GetInstance()
        window.SetDisplayModeToNever()
        said = []
        tag = window.AddObserver('ErrorEvent', lambda *_: said.append('error'))
        mesher.UpdatePipeline()
        window.RemoveObserver(tag)
        window.SetDisplayModeToDefault()
        self.assertEqual(mesher.GetDataInformation().GetNumberOfCells(), 0)


if __name__ == '__main__':
    unittest.main()
