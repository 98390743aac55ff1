#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""A program that the robot cannot run to its end is refused before anything moves, naming the pass and the place."""
import os
import subprocess
import tempfile
import unittest
from math import cos, sin

import actionlib
import rospy
import rostest
from geometry_msgs.msg import Point, Pose, Quaternion
from scan_cell_msgs import msg, srv

TIMEOUT = 60  # [s]
DOWN = (1, 0, 0, 0)
# At its present pose the robot looks down at (0.8, 0, 0.6).
GOOD = {'line': {'start': ((0.8, -0.1, 0.6), DOWN), 'end': ((0.8, 0.1, 0.6), DOWN)}}
FAR = {'line': {'start': ((0.8, 0.1, 0.6), DOWN), 'end': ((1.35, 0, 1.5), DOWN)}}
# Flange by Denavit and Hartenberg with the joints 0, 0, -90, 0, J5, 0 degrees: J5 from 30 through 0, where the wrist is
# straight, to -30.
STRAIGHT_WRIST = {'arc': {'start': ((0.879342413, 0, 1.1225), (0.8660254038, 0, 0.5, 0)),
                          'via': ((0.89207, 0, 1.17), (0.7071067812, 0, 0.7071067812, 0)),
                          'end': ((0.879342413, 0, 1.2175), (0.5, 0, 0.8660254038, 0))}}


def round_the_base(angle):
    """0.55 m from the axis of J1, which turns at most at 2.44 rad/s: at most 1.34 m/s along the circle."""
    return ((0.55 * cos(angle), 0.55 * sin(angle), 0.6), DOWN)


ROUND_THE_BASE = {'arc': {'start': round_the_base(-0.4), 'via': round_the_base(0), 'end': round_the_base(0.4)}}


def written(pose):
    return '{translation: [%.10g, %.10g, %.10g], rotation: [%.10g, %.10g, %.10g, %.10g]}' % (pose[0] + pose[1])


def program(*passes):
    """The text of a program file; each pass is its motion and its speed [m/s]."""
    text = 'frame: base_link\npasses:\n'
    for number, (way, speed) in enumerate(passes, 1):
        (kind, poses), = way.items()
        text += '  - name: number %d\n    %s:\n' % (number, kind)
        text += ''.join('      %s: %s\n' % (name, written(pose)) for name, pose in poses.items())
        text += '    speed: %g\n    rate: 100\n    laser: 0\n' % speed
    return text


def call(name, service, *arguments):
    rospy.wait_for_service(name, TIMEOUT)
    return rospy.ServiceProxy(name, service)(*arguments)


def standing():
    return call('/c4g_driver/get_static_pose', srv.GetStaticPose).joints.position


class ProgramCheck(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('program_check')
        rospy.Service('/laser_trigger/check_arm', srv.ArmTrigger, lambda _: {'success': True})
        # Replaces binder and triangulation, of which only these are needed before the motion; for laser_0 only.
        rospy.Service('/pose_frame_binder/check_run', srv.StartRun, lambda _: {'success': True})
        rospy.Service('/laser_triangulation/check_run', srv.StartRun,
                      lambda request: {'success': request.run.lasers == 1, 'message': 'laser_1: not calibrated'})
        cls.scan = actionlib.SimpleActionClient('/scan_cell/scan', msg.ScanAction)
        assert cls.scan.wait_for_server(rospy.Duration(TIMEOUT))
        deadline = rospy.get_time() + TIMEOUT
        while cls.check(program((GOOD, 0.1)))[0] != 0:  # until the nodes are up
            assert rospy.get_time() < deadline, cls.check(program((GOOD, 0.1)))

    @staticmethod
    def check(text):
        """Exit code and output of the tool."""
        with tempfile.NamedTemporaryFile('w', suffix='.yaml', delete=False) as file:
            file.write(text)
        try:
            done = subprocess.run(['rosrun', 'scan_cell', 'check_program', '--program', file.name], timeout=TIMEOUT,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
        finally:
            os.unlink(file.name)
        return done.returncode, done.stdout

    def test_names_the_second_pass_whose_laser_is_not_calibrated(self):
        self.expect_refused('pass 2 (number 2): refused by /laser_triangulation; laser_1: not calibrated',
                            text=program((GOOD, 0.1), (GOOD, 0.1)).replace('laser: 0', 'laser: 1')
                            .replace('laser: 1', 'laser: 0', 1))

    def expect_refused(self, *words, text):
        before = standing()
        code, said = self.check(text)
        self.assertEqual(code, 2, said)
        for word in words:
            self.assertIn(word, said)
        self.assertEqual(standing(), before)

    def test_lets_pass_what_the_robot_can_run(self):
        code, said = self.check(program((GOOD, 0.1), (ROUND_THE_BASE, 0.2)))
        self.assertEqual(code, 0, said)
        self.assertIn('2 passes, nothing stands in the way', said)
        self.assertNotIn('warning', said)

    def test_names_the_second_pass_that_is_out_of_reach(self):
        self.expect_refused('pass 2 (number 2), its line', 'at 1.350 0.000 1.500 m', 'out of reach by 0.',
                            text=program((GOOD, 0.1), (FAR, 0.1)))

    def test_names_the_second_pass_that_goes_through_a_singular_posture(self):
        self.expect_refused('pass 2 (number 2), its arc', 'passes a singular posture of J4 and J6 at ',
                            text=program((GOOD, 0.1), (STRAIGHT_WRIST, 0.05)))

    def test_names_the_second_pass_that_is_too_fast_an_arc(self):
        self.expect_refused('pass 2 (number 2), its arc', 'speed of J1: 2.7',
                            text=program((GOOD, 0.1), (ROUND_THE_BASE, 1.5)))

    def test_refuses_such_a_scan_before_anything_moves(self):
        before = standing()
        goal = msg.ScanGoal(scan_id='out of reach', frame='base_link')
        for way in (GOOD, FAR):
            one = msg.ScanPass(kind=msg.ScanPass.LINE, speed=0.1, rate=100, lasers=msg.ScanPass.LASER_0)
            for place, turn in way['line'].values():
                one.poses.append(Pose(Point(*place), Quaternion(*turn)))
            goal.passes.append(one)
        self.scan.send_goal_and_wait(goal, rospy.Duration(TIMEOUT))
        result = self.scan.get_result()
        self.assertEqual(result.outcome, msg.ScanResult.REFUSED, result.message)
        self.assertIn('pass 2, its line: the robot cannot follow it at 1.350 0.000 1.500 m', result.message)
        self.assertEqual(result.passes_finished, 0)
        self.assertEqual(standing(), before)


if __name__ == '__main__':
    rostest.rosrun('scan_cell_demo', 'program_check', ProgramCheck)
