#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""All services, topics and actions of the running cell, as seen by the command line's tools.

It goes through what the master and the nodes list, so a new one is covered automatically. Alone, on a bare system:
rostest scan_cell_demo command_line.test
"""
import io
import os
import subprocess
import tempfile
import threading
import time
import unittest

import genpy.message
import rosgraph
import roslib.message
import rospkg
import rospy
import rosservice
import rostest
from scan_cell_msgs.srv import GetStaticPose

TIMEOUT = 60  # [s] for what must come
ACTIONS = ('/c4g_driver/move', '/scan_cell/scan', '/scan_cell/calibrate', '/tool_path_stretcher/stretch')
# Publish even while the cell is idle.
ALWAYS = ('/c4g_driver/status', '/camera/parameter_updates', '/diagnostics', '/joint_states', '/laser_trigger/state',
          '/scan_cell/scan/status', '/scan_cell/state', '/tf', '/tf_static')
# The cell's own, and the managers of its nodelets.
NODES = ('/c4g_driver', '/chain', '/laser_trigger', '/preprocess', '/scan_cell', '/scan_cell_sim',
         '/tool_path_stretcher', '/videe')
# Called as a person would call them; none moves the robot or switches a laser on.
HARMLESS = (('/c4g_driver/reset_alarms', []), ('/c4g_driver/set_drives', ['true']),
            ('/c4g_driver/get_static_pose', []), ('/c4g_driver/set_override', ['100']),
            ('/laser_trigger/disarm', []), ('/scan_cell_sim/set_faults', ['{}']),
            ('/scan_cell/set_logger_level', ['ros.scan_cell', 'info']))


def cure(type_name):
    """What a user on Debian can do about a missing type."""
    return '%s: its Python module cannot be loaded; add python3-%s to scripts/packages.txt' % (
        type_name, type_name.split('/')[0].replace('_', '-'))


def buildable(message_class, arguments):
    """Fills a message as rosservice and rostopic do, without sending it."""
    message = message_class()
    genpy.message.fill_message_args(message, arguments)
    message.serialize(io.BytesIO())


def command(*words):
    return subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=TIMEOUT,
                          universal_newlines=True, check=False)


class Heard:
    """The first message of every topic, as received."""

    def __init__(self, topics):
        self.news = threading.Condition()
        self.first = {}
        self.subscribers = [rospy.Subscriber(topic, rospy.AnyMsg, self.keep, topic) for topic in topics]

    def keep(self, message, topic):
        with self.news:
            self.first.setdefault(topic, message._buff)
            self.news.notify_all()

    def wait_for(self, topics):
        """Topics without a message."""
        with self.news:
            self.news.wait_for(lambda: set(topics) <= set(self.first), TIMEOUT)
            return sorted(set(topics) - set(self.first))


class CommandLine(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('command_line')
        cls.master = rosgraph.Master(rospy.get_name())
        deadline = time.monotonic() + TIMEOUT
        while cls.absent():
            assert time.monotonic() < deadline, 'the cell does not start: no ' + ', '.join(sorted(cls.absent()))
            time.sleep(0.1)
        cls.services = rosservice.get_service_list()
        cls.types = {topic: kind for topic, kind in cls.master.getTopicTypes() if kind != '*'}
        publishers = dict(cls.master.getSystemState()[0])
        cls.published = sorted(set(publishers) & set(cls.types))

    @classmethod
    def absent(cls):
        """What the complete cell has, and is still missing."""
        topics = set(ALWAYS) | {action + '/goal' for action in ACTIONS}
        there = dict(cls.master.getTopicTypes())
        services = {service for service, _ in HARMLESS}
        return (topics - set(there)) | (services - set(rosservice.get_service_list()))

    def expect_none(self, failures):
        self.assertFalse(failures, '\n'.join([''] + sorted(set(failures))))

    def test_every_service_can_be_called(self):
        failures = []
        for service in self.services:
            kind = rosservice.get_service_type(service)
            if kind is None:
                continue  # its node has ended meanwhile
            service_class = roslib.message.get_service_class(kind)
            if service_class is None:
                failures.append(cure(kind) + ': ' + service)
                continue
            buildable(service_class._request_class, [{}])
            service_class._response_class().serialize(io.BytesIO())
        self.assertGreater(len(self.services), 30, 'this is not the whole cell')
        self.expect_none(failures)

    def test_harmless_services_answer_on_the_command_line(self):
        for service, arguments in HARMLESS:
            self.assertIn(service, self.services)
            done = command('rosservice', 'call', service, *arguments)
            self.assertEqual(done.returncode, 0, service + ': ' + done.stdout)
            self.assertNotIn('success: False', done.stdout, service)

    def test_record_pose_appends_the_pose_in_which_the_robot_stands(self):
        with tempfile.TemporaryDirectory() as folder:
            poses = os.path.join(folder, 'poses.csv')
            done = command('rosrun', 'scan_cell', 'record_pose', '--poses', poses)
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assertIn('%s: pose 1: ' % poses, done.stdout)
            done = command('rosrun', 'scan_cell', 'record_pose', '--poses', poses)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn('teach another pose', done.stdout)
            stands = rospy.ServiceProxy('/c4g_driver/get_static_pose', GetStaticPose)().pose.pose.position
            with open(poses) as file:
                rows = [row for row in file.read().splitlines() if not row.startswith('#')]
            self.assertEqual(rows[0], 'x,y,z,qx,qy,qz,qw')
            self.assertEqual(len(rows), 2)
            for value, of_robot in zip(rows[1].split(','), (stands.x, stands.y, stands.z)):
                self.assertAlmostEqual(float(value), of_robot, delta=1e-5)
            with open(poses, 'w') as file:
                file.write('these are no poses\n')
            done = command('rosrun', 'scan_cell', 'record_pose', '--poses', poses)
            self.assertEqual(done.returncode, 2, done.stdout)

    def test_no_node_of_the_suite_can_be_asked_for_its_loggers(self):
        """Debian's rosconsole crashes any roscpp node that answers it, also the robot's driver."""
        for node in NODES:
            self.assertIn(node + '/set_logger_level', self.services)
            self.assertNotIn(node + '/get_loggers', self.services)

    def test_every_topic_can_be_echoed(self):
        failures = []
        for topic, kind in self.types.items():
            message_class = roslib.message.get_message_class(kind)
            if message_class is None:
                failures.append(cure(kind) + ': ' + topic)
                continue
            message_class().serialize(io.BytesIO())
        self.assertGreater(len(self.types), 30, 'this is not the whole cell')
        self.expect_none(failures)

    def test_what_is_published_can_be_read(self):
        heard = Heard(self.published)
        self.assertEqual(heard.wait_for(ALWAYS), [], 'these are published all the time')
        for topic, bytes_of_it in list(heard.first.items()):  # others still arrive
            message_class = roslib.message.get_message_class(self.types[topic])
            self.assertIsNotNone(message_class, cure(self.types[topic]) + ': ' + topic)
            str(message_class().deserialize(bytes_of_it))
        for topic in ALWAYS:
            done = command('rostopic', 'echo', '-n1', topic)
            self.assertEqual(done.returncode, 0, topic + ': ' + done.stdout)
            self.assertIn('---', done.stdout, topic)

    def test_every_action_can_be_asked_for(self):
        actions = [(topic[:-len('/goal')], kind[:-len('Goal')]) for topic, kind in self.types.items()
                   if topic.endswith('/goal') and kind.endswith('ActionGoal')]
        names = dict(actions)
        self.assertLessEqual(set(ACTIONS), set(names))
        for name, kind in actions:
            for topic, part in (('goal', 'Goal'), ('cancel', None), ('status', None), ('feedback', 'Feedback'),
                                ('result', 'Result')):
                self.assertIn(name + '/' + topic, self.types)
                if part is not None:
                    self.assertEqual(self.types[name + '/' + topic], kind + part)
            goal = roslib.message.get_message_class(kind + 'Goal')
            self.assertIsNotNone(goal, cure(kind + 'Goal'))
            buildable(goal, [{'goal': {}}])
            self.assertIsNotNone(roslib.message.get_message_class(kind), cure(kind))

    def test_every_type_of_the_suite_can_be_shown(self):
        """Also types that no node of this cell uses at present, and the types that they contain."""
        folder = rospkg.RosPack().get_path('scan_cell_msgs')
        failures = []
        for kind, find in (('msg', roslib.message.get_message_class), ('srv', roslib.message.get_service_class)):
            for name in sorted(os.listdir(os.path.join(folder, kind))):
                type_name = 'scan_cell_msgs/' + os.path.splitext(name)[0]
                if find(type_name) is None:
                    failures.append(cure(type_name))
        self.expect_none(failures)


if __name__ == '__main__':
    rostest.rosrun('scan_cell_demo', 'command_line', CommandLine)
