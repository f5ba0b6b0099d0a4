# SPDX-FileCopyrightText: Copyright (c) The Biting Developers
# SPDX-License-Identifier: BSD-3-Clause

"""The filters on several ranks give the bytes of one; an error is said once, and nothing hangs."""

import json
import os
import shutil
import subprocess
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
SECONDS = 120  # each takes a few


def mpiexec():
    """The command, or None. Open MPI refuses root and more ranks than cores, unless it is told."""
    command = shutil.which('mpiexec')
    if not command:
        return None
    version = subprocess.run([command, '--version'], capture_output=True, text=True, check=False)
    is_open_mpi = any(name in version.stdout for name in ('Open MPI', 'OpenRTE', 'open-mpi'))
    return [command] + (['--allow-run-as-root', '--oversubscribe'] if is_open_mpi else [])


def environment(path):
    """Without what tells a process that it is one of an MPI run already, as pvpython is."""
    kept = {name: value for name, value in os.environ.items()
            if not name.startswith(('OMPI_', 'PMIX_', 'PMI_', 'ORTE_'))}
    return dict(kept, BITING_ANSWER=path)


def answer_of(ranks):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'answer.json')
        subprocess.run(
            mpiexec() + ['-n', str(ranks), 'pvbatch', '--force-offscreen-rendering',
                         os.path.join(HERE, 'RanksScenarios.py')],
            env=environment(path), timeout=SECONDS, check=True,
            stdout=subprocess.DEVNULL)
        with open(path, encoding='ascii') as file:
            return json.load(file)


@unittest.skipUnless(mpiexec() and shutil.which('pvbatch'), 'mpiexec or pvbatch is missing')
class TestRanksProxy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.serial = answer_of(1)
        cls.parallel = {ranks: answer_of(ranks) for ranks in (2, 3)}

    def test_the_serial_outputs_do_not_depend_on_who_would_have_the_pieces(self):
        for name, result in self.serial.items():
            first = self.serial[name.rsplit('.', 1)[0] + '.First']
            self.assertEqual(result, first, name)

    def test_outputs_on_ranks_are_the_serial_ones_byte_for_byte(self):
        for ranks, answer in self.parallel.items():
            for name, result in answer.items():
                self.assertEqual(result, self.serial[name], '%s on %d ranks' % (name, ranks))


if __name__ == '__main__':
    unittest.main(verbosity=2)  # says why a test is skipped
