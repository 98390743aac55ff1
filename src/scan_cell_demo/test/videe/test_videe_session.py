#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""ViDeE on the simulated cell: the session of docs/videe_protocol.md as written, and one state for all clients."""
import os
import re
import shutil
import socket
import subprocess
import threading
import time
import unittest

import actionlib
import rospkg
import rospy
import rostest
from geometry_msgs.msg import Point, Pose, Quaternion
from scan_cell_common.ply import read_vertices
from scan_cell_msgs.msg import CellState, ScanAction, ScanActionFeedback, ScanGoal, ScanPass, ScanResult, TriggerState
from scan_cell_msgs.srv import GrabImage, LoadWorld

PAGE = os.path.join(os.path.dirname(os.path.realpath(__file__)), '../../../../docs/videe_protocol.md')
ADDRESS = ('127.0.0.1', 5998)
TIMEOUT = 120  # [s] on a busy machine


def world(name):
    return os.path.join(rospkg.RosPack().get_path('scan_cell_sim'), 'config', name)


def session_of_the_page():
    """Pairs of command and answer below the nc command."""
    with open(PAGE) as page:
        block = page.read().split('    nc 127.0.0.1 5000\n')[1].split('\n\n')[0]
    lines = [line.strip() for line in block.splitlines()]
    return list(zip(lines[::2], lines[1::2]))


def pattern(answer):
    """Allows any number of frames, points and so on, and any machine."""
    text = re.sub(r'\d+', r'\\d+', re.escape(answer)) + '$'
    return re.sub(r'machine=\S+', r'machine=\\S+$', text)


class Client:
    """A ViDeE client, once the server listens."""

    def __init__(self):
        end = time.time() + TIMEOUT
        while True:
            try:
                self.socket = socket.create_connection(ADDRESS, timeout=TIMEOUT)
                break
            except ConnectionRefusedError:
                assert time.time() < end, 'no ViDeE server'
                time.sleep(0.1)
        self.lines = self.socket.makefile('rw', newline='\n')

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.lines.close()
        self.socket.close()

    def close(self):
        self.__exit__()

    def send_and_hang_up(self, data):
        """What the server accepts within a second."""
        self.socket.settimeout(1)
        try:
            self.socket.sendall(data)
        except OSError:  # it accepts no more, or has closed the connection
            pass
        self.close()

    def send_and_close_its_direction(self, data):
        self.socket.sendall(data)
        self.socket.shutdown(socket.SHUT_WR)

    def ask(self, command):
        self.lines.write(command + '\n')
        self.lines.flush()
        return self.lines.readline().rstrip('\n')


