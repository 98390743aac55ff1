#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""bind_bag and estimate_time_offset on recorded scans."""
import io
import math
import os
import re
import subprocess
import tempfile
import unittest

import rosbag
import rostest
from scan_cell_msgs.msg import BindingAudit, PeakProfile, PoseMatch, ScanRun, TriggerEvent
from tf2_msgs.msg import TFMessage

from scan_messages import LATENCY, PERIOD, SPEED, events, poses, profiles, stamp, transform

SCANNER = """
camera: {width: 1000, height: 800, fx: 800, fy: 800, cx: 500, cy: 400, distortion: [0, 0, 0, 0, 0]}
flange_to_camera: {translation: [0, 0, 0.1], rotation: [0, 0, 0, 1]}
lasers:
  - {normal: [0.8, 0, -0.6], distance: -0.2, origin: [-0.25, 0, 0]}
"""


def write_scan_of_waves(bag, direction, delay):
    """A surface z = 8 mm sin(60 x) under a flange that looks down from 0.7 m and moves along x, with
    poses that are stamped late. The line is found by bisection."""
    speed, rate, length = 0.1, 100.0, 0.15

    def flange(t):
        return speed * t if direction > 0 else length - speed * t

    for i in range(int((length / speed + 0.6) * 250)):
        t = -0.3 + i / 250.0
        bag.write('/tf', transform('base_link', 'tool0', t + delay, (flange(t), 0, 0.7),
                                   (1, 0, 0, 0)), stamp(1 + t))
    for i in range(int(length / speed * rate)):
        t = i / rate
        event = TriggerEvent(arming=1, count=i + 1, lasers=TriggerEvent.LASER_0)
        event.header.stamp = stamp(t)
        low, high = 0.5, 0.7  # depth from the camera
        for _ in range(60):
            depth = (low + high) / 2
            x = (0.6 * depth - 0.2) / 0.8
            above = 0.7 - depth - 0.1 > 0.008 * math.sin(60 * (flange(t) + x))
            low, high = (depth, high) if above else (low, depth)
        profile = PeakProfile(acquisition=1, frame_counter=i, laser=0, first_row=370,
                              position=[500 + 800 * x / depth] * 60, width=[3] * 60,
                              intensity=[9] * 60)
        profile.header.stamp = stamp(t + LATENCY)
        bag.write('/laser_trigger/events', event, stamp(1 + t))
        bag.write('/camera/profiles', profile, stamp(1 + t + LATENCY))


