#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The panel in rviz itself, on a virtual screen, opened as the cell's launch file does."""
import os
import signal
import subprocess
import tempfile
import time
import unittest

import rosgraph
import rostest

SETTINGS = os.path.join(os.path.dirname(os.path.realpath(__file__)), '../../../../launch/cell.rviz')
PATIENCE = 90  # [s] software rendering
ASKED = '/part_recipes/run/status'  # only by the seat


class InRviz(unittest.TestCase):
    def setUp(self):
        home = tempfile.TemporaryDirectory()
        self.addCleanup(home.cleanup)
        self.home = home.name

    def start_rviz(self):
        screen = ['xvfb-run', '--auto-servernum', '--server-num', '100', '--server-args', '-screen 0 1600x1000x24']
        rviz = subprocess.Popen(screen + ['/usr/bin/rosrun', 'scan_cell_rviz', 'own_rviz.py', SETTINGS, '__name:=rviz'],
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True,
                                env=dict(os.environ, LIBGL_ALWAYS_SOFTWARE='1', ROS_HOME=self.home))
        self.addCleanup(self.end, rviz)
        return rviz

    @staticmethod
    def end(rviz):
        if rviz.poll() is None:
            os.killpg(rviz.pid, signal.SIGKILL)
            rviz.communicate()

    @staticmethod
    def listeners():
        _, subscribers, _ = rosgraph.Master('/test_in_rviz').getSystemState()
        return dict(subscribers).get(ASKED, [])

    def wait_for(self, condition, rviz):
        end = time.time() + PATIENCE
        while not condition():
            if rviz.poll() is not None:
                self.fail('rviz ended with %d: %s' % (rviz.returncode, rviz.communicate()[0]))
            self.assertLess(time.time(), end)
            time.sleep(0.1)

    def test_rviz_opens_the_seat_and_ends_in_order(self):
        rviz = self.start_rviz()
        self.wait_for(lambda: '/rviz' in self.listeners(), rviz)
        subprocess.run(['pkill', '-INT', '--session', str(os.getsid(rviz.pid)), '--exact', 'rviz'], check=True)
        log, _ = rviz.communicate(timeout=PATIENCE)
        self.assertEqual(rviz.returncode, 0, log)
        self.assertNotIn('Segmentation', log)
        self.assertNotIn('failed to load', log.lower())
        self.assertTrue(os.path.isfile(os.path.join(self.home, 'scan_cell_rviz', 'cell.rviz')), log)


if __name__ == '__main__':
    rostest.rosrun('scan_cell_rviz', 'in_rviz', InRviz)
