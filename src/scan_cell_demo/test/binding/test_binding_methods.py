#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""test_binding_methods.py METHOD   which pulse is at which place: poses given by the running cell's binder against the
true pose of the flange at each frame's exposure."""
import statistics
import sys
import threading
import time
import unittest

import actionlib
import numpy
import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import Point, Pose, PoseStamped, Quaternion
from scan_cell_msgs.msg import BindingAudit, BoundProfile, ScanAction, ScanGoal, ScanPass, ScanResult

METHOD = sys.argv[1]
TIMEOUT = 120  # [s] on a busy machine
SPEED, RATE = 0.06, 100.0  # [m/s], [Hz]
ACCELERATION = 6.0  # [m/s^2] of the simulated robot's ramps
# A pulse is stamped to 0.01 ms, or to about 1 ms by a busy machine; the true pose is that of the pulse on its wire.
STAMPED_TO = 1e-3  # [s]


def flange(x, y=0.0, z=0.595):
    return Pose(position=Point(x=x, y=y, z=z), orientation=Quaternion(x=1))


def line(lasers, speed=SPEED):
    return ScanPass(kind=ScanPass.LINE, poses=[flange(-0.18), flange(0.18)], speed=speed, rate=RATE, lasers=lasers)


def matrix(transform):
    q, t = transform.rotation, transform.translation
    return numpy.array([[1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y - q.z * q.w), 2 * (q.x * q.z + q.y * q.w), t.x],
                        [2 * (q.x * q.y + q.z * q.w), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z - q.x * q.w), t.y],
                        [2 * (q.x * q.z - q.y * q.w), 2 * (q.y * q.z + q.x * q.w), 1 - 2 * (q.x * q.x + q.y * q.y), t.z],
                        [0, 0, 0, 1]])


