#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Plays the person who teaches tool and world in the simulated cell: drives the robot by hand, touches with the
tool's tip, and has the cell record where the robot stands (~record_pose), for cell_frames.

Writes OUTPUT/tool_poses.csv, the tip on one fixed point from several orientations, and OUTPUT/world_poses.csv, the tip
on the points O, X and XY of the world's board. A person sees when the tip touches; this one knows it from the cell
file, as the simulator has it.
"""
import argparse
import os
import random

import numpy
import yaml
from scan_cell_common.command_line import add_version

FIXED_POINT = (0.05, 0.1, 0.1)  # [m] in world: of a pin that stands on the floor
# [deg] off upright, and the direction of the axis; not about -y, where the wrist would be straight on the way
TILTS = ((0, 0), (25, 0), (25, 45), (25, 90), (25, 135), (25, 180))
ROLLS = (0, 20, -20, 40, -40, 10)  # [deg] about the tool's axis
BOARD = ((0, 0, 0), (0.3, 0, 0), (0.3, 0.2, 0))  # [m] in world: O, X, XY
RETRACT = 0.05  # [m] back along the tool's axis before and after each touch
TIMEOUT = 60  # [s] of a motion, and for the cell to start


def turn(axis, degrees):
    """Matrix of a rotation about an axis of unit length (Rodrigues)."""
    angle = numpy.radians(degrees)
    x, y, z = axis
    k = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + numpy.sin(angle) * k + (1 - numpy.cos(angle)) * k @ k


def pose(rotation, place):
    result = numpy.eye(4)
    result[:3, :3] = rotation
    result[:3, 3] = place
    return result


def from_yaml(entry):
    *vector, w = entry['rotation']
    length = numpy.linalg.norm(vector)
    axis = numpy.array(vector) / length if length else (0, 0, 1)
    return pose(turn(axis, numpy.degrees(2 * numpy.arctan2(length, w))), entry['translation'])


def quaternion(r):
    """x y z w of a rotation matrix near half a turn about x, as of a tool that looks down."""
    x = numpy.sqrt(1 + r[0, 0] - r[1, 1] - r[2, 2]) / 2
    return x, (r[0, 1] + r[1, 0]) / (4 * x), (r[0, 2] + r[2, 0]) / (4 * x), (r[2, 1] - r[1, 2]) / (4 * x)


def touches():
    """Name of the file, and the tip's pose in world; the tool looks down."""
    down = turn((1, 0, 0), 180)
    for (tilt, direction), roll in zip(TILTS, ROLLS):
        axis = (numpy.cos(numpy.radians(direction)), numpy.sin(numpy.radians(direction)), 0)
        yield 'tool_poses.csv', pose(turn(axis, tilt) @ down @ turn((0, 0, 1), roll), FIXED_POINT)
    for point in BOARD:
        yield 'world_poses.csv', pose(down, point)


class Teacher:
    """Moves the robot and has its poses recorded."""

    def __init__(self, driver, cell):
        import actionlib
        import rospy
        from scan_cell_msgs import msg, srv
        self.rospy, self.msg = rospy, msg
        self.record_pose = rospy.ServiceProxy(cell + '/record_pose', srv.RecordPose)
        self.record_pose.wait_for_service(TIMEOUT)
        self.client = actionlib.SimpleActionClient(driver + '/move', msg.MoveAction)
        if not self.client.wait_for_server(rospy.Duration(TIMEOUT)):
            raise RuntimeError('%s/move: no action server; start the cell with sim:=true' % driver)
        self.wait_for_robot(driver)

    def wait_for_robot(self, driver):
        end = self.rospy.Time.now() + self.rospy.Duration(TIMEOUT)
        while not self.rospy.wait_for_message(driver + '/status', self.msg.RobotStatus, TIMEOUT).connected:
            if self.rospy.Time.now() > end:
                raise RuntimeError('%s: not connected to the controller' % driver)

    def move(self, flange):
        goal = self.msg.MoveGoal(kind=self.msg.MoveGoal.CARTESIAN)
        goal.pose.header.frame_id = 'base_link'
        place, rotation = goal.pose.pose.position, goal.pose.pose.orientation
        place.x, place.y, place.z = flange[:3, 3]
        rotation.x, rotation.y, rotation.z, rotation.w = quaternion(flange[:3, :3])
        self.client.send_goal_and_wait(goal, self.rospy.Duration(TIMEOUT))
        result = self.client.get_result()
        if result is None or result.outcome != self.msg.MoveResult.REACHED:
            raise RuntimeError('%s/move: %s' % (self.client.action_client.ns, result and result.message))

    def touch(self, flange, path):
        """Goes there and back. The robot settles after it has reached the pose, so the cell is
        asked until it stands."""
        away = flange @ pose(numpy.eye(3), (0, 0, -RETRACT))
        self.move(away)
        self.move(flange)
        end = self.rospy.Time.now() + self.rospy.Duration(TIMEOUT)
        answer = self.record_pose(path)
        while not answer.success and self.rospy.Time.now() < end:
            self.rospy.sleep(0.1)
            answer = self.record_pose(path)
        if not answer.success:
            raise RuntimeError(answer.message)
        print('%s: pose %d' % (path, answer.poses))
        self.move(away)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_version(parser)
    parser.add_argument('--cell', required=True, help="cell file of the simulator: where the robot and the tip truly are")
    parser.add_argument('--output', required=True, help='folder for the files of taught poses; must not hold them yet')
    parser.add_argument('--deviation', type=float, default=0, help='standard deviation of a touch along each axis [m]')
    parser.add_argument('--seed', type=int, default=1, help='of the touches that miss')
    parser.add_argument('--driver', default='/c4g_driver', help="node of the robot's driver")
    parser.add_argument('--node', default='/scan_cell', help='node that records poses')
    options = parser.parse_args()
    with open(options.cell) as file:
        cell = yaml.safe_load(file)
    for name in ('tool_poses.csv', 'world_poses.csv'):
        if os.path.exists(os.path.join(options.output, name)):
            parser.error('%s is in %s already; give another folder' % (name, options.output))
    import rospy
    rospy.init_node('touch_points', anonymous=True)
    teacher = Teacher(options.driver, options.node)
    base, tool = from_yaml(cell['base_link_in_world']), from_yaml(cell['tool_tip_in_tool0'])
    draw = random.Random(options.seed)
    for name, tip in touches():
        tip[:3, 3] += [draw.gauss(0, options.deviation) for _ in range(3)]
        flange = numpy.linalg.inv(base) @ tip @ numpy.linalg.inv(tool)
        teacher.touch(flange, os.path.abspath(os.path.join(options.output, name)))


if __name__ == '__main__':
    try:
        main()
    except (OSError, RuntimeError) as error:
        raise SystemExit('touch_points.py: %s' % error)