class Videe(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        rospy.init_node('test_videe_session')
        cls.news = threading.Condition()
        cls.states, cls.lasers, cls.points, cls.passes = [], None, 0, 0
        rospy.Subscriber('/scan_cell/state', CellState, cls.on_state)
        rospy.Subscriber('/laser_trigger/state', TriggerState, cls.on_trigger)
        rospy.Subscriber('/scan_cell/scan/feedback', ScanActionFeedback, cls.on_feedback)
        cls.scan = actionlib.SimpleActionClient('/scan_cell/scan', ScanAction)
        assert cls.scan.wait_for_server(rospy.Duration(TIMEOUT))
        with Client() as client:  # until robot and camera are up, scans are refused
            cls.wait_until_up(client)

    @classmethod
    def wait_until_up(cls, client):
        end = time.time() + TIMEOUT
        while not client.ask('GRAB_IMAGE').startswith('OK'):
            assert time.time() < end, 'no image'
            time.sleep(0.5)
        while True:
            client.ask('SET_POSITION -20,0,595,180,0,0 20,0,595,180,0,0')
            client.ask('START_SCAN')
            client.ask('WAIT_SCAN')
            answer = client.ask('STOP_SCAN')
            if answer.startswith('OK'):
                return
            assert time.time() < end, answer

    @classmethod
    def on_state(cls, state):
        with cls.news:
            cls.states.append(state)
            cls.news.notify_all()

    @classmethod
    def on_trigger(cls, state):
        with cls.news:
            cls.lasers = state.lasers
            cls.news.notify_all()

    @classmethod
    def on_feedback(cls, feedback):
        with cls.news:
            cls.points, cls.passes = feedback.feedback.points, feedback.feedback.passes
            cls.news.notify_all()

    def wait_for(self, condition, what):
        with self.news:
            self.assertTrue(self.news.wait_for(condition, TIMEOUT), what)

    def scanning(self):
        return self.states and self.states[-1].state == CellState.SCANNING

    def prepared(self):
        client = Client()
        self.assertEqual(client.ask('SET_POSITION -180,0,595,180,0,0 180,0,595,180,0,0'), 'OK')
        return client

    def start_ros_scan(self):
        """Retries: the scan of the test before may still be ending."""
        end = time.time() + TIMEOUT
        self.scan.send_goal(self.ros_goal())
        while self.scan.get_state() != actionlib.GoalStatus.ACTIVE:
            if self.scan.get_state() == actionlib.GoalStatus.REJECTED:
                self.assertLess(time.time(), end, self.scan.get_goal_status_text())
                self.scan.send_goal(self.ros_goal())
            time.sleep(0.05)

    def start(self, client):
        end = time.time() + TIMEOUT
        while True:
            answer = client.ask('START_SCAN')
            if 'is running' not in answer:
                break
            self.assertLess(time.time(), end, answer)
            time.sleep(0.05)
        self.assertEqual(answer, 'OK')

    def ros_goal(self):
        line = ScanPass(kind=ScanPass.LINE, speed=0.06, rate=100, lasers=ScanPass.LASER_0)
        for x in (-0.18, 0.18):
            line.poses.append(Pose(position=Point(x=x, z=0.595), orientation=Quaternion(x=1)))
        return ScanGoal(scan_id='of a ROS client', frame='world', passes=[line])

    def test_session_of_the_page_runs_as_it_stands_there(self):
        session = session_of_the_page()
        commands = [command.split()[0] for command, _ in session]
        for command in ('INIT_CYCLE', 'SET_POSITION', 'START_SCAN', 'WAIT_SCAN', 'STOP_SCAN', 'GRAB_IMAGE', 'RESET'):
            self.assertIn(command, commands)
        with Client() as client:
            for command, answer in session:
                said = client.ask(command)
                self.assertRegex(said, pattern(answer), command)
                for file in re.findall(r'/tmp/\S+', said):
                    os.remove(file)
        self.wait_for(lambda: self.lasers == 0, 'the lasers are off after RESET')

    def test_ros_clients_see_a_scan_of_videe_and_are_refused_by_its_name(self):
        with self.prepared() as client:
            self.start(client)
            self.wait_for(self.scanning, 'the scan is on the state topic')
            name = self.states[-1].scan_id
            self.scan.send_goal_and_wait(self.ros_goal(), rospy.Duration(TIMEOUT))
            self.assertIn("'%s' is running" % name, self.scan.get_result().message)
            answer = rospy.ServiceProxy('/scan_cell/grab_image', GrabImage)()
            self.assertIn("'%s' is running" % name, answer.message)
            self.assertEqual(client.ask('WAIT_SCAN'), 'OK')
            self.assertRegex(client.ask('STOP_SCAN'), 'OK scan=%s .* ended=whole ' % name)

    def test_videe_clients_are_refused_by_the_name_of_a_scan_of_ros(self):
        self.start_ros_scan()
        self.wait_for(self.scanning, 'the scan is on the state topic')
        with self.prepared() as client:
            for command in ('START_SCAN', 'GRAB_IMAGE'):
                self.assertIn("'of a ROS client' is running", client.ask(command))
        self.assertTrue(self.scan.wait_for_result(rospy.Duration(TIMEOUT)))
        self.assertEqual(self.scan.get_result().outcome, ScanResult.FINISHED, 'it was not disturbed')

    def test_reset_ends_a_scan_of_a_ros_client_too(self):
        self.start_ros_scan()
        self.wait_for(lambda: self.lasers, 'a laser is on')
        with Client() as client:
            self.assertEqual(client.ask('RESET'), 'OK')
        self.assertTrue(self.scan.wait_for_result(rospy.Duration(TIMEOUT)))
        self.assertEqual(self.scan.get_state(), actionlib.GoalStatus.PREEMPTED)
        self.wait_for(lambda: self.lasers == 0, 'the lasers are off')

    def test_after_a_reset_the_cell_is_free_for_the_next_scan(self):
        for _ in range(3):
            self.start_ros_scan()
            self.wait_for(lambda: self.lasers, 'a laser is on')
            with Client() as client:
                self.assertEqual(client.ask('RESET'), 'OK')
                self.assertEqual(client.ask('SET_POSITION -20,0,595,180,0,0 20,0,595,180,0,0'), 'OK')
                self.assertEqual(client.ask('START_SCAN'), 'OK')
                self.assertEqual(client.ask('INIT_CYCLE'), 'OK')
                client.ask('SET_POSITION -20,0,595,180,0,0 20,0,595,180,0,0')
                self.assertEqual(client.ask('START_SCAN'), 'OK')

    def test_stop_scan_stops_a_scan_under_way_and_keeps_what_came(self):
        with self.prepared() as client:
            self.start(client)
            self.wait_for(lambda: self.lasers, 'a laser is on')
            self.wait_for(lambda: self.points > 1000, 'points come')
            answer = client.ask('STOP_SCAN')
            kept = re.match(r'OK scan=(\S+) frames=(\d+) points=(\d+) ended=stopped cloud=(\S+) machine=(\S+)$', answer)
            self.assertTrue(kept, answer)
            scan, frames, points, cloud, machine = kept.groups()
            self.assertLess(int(frames), 500, 'of 600: it was stopped')
            self.assertGreater(int(points), 1000)
            self.assertEqual(os.path.basename(cloud), scan + '.ply')
            with open(cloud, 'rb') as file:
                self.assertIn(b'element vertex %s\n' % points.encode(), file.read(2000))
            os.remove(cloud)
            self.assertEqual(socket.gethostbyname(machine)[:4], '127.')
            self.wait_for(lambda: self.lasers == 0, 'the lasers are off')
            self.assertIn('no scan is running', client.ask('STOP_SCAN'))
            self.start(client)  # the next scan
            self.assertEqual(client.ask('WAIT_SCAN'), 'OK')
            answer = client.ask('STOP_SCAN')
            self.assertIn(' ended=whole ', answer)
            os.remove(re.search(r'cloud=(\S+)', answer).group(1))

    def test_each_pair_of_positions_is_a_pass_of_one_cloud(self):
        with Client() as client:
            first, second = '-180,-10,595,180,0,0 180,-10,595,180,0,0', '180,10,595,180,0,0 0,10,595,180,0,0'
            self.assertEqual(client.ask('SET_POSITION %s %s' % (first, second)), 'OK')
            self.start(client)
            self.assertEqual(client.ask('WAIT_SCAN'), 'OK')
            answer = client.ask('STOP_SCAN')
            self.assertIn(' ended=whole ', answer)
            self.assertEqual(self.passes, 2)
            cloud = re.search(r'cloud=(\S+)', answer).group(1)
            points = read_vertices(cloud)
            os.remove(cloud)
            for number, ends in enumerate(((-0.18, 0.18), (0, 0.18))):
                x = points['x'][points['pass'] == number]
                self.assertGreater(len(x), 10000)
                self.assertAlmostEqual(x.max() - x.min(), ends[1] - ends[0], delta=0.05)

    def test_stop_scan_says_where_nothing_was_captured_yet(self):
        with self.prepared() as client:
            self.start(client)
            answer = client.ask('STOP_SCAN')  # on the way to the start
            self.assertRegex(answer, 'ERROR scan .*: no point was captured; ')
            self.wait_for(lambda: not self.scanning(), 'the scan has ended')

    def test_the_same_cell_calibrates(self):
        rospy.ServiceProxy('/scan_cell_sim/load_world', LoadWorld)(world('calibration_board.yaml'))
        with Client() as client:
            self.assertEqual(client.ask('INIT_CALIBRATION'), 'OK poses=4')
            answer = client.ask('PERFORM_CALIBRATION')
            recorded = re.match(r'OK session=(\S+) views=4 skipped=0$', answer)
            self.assertTrue(recorded, answer)
            self.assertTrue(os.path.isdir(recorded.group(1)))
            shutil.rmtree(recorded.group(1))
            rospy.ServiceProxy('/scan_cell_sim/load_world', LoadWorld)(world('reference_frame.yaml'))
            client.ask('SET_POSITION -180,0,595,180,0,0 180,0,595,180,0,0')
            self.start(client)
            self.assertEqual(client.ask('WAIT_SCAN'), 'OK')
            answer = client.ask('STOP_SCAN')
            self.assertIn(' ended=whole ', answer, 'the camera is as it was before')
            os.remove(re.search(r'cloud=(\S+)', answer).group(1))

    def test_positions_end_with_the_connection(self):
        self.prepared().close()
        with Client() as client:
            self.assertIn('no positions', client.ask('START_SCAN'))

    def test_lasers_go_off_where_the_client_hangs_up_behind_megabytes(self):
        for ahead in (b'INIT_CYCLE\n' * 20000, b'A' * 3000000, b'GRAB_IMAGE\n' * 1000):
            client = self.prepared()
            self.start(client)
            self.wait_for(lambda: self.lasers, 'a laser is on')
            client.send_and_hang_up(b'WAIT_SCAN\n' + ahead)
            self.wait_for(lambda: self.lasers == 0, 'the lasers are off behind %d bytes' % len(ahead))
            self.wait_for(lambda: not self.scanning(), 'the scan has ended')
            self.assertIn('cancelled', self.states[-1].message)

    def test_a_line_too_long_ends_the_connection_and_its_scan(self):
        with self.prepared() as client:
            self.start(client)
            self.wait_for(lambda: self.lasers, 'a laser is on')
            self.assertIn('ERROR line too long', client.ask('A' * 1024))
            self.wait_for(lambda: self.lasers == 0, 'the lasers are off')

    def test_of_a_client_that_is_gone_only_what_ends_things_is_carried_out(self):
        self.start_ros_scan()
        self.wait_for(lambda: self.lasers, 'a laser is on')
        with Client() as client:
            client.send_and_close_its_direction(b'GRAB_IMAGE\nRESET\n')
            self.assertIn('ERROR', client.lines.readline(), 'that it is gone, or that a scan runs')
            self.assertEqual(client.lines.readline(), 'OK\n')
        self.wait_for(lambda: self.lasers == 0, 'the lasers are off')

    def test_lasers_go_off_when_the_client_goes(self):
        with self.prepared() as client:
            self.start(client)
            self.wait_for(lambda: self.lasers, 'a laser is on')
        self.wait_for(lambda: self.lasers == 0, 'the lasers are off')
        self.wait_for(lambda: not self.scanning(), 'the scan has ended')

    def test_when_the_node_ends_what_its_client_has_under_way_ends_too(self):  # the last by its name
        with self.prepared() as client:
            self.start(client)
            self.wait_for(lambda: self.lasers, 'a laser is on')
            subprocess.check_call(['rosnode', 'kill', '/videe'])
            self.wait_for(lambda: not self.scanning(), 'the scan has ended')
        self.assertIn('cancelled', self.states[-1].message)


if __name__ == '__main__':
    rostest.rosrun('scan_cell_demo', 'videe_session', Videe)
