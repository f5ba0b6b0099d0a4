# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""The figures that Data/section6.py prints, against those of the paper."""

import os
import sys
import unittest

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'Data')
sys.path.insert(0, DATA)
import section6


class TestSection6Proxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        section6.load(os.environ['BITING_PLUGIN'])

    def test_meshes_have_the_papers_size_and_better_angles(self):
        for constant, order, figures in self.meshes():
            vertices, angle, _ = section6.PAPER[constant]
            # The order of bites alone moves the count by as much.
            self.assertLess(abs(figures[0] / vertices - 1), 0.15, (constant, order))
            self.assertGreater(figures[1], angle, (constant, order))

    def test_conformities_crowd_at_the_biting_constant(self):
        for constant, order, figures in self.meshes():
            self.assertLess(abs(figures[-1] - constant), 0.02, (constant, order))
            self.assertLess(abs(figures[3] - constant), 0.05, (constant, order))

    def meshes(self):
        for constant in section6.CONSTANTS:
            for order in section6.ORDERS:
                yield constant, order, section6.figures_of(section6.bite(constant, order))


if __name__ == '__main__':
    unittest.main()
