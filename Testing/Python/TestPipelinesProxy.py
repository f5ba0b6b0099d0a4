# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Pipelines of ParaView's own filters: the mesh covers the area of the cells that they hand over.

The area is added up here, cell by cell, from the data alone.
"""

import math
import os
import unittest

from paraview import servermanager, simple

ROUNDING = 1e-6  # of areas: points are floats


def leaves(data):
    if not data.IsA('vtkCompositeDataSet'):
        return [data]
    found = []
    walk = data.NewIterator()
    walk.InitTraversal()
    while not walk.IsDoneWithTraversal():
        found.append(walk.GetCurrentDataObject())
        walk.GoToNextItem()
    return found


def area_of_cell(cell):
    """Half the length of the sum of cross products around it."""
    count = cell.GetNumberOfPoints()
    places = [cell.GetPoints().GetPoint(k) for k in range(count)]
    if cell.GetClassName() == 'vtkPixel':
        places[2], places[3] = places[3], places[2]
    offsets = [[a - b for a, b in zip(place, places[0])] for place in places]
    total = [0.0, 0.0, 0.0]
    for a, b in zip(offsets[1:-1], offsets[2:]):
        for k in range(3):
            total[k] += a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]
    return 0.5 * math.hypot(*total)


def area_of(proxy):
    proxy.UpdatePipeline()
    return math.fsum(area_of_cell(part.GetCell(k)) for part in leaves(servermanager.Fetch(proxy))
                     for k in range(part.GetNumberOfCells())
                     if part.GetCell(k).GetCellDimension() == 2)


def wavelet(*extent):
    return simple.Wavelet(WholeExtent=extent)


def high(image, lower=150.0):
    found = simple.Threshold(Input=image, Scalars=['POINTS', 'RTData'])
    found.LowerThreshold, found.UpperThreshold = lower, 300.0
    return found


def slice_of(producer, normal, origin=(0.3, 0.2, 0.1)):
    cut = simple.Slice(Input=producer)
    cut.SliceType.Origin, cut.SliceType.Normal = list(origin), list(normal)
    return cut


def clip_by_ball(producer, **parameters):
    clip = simple.Clip(Input=producer, ClipType='Sphere', **parameters)
    clip.ClipType.Radius = 13.3
    return clip


def between(producer, low, high_value):
    return simple.IsoVolume(
        Input=producer, InputScalars=['POINTS', 'RTData'], ThresholdRange=[low, high_value])


def turned(producer, degrees, offset=(0, 0, 0), scale=1.0):
    moved = simple.Transform(Input=producer)
    moved.Transform.Rotate, moved.Transform.Translate = list(degrees), list(offset)
    moved.Transform.Scale = [scale] * 3
    return moved


class TestPipelinesProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())
        cls.image = wavelet(-20, 20, -20, 20, 0, 0)
        cls.volume = wavelet(-8, 8, -8, 8, -8, 8)

    def expect_area(self, producer, area=None, rounding=ROUNDING, **parameters):
        wanted = area_of(producer) if area is None else area
        self.assertGreater(wanted, 0.0)
        found = area_of(BitingMesher(Input=producer, **parameters))
        self.assertLess(abs(found - wanted), rounding * wanted, (producer, found, wanted))

    def test_thresholds_as_they_are_and_as_surfaces(self):
        cells = high(self.image)
        surface = simple.ExtractSurface(Input=cells)
        for producer in (cells, surface, simple.CleantoGrid(Input=cells),
                         simple.TriangleStrips(Input=simple.Triangulate(Input=surface)),
                         simple.PointDatatoCellData(Input=surface)):
            self.expect_area(producer, area_of(cells), UniformSpacing=3.0)
        self.expect_area(simple.Shrink(Input=surface), UniformSpacing=3.0)

    def test_clips_crinkled_or_not_and_what_they_leave_over(self):
        surface = simple.ExtractSurface(Input=high(self.image))
        for clip in (clip_by_ball(self.image), clip_by_ball(self.image, Crinkleclip=1),
                     clip_by_ball(self.image, Invert=0), clip_by_ball(surface)):
            self.expect_area(clip, UniformSpacing=3.0)

    def test_slices_of_images_and_tetrahedra_and_what_lies_between_values_on_them(self):
        for producer in (self.volume, simple.Tetrahedralize(Input=self.volume)):
            for normal in ((0, 0, 1), (1, 2, 3), (1, 1, 0)):
                cut = slice_of(producer, normal)
                self.expect_area(cut)
                self.expect_area(between(cut, 150.0, 220.0))

    def test_cell_edges_kept_do_not_change_the_area(self):
        cut = between(slice_of(self.volume, (1, 2, 3)), 150.0, 220.0)
        self.expect_area(cut, KeepCellEdges=True)

    def test_texts(self):
        for text in ('Biting', '8&%@', '...iii'):
            letters = simple.a3DText(Text=text)
            self.expect_area(letters)
            extruded = simple.LinearExtrusion(Input=letters, Capping=1)
            self.expect_area(slice_of(extruded, (0, 0, 1), (0, 0, 0.3)), area_of(letters),
                             rounding=1e-4)

    def test_blocks_together_and_each_alone(self):
        ring = simple.Disk(InnerRadius=2, OuterRadius=3, CircumferentialResolution=40)
        core = simple.Disk(InnerRadius=0.5, OuterRadius=1, CircumferentialResolution=20)
        blocks = simple.GroupDatasets(Input=[ring, core])
        self.expect_area(blocks)
        self.expect_area(blocks, MeshBlocksSeparately=True)
        self.expect_area(simple.GroupDatasets(Input=[
            ring, simple.ProgrammableSource(Script='pass')]), area_of(ring))

    def test_parts_side_by_side_and_on_top_of_each_other(self):
        whole = simple.Plane()
        beside = simple.Plane(Origin=[0.5, -0.5, 0], Point1=[1.5, -0.5, 0], Point2=[0.5, 0.5, 0],
                              XResolution=3, YResolution=7)
        over = simple.Plane(Origin=[0, 0, 0], Point1=[1, 0, 0], Point2=[0, 1, 0])
        self.expect_area(simple.AppendGeometry(Input=[whole, beside]), 2.0)
        self.expect_area(simple.AppendGeometry(Input=[whole, over]), 1.5)  # once covered
        self.expect_area(simple.AppendDatasets(Input=[
            self.image, wavelet(20, 40, -20, 20, 0, 0)]), 2400.0)

    def test_turned_planes_far_away_and_tiny_ones(self):
        clip = clip_by_ball(self.image)
        area = area_of(clip)
        self.expect_area(turned(clip, (90, 0, 0)), area)
        self.expect_area(turned(clip, (10, 20, 30), scale=1e-5), 1e-10 * area)
        # Floats of some 1e5 are right to .01, which is 1e-3 of the area of a strip along the rim.
        self.expect_area(turned(clip, (33, 48, 71), (1e5, 2e5, -3e5)), area, rounding=1e-3)

    def test_contours_that_end_at_the_rim_are_told_and_areas_above_a_value_are_whole(self):
        lines = simple.Contour(Input=slice_of(simple.Wavelet(), (0, 0, 1), (0, 0, 0.03)))
        lines.ContourBy, lines.Isosurfaces = ['POINTS', 'RTData'], [180.0]
        mesher = BitingMesher(Input=lines)
        mesher.UpdatePipeline()
        problems = servermanager.Fetch(mesher, idx=3).GetPointData().GetAbstractArray('Message')
        messages = ' '.join(problems.GetValue(k) for k in range(problems.GetNumberOfValues()))
        self.assertIn('Interfaces outside of the domain', messages)
        self.expect_area(between(slice_of(simple.Wavelet(), (0, 0, 1), (0, 0, 0.03)), 180.0, 300.0))

    def test_a_tolerance_keeps_the_area_to_a_few_percent(self):
        for producer in (high(self.image), clip_by_ball(self.image, Invert=0),
                         between(self.image, 120.0, 200.0)):
            self.expect_area(producer, rounding=0.06, UniformSpacing=4.0, BoundaryTolerance=0.2)


if __name__ == '__main__':
    unittest.main()
