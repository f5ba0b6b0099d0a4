# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""A mesh of blocks is spread over ranks: together they have the serial mesh, byte for byte."""

import os
import shutil
import subprocess
import unittest

from TestRanksProxy import HERE, RENUMBERED, answer_by, environment, mpiexec

SCRIPT = os.path.join(HERE, 'RanksBlocks.py')
ALL = ['pieces', 'drawings', 'sources', 'rules', 'filters', 'files', 'errors']
SCENARIOS = {1: ALL, 2: ALL, 3: ['pieces', 'drawings', 'rules', 'filters']}


def answer_of(ranks):
    command = mpiexec() + ['-n', str(ranks), 'pvbatch']
    return answer_by(command, SCENARIOS[ranks], script=SCRIPT)


@unittest.skipUnless(mpiexec() and shutil.which('pvbatch'), 'mpiexec or pvbatch is missing')
class TestRanksBlocksProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        answers = {ranks: answer_of(ranks) for ranks in SCENARIOS}
        cls.serial = answers[1][0]
        cls.parallel = {ranks: answers[ranks][0] for ranks in answers if ranks > 1}
        cls.said = {ranks: answers[ranks][1] for ranks in answers}

    def test_each_rank_has_a_fair_share_and_each_point_one_owner(self):
        points, cells = self.serial['Pieces']
        for ranks, answer in self.parallel.items():
            own, held = answer['Pieces']
            self.assertEqual(len(held), ranks)
            self.assertEqual(sum(own), points[0])
            self.assertLess(max(held), 1.7 * cells[0] / ranks)

    def test_the_union_is_the_serial_mesh_byte_for_byte(self):
        for ranks, answer in self.parallel.items():
            for name in answer:
                if name not in ('Pieces', 'Area'):
                    with self.subTest(name=name, ranks=ranks):
                        self.assert_serial(name, answer[name])

    def assert_serial(self, name, result):
        wanted = self.serial[name]
        if name.endswith(RENUMBERED) or name.startswith('Source'):
            wanted = dict(wanted, ids=result['ids'])
        self.assertEqual(result, wanted)

    def test_the_mesh_does_not_depend_on_who_has_the_pieces_nor_on_what_failed_before(self):
        for name, result in self.serial.items():
            if name.startswith('Polylines.'):
                self.assertEqual(result, self.serial['Polylines.First'], name)

    def test_the_summary_counts_what_all_ranks_have(self):
        self.assertIn('Mean of smallest angles', ' '.join(self.serial['Summary']))
        for ranks in (2, 3):
            self.assertEqual(self.parallel[ranks]['Summary'], self.serial['Summary'])

    def test_integrals_are_the_serial_ones_but_for_the_order_of_their_sums(self):
        for answer in self.parallel.values():
            if 'Area' in answer:
                self.assertAlmostEqual(answer['Area'] / self.serial['Area'], 1.0, places=12)

    def test_what_is_refused_or_stopped_is_empty_and_said_once(self):
        for name, result in self.serial.items():
            if name.startswith(('Error', 'Abort')):
                self.assertEqual(result['messages'], int(name.startswith('Error')), name)
                self.assertRegex(result['digests'][0], '^0 ', name)
        for ranks, said in self.said.items():
            lines = [line for line in said.splitlines() if 'pvbatch.0' not in line]
            if ranks > 1:
                self.assertFalse([line for line in lines if 'ERR|' in line or 'WARN|' in line])

    def test_a_rank_that_is_killed_ends_the_run_with_a_message(self):
        for scenario in ('killed', 'killed_at_work'):
            result = subprocess.run(
                mpiexec() + ['-n', '3', 'pvbatch', '--force-offscreen-rendering', SCRIPT, scenario],
                env=environment(''), timeout=120, check=False, capture_output=True, text=True)
            self.assertNotEqual(result.returncode, 0)
            self.assertRegex(result.stdout + result.stderr, '(?i)signal 9|killed', scenario)


if __name__ == '__main__':
    unittest.main(verbosity=2)  # says why a test is skipped