class Binding(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        rospy.init_node('test_binding_methods')
        cls.news = threading.Condition()
        cls.begin, cls.bound, cls.truth = rospy.Time.now(), [], {}
        rospy.Subscriber('/pose_frame_binder/bound_profiles', BoundProfile, cls.on_bound, tcp_nodelay=True)
        rospy.Subscriber('/scan_cell_sim/true_exposures', PoseStamped, cls.on_truth, tcp_nodelay=True)
        cls.transforms = tf2_ros.Buffer()
        cls.listener = tf2_ros.TransformListener(cls.transforms)
        transform = cls.transforms.lookup_transform('world', 'base_link', rospy.Time(0), rospy.Duration(TIMEOUT)).transform
        cls.base = matrix(transform)
        cls.client = actionlib.SimpleActionClient('/scan_cell/scan', ScanAction)
        assert cls.client.wait_for_server(rospy.Duration(TIMEOUT))
        cls.wait_until_up()

    @classmethod
    def wait_until_up(cls):
        end = time.time() + TIMEOUT
        short = ScanPass(kind=ScanPass.LINE, poses=[flange(-0.02), flange(0.02)], speed=SPEED, rate=RATE)
        while cls.scan(short).outcome != ScanResult.FINISHED:
            assert time.time() < end, cls.client.get_result().message
            time.sleep(0.5)

    @classmethod
    def on_bound(cls, bound):
        with cls.news:
            if bound.header.stamp >= cls.begin:
                cls.bound.append(bound)
            cls.news.notify_all()

    @classmethod
    def on_truth(cls, pose):
        with cls.news:
            if pose.header.stamp >= cls.begin:
                cls.truth[pose.header.stamp.to_nsec()] = pose.pose.position
            cls.news.notify_all()

    @classmethod
    def scan(cls, *passes):
        with cls.news:
            cls.begin = rospy.Time.now()
            cls.bound.clear()
            cls.truth.clear()
        cls.client.send_goal_and_wait(ScanGoal(frame='world', passes=passes), rospy.Duration(TIMEOUT))
        return cls.client.get_result()

    def bound_of(self, result):
        """All bound poses of a scan, each with the distance [m] from its true place."""
        self.assertEqual(result.outcome, ScanResult.FINISHED, result.message)
        with self.news:
            all_there = lambda: (len(self.bound) == result.audit.frames_bound and
                                 all(b.profile.device_time in self.truth for b in self.bound))
            self.assertTrue(self.news.wait_for(all_there, TIMEOUT), 'profiles and truth do not arrive')
            return [(b, self.off(b)) for b in self.bound]

    def off(self, bound):
        true = self.truth[bound.profile.device_time]
        place = self.base @ [true.x, true.y, true.z, 1]
        return float(numpy.linalg.norm([bound.pose.position.x - place[0], bound.pose.position.y - place[1],
                                        bound.pose.position.z - place[2]]))

    def check_places(self, result, speed, median):
        bound = self.bound_of(result)
        offs = [off for _, off in bound]
        print('%s: %d frames, off by %.3f mm (median), %.3f mm (most)' %
              (METHOD, len(bound), 1e3 * statistics.median(offs), 1e3 * max(offs)))
        self.assertLessEqual(statistics.median(offs), median)
        for b, off in bound:
            self.assertLessEqual(off, b.match.position_error_bound + STAMPED_TO * speed, b.match)


class ConstantSpeed(Binding):
    # The distance that the robot loses in its ramp, and a tenth of it for the stamps.
    median = 1.1 * SPEED ** 2 / (2 * ACCELERATION)

    def test_puts_each_pulse_where_the_robot_truly_was(self):
        result = self.scan(line(ScanPass.LASER_0))
        self.assertEqual(result.audit.method, BindingAudit.CONSTANT_SPEED)
        self.assertEqual(result.audit.constant_speed, result.audit.frames_bound)
        self.assertGreater(result.audit.frames_bound, 0.9 * 0.36 / SPEED * RATE)
        self.check_places(result, SPEED, self.median)

    def test_puts_pulses_on_the_line_in_step_with_their_times(self):
        bound = [b for b, _ in self.bound_of(self.scan(line(ScanPass.LASER_1)))]
        first = bound[0]
        for b in bound:
            way = SPEED * (b.header.stamp - first.header.stamp).to_sec()
            self.assertAlmostEqual(b.pose.position.x - first.pose.position.x, way, delta=1e-7)
            self.assertAlmostEqual(b.pose.position.z, 0.595, delta=1e-7)

    def test_follows_a_pass_there_and_back_and_lasers_that_take_turns(self):
        for lasers in (ScanPass.EACH, ScanPass.ALTERNATE):
            self.check_places(self.scan(line(lasers)), SPEED, self.median)

    def test_refuses_an_arc_or_a_polyline_before_anything_moves_and_names_the_cure(self):
        arc = ScanPass(kind=ScanPass.ARC, poses=[flange(-0.18), flange(0, 0.05), flange(0.18)], speed=SPEED, rate=RATE)
        way = ScanPass(kind=ScanPass.POLYLINE, poses=[flange(-0.18), flange(0, 0.05), flange(0.18)], speed=SPEED,
                       rate=RATE)
        for other in (arc, way):
            result = self.scan(line(ScanPass.LASER_0), other)
            self.assertEqual(result.outcome, ScanResult.REFUSED, result.message)
            self.assertIn('pass 2: an arc or a polyline', result.message)
            self.assertIn('scan it with binding:=interpolate', result.message)
            self.assertEqual(len(self.truth), 0, 'no frame was exposed')


class FirstPose(Binding):

    def test_gives_each_frame_the_first_pose_and_none_twice(self):
        result = self.scan(line(ScanPass.LASER_0))
        self.assertEqual(result.audit.method, BindingAudit.FIRST_POSE)
        shares = (result.audit.one_to_one, result.audit.frames_share_pose, result.audit.poses_share_frame)
        self.assertEqual(sum(shares), result.audit.frames_bound)
        # Poses come every 4 ms: two or three from one pulse to the next.
        self.assertGreater(result.audit.poses_share_frame, 0.9 * result.audit.frames_bound)
        self.check_places(result, SPEED, 0.004 * SPEED)
        # Before and after the ramp the robot stands still: poses there are alike, but not equal.
        moving = [b.pose.position.x for b, _ in self.bound_of(result) if abs(b.pose.position.x) < 0.179]
        self.assertEqual(len(set(moving)), len(moving))

    def test_binds_a_pass_that_is_no_line(self):
        result = self.scan(ScanPass(kind=ScanPass.ARC, poses=[flange(-0.18), flange(0, 0.05), flange(0.18)],
                                    speed=SPEED, rate=RATE))
        self.check_places(result, SPEED, 0.004 * SPEED)


if __name__ == '__main__':
    rostest.rosrun('scan_cell_demo', 'binding_' + METHOD,
                   {'constant_speed': ConstantSpeed, 'first_pose': FirstPose}[METHOD])
