#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The binder node on real topics."""
import collections
import io
import math
import re
import socket
import subprocess
import tempfile
import threading
import time
import unittest

import rosbag
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import TransformStamped
from scan_cell_msgs.msg import (BindingAudit, BoundProfile, DroppedFrame, PeakProfile, PoseMatch,
                                TriggerEvent)
from scan_cell_msgs.srv import FinishBinding, StartScan
from tf2_msgs.msg import TFMessage

START = 1700000000
SPEED = 0.2       # [m/s] of the flange along y of the base
PERIOD = 0.01     # [s] of the pulses
LATENCY = 0.004   # [s] of the camera's stamps

# Where the binder's diagnostics count what it took of each topic.
COUNTS = {'poses': ('poses', 'poses late', 'poses repeated', 'poses unusable'),
          'events': ('pulses', 'pulses refused'), 'profiles': ('frames',)}


def stamp(seconds):
    return rospy.Time(START, 0) + rospy.Duration(seconds)


def transform(parent, child, seconds, xyz, q=(0, 0, 0, 1)):
    message = TransformStamped()
    message.header.stamp = stamp(seconds)
    message.header.frame_id = parent
    message.child_frame_id = child
    t = message.transform
    t.translation.x, t.translation.y, t.translation.z = xyz
    t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w = q
    return TFMessage([message])


def poses(count):
    """Every 4 ms from before the first pulse to after the last."""
    times = [-0.05 + 0.004 * i for i in range(int((count * PERIOD + 0.2) / 0.004))]
    return [transform('base_link', 'tool0', t, (0.5, SPEED * t, 0.7)) for t in times]


def events(count):
    messages = []
    for i in range(count):
        event = TriggerEvent(arming=1, count=i + 1, lasers=TriggerEvent.LASER_1)
        event.header.stamp = stamp(i * PERIOD)
        messages.append(event)
    return messages


def profiles(count, lost=()):
    messages = []
    for i in range(count):
        if i in lost:
            continue
        profile = PeakProfile(acquisition=1, frame_counter=65530 + i, laser=PeakProfile.LASER_UNKNOWN,
                              position=[1.5, 2.5], width=[3, 3], intensity=[9, 9])
        profile.header.stamp = stamp(i * PERIOD + LATENCY)
        messages.append(profile)
    return messages


SCANNER = """
camera: {width: 1000, height: 800, fx: 800, fy: 800, cx: 500, cy: 400, distortion: [0, 0, 0, 0, 0]}
flange_to_camera: {translation: [0, 0, 0.1], rotation: [0, 0, 0, 1]}
lasers:
  - {normal: [0.8, 0, -0.6], distance: -0.2, origin: [-0.25, 0, 0]}
"""


def write_scan_of_waves(bag, direction, delay):
    """A surface z = 8 mm sin(60 x) under a flange that looks down from 0.7 m and goes along x, and
    whose poses are stamped late. The line is met by bisection."""
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


