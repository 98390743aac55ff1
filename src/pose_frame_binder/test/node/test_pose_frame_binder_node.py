#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The binder node on real topics."""
import collections
import io
import socket
import subprocess
import threading
import time
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from scan_cell_msgs.msg import (BindingAudit, BoundProfile, DroppedFrame, PeakProfile, PoseMatch,
                                TriggerEvent)
from scan_cell_msgs.srv import FinishBinding, StartScan
from tf2_msgs.msg import TFMessage

from scan_messages import LATENCY, PERIOD, SPEED, events, poses, profiles, stamp, transform

# Where the binder's diagnostics count the messages of each topic.
COUNTS = {'poses': ('poses', 'poses late', 'poses repeated', 'poses unusable'),
          'events': ('pulses', 'pulses refused'), 'profiles': ('frames',)}


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
        # The base is rotated by 90 degrees about z and stands at x = -1 in the world.
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
        """Waits until the binder's diagnostics report this number of messages."""
        end = time.time() + 60
        while True:
            for array in list(self.diagnostics):
                values = {v.key: v.value for s in array.status for v in s.values}
                if array.header.stamp > since and sum(int(values.get(n, 0)) for n in names) >= count:
                    return
            self.assertLess(time.time(), end, '%s are not taken' % names[0])
            time.sleep(0.01)

    def publish(self, data, order):
        """Publishes one topic after the other."""
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
        """Sends all data first, since ~finish would wait in vain for what is missing."""
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

    def test_hands_on_the_laser_of_each_pulse_and_drops_a_frame_whose_laser_is_not_certain(self):
        count = 60
        data = {'poses': poses(count), 'events': events(count), 'profiles': profiles(count)}
        for i, (event, profile) in enumerate(zip(data['events'], data['profiles'])):
            t = (i + min(i, 4)) * PERIOD  # they take turns: the first pulses are twice as far apart
            event.header.stamp, profile.header.stamp = stamp(t), stamp(t + LATENCY)
            event.lasers = (TriggerEvent.LASER_0, TriggerEvent.LASER_1)[i % 2]
        data['profiles'][31].laser = 0
        answer = self.scan(data, ('poses', 'events', 'profiles'), count)
        self.assertTrue(answer.success, answer.message)
        self.assertIn('1 laser_uncertain', answer.message)
        self.assertEqual([(d.reason, d.trigger_count, d.detail) for d in answer.audit.dropped],
                         [(DroppedFrame.LASER_UNCERTAIN, 32,
                           'the camera says laser_0, but laser_1 alone was on with its pulse')])
        self.assertEqual(len(self.bound), count - 1)
        for bound in self.bound:
            self.assertEqual(bound.profile.laser, (bound.match.trigger_count - 1) % 2)

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
        """A camera that is late by more than the patience, but still sends."""
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

    def test_does_not_wait_for_a_camera_that_runs_free(self):
        """One pulse has no frame, and frames that no pulse exposed keep arriving."""
        count, patience = 20, 0.5
        data = {'poses': poses(count), 'events': events(count),
                'profiles': profiles(count, lost=(7,))}
        self.assertTrue(self.start('scan').success)
        self.publish(data, ('poses', 'events', 'profiles'))
        ended = threading.Event()

        def run_free():
            number, profile = 2 * count, profiles(1)[0]
            while not ended.wait(0.01):
                number += 1
                profile.frame_counter = 65530 + number
                profile.header.stamp = stamp(number * PERIOD + LATENCY)
                self.publishers['profiles'].publish(profile)

        camera = threading.Thread(target=run_free)
        camera.start()
        answers = []
        finish = threading.Thread(
            target=lambda: answers.append(self.finish(count, rospy.Duration(patience))))
        finish.start()
        finish.join(60)
        ended.set()
        camera.join()
        finish.join()
        self.assertTrue(answers[0].success, answers[0].message)
        self.assertEqual(answers[0].audit.frames_bound, count - 1)
        self.assertLess(answers[0].audit.frames_dropped, 5000, 'it waited for a minute')

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

    def test_refuses_to_finish_what_was_not_started(self):
        answer = self.finish(0, rospy.Duration(0.1))
        self.assertFalse(answer.success)
        self.assertIn('no scan is running', answer.message)

    def test_refuses_to_start_without_the_static_transform_and_names_it(self):
        answer = rospy.ServiceProxy('/lost_binder/start', StartScan)('scan')
        self.assertFalse(answer.success)
        self.assertIn('static transform from nowhere to base_link', answer.message)

    def test_refuses_a_bad_parameter_by_name(self):
        for parameter, words in (('_method:=guess', '/bad_binder/method'),
                                 ('_method:=constant_speed _constant_speed/speed:=1', 'constant_speed/frame_rate'),
                                 ('_lookup/port:=45017', 'lookup on 127.0.0.1:45017'),
                                 ('_fixed_frame:=/world', 'fixed_frame'),
                                 ('_flange_frame:=', 'flange_frame')):
            run = subprocess.run(['rosrun', 'pose_frame_binder', 'pose_frame_binder_node',
                                  '__name:=bad_binder'] + parameter.split(), timeout=60,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.assertEqual(run.returncode, 1)
            self.assertIn(words, run.stdout.decode())
            rospy.delete_param('/bad_binder')


if __name__ == '__main__':
    rostest.rosrun('pose_frame_binder', 'pose_frame_binder_node', PoseFrameBinderNode)