class BagTools(unittest.TestCase):
    def test_binds_the_same_from_a_bag(self):
        count = 30
        with tempfile.TemporaryDirectory() as folder:
            with rosbag.Bag(folder + '/scan.bag', 'w') as bag:
                half = 0.5 ** 0.5
                bag.write('/tf_static', transform('world', 'base_link', 0, (-1, 0, 0),
                                                  (0, 0, half, half)), stamp(0))
                for topic, messages in (('/laser_trigger/events', events(count)),
                                        ('/camera/profiles', profiles(count, lost=(4,))),
                                        ('/tf', poses(count))):
                    for message in messages:
                        bag.write(topic, message, stamp(1))
            arguments = ['rosrun', 'pose_frame_binder', 'bind_bag', '--bag', folder + '/scan.bag']
            subprocess.run(arguments + ['--output', folder + '/bound.bag'], check=True, timeout=60)
            with rosbag.Bag(folder + '/bound.bag') as bag:
                bound = [m for _, m, _ in bag.read_messages('/pose_frame_binder/bound_profiles')]
                audits = [m for _, m, _ in bag.read_messages('/pose_frame_binder/audit')]
            self.assertEqual([b.match.trigger_count for b in bound],
                             [n for n in range(1, count + 1) if n != 5])
            for b in bound:
                self.assertAlmostEqual(b.pose.position.x,
                                       -1 - SPEED * PERIOD * (b.match.trigger_count - 1), 8)
            self.assertEqual(audits[0].frames_never_arrived, 1)
            motion = ('--start 1 2 3 0 0 0 1 --end 1 2 -3 0 0 0 1 --speed 0.3 --frame-rate 100').split()
            subprocess.run(arguments + ['--output', folder + '/speed.bag', '--method',
                                        'constant_speed'] + motion, check=True, timeout=60)
            with rosbag.Bag(folder + '/speed.bag') as bag:
                bound = [m for _, m, _ in bag.read_messages('/pose_frame_binder/bound_profiles')]
                audits = [m for _, m, _ in bag.read_messages('/pose_frame_binder/audit')]
            self.assertEqual(audits[0].method, BindingAudit.CONSTANT_SPEED)
            self.assertEqual(audits[0].constant_speed, count - 1)
            for b in bound:
                self.assertEqual(b.match.rule, PoseMatch.CONSTANT_SPEED)
                self.assertAlmostEqual(b.pose.position.z, 3 - 0.003 * (b.match.trigger_count - 1), 9)
            run = subprocess.run(arguments + ['--output', folder + '/none.bag', '--profiles', '/no'],
                                 stderr=subprocess.PIPE, timeout=60)
            self.assertEqual(run.returncode, 1)
            self.assertIn('check that it holds', run.stderr.decode())
            run = subprocess.run(arguments + ['--output', folder + '/none.bag',
                                              '--camera-latency', 'nan'],
                                 stderr=subprocess.PIPE, timeout=60)
            self.assertEqual(run.returncode, 1)
            self.assertIn('--camera-latency', run.stderr.decode())

    def test_knows_the_passes_that_the_bag_tells_and_else_counts_armings(self):
        half = 10
        for told, expected in (((7, 7), (7, 7)), ((), (0, 1))):
            pulses = events(2 * half)
            for event in pulses[half:]:
                event.arming, event.count = 2, event.count - half
            with tempfile.TemporaryDirectory() as folder:
                with rosbag.Bag(folder + '/scan.bag', 'w') as bag:
                    bag.write('/tf_static', transform('world', 'base_link', 0, (0, 0, 0), (0, 0, 0, 1)), stamp(0))
                    for index in told:
                        bag.write('/scan_cell/runs', ScanRun(pass_index=index), stamp(0))
                    for topic, messages in (('/laser_trigger/events', pulses), ('/camera/profiles', profiles(2 * half)),
                                            ('/tf', poses(2 * half))):
                        for message in messages:
                            bag.write(topic, message, stamp(1))
                subprocess.run(['rosrun', 'pose_frame_binder', 'bind_bag', '--bag', folder + '/scan.bag', '--output',
                                folder + '/bound.bag'], check=True, timeout=60)
                with rosbag.Bag(folder + '/bound.bag') as bag:
                    bound = [m for _, m, _ in bag.read_messages('/pose_frame_binder/bound_profiles')]
                self.assertEqual([(b.match.arming, b.pass_index) for b in bound],
                                 [(1, expected[0])] * half + [(2, expected[1])] * half)

    def test_names_a_bag_that_is_damaged(self):
        whole = io.BytesIO()
        poses(1)[0].serialize(whole)
        for topic in ('/tf', '/tf_static'):
            with tempfile.TemporaryDirectory() as folder:
                with rosbag.Bag(folder + '/scan.bag', 'w') as bag:
                    bag.write(topic, (TFMessage._type, whole.getvalue()[:40], TFMessage._md5sum,
                                      TFMessage), stamp(1), raw=True)
                base = 'base_link' if topic == '/tf' else 'world'
                run = subprocess.run(['rosrun', 'pose_frame_binder', 'bind_bag',
                                      '--bag', folder + '/scan.bag', '--fixed-frame', base,
                                      '--output', folder + '/bound.bag'],
                                     stderr=subprocess.PIPE, timeout=60)
                self.assertEqual(run.returncode, 1)
                self.assertIn(folder + '/scan.bag: Buffer Overrun; check', run.stderr.decode())
                self.assertEqual(os.listdir(folder), ['scan.bag'])

    def test_refuse_the_old_names_of_their_options_and_say_the_new_ones(self):
        for tool, old, now in (('bind_bag', '--most-pose-gap', '--max-pose-gap'),
                               ('estimate_time_offset', '--most-delay', '--max-delay'),
                               ('estimate_time_offset', '--most-distance', '--max-distance'),
                               ('estimate_time_offset', '--least-range', '--min-range'),
                               ('estimate_time_offset', '--most-range', '--max-range')):
            run = subprocess.run(['rosrun', 'pose_frame_binder', tool, old, '1'], timeout=60,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.assertEqual(run.returncode, 1)
            self.assertEqual(run.stdout.decode(),
                             '%s: %s: renamed; use %s\n' % (tool, old, now))

    def test_estimates_the_delay_of_the_poses_from_two_bags(self):
        delay = 0.009
        with tempfile.TemporaryDirectory() as folder:
            with open(folder + '/scanner.yaml', 'w') as file:
                file.write(SCANNER)
            for name, direction in (('there', 1), ('back', -1)):
                with rosbag.Bag('%s/%s.bag' % (folder, name), 'w') as bag:
                    write_scan_of_waves(bag, direction, delay)
            arguments = ['rosrun', 'pose_frame_binder', 'estimate_time_offset',
                         '--forward', folder + '/there.bag', '--scanner', folder + '/scanner.yaml']
            text = subprocess.run(arguments + ['--backward', folder + '/back.bag'], check=True,
                                  timeout=120, stdout=subprocess.PIPE).stdout.decode()
            found, uncertainty = (float(word) / 1000 for word in re.search(
                r'pose_delay: (\S+) ms, standard deviation (\S+) ms', text).groups())
            self.assertLess(abs(found - delay), max(3 * uncertainty, 2e-5), text)
            run = subprocess.run(arguments + ['--backward', folder + '/there.bag'],
                                 stderr=subprocess.PIPE, timeout=120)
            self.assertEqual(run.returncode, 1)
            self.assertIn('not in opposite directions', run.stderr.decode())


if __name__ == '__main__':
    rostest.rosrun('pose_frame_binder', 'bag_tools', BagTools)
