# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""The filters on several ranks give the bytes of one; an error is said once, and nothing hangs."""

import json
import os
import shutil
import socket
import subprocess
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
SECONDS = 300  # for all scenarios on a number of ranks, which take a minute

# The time goes into starting ranks, and into what they wait for each other: fewer for three.
PIECES = ['drawings', 'mixed', 'redistributed', 'sources', 'rules', 'hidden_cells']
ALL = PIECES + ['redistributed_otherwise', 'contours', 'other_filters', 'separate_blocks',
                'writers', 'errors', 'aborts', 'upstream']
SCENARIOS = {1: ALL, 2: ALL, 3: PIECES + ['contours', 'other_filters']}

# Scenarios of one form are the same drawing, whatever ranks have of it.
SAME_DRAWING = ('Polylines', 'Segments', 'Polygons', 'Tilted', 'Composite')
# Nothing says what the numbers of points and cells were before they were dealt out.
RENUMBERED = ('Dealt', 'Around', 'D3', 'Redistributed')
RENUMBERED_FORMS = ('Contour', 'Hidden', 'Source')
# Their inner polygons are holes, which is told: three problems, one message.
NESTED_FORMS = ('Polygons', 'Composite')


def mpiexec():
    """The command, or None. Open MPI refuses root and more ranks than cores, unless it is told."""
    command = shutil.which('mpiexec')
    if not command:
        return None
    version = subprocess.run([command, '--version'], capture_output=True, text=True, check=False)
    is_open_mpi = any(name in version.stdout for name in ('Open MPI', 'OpenRTE', 'open-mpi'))
    return [command] + (['--allow-run-as-root', '--oversubscribe'] if is_open_mpi else [])


def free_port():
    with socket.socket() as listener:
        listener.bind(('localhost', 0))
        return listener.getsockname()[1]


def environment(path):
    """Without what tells a process that it is one of an MPI run already, as pvpython is.

    Ranks of Open MPI that wait shall leave the cores to others: that halves the CPU time.
    """
    kept = {name: value for name, value in os.environ.items()
            if not name.startswith(('OMPI_', 'PMIX_', 'PMI_', 'ORTE_'))}
    return dict(kept, BITING_ANSWER=path, OMPI_MCA_mpi_yield_when_idle='1')


def answer_by(command, scenarios, script=os.path.join(HERE, 'RanksScenarios.py'), **variables):
    """What the scenarios gave, and what any rank said that the first one did not catch."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'answer.json')
        result = subprocess.run(
            command + ['--force-offscreen-rendering', script] + scenarios,
            env=dict(environment(path), **variables), timeout=SECONDS, check=True,
            capture_output=True, text=True)
        with open(path, encoding='ascii') as file:
            return json.load(file), result.stderr


def answer_of(ranks):
    return answer_by(mpiexec() + ['-n', str(ranks), 'pvbatch'], SCENARIOS[ranks])


def answer_of_server(ranks, scenarios):
    port = str(free_port())
    server = subprocess.Popen(
        mpiexec() + ['-n', str(ranks), 'pvserver', '--force-offscreen-rendering',
                     '--server-port=' + port],
        env=environment(''), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        answer = answer_by(['pvpython'], scenarios, BITING_SERVER_PORT=port)[0]
        server.wait(SECONDS)
        return answer
    finally:
        server.terminate()
        server.wait()


@unittest.skipUnless(mpiexec() and shutil.which('pvbatch'), 'mpiexec or pvbatch is missing')
class TestRanksProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        answers = {ranks: answer_of(ranks) for ranks in SCENARIOS}
        cls.serial = answers[1][0]
        cls.parallel = {ranks: answers[ranks][0] for ranks in answers if ranks > 1}
        cls.said = {ranks: answers[ranks][1] for ranks in answers}

    def test_the_serial_outputs_do_not_depend_on_who_would_have_the_pieces(self):
        for name, result in self.serial.items():
            form = name.split('.')[0]
            if form in SAME_DRAWING:
                self.assertEqual(result['digests'], self.serial[form + '.First']['digests'], name)

    def test_hidden_cells_are_no_part_of_the_mesh_whatever_it_is_made_of(self):
        meshes = [self.serial['Hidden.' + form]['digests'][0] for form in ('Grid', 'Quads')]
        self.assertEqual(len(set(meshes)), 1)

    def test_lines_segments_and_polygons_that_draw_the_same_give_the_same_mesh(self):
        # But for the arrays of cells, which polygons have and lines have not.
        meshes = [self.serial[form + '.First']['digests'][0].rsplit(',', 1)[0]
                  for form in ('Polylines', 'Segments', 'Polygons', 'Composite')]
        self.assertEqual(len(set(meshes)), 1)

    def test_outputs_on_ranks_are_the_serial_ones_byte_for_byte(self):
        for ranks, answer in self.parallel.items():
            self.assertTrue(answer)
            for name, result in answer.items():
                with self.subTest(name=name, ranks=ranks):
                    self.assert_serial(name, result)

    def assert_serial(self, name, result):
        wanted = dict(self.serial[name])
        if name.split('.')[-1] in RENUMBERED or name.startswith(RENUMBERED_FORMS):
            wanted['ids'] = result['ids']
        self.assertEqual(result, wanted, name)

    @unittest.skipUnless(shutil.which('pvserver'), 'pvserver is missing')
    def test_a_server_of_two_ranks_gives_the_serial_bytes(self):
        answer = answer_of_server(2, ['redistributed', 'contours'])
        self.assertTrue(answer)
        for name, result in answer.items():
            self.assert_serial(name, result)

    def test_scenarios_mesh_and_refuse_what_they_are_meant_to(self):
        for name, result in self.serial.items():
            if name.startswith(('Error', 'Abort')):
                silent = name in ('Error.Nothing', 'Abort.Stopped')
                self.assertEqual(result['messages'], 0 if silent else 1, name)
                self.assertRegex(result['digests'][0], '^0 ', name)
            else:
                nested = name.startswith(NESTED_FORMS)
                self.assertEqual(result['messages'], 1 if nested else 0, name)
                self.assertNotRegex(result['digests'][0], '^0 ', name)
                if nested:
                    self.assertRegex(result['digests'][2], '^3 problems', name)

    def test_only_the_first_rank_says_what_is_wrong(self):
        for ranks, said in self.said.items():
            lines = [line for line in said.splitlines() if 'pvbatch.0' not in line]
            if ranks > 1:
                self.assertFalse([line for line in lines if 'ERR|' in line or 'WARN|' in line])


if __name__ == '__main__':
    unittest.main(verbosity=2)  # says why a test is skipped
