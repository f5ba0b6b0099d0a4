# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""Twenty models of Gmsh with holes, inclusions and physical groups: Gmsh meshes them, ParaView's Extract
Surface hands on triangles and lines, and the mesher makes of it the same area, regions and tags, as the
remesher does where it refines the mesh of Gmsh to half its spacing, or coarsens it to twice.

What they must be is added up here from the file of Gmsh, cell by cell.
"""

import math
import os
import random
import shutil
import subprocess
import tempfile
import unittest

from paraview import simple

GMSH = shutil.which('gmsh')
NUMBER_OF_MODELS = 20
FIRST_SURFACE = 1000  # no number of a group of curves is as high
IDS = 'CellEntityIds'  # of physical groups, where there are any
TRIANGLE, LINE = 5, 3
EQUILATERAL = math.sqrt(0.1875)  # area, of sides 1


def model(seed):
    """A rectangle; in the squares of a grid circles, each a hole, an inclusion, or not there. Some of
    the curves are in physical groups."""
    numbers = random.Random(seed)
    columns, rows = numbers.randint(1, 4), numbers.randint(1, 3)
    size = 10.0 ** numbers.randint(-3, 4)
    text = 'SetFactory("OpenCASCADE");\nh = %r;\nRectangle(%d) = {0, 0, 0, %r, %r};\n' % (
        0.1 * size, FIRST_SURFACE, columns * size, rows * size)
    discs, inclusions = [], []
    for place in range(columns * rows):
        kind = numbers.choice(('hole', 'inclusion', 'nothing'))
        if kind == 'nothing':
            continue
        disc = FIRST_SURFACE + 1 + place
        x, y = (place % columns + 0.5) * size, (place // columns + 0.5) * size
        text += 'Disk(%d) = {%r, %r, 0, %r, %r};\n' % (
            disc, x, y, numbers.uniform(0.3, 0.4) * size, numbers.uniform(0.2, 0.3) * size)
        discs.append(disc)
        inclusions += [disc] if kind == 'inclusion' else []
    if discs:
        text += 'BooleanDifference(%d) = {Surface{%d}; Delete;}{Surface{%s};};\n' % (
            FIRST_SURFACE + 500, FIRST_SURFACE, ', '.join(map(str, discs)))
    for disc in set(discs) - set(inclusions):
        text += 'Recursive Delete {Surface{%d};}\n' % disc
    text += 'Coherence;\n' if inclusions else ''
    return text + '''surfaces() = Surface{:};
For k In {0 : #surfaces() - 1}
  Physical Surface(%d + k) = surfaces(k);
EndFor
curves() = Curve{:};
For k In {0 : #curves() - 1}
  If (k %% 3 != %d)
    Physical Curve(k + 1) = curves(k);
  EndIf
EndFor
Mesh.MeshSizeMin = h;
Mesh.MeshSizeMax = h;
''' % (FIRST_SURFACE, seed % 3)


def sizes(data, kind):
    """By number of the entity: areas of the triangles, or lengths of the lines."""
    ids = data.GetCellData().GetArray(IDS)
    found = {}
    for cell in range(data.GetNumberOfCells()):
        if data.GetCellType(cell) == kind:
            places = data.GetCell(cell).GetPoints()
            a, b, c = (places.GetPoint(k % places.GetNumberOfPoints()) for k in range(3))
            size = (math.dist(a, b) if kind == LINE else
                    0.5 * abs((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])))
            found.setdefault(int(ids.GetValue(cell)), []).append(size)
    return {entity: math.fsum(parts) for entity, parts in found.items()}


@unittest.skipUnless(GMSH, 'Gmsh is not installed')
class TestGmshModelsProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())

    def expect_same(self, found, expected, relative):
        self.assertEqual(set(found), set(expected))
        for entity, size in expected.items():
            self.assertAlmostEqual(found[entity] / size, 1.0, delta=relative)

    def test_area_regions_and_tags_are_those_of_the_model(self):
        kinds = [0, 0]
        with tempfile.TemporaryDirectory() as folder:
            for seed in range(NUMBER_OF_MODELS):
                path = os.path.join(folder, 'model%d' % seed)
                with open(path + '.geo', 'w', encoding='ascii') as file:
                    file.write(model(seed))
                subprocess.run([GMSH, path + '.geo', '-2', '-format', 'vtk', '-o', path + '.vtk'],
                               check=True, capture_output=True, timeout=100)
                with self.subTest(seed=seed):
                    kinds[self.check(path + '.vtk') > 1] += 1
        self.assertGreater(min(kinds), 2, 'models of one region, and of several')

    def check(self, path):
        """Returns the number of regions."""
        given = simple.LegacyVTKReader(FileNames=[path])
        surface = simple.ExtractSurface(Input=given)
        surface.UpdatePipeline()
        model_made = simple.FetchData(given)[0]
        areas, lengths = sizes(model_made, TRIANGLE), sizes(model_made, LINE)
        self.compare(BitingMesher(Input=surface, RegionArray=IDS,
                                  BoundarySpacingArray=['POINTS', 'None']), areas, lengths)
        triangles = sum(model_made.GetCellType(cell) == TRIANGLE
                        for cell in range(model_made.GetNumberOfCells()))
        spacing = math.sqrt(sum(areas.values()) / triangles / EQUILATERAL)
        for scale in (0.5, 2.0):
            self.compare(BitingRemesher(Input=surface, RegionArray=IDS,
                                        UniformSpacing=scale * spacing), areas, lengths)
        return len(areas)

    def compare(self, meshed, areas, lengths):
        meshed.UpdatePipeline()
        mesh = simple.FetchData(simple.OutputPort(meshed, 0))[0]
        edges = simple.FetchData(simple.OutputPort(meshed, 1))[0]
        regions = mesh.GetCellData().GetArray('RegionId')
        found = {}
        for cell in range(mesh.GetNumberOfCells()):
            places = mesh.GetCell(cell).GetPoints()
            a, b, c = (places.GetPoint(k) for k in range(3))
            area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]))
            found.setdefault(int(regions.GetValue(cell)), []).append(area)
        # Inclusions do not touch each other: each region is one entity.
        self.assertEqual(len(found), len(areas))
        for ours, theirs in zip(sorted(map(math.fsum, found.values())), sorted(areas.values())):
            self.assertAlmostEqual(ours / theirs, 1.0, delta=1e-6)
        tagged = {entity: length for entity, length in sizes(edges, LINE).items()
                  if 0 <= entity < FIRST_SURFACE}  # below: on no line
        self.expect_same(tagged, lengths, 1e-6)


if __name__ == '__main__':
    unittest.main()