class PoseFrameBinderNode(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('test_pose_frame_binder_node')
        cls.bound = []
        cls.audits = []
        rospy.Subscriber('/binder/bound_profiles', BoundProfile, cls.bound.append)
        rospy.Subscriber('/binder/audit', BindingAudit, cls.audits.append)
        cls.diagnostics = collections.deque(maxlen=100)
        rospy.Subscriber('/diagnostics', DiagnosticArray, cls.diagnostics.append)
        cls.publishers = {
            'poses': rospy.Publisher('/tf', TFMessage, queue_size=10000),
            'events': rospy.Publisher('/laser_trigger/events', TriggerEvent, queue_size=10000),
            'profiles': rospy.Publisher('/camera/profiles', PeakProfile, queue_size=10000)}
        cls.static = rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True)
        # The base is turned by 90 degrees about z and stands at x = -1 in the world.
        half = 0.5 ** 0.5
        cls.static.publish(transform('world', 'base_link', 0, (-1, 0, 0), (0, 0, half, half)))
        for node in ('binder', 'lost_binder'):
            for name in ('start', 'finish'):
                rospy.wait_for_service('/%s/%s' % (node, name), 30)
        cls.start = rospy.ServiceProxy('/binder/start', StartScan)
        cls.finish = rospy.ServiceProxy('/binder/finish', FinishBinding)
        end = time.time() + 30
        while any(p.get_num_connections() == 0 for p in cls.publishers.values()):
            assert time.time() < end, 'the binder does not subscribe'
            time.sleep(0.01)

    def wait_for_counts(self, names, count, since):
        """Until the binder's diagnostics say that it took so many."""
        end = time.time() + 60
        while True:
            for array in list(self.diagnostics):
                values = {v.key: v.value for s in array.status for v in s.values}
                if array.header.stamp > since and sum(int(values.get(n, 0)) for n in names) >= count:
                    return
            self.assertLess(time.time(), end, '%s are not taken' % names[0])
            time.sleep(0.01)

    def publish(self, data, order):
        """Topic after topic."""
        since = rospy.Time.now()
        for name in order:
            for message in data[name]:
                self.publishers[name].publish(message)
            self.wait_for_counts(COUNTS[name], len(data[name]), since)

    def scan(self, data, order, triggers):
        """A scan with nothing missing: ~finish is called first, and waits for it."""
        del self.bound[:]
        self.assertTrue(self.start('scan').success)
        thread = threading.Thread(target=self.publish, args=(data, order[:-1]))
        thread.start()
        finished = []
        finish = threading.Thread(
            target=lambda: finished.append(self.finish(triggers, rospy.Duration(60))))
        finish.start()
        thread.join()
        self.assertEqual(finished, [], '~finish must wait for the ' + order[-1])
        for message in data[order[-1]]:
            self.publishers[order[-1]].publish(message)
        finish.join()
        return self.with_bound(finished[0])

    def scan_with_gaps(self, data, order, triggers):
        """All data come first, since ~finish waits in vain for what is missing."""
        del self.bound[:]
        self.assertTrue(self.start('scan').success)
        self.publish(data, order)
        return self.with_bound(self.finish(triggers, rospy.Duration(0.1)))

    def with_bound(self, answer):
        end = time.time() + 30
        while len(self.bound) < answer.audit.frames_bound:
            self.assertLess(time.time(), end, 'bound profiles are missing')
            time.sleep(0.01)
        return answer

    def test_binds_to_the_pose_at_the_pulse_in_the_fixed_frame(self):
        count = 60
        data = {'poses': poses(count), 'events': events(count), 'profiles': profiles(count)}
        answer = self.scan(data, ('poses', 'events', 'profiles'), count)
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.audit.frames_bound, count)
        self.assertEqual(answer.audit.interpolated, count)
        self.assertEqual(answer.audit.dropped, [])
        for i, bound in enumerate(self.bound):
            self.assertEqual(bound.header.frame_id, 'world')
            self.assertEqual(bound.header.stamp, stamp(i * PERIOD))
            self.assertEqual(bound.match.trigger_count, i + 1)
            self.assertEqual(bound.match.frame_counter, 65530 + i)
            self.assertEqual(bound.match.rule, PoseMatch.INTERPOLATED)
            self.assertEqual(bound.profile.laser, 1)
            self.assertEqual(list(bound.profile.position), [1.5, 2.5])
            y = SPEED * i * PERIOD
            self.assertAlmostEqual(bound.pose.position.x, -1 - y, 8)
            self.assertAlmostEqual(bound.pose.position.y, 0.5, 8)
            self.assertAlmostEqual(bound.pose.position.z, 0.7, 8)
            self.assertAlmostEqual(bound.pose.orientation.z, 0.5 ** 0.5, 8)

    def test_gives_the_same_bytes_whatever_topic_comes_first(self):
        count = 40
        data = {'poses': poses(count), 'events': events(count),
                'profiles': profiles(count, lost=(7, 8, 21))}
        results = []
        for order in (('poses', 'events', 'profiles'), ('profiles', 'events', 'poses'),
                      ('events', 'poses', 'profiles')):
            answer = self.scan_with_gaps(data, order, count)
            self.assertEqual(answer.audit.frames_bound, count - 3)
            self.assertEqual(answer.audit.frames_never_arrived, 3)
            self.assertEqual([(d.reason, d.trigger_count) for d in answer.audit.dropped],
                             [(DroppedFrame.NEVER_ARRIVED, n) for n in (8, 9, 22)])
            buffer = io.BytesIO()
            for bound in self.bound:
                bound.header.seq = bound.profile.header.seq = 0  # roscpp's own count
                bound.serialize(buffer)
            results.append(buffer.getvalue())
        self.assertEqual(results[0], results[1])
        self.assertEqual(results[0], results[2])

    def test_says_which_frames_no_pose_was_measured_for(self):
        data = {'poses': poses(20), 'events': events(60), 'profiles': profiles(60)}
        answer = self.scan_with_gaps(data, ('poses', 'events', 'profiles'), 60)
        reasons = {d.reason for d in answer.audit.dropped}
        self.assertEqual(reasons, {DroppedFrame.NO_POSE_AFTER})
        self.assertEqual(answer.audit.frames_bound + len(answer.audit.dropped), 60)

    def test_waits_as_long_as_frames_keep_coming(self):
        """A camera that is behind by more than the patience, but still sends."""
        count, pace, patience = 60, 0.1, 2.0
        del self.bound[:]
        self.assertTrue(self.start('scan').success)
        self.publish({'poses': poses(count), 'events': events(count)}, ('poses', 'events'))

        def send():
            for profile in profiles(count):
                self.publishers['profiles'].publish(profile)
                time.sleep(pace)

        late = threading.Thread(target=send)
        late.start()
        answer = self.finish(count, rospy.Duration(patience))
        late.join()
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.audit.frames_bound, count)

    def test_says_when_trigger_events_are_missing(self):
        data = {'poses': poses(20), 'events': events(20), 'profiles': profiles(20)}
        answer = self.scan_with_gaps(data, ('poses', 'events', 'profiles'), 25)
        self.assertFalse(answer.success)
        self.assertIn('only 20 of 25 trigger events', answer.message)
        self.assertEqual(answer.audit.triggers, 25)
        self.assertEqual(answer.audit.triggers_missing, 5)
        self.assertEqual(answer.audit.frames_bound, 20)

    def test_counts_trigger_events_that_came_twice(self):
        data = {'poses': poses(20), 'events': events(20), 'profiles': profiles(20)}
        data['events'].insert(7, data['events'][6])
        answer = self.scan(data, ('poses', 'events', 'profiles'), 20)
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.audit.triggers, 20)
        self.assertEqual(answer.audit.triggers_refused, 1)
        self.assertIn('1 trigger events came twice', answer.message)

    def test_tells_the_latency_and_when_it_is_probably_wrong(self):
        data = {'poses': poses(20), 'events': events(20), 'profiles': profiles(20)}
        answer = self.scan(data, ('poses', 'events', 'profiles'), 20)
        self.assertAlmostEqual(answer.audit.latency, LATENCY, 6)
        self.assertFalse(answer.audit.latency_doubtful)
        for profile in data['profiles']:
            profile.header.stamp += rospy.Duration(PERIOD)
        answer = self.scan_with_gaps(data, ('poses', 'events', 'profiles'), 20)
        self.assertTrue(answer.audit.latency_doubtful)

    def test_drops_poses_that_are_none(self):
        data = {'poses': poses(40), 'events': events(40), 'profiles': profiles(40)}
        zeros = transform('base_link', 'tool0', 0.1011, (0.5, 9, 0.7), (0, 0, 0, 0))
        nans = transform('base_link', 'tool0', 0.2011, (float('nan'), 9, 0.7))
        data['poses'] += [zeros, nans]
        data['poses'].sort(key=lambda m: m.transforms[0].header.stamp)
        answer = self.scan(data, ('poses', 'events', 'profiles'), 40)
        self.assertEqual(answer.audit.poses, len(data['poses']) - 2)
        self.assertEqual(answer.audit.frames_bound, 40)
        for bound in self.bound:
            self.assertLess(abs(bound.pose.position.x), 2)

    def test_tells_old_clients_the_pose_of_a_frame_after_the_scan(self):
        count = 20
        data = {'poses': poses(count), 'events': events(count), 'profiles': profiles(count, lost=(7,))}
        with socket.create_connection(('127.0.0.1', 45017), timeout=30) as connection:
            answers = connection.makefile('r')

            def ask(line):
                connection.sendall(line.encode())
                return answers.readline()

            del self.bound[:]
            self.assertTrue(self.start('scan').success)
            self.publish(data, ('poses', 'events', 'profiles'))
            self.assertEqual(ask('65530\n'), 'NONE\n')  # not before the scan is finished
            answer = self.with_bound(self.finish(count, rospy.Duration(0.1)))
            self.assertEqual(answer.audit.frames_bound, count - 1)
            for i in (0, 3, 19):
                x, y, z, rx, ry, rz = (float(w) for w in ask('%d\n' % (65530 + i)).split(','))
                self.assertAlmostEqual(x, 1000 * (-1 - SPEED * PERIOD * i), 5)
                self.assertAlmostEqual(y, 500, 5)
                self.assertAlmostEqual(z, 700, 5)
                self.assertAlmostEqual(rx, 0, 6)
                self.assertAlmostEqual(ry, 0, 6)
                self.assertAlmostEqual(rz, 90, 6)
            self.assertEqual(ask('65537\n'), 'NONE\n')
            self.assertTrue(ask('first\n').startswith('ERROR'))
            self.assertTrue(self.start('next').success)
            self.assertEqual(ask('65530\n'), 'NONE\n')

    def test_keeps_the_audit_latched(self):
        data = {'poses': poses(5), 'events': events(5), 'profiles': profiles(5)}
        self.scan(data, ('poses', 'events', 'profiles'), 5)
        late = rospy.wait_for_message('/binder/audit', BindingAudit, 30)
        self.assertEqual(late.scan_id, 'scan')

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
            run = subprocess.run(arguments + ['--output', folder + '/none.bag', '--profiles', '/no'],
                                 stderr=subprocess.PIPE, timeout=60)
            self.assertEqual(run.returncode, 1)
            self.assertIn('check that it holds', run.stderr.decode())
            run = subprocess.run(arguments + ['--output', folder + '/none.bag',
                                              '--camera-latency', 'nan'],
                                 stderr=subprocess.PIPE, timeout=60)
            self.assertEqual(run.returncode, 1)
            self.assertIn('camera_latency', run.stderr.decode())

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

    def test_refuses_to_finish_what_was_not_started(self):
        answer = self.finish(0, rospy.Duration(0.1))
        self.assertFalse(answer.success)
        self.assertIn('no scan is under way', answer.message)

    def test_refuses_to_start_without_the_static_transform_and_names_it(self):
        answer = rospy.ServiceProxy('/lost_binder/start', StartScan)('scan')
        self.assertFalse(answer.success)
        self.assertIn('static transform from nowhere to base_link', answer.message)

    def test_refuses_a_bad_parameter_by_name(self):
        for parameter, words in (('_method:=guess', '/bad_binder/method'),
                                 ('_method:=constant_speed', 'constant_speed/speed'),
                                 ('_lookup/port:=45017', 'lookup on 127.0.0.1:45017'),
                                 ('_fixed_frame:=/world', 'fixed_frame'),
                                 ('_flange_frame:=', 'flange_frame')):
            run = subprocess.run(['rosrun', 'pose_frame_binder', 'pose_frame_binder_node',
                                  '__name:=bad_binder', parameter], timeout=60,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.assertEqual(run.returncode, 1)
            self.assertIn(words, run.stdout.decode())
            rospy.delete_param('/bad_binder')


if __name__ == '__main__':
    rostest.rosrun('pose_frame_binder', 'pose_frame_binder_node', PoseFrameBinderNode)
