#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The trigger node on real topics, with a UDP socket as the circuit."""
import glob
import os
import signal
import socket
import subprocess
import threading
import time
import unittest
import xmlrpc.client

import rosgraph
import rospy
import rostest
from scan_cell_msgs.msg import TriggerEvent, TriggerState
from scan_cell_msgs.srv import ArmTrigger, DisarmTrigger
from std_msgs.msg import Empty

PULSE = 1
CLIENT = '''
import rospy
from scan_cell_msgs.msg import TriggerState
from scan_cell_msgs.srv import ArmTrigger
rospy.init_node("client_to_kill")
rospy.Subscriber("/laser_trigger/state", TriggerState, lambda state: None)
rospy.wait_for_message("/laser_trigger/state", TriggerState, 30)
arm = rospy.ServiceProxy("/laser_trigger/arm", ArmTrigger)
assert arm(rate=100, lasers=3).success
rospy.spin()
'''


class Circuit(threading.Thread):
    """Records every value of the data register that it receives."""

    def __init__(self, port):
        super().__init__(daemon=True)
        self.writes = []
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(('127.0.0.1', port))

    def run(self):
        while True:
            self.writes.append((time.time(), self.socket.recv(16)))

    def port(self):
        return self.socket.getsockname()[1]

    def data(self):
        return self.writes[-1][1] if self.writes else None

    def rising_edges(self):
        writes = list(self.writes)
        return [now[0] for before, now in zip(writes, writes[1:])
                if now[1][0] & PULSE and not before[1][0] & PULSE]


def child_of(parent):
    """The only child of a process."""
    for status in glob.glob('/proc/[0-9]*/status'):
        try:
            with open(status) as lines:
                if 'PPid:\t%d\n' % parent in lines.readlines():
                    return int(status.split('/')[2])
        except OSError:
            pass  # a process that ended meanwhile
    raise AssertionError('process %d has no child' % parent)


