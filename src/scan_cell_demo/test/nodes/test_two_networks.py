#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The cell across two networks: robot, camera and trigger circuit in one namespace, the processing in another."""
import json
import os
import shutil
import subprocess
import tempfile
import unittest

import rostest

SCRIPT = os.path.join(os.path.dirname(os.path.realpath(__file__)), 'two_networks.sh')
# and of processes: whatever happens, nothing keeps running
AS_ROOT = [] if os.geteuid() == 0 else ['--user', '--map-root-user']
NAMESPACE = ['unshare', '--net', '--pid', '--fork', '--kill-child', '--mount-proc'] + AS_ROOT
TIMEOUT = 240  # [s] on a busy machine
MAX_CLOUD_RMS = 0.3  # [mm]


def why_not_allowed():
    """Empty if this user may create network namespaces and virtual cables between them."""
    tried = subprocess.run(NAMESPACE + ['ip', 'link', 'add', 'name', 'near', 'type', 'veth', 'peer', 'name', 'far'],
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return '' if tried.returncode == 0 else tried.stdout.decode().strip() or 'it fails'


class TwoNetworks(unittest.TestCase):

    def setUp(self):
        reason = why_not_allowed()
        if reason:
            self.skipTest('network namespaces are not allowed here: ' + reason)
        self.folder = tempfile.mkdtemp(prefix='two_networks_')
        self.addCleanup(shutil.rmtree, self.folder)

    def log(self):
        texts = []
        for name in ('scan.log', 'cell.log', 'simulator.log'):
            path = os.path.join(self.folder, name)
            if os.path.exists(path):
                with open(path, errors='replace') as file:
                    texts.append('%s:\n%s' % (name, file.read()[-2000:]))
        return '\n'.join(texts)

    def test_scans_over_the_cable_as_well_as_on_one_machine(self):
        run = subprocess.Popen(NAMESPACE + ['bash', SCRIPT, self.folder], stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT)
        try:
            output = run.communicate(timeout=TIMEOUT)[0].decode(errors='replace')
        except subprocess.TimeoutExpired:
            run.kill()
            run.communicate()
            self.fail('not done in time\n' + self.log())
        self.assertEqual(run.returncode, 0, output + self.log())
        with open(os.path.join(self.folder, 'judged.json')) as file:
            cloud = json.load(file)
        self.assertGreater(cloud['points'], 10000)
        self.assertLess(cloud['rms_mm'], MAX_CLOUD_RMS)


if __name__ == '__main__':
    rostest.rosrun('scan_cell_demo', 'two_networks', TwoNetworks)
