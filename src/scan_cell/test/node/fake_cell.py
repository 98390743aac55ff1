#!/usr/bin/python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Plays every node around scan_cell_node: it does what it is told and can go silent.

Parameters under /fake:
silent      device that goes silent after ten pulses
hangs       service of the trigger that answers late: arm or disarm
speed       refused: the driver refuses one; lost: it has no link to the controller
binder      missing: it misses trigger events; no pose: the whole last arming is dropped; no end: the frames of the last pulses; broken: its service fails
uncalibrated lasers that the scanner model does not have (mask)
exposure    [s] of the camera (default 0.001)
move_time   [s] a motion takes (default 1.5)
"""

import struct

import actionlib
import rospy
from geometry_msgs.msg import TransformStamped
from scan_cell_msgs import msg, srv
from sensor_msgs.msg import PointCloud2, PointField
from std_msgs.msg import Empty, String
from tf2_msgs.msg import TFMessage

HANGS = 6  # [s] longer than any allowed wait while the robot moves


def fake(name, default=''):
    return rospy.get_param('/fake/' + name, default)


def cloud_of_one_point():
    cloud = PointCloud2(height=1, width=1, point_step=12, row_step=12, data=struct.pack('<fff', 1, 2, 3))
    cloud.fields = [PointField(n, 4 * i, PointField.FLOAT32, 1) for i, n in enumerate('xyz')]
    return cloud


class FakeCell:

    def __init__(self):
        self.armed = False
        self.measured = rospy.Time()
        self.pulses = 0
        self.frames = 0
        self.arming = 0
        self.last_goal = None
        self.log = rospy.Publisher('/fake/log', String, queue_size=100)
        self.status = rospy.Publisher('/c4g_driver/status', msg.RobotStatus, queue_size=10)
        self.transforms = rospy.Publisher('/tf', TFMessage, queue_size=10)
        self.profiles = rospy.Publisher('/camera/profiles', msg.PeakProfile, queue_size=100)
        self.events = rospy.Publisher('/laser_trigger/events', msg.TriggerEvent, queue_size=100)
        self.state = rospy.Publisher('/laser_trigger/state', msg.TriggerState, queue_size=10, latch=True)
        rospy.Subscriber('/laser_trigger/keep_alive', Empty, lambda _: None)
        self.serve_stages()
        self.serve_devices()
        self.move = actionlib.SimpleActionServer('/c4g_driver/move', msg.MoveAction, self.on_move, False)
        self.move.start()
        rospy.Timer(rospy.Duration(0.02), self.tick)

    def serve_devices(self):
        ok = {'success': True}
        rospy.Service('/c4g_driver/set_linear_speed', srv.SetLinearSpeed, self.on_speed)
        rospy.Service('/c4g_driver/set_parameter', srv.SetControllerParameter, lambda _: ok)
        rospy.Service('/c4g_driver/get_static_pose', srv.GetStaticPose, self.on_static_pose)
        rospy.Service('/camera/set_acquisition', srv.SetAcquisition, self.on_set_acquisition)
        rospy.Service('/laser_trigger/check_arm', srv.ArmTrigger, self.on_check_arm)
        rospy.Service('/laser_trigger/arm', srv.ArmTrigger, self.on_arm)
        rospy.Service('/laser_trigger/disarm', srv.DisarmTrigger, self.on_disarm)

    def serve_stages(self):
        for node in ('pose_frame_binder', 'laser_triangulation'):
            rospy.Service('/%s/start' % node, srv.StartScan, lambda _: {'success': True})
        for name in ('check_run', 'start_run'):
            rospy.Service('/pose_frame_binder/' + name, srv.StartRun, lambda _: {'success': True})
        rospy.Service('/laser_triangulation/check_run', srv.StartRun, self.on_check_run)
        rospy.Service('/pose_frame_binder/finish', srv.FinishBinding, self.on_finish_binding)
        rospy.Service('/laser_triangulation/finish', srv.FinishCloud, self.on_finish_cloud)

    def on_check_run(self, request):
        unfit = request.run.lasers & fake('uncalibrated', 0)
        return {'success': unfit == 0, 'message': 'laser mask %d is not calibrated' % unfit}

    def silent(self, device):
        return self.armed and self.pulses > 10 and fake('silent') == device

    def on_speed(self, _):
        trouble = fake('speed')
        return {'success': trouble == '', 'link_lost': trouble == 'lost', 'message': trouble}

    def on_static_pose(self, _):
        answer = srv.GetStaticPoseResponse(success=fake('moves') == '', message='moving')
        answer.pose.header.frame_id = 'base_link'
        answer.pose.pose.position.x = fake('flange_x', 0.5)
        answer.pose.pose.orientation.x = 1
        return answer

    @staticmethod
    def on_set_acquisition(_):
        answer = srv.SetAcquisitionResponse(success=True)
        answer.taken.exposure = fake('exposure', 0.001)
        return answer

    def on_check_arm(self, request):
        fits = not request.alternate or request.exposure * request.rate < 1
        return {'success': fits, 'message': 'rate: %g Hz to alternate' % request.rate}

    def on_arm(self, request):
        if fake('hangs') == 'arm':
            rospy.sleep(HANGS)
            return {'success': False}
        self.arming += 1
        self.pulses = self.frames = 0
        self.armed = True
        self.log.publish('armed')
        return {'success': True, 'arming': self.arming}

    def on_disarm(self, _):
        self.armed = False
        self.log.publish('disarmed')
        if fake('hangs') == 'disarm':
            rospy.sleep(HANGS)
        return {'success': True, 'arming': self.arming, 'pulses': self.pulses}

    def on_finish_binding(self, request):
        if fake('binder') == 'broken':
            raise rospy.ServiceException('broken')
        missing = 3 if fake('binder') == 'missing' else 0
        if fake('binder') == 'no end':
            self.frames = max(0, min(self.frames, request.triggers) - 15)
        audit = msg.BindingAudit(triggers=request.triggers, triggers_missing=missing,
                                 frames_bound=min(self.frames, request.triggers) - missing)
        audit.dropped = [msg.DroppedFrame(reason=msg.DroppedFrame.NEVER_ARRIVED, arming=self.arming, trigger_count=n)
                         for n in range(self.frames + 1, request.triggers + 1)]
        if fake('binder') == 'no pose':
            audit.dropped = [msg.DroppedFrame(reason=msg.DroppedFrame.NO_POSE_BEFORE, arming=self.arming,
                                              trigger_count=n, detail='no pose before it')
                             for n in range(1, self.pulses + 1)]
        return {'success': missing == 0, 'message': '%d events missing' % missing, 'audit': audit}

    def on_finish_cloud(self, request):
        self.log.publish('cloud partial' if request.partial else 'cloud whole')
        response = srv.FinishCloudResponse(success=True)
        response.statistics.points = request.profiles
        response.cloud = cloud_of_one_point()
        if fake('cloud') == 'large':
            response.cloud.data, response.cloud.width = b'', 0
            response.file = '/scans/large.ply'
        return response

    def on_move(self, goal):
        start = rospy.Time.now()
        while not rospy.is_shutdown():
            share = (rospy.Time.now() - start).to_sec() / fake('move_time', 1.5)
            if self.move.is_preempt_requested():
                self.log.publish('stopped')
                self.move.set_preempted(msg.MoveResult(outcome=msg.MoveResult.STOPPED))
                return
            if share >= 1:
                self.move.set_succeeded(msg.MoveResult(outcome=msg.MoveResult.REACHED))
                return
            self.move.publish_feedback(msg.MoveFeedback(progress=share))
            rospy.sleep(0.02)

    def tick(self, _):
        transform = TransformStamped(child_frame_id='tool0')
        transform.header.frame_id, transform.header.stamp = 'base_link', rospy.Time.now()
        transform.transform.rotation.w = 1
        self.transforms.publish([transform])
        if not self.silent('robot'):
            status = msg.RobotStatus(connected=True)
            if not self.silent('pose'):
                self.measured = rospy.Time.now()
            status.header.stamp = self.measured
            self.status.publish(status)
        if not self.armed:
            return
        self.pulses += 1
        if not self.silent('trigger'):
            self.events.publish(msg.TriggerEvent(arming=self.arming, count=self.pulses))
        if not self.silent('camera'):
            self.frames = self.pulses
            self.profiles.publish(msg.PeakProfile(frame_counter=self.pulses))


if __name__ == '__main__':
    rospy.init_node('fake_cell')
    FakeCell()
    rospy.spin()
