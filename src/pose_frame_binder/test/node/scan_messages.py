# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""A scan along y of the base, as messages."""
import rospy
from geometry_msgs.msg import TransformStamped
from scan_cell_msgs.msg import PeakProfile, TriggerEvent
from tf2_msgs.msg import TFMessage

START = 1700000000
SPEED = 0.2       # [m/s] of the flange along y of the base
PERIOD = 0.01     # [s] of the pulses
LATENCY = 0.004   # [s] of the camera's stamps


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
    """Poses every 4 ms from before the first pulse to after the last."""
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
