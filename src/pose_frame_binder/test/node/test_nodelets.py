#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Binder and triangulation as nodelets in one manager, beside the nodes, on the same topics."""
import math
import random
import struct
import subprocess
import threading
import time
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import TransformStamped
from scan_cell_msgs.msg import PeakProfile, TriggerEvent
from scan_cell_msgs.srv import FinishBinding, FinishCloud, StartScan
from sensor_msgs.msg import PointCloud2
from tf2_msgs.msg import TFMessage

START = 1700000000
PERIOD = 0.002    # [s] of the pulses
LATENCY = 0.004   # [s] of the camera's stamps
ROWS = 400
SPEED = 0.2       # [m/s] along y
CHAINS = ('nodelets', 'nodes')


def stamp(seconds):
    return rospy.Time(START, 0) + rospy.Duration(seconds)


def pose(seconds, parent='base_link', child='tool0'):
    message = TransformStamped()
    message.header.stamp = stamp(seconds)
    message.header.frame_id = parent
    message.child_frame_id = child
    message.transform.translation.y = SPEED * seconds
    message.transform.rotation.w = 1
    return TFMessage([message])


def event(number):
    message = TriggerEvent(arming=1, count=number + 1, lasers=TriggerEvent.LASER_0)
    message.header.stamp = stamp(number * PERIOD)
    return message


def profile(number, random_numbers):
    position = [float('nan') if random_numbers.random() < 0.1 else 560 + random_numbers.gauss(0, 9)
                for _ in range(ROWS)]
    message = PeakProfile(acquisition=1, frame_counter=number, laser=PeakProfile.LASER_UNKNOWN,
                          first_row=200, position=position, width=[4] * ROWS, intensity=[9] * ROWS)
    message.header.stamp = stamp(number * PERIOD + LATENCY)
    return message


def wait_for(condition, what):
    end = time.time() + 30
    while not condition():
        assert time.time() < end, what
        time.sleep(0.01)