class LaserTriggerNode(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('test_laser_trigger_node')
        cls.circuit = Circuit(15420)
        cls.circuit.start()
        cls.events = []
        cls.states = []
        rospy.Subscriber('/laser_trigger/events', TriggerEvent, cls.events.append)
        rospy.Subscriber('/laser_trigger/state', TriggerState, cls.states.append)
        cls.keep_alive = rospy.Publisher('/laser_trigger/keep_alive', Empty, queue_size=1)
        for name in ('arm', 'check_arm', 'disarm'):
            rospy.wait_for_service('/laser_trigger/' + name, 30)
        cls.arm = rospy.ServiceProxy('/laser_trigger/arm', ArmTrigger)
        cls.check_arm = rospy.ServiceProxy('/laser_trigger/check_arm', ArmTrigger)
        cls.disarm = rospy.ServiceProxy('/laser_trigger/disarm', DisarmTrigger)
        cls.keep_alive_wanted = True
        threading.Thread(target=cls.keep_it_alive, daemon=True).start()

    @classmethod
    def keep_it_alive(cls):
        while not rospy.is_shutdown():
            if cls.keep_alive_wanted:
                cls.keep_alive.publish()
            time.sleep(0.05)

    def wait(self, condition, what, timeout=30):
        end = time.time() + timeout
        while not condition():
            self.assertLess(time.time(), end, 'waited in vain until ' + what)
            time.sleep(0.01)

    def arm_and_wait(self, lasers, alternate=False):
        before = len(self.circuit.rising_edges())
        answer = self.arm(rate=100, lasers=lasers, alternate=alternate)
        self.assertTrue(answer.success, answer.message)
        self.wait(lambda: len(self.circuit.rising_edges()) > before + 5, 'pulses come')
        return answer.arming

    def lines_go_low(self):
        self.wait(lambda: self.circuit.data() == b'\x00', 'the lines are low')

    def test_1_is_low_and_says_so_at_the_start(self):
        self.wait(lambda: self.states, 'the latched state comes')
        self.assertFalse(self.states[0].armed)
        self.lines_go_low()

    def test_2_sends_an_event_of_each_pulse_and_counts_them(self):
        self.wait(lambda: self.keep_alive.get_num_connections() > 0, 'the keep-alive is connected')
        arming = self.arm_and_wait(TriggerEvent.LASER_0)
        self.assertIn(self.circuit.data()[0] & ~PULSE, (0b010,))
        ended = self.disarm()
        self.lines_go_low()
        self.assertEqual(ended.arming, arming)
        mine = lambda: [e for e in self.events if e.arming == arming]
        self.wait(lambda: len(mine()) == ended.pulses, 'the last event comes')
        self.assertEqual([e.count for e in mine()], list(range(1, ended.pulses + 1)))
        edges = self.circuit.rising_edges()[-ended.pulses:]
        for event, edge in zip(mine(), edges):
            self.assertEqual(event.lasers, TriggerEvent.LASER_0)
            self.assertLess(abs(event.header.stamp.to_sec() - edge), 0.5)
        self.assertTrue(self.disarm().success, 'disarming what is disarmed succeeds')

    def test_2b_lets_the_lasers_take_turns_and_says_which_was_on(self):
        arming = self.arm_and_wait(3, alternate=True)
        mine = lambda: [e for e in self.events if e.arming == arming]
        self.wait(lambda: len(mine()) > 20, 'events come')
        self.wait(lambda: self.states[-1].armed, 'the state says so')
        self.assertTrue(self.states[-1].alternate)
        self.assertEqual(self.states[-1].lasers, 3)
        self.assertTrue(self.disarm().success)
        self.lines_go_low()
        for event in mine():
            self.assertEqual(event.lasers, TriggerEvent.LASER_0 if event.count % 2 else TriggerEvent.LASER_1)
        self.wait(lambda: not self.states[-1].armed, 'the state says so')
        self.assertFalse(self.states[-1].alternate)

    def test_2c_lasers_that_take_turns_go_off_without_keep_alive(self):
        self.arm_and_wait(3, alternate=True)
        type(self).keep_alive_wanted = False
        self.lines_go_low()
        type(self).keep_alive_wanted = True
        self.wait(lambda: not self.states[-1].armed, 'the state says so')
        self.assertIn('keep-alive', self.states[-1].message)

    def test_3_refuses_what_makes_no_sense(self):
        for request, word in ((dict(rate=0, lasers=1), 'rate'), (dict(rate=1e9, lasers=1), 'rate'),
                              (dict(rate=100, lasers=4), 'lasers'),
                              (dict(rate=100, lasers=1, alternate=True), 'lasers'),
                              (dict(rate=900, lasers=3, alternate=True), 'rate')):
            answer = self.arm(**request)
            self.assertFalse(answer.success)
            self.assertIn(word, answer.message)
        self.arm_and_wait(0)
        answer = self.arm(rate=100, lasers=3)
        self.assertFalse(answer.success)
        self.assertIn('already armed', answer.message)
        self.disarm()

    def test_3b_tells_whether_it_would_be_armed_and_writes_no_line(self):
        self.lines_go_low()
        before = len(self.circuit.writes)
        for request, word in ((dict(rate=900, lasers=3, alternate=True), '833 Hz'),
                              (dict(rate=100, lasers=3, alternate=True, exposure=0.0098), 'exposure of 9.9 ms'),
                              (dict(rate=100, lasers=3, alternate=True, exposure=0.0096), None)):
            answer = self.check_arm(**request)
            self.assertEqual(answer.success, word is None, answer.message)
            self.assertIn(word or '', answer.message)
            self.assertEqual(answer.arming, 0)
        self.arm_and_wait(0)
        self.assertIn('already armed', self.check_arm(rate=100, lasers=3).message)
        self.disarm()
        self.lines_go_low()
        self.assertEqual([data for _, data in self.circuit.writes[before:] if data[0] & ~PULSE], [])

    def test_4_disarms_with_a_reason_without_keep_alive(self):
        self.arm_and_wait(3)
        type(self).keep_alive_wanted = False
        self.lines_go_low()
        type(self).keep_alive_wanted = True
        self.wait(lambda: not self.states[-1].armed, 'the state says so')
        self.assertIn('keep-alive', self.states[-1].message)
        self.assertEqual(self.states[-1].lasers, 0)

    def test_4b_disarms_when_the_client_that_armed_it_is_killed_though_others_keep_it_alive(self):
        client = subprocess.Popen(['/usr/bin/python3', '-c', CLIENT])
        try:
            self.wait(lambda: self.circuit.data() not in (None, b'\x00'), 'the client has armed it')
        finally:
            client.kill()
            client.wait()
        self.lines_go_low()
        self.wait(lambda: not self.states[-1].armed, 'the state says so')
        self.assertEqual(self.states[-1].message, 'its client /client_to_kill is gone')

    def test_4c_stays_armed_when_another_listener_is_killed(self):
        listener = subprocess.Popen(['/usr/bin/python3', '-c', CLIENT.split('arm = ')[0] +
                                     'print("listens", flush=True)\nrospy.spin()'], stdout=subprocess.PIPE)
        self.assertEqual(listener.stdout.readline(), b'listens\n')
        self.arm_and_wait(3)
        listener.kill()
        listener.wait()
        before = len(self.circuit.rising_edges())
        self.wait(lambda: len(self.circuit.rising_edges()) > before + 50, 'pulses go on')
        self.assertTrue(self.disarm().success)

    def test_5_refuses_to_start_with_a_bad_parameter(self):
        for argument, name in (('_pulse_width:=-1', 'pulse_width'), ('_portt:=loopback', 'portt'),
                               ('_port:=usb', 'port')):
            run = subprocess.run(['rosrun', 'laser_trigger', 'laser_trigger_node',
                                  '__name:=bad_trigger', argument], timeout=60,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            subprocess.run(['rosparam', 'delete', '/bad_trigger'], timeout=60, check=True)
            self.assertEqual(run.returncode, 1)
            self.assertIn(name, run.stdout.decode())

    def test_6_lasers_go_off_at_each_signal_by_the_node_itself(self):
        signal.signal(signal.SIGHUP, signal.SIG_DFL)  # under nohup the node would ignore it, too
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            circuit = Circuit(0)
            circuit.start()
            node = subprocess.Popen(['rosrun', 'laser_trigger', 'laser_trigger_node',
                                     '__name:=signalled', '_port:=loopback',
                                     '_keep_alive_timeout:=5', '_hang_timeout:=10',
                                     '_loopback_port:=%d' % circuit.port()])
            guardian = None
            try:
                rospy.wait_for_service('/signalled/arm', 60)
                arm = rospy.ServiceProxy('/signalled/arm', ArmTrigger)
                guardian = child_of(node.pid)
                os.kill(guardian, signal.SIGSTOP)  # so that the guardian is not the writer
                answer = arm(rate=100, lasers=3)
                self.assertTrue(answer.success, answer.message)
                self.wait(lambda: len(circuit.rising_edges()) > 2, 'the lasers are on')
                node.send_signal(number)
                self.wait(lambda: circuit.data() == b'\x00', 'the lines are low')
                self.assertEqual(node.wait(60), 0, 'signal %d' % number)
                self.assertEqual(circuit.data(), b'\x00')
            finally:
                node.kill()
                if guardian:
                    os.kill(guardian, signal.SIGCONT)
                subprocess.run(['rosparam', 'delete', '/signalled'], timeout=60, check=True)

    def test_7_lasers_go_off_when_the_node_is_killed(self):
        self.arm_and_wait(3)
        uri = rosgraph.Master('/test').lookupNode('/laser_trigger')
        process = xmlrpc.client.ServerProxy(uri).getPid('/test')[2]
        self.assertGreater(process, 1)
        os.kill(process, signal.SIGKILL)
        self.lines_go_low()


if __name__ == '__main__':
    rostest.rosrun('laser_trigger', 'laser_trigger_node', LaserTriggerNode)
