# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""The proxy of Biting Surface Check: surfaces of others, and those of ParaView's own filters."""

import os
import unittest

from paraview import servermanager, simple

simple.LoadPlugin(os.environ['BITING_PLUGIN'], ns=globals())

SHARED = os.path.join(os.path.dirname(__file__), '..', '..', '..', 'shared', 'surfaces')
ALARMS = ('Folds', 'SelfCrossings', 'DuplicateTriangles')


def figure(check, name):
    data = servermanager.Fetch(check, idx=0).GetFieldData()
    return data.GetArray(name).GetValue(0)


class SurfaceCheckProxy(unittest.TestCase):

    def assert_no_alarm(self, name, source, more=('NonManifoldEdges', 'PinchedVertices')):
        check = BitingSurfaceCheck(Input=source)
        data = servermanager.Fetch(check, idx=0).GetFieldData()
        found = [alarm for alarm in ALARMS + more if data.GetArray(alarm).GetValue(0) > 0]
        self.assertEqual(found, [], name)
        simple.Delete(check)

    def test_the_panel_has_a_summary_and_the_defaults_are_those_of_the_filter(self):
        check = BitingSurfaceCheck(Input=simple.Sphere())
        self.assertEqual(check.FeatureAngle, 40.0)
        check.UpdatePipeline()
        check.UpdatePipelineInformation()
        self.assertIn('closed and does not cross itself', check.Summary)
        self.assertEqual(figure(check, 'EulerNumber'), 2)

    def test_surfaces_of_others_are_what_their_index_says(self):
        path = os.path.join(SHARED, 'INDEX.md')
        if not os.path.exists(path):
            self.skipTest('the surfaces are not there')
        rows = [line.split('|')[1:-1] for line in open(path) if line.startswith('| ')]
        rows = [[entry.strip() for entry in row] for row in rows if 'file' not in row[0]]
        self.assertEqual(len(rows), 30)
        for row in rows:
            check = BitingSurfaceCheck(Input=simple.OpenDataFile(os.path.join(SHARED, row[0])))
            names = ('OpenEdges', 'NonManifoldEdges', 'Parts', 'EulerNumber')
            self.assertEqual([figure(check, name) for name in names],
                             [int(entry) for entry in row[2:6]], row[0])
            if int(row[2]) == 0 and int(row[3]) == 0:
                volume = float(row[6])
                self.assertAlmostEqual(figure(check, 'Volume') / volume, 1.0, 2, row[0])

    def test_contours_clips_and_isovolumes_of_paraview_give_no_alarm(self):
        wavelet = simple.Wavelet()
        for value in range(70, 270, 10):
            contour = simple.Contour(Input=wavelet, ContourBy='RTData', Isosurfaces=[value])
            self.assert_no_alarm('contour %s' % value, contour)
        for normal in ([1, 0, 0], [1, 1, 1], [0.3, 0.5, 0.8]):
            for origin in (0, 0.5, 3.3):
                clip = simple.Clip(Input=wavelet, ClipType='Plane')
                clip.ClipType.Normal = normal
                clip.ClipType.Origin = [origin, 0, 0]
                self.assert_no_alarm(
                    'clip %s %s' % (normal, origin), simple.ExtractSurface(Input=clip))

    def test_sources_and_text_of_paraview_give_no_alarm(self):
        for source in (simple.Sphere(), simple.Cone(), simple.Cylinder(), simple.Box(),
                       simple.Superquadric(), simple.Disk(), simple.Plane(), simple.Arrow()):
            self.assert_no_alarm(source.GetXMLName(), source)
        self.assert_no_alarm('text', getattr(simple, 'a3DText')(Text='Biting'))


if __name__ == '__main__':
    unittest.main()