class Nodelets(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('test_nodelets')
        cls.increments = {chain: [] for chain in CHAINS}
        cls.diagnosed = set()
        for chain in CHAINS:
            rospy.Subscriber('/%s/triangulation/cloud' % chain, PointCloud2,
                             cls.increments[chain].append)
        rospy.Subscriber('/diagnostics', DiagnosticArray, lambda message: cls.diagnosed.update(
            status.name for status in message.status))
        cls.publishers = {
            '/tf': rospy.Publisher('/tf', TFMessage, queue_size=10000),
            'events': rospy.Publisher('/laser_trigger/events', TriggerEvent, queue_size=10000),
            'profiles': rospy.Publisher('/camera/profiles', PeakProfile, queue_size=10000)}
        cls.static = rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True)
        cls.static.publish(pose(0, 'world', 'base_link'))
        cls.call = {}
        for chain in CHAINS:
            for name, kind in (('binder/start', StartScan), ('triangulation/start', StartScan),
                               ('binder/finish', FinishBinding),
                               ('triangulation/finish', FinishCloud)):
                rospy.wait_for_service('/%s/%s' % (chain, name), 60)
                cls.call[chain, name] = rospy.ServiceProxy('/%s/%s' % (chain, name), kind)
        for name, publisher in cls.publishers.items():
            wait_for(lambda: publisher.get_num_connections() == len(CHAINS),
                     name + ' is not subscribed')

    def finish(self, chain, frames, answers):
        """As the cell does, and before the data, for which the calls wait."""
        cloud = threading.Thread(target=lambda: answers.update({(chain, 'cloud'): self.call[
            chain, 'triangulation/finish'](frames, rospy.Duration(30), False)}))
        cloud.start()
        answers[chain, 'audit'] = self.call[chain, 'binder/finish'](frames, rospy.Duration(30))
        cloud.join()

    def test_give_the_same_cloud_as_the_nodes_byte_for_byte(self):
        frames, seed = 500, 7
        random_numbers = random.Random(seed)
        profiles = [profile(n, random_numbers) for n in range(frames)]
        for chain in CHAINS:
            for stage in ('binder', 'triangulation'):
                answer = self.call[chain, stage + '/start']('scan')
                self.assertTrue(answer.success, answer.message)
        answers = {}
        threads = [threading.Thread(target=self.finish, args=(chain, frames, answers))
                   for chain in CHAINS]
        for thread in threads:
            thread.start()
        for seconds in range(-10, int(frames * PERIOD / 0.002) + 60):
            self.publishers['/tf'].publish(pose(seconds * 0.002))
        for number in range(frames):
            self.publishers['events'].publish(event(number))
            self.publishers['profiles'].publish(profiles[number])
        for thread in threads:
            thread.join()
        for chain in CHAINS:
            audit = answers[chain, 'audit']
            self.assertTrue(audit.success, audit.message)
            self.assertEqual((audit.audit.frames_bound, audit.audit.frames_dropped), (frames, 0))
            self.assertTrue(answers[chain, 'cloud'].success, answers[chain, 'cloud'].message)
        with_peak = sum(not math.isnan(p) for message in profiles for p in message.position)
        clouds = [answers[chain, 'cloud'].cloud for chain in CHAINS]
        self.assertEqual([cloud.width for cloud in clouds], [with_peak] * len(CHAINS))
        self.assertEqual(clouds[0].data, clouds[1].data)
        for chain, cloud in zip(CHAINS, clouds):
            wait_for(lambda: sum(c.width for c in self.increments[chain]) >= with_peak,
                     'the growing cloud is not whole')
            self.assertEqual(b''.join(c.data for c in self.increments[chain]), cloud.data)
        self.check_against_the_closed_form(profiles[0], clouds[0])

    def check_against_the_closed_form(self, message, cloud):
        """The first profile's points, for the camera and plane of scanner.yaml, at t = 0."""
        rows = [row for row in range(ROWS) if not math.isnan(message.position[row])]
        for index, row in enumerate(rows):
            x, y = (message.position[row] - 500) / 800.0, (200 + row - 400) / 800.0
            depth = -0.2 / (0.8 * x - 0.6)
            point = struct.unpack_from('<fff', cloud.data, index * cloud.point_step)
            for value, right in zip(point, (x * depth, y * depth, depth + 0.1)):
                self.assertAlmostEqual(value, right, 5)

    def test_answer_while_a_call_waits_although_the_manager_has_one_worker(self):
        self.assertTrue(self.call['nodelets', 'binder/start']('scan').success)
        waiting = threading.Thread(target=self.call['nodelets', 'binder/finish'],
                                   args=(1, rospy.Duration(5)))
        waiting.start()
        for _ in range(20):  # the first may arrive before the call that waits
            self.assertFalse(self.call['nodelets', 'triangulation/finish'](
                1, rospy.Duration(0), False).success)
        self.assertTrue(waiting.is_alive())
        waiting.join()

    def test_report_under_their_own_names(self):
        for chain in CHAINS:
            for stage in ('binder: binding', 'triangulation: triangulation'):
                name = '%s/%s' % (chain, stage)
                wait_for(lambda: name in self.diagnosed,
                         'no diagnostics of %s among %s' % (name, self.diagnosed))

    def test_refuse_a_bad_parameter_by_name(self):
        for nodelet, parameter, words in (
                ('pose_frame_binder/Binder', '_method:=guess', '/bad/method'),
                ('laser_triangulation/Triangulation', '_scanner:=/no/such.yaml', '/no/such.yaml')):
            run = subprocess.run(['rosrun', 'nodelet', 'nodelet', 'standalone', nodelet,
                                  '__name:=bad', parameter], timeout=60, stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT)
            rospy.delete_param('/bad')
            self.assertNotEqual(run.returncode, 0)
            self.assertIn(words, run.stdout.decode())


if __name__ == '__main__':
    rostest.rosrun('pose_frame_binder', 'nodelets', Nodelets)
