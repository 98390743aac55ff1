#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs an adapted path with the tool in the simulated cell, first dry, then for real, with typed commands. The simulator
gives the true positions of the tip."""
import hashlib
import json
import math
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import rospy
import rostest
from geometry_msgs.msg import PoseStamped
from scan_cell_msgs.msg import RobotStatus, WorkPreview
from sensor_msgs.msg import JointState

LENGTH = 0.2  # [m]
SPACING = 0.005  # [m]
HEIGHT = 0.1  # [m] of the path in the world
LIFT = 0.05  # [m] default
TIP = 0.2  # [m] the simulator's tool, along z of the flange
PATIENCE = 60  # [s]


def sha256(path):
    with open(path, 'rb') as file:
        return hashlib.sha256(file.read()).hexdigest()


class Work(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix='work_')
        self.addCleanup(shutil.rmtree, self.folder)
        self.tips = []
        self.status = None
        self.lock = threading.Lock()
        rospy.Subscriber('/scan_cell_sim/true_flange', PoseStamped, self.on_flange)
        rospy.Subscriber('/c4g_driver/status', RobotStatus, self.on_status)
        self.wait_for(lambda: self.status and self.status.motion_possible == RobotStatus.YES)

    def on_flange(self, message):
        """The tool always points straight down: its tip is below the flange."""
        with self.lock:
            self.tips.append((message.pose.position.x, message.pose.position.y, message.pose.position.z - TIP))

    def on_status(self, message):
        self.status = message

    def wait_for(self, condition):
        end = time.time() + PATIENCE
        while not condition():
            self.assertLess(time.time(), end)
            time.sleep(0.02)

    def file(self, name):
        return os.path.join(self.folder, name)

    def write_path(self, name='path.csv', height=HEIGHT):
        count = int(round(LENGTH / SPACING)) + 1
        with open(self.file(name), 'w') as file:
            file.write('x,y,z,qx,qy,qz,qw\n')
            for i in range(count):
                file.write('%.4f,0,%.4f,0,0,0,1\n' % (i * SPACING, height))
        return count

    def write_report(self, count, age=0, scanner=None, proven='0' * 64):
        scanner_file = rospy.get_param('/calibrated_frames/scanner_file')
        report = {'verdict': 'accepted', 'message': '',
                  'files': {'reference': None, 'object': None, 'path': {'name': 'proven.csv', 'sha256': proven},
                            'output': {'name': 'path.csv', 'sha256': sha256(self.file('path.csv'))}},
                  'calibration': {'scanner': {'name': scanner_file, 'sha256': scanner or sha256(scanner_file)},
                                  'cell': {'name': 'cell', 'sha256': sha256(
                                      rospy.get_param('/calibrated_frames/cell_file'))}},
                  'scanned': time.time() - age, 'quality': [{'in_air': False}] * count}
        with open(self.file('report.json'), 'w') as file:
            json.dump(report, file)

    def command(self, *options):
        return ['rosrun', 'scan_cell', 'work', '--path', self.file('path.csv'), '--report', self.file('report.json'),
                '--waypoint-z', 'out_of_part', '--record', self.file('record.json')] + list(options)

    def work(self, *options):
        with self.lock:
            self.tips = []
        run = subprocess.run(self.command(*options), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                             timeout=180, check=False)
        return run.returncode, run.stdout

    def record(self):
        with open(self.file('record.json')) as file:
            return json.load(file)

    def expect_tip_at_height(self, height):
        """The tip was everywhere on the path, and never below it."""
        with self.lock:
            tips = list(self.tips)
        lowest = min(z for _, _, z in tips)
        self.assertAlmostEqual(lowest, height, delta=1e-4)
        along = [x for x, _, z in tips if abs(z - height) < 1e-4]
        self.assertAlmostEqual(max(along) - min(along), LENGTH * math.cos(0.052359877), delta=0.003)

    def expect_refused(self, code, log, word):
        self.assertEqual(code, 2, log)
        self.assertIn(word, log)
        with self.lock:
            tips = list(self.tips)
        for axis in range(3):
            values = [tip[axis] for tip in tips] or [0]
            self.assertLess(max(values) - min(values), 1e-6, 'nothing moved')

    def test_dry_run_comes_before_the_real_one(self):
        count = self.write_path()
        self.write_report(count, proven=hashlib.sha256(self.folder.encode()).hexdigest())
        self.expect_refused(*self.work(), word='dry')

        code, log = self.work('--dry-run')
        self.assertEqual(code, 0, log)
        self.expect_tip_at_height(HEIGHT + LIFT)
        record = self.record()
        self.assertTrue(record['dry_run'])
        self.assertEqual([each['waypoint'] for each in record['passed']], list(range(count)))
        self.assertEqual({each['outputs'] for each in record['passed']}, {0})

        code, log = self.work()
        self.assertEqual(code, 0, log)
        self.expect_tip_at_height(HEIGHT)
        record = self.record()
        self.assertEqual([each['waypoint'] for each in record['passed']], list(range(count)))
        self.assertEqual({each['outputs'] for each in record['passed'][:-1]}, {4}, 'output 3 in contact')
        self.assertEqual(record['passed'][-1]['outputs'], 0)

    def test_what_was_not_accepted_together_is_refused(self):
        count = self.write_path()
        self.write_report(count, scanner='0' * 64)
        self.expect_refused(*self.work('--dry-run'), word='scanner model')
        self.write_report(count, age=1e5)
        self.expect_refused(*self.work('--dry-run'), word='scan')
        self.write_report(count)
        with open(self.file('path.csv'), 'a') as file:
            file.write('0.3,0,%.4f,0,0,0,1\n' % HEIGHT)
        self.expect_refused(*self.work('--dry-run'), word='SHA-256')

    def test_path_out_of_reach_is_refused_with_its_waypoint(self):
        count = self.write_path(height=2.5)
        self.write_report(count)
        self.expect_refused(*self.work('--dry-run'), word='waypoint')

    def preview(self, *options):
        with self.lock:
            self.tips = []
        run = subprocess.run(['rosrun', 'scan_cell', 'preview_work', '--path', self.file('path.csv'), '--report',
                              self.file('report.json'), '--waypoint-z', 'out_of_part'] + list(options),
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60, check=False)
        shown = rospy.wait_for_message('/scan_cell/work_preview', WorkPreview, PATIENCE)
        with self.lock:
            tips = list(self.tips)
        self.assertLess(max(x for x, _, _ in tips) - min(x for x, _, _ in tips), 1e-6, 'nothing moved')
        return run.returncode, run.stdout, shown

    def test_preview_tells_where_the_robot_will_stand_before_it_moves(self):
        count = self.write_path()
        self.write_report(count)
        code, log, shown = self.preview('--dry-run')
        self.assertEqual(code, 0, log)
        self.assertTrue(shown.dry_run)
        self.assertEqual([each for each in shown.path_waypoints if each >= 0], list(range(count)))
        self.assertEqual({each.outputs for each in shown.waypoints}, {0})
        code, log = self.work('--dry-run')
        self.assertEqual(code, 0, log)
        stands = rospy.wait_for_message('/joint_states', JointState, PATIENCE)
        joints = dict(zip(stands.name, stands.position))
        for name, angle in zip(shown.joint_names, shown.joints[-6:]):
            self.assertAlmostEqual(joints[name], angle, delta=1e-3)

    def test_preview_tells_all_that_the_robot_cannot_do(self):
        count = self.write_path(height=2.5)
        self.write_report(count)
        code, log, shown = self.preview()
        self.assertEqual(code, 2, log)
        self.assertTrue(shown.message.startswith('the approach to waypoint 0'), shown.message)
        self.assertIn('waypoint %d: ' % (count - 1), log)
        self.assertGreater(len(shown.faults), count // 2)
        self.assertIn(shown.message, log)

    def test_an_interrupt_stops_the_robot_and_what_was_done_is_written(self):
        count = self.write_path()
        self.write_report(count)
        run = subprocess.Popen(self.command('--dry-run'), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                               start_new_session=True)
        self.wait_for(lambda: self.tips and min(z for _, _, z in self.tips[-3:]) < HEIGHT + LIFT + 1e-4)
        time.sleep(0.5)  # a few waypoints later
        os.killpg(run.pid, signal.SIGINT)
        log, _ = run.communicate(timeout=PATIENCE)
        self.assertEqual(run.returncode, 1, log)
        self.wait_for(lambda: self.status.in_motion == RobotStatus.NO)
        record = self.record()
        self.assertFalse(record['finished'])
        self.assertLess(len(record['passed']), count)
        with self.lock:
            self.tips = []
        self.wait_for(lambda: len(self.tips) > 20)
        self.assertLess(max(x for x, _, _ in self.tips) - min(x for x, _, _ in self.tips), 1e-6, 'it stands')


if __name__ == '__main__':
    rospy.init_node('work')
    rostest.rosrun('scan_cell_demo', 'work', Work, sys.argv)
