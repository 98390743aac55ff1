#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Calibrates tool and world of the simulated cell from poses that the cell recorded while the tip touched, and
compares them with the truth."""
import math
import os
import re
import shutil
import subprocess
import tempfile
import unittest

import numpy
import rospkg
import rostest
import yaml

TRUTH = os.path.join(rospkg.RosPack().get_path('scan_cell_sim'), 'config', 'cell.yaml')
TIMEOUT = 300  # [s] of a robot that goes to nine places
# The controller sends poses to 1 um and 1e-5 degrees, the file keeps metres to 1 um: over a lever of 0.2 m and
# distances of 0.2 m this amounts to a few um.
ROUNDING = 2e-5  # [m]


def run(*command):
    ended = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=TIMEOUT)
    said = ended.stdout.decode()
    assert ended.returncode == 0, said
    return said


def entries(path):
    with open(path) as file:
        return yaml.safe_load(file)


def distance(one, other):
    return float(numpy.linalg.norm(numpy.array(one['translation']) - other['translation']))


def angle(one, other):
    """[rad] between two rotations."""
    return 2 * math.acos(min(1.0, abs(float(numpy.dot(one['rotation'], other['rotation'])))))


class TaughtCell(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.cell = os.path.join(self.folder, 'cell.yaml')

    def tearDown(self):
        shutil.rmtree(self.folder)

    def teach(self, *options):
        run('rosrun', 'scan_cell_sim', 'touch_points.py', '--cell', TRUTH, '--output', self.folder, *options)
        tool = run('rosrun', 'scan_calibration', 'cell_frames', 'tool', '--cell', self.cell,
                   '--poses', os.path.join(self.folder, 'tool_poses.csv'))
        world = run('rosrun', 'scan_calibration', 'cell_frames', 'world', '--cell', self.cell,
                    '--points', os.path.join(self.folder, 'world_poses.csv'))
        print(tool + world)
        truth, found = entries(TRUTH), entries(self.cell)
        off = {name: (distance(found[name], truth[name]), angle(found[name], truth[name]))
               for name in ('tool_tip_in_tool0', 'base_link_in_world')}
        print('tip off by %.4f mm; base off by %.4f mm and %.5f deg' %
              (1e3 * off['tool_tip_in_tool0'][0], 1e3 * off['base_link_in_world'][0],
               math.degrees(off['base_link_in_world'][1])))
        return off, tool

    def test_tool_and_world_come_out_where_they_truly_are(self):
        off, _ = self.teach()
        self.assertLess(off['tool_tip_in_tool0'][0], ROUNDING)
        self.assertLess(off['base_link_in_world'][1], ROUNDING / 0.2)
        # The base is 0.8 m from the touched points.
        self.assertLess(off['base_link_in_world'][0], ROUNDING + 0.8 * ROUNDING / 0.2)

    def test_touches_that_miss_leave_the_tip_within_what_the_tool_says(self):
        miss = 2e-4  # [m]
        off, said = self.teach('--deviation', str(miss))
        deviation = re.search(r'standard deviation (\S+) (\S+) (\S+) mm', said).groups()
        length = math.hypot(*(1e-3 * float(each) for each in deviation))
        self.assertLess(off['tool_tip_in_tool0'][0], 4 * length)
        self.assertGreater(off['tool_tip_in_tool0'][0], ROUNDING, 'the touches did miss')


if __name__ == '__main__':
    rostest.rosrun('scan_cell_demo', 'taught_cell', TaughtCell)
