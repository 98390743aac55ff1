#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Every node and nodelet of the suite ends on SIGTERM and SIGHUP as on Ctrl-C."""
import collections
import glob
import os
import signal
import subprocess
import threading
import time
import unittest
import xml.etree.ElementTree as ElementTree

import rosgraph
import roslib.packages
import rospkg
import rospy
import rostest
from bond.msg import Status
from catkin.find_in_workspaces import find_in_workspaces
from nodelet.srv import NodeletList
from scan_cell_msgs.srv import FinishCloud, StartScan

PACKAGES = rospkg.RosPack()
SOURCES = os.path.join(os.path.dirname(os.path.realpath(__file__)), '../../..')
SIMULATOR = os.path.join(PACKAGES.get_path('scan_cell_sim'), 'config')
SCANNER = os.path.join(SIMULATOR, 'scanner.yaml')
PROGRAM = os.path.join(PACKAGES.get_path('scan_cell'), 'config/scan_line.yaml')
# Required to start.
NODES = {
    ('c4g_driver', 'c4g_driver_node'): ['_address:=127.0.0.1'],
    ('laser_triangulation', 'laser_triangulation_node'): ['_scanner:=' + SCANNER],
    ('laser_trigger', 'laser_trigger_node'): ['_port:=loopback'],
    ('part_recipes', 'part_recipes_node'): [],
    ('pose_frame_binder', 'pose_frame_binder_node'): [],
    ('scan_calibration', 'calibrated_frames_node'): [
        '_scanner_file:=' + SCANNER, '_cell_file:=' + os.path.join(SIMULATOR, 'cell.yaml')],
    ('scan_cell', 'scan_cell_node'): [],
    ('scan_cell', 'videe_node'): ['_program:=' + PROGRAM],
    ('scan_cell_sim', 'scan_cell_sim_node'): [],
    ('tecnogamma_camera', 'tecnogamma_camera_node'): ['_camera:=127.0.0.1'],
    ('tool_path_stretcher', 'tool_path_stretcher_node'): [],
}
NODELETS = {
    'cloud_preprocess/Clean': [],
    'cloud_preprocess/Floor': [],
    'cloud_preprocess/Grid': [],
    'cloud_preprocess/Isolate': [],
    'cloud_preprocess/Outliers': [],
    'laser_triangulation/Triangulation': ['_scanner:=' + SCANNER],
    'pose_frame_binder/Binder': [],
    'tecnogamma_camera/Camera': ['_camera:=127.0.0.1'],
}
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
LOGGERS = ('/get_loggers', '/set_logger_level')
PATIENCE = 60  # [s]
STEADY = 10  # checks of the master: a node that is still registering topics when it ends leaves some there


def built_nodes():
    found = set()
    for description in glob.glob(os.path.join(SOURCES, '*/package.xml')):
        package = os.path.basename(os.path.dirname(description))
        for folder in find_in_workspaces(['libexec'], project=package):
            found.update((package, name) for name in os.listdir(folder)
                         if name.endswith('_node') and not name.startswith(('test_', 'bench_')))
    return found


def declared_nodelets():
    return {element.get('name') for description in glob.glob(os.path.join(SOURCES, '*/nodelets.xml'))
            for element in ElementTree.parse(description).getroot().iter('class')}


def wait_for(condition, what):
    end = time.time() + PATIENCE
    while not condition():
        assert time.time() < end, what
        time.sleep(0.02)


class NodeEndings(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('node_endings', disable_signals=True)

    def setUp(self):
        signal.signal(signal.SIGHUP, signal.SIG_DFL)  # under nohup the nodes would ignore it, too
        self.master = rosgraph.Master('/test_node_endings')
        self.processes = []
        self.started = 0

    def tearDown(self):
        for process in self.processes:
            process.kill()
            process.wait()

    def start(self, package, program, *words):
        """Starts a node under a name of its own, and deletes its parameters after the test."""
        self.started += 1
        name = '/%s_%d' % (self.id().rsplit('.', 1)[-1], self.started)
        path = roslib.packages.find_node(package, program)[0]
        process = subprocess.Popen([path, *words, '__name:=' + name[1:]])
        self.processes.append(process)
        self.addCleanup(subprocess.run, ['rosparam', 'delete', name], stderr=subprocess.DEVNULL,
                        timeout=PATIENCE)
        return process, name

    def offers(self, name):
        """What a node publishes and serves, without what every roscpp node has."""
        published, _, services = self.master.getSystemState()
        return {topic for topic, nodes in published if name in nodes and topic != '/rosout'} | {
            service for service, nodes in services
            if name in nodes and not service.endswith(LOGGERS)}

    def is_known(self, name):
        return any(name in nodes for kind in self.master.getSystemState() for _, nodes in kind)

    def has_loaded(self, manager, nodelet):
        """The manager answers this only after it has loaded the nodelets requested."""
        try:
            return nodelet in rospy.ServiceProxy(manager + '/list', NodeletList)().nodelets
        except rospy.ServiceException:  # not there yet
            return False

    def wait_until_bound(self, manager, count):
        """Waits until the manager and its nodelets' loaders have received each other's messages. If Debian's manager
        ends before, it unloads through objects already destroyed, and crashes on any signal."""
        beats = collections.Counter()
        listener = rospy.Subscriber(manager + '/bond', Status,
                                    lambda status: beats.update([(status.id, status.instance_id)]))

        def is_bound():
            sides = collections.Counter(bond for (bond, _), heard in list(beats.items()) if heard >= 3)
            return list(sides.values()).count(2) == count

        wait_for(is_bound, 'the bonds of %s' % manager)
        listener.unregister()

    def wait_until_it_runs(self, process, name):
        looks = []

        def is_settled():
            looks.append(self.offers(name))
            return len(looks) > STEADY and looks[-1] and looks[-1] == looks[-1 - STEADY]

        wait_for(lambda: is_settled() or process.poll() is not None, '%s starts' % name)
        self.assertIsNone(process.poll(), '%s ended by itself' % name)

    def end(self, process, name, number, what):
        process.send_signal(number)
        what = '%s, signal %d' % (what, number)
        self.assertEqual(process.wait(PATIENCE), 0, what)
        self.assertFalse(self.is_known(name), '%s: still registered at the master' % what)

    def test_none_is_left_out(self):
        self.assertEqual(built_nodes(), set(NODES))
        self.assertEqual(declared_nodelets(), set(NODELETS))

    def test_each_node_ends_cleanly(self):
        for (package, program), words in NODES.items():
            for number in SIGNALS:
                process, name = self.start(package, program, *words)
                self.wait_until_it_runs(process, name)
                self.end(process, name, number, program)

    def test_a_node_ends_cleanly_amid_a_call(self):
        process, name = self.start('laser_triangulation', 'laser_triangulation_node', '_scanner:=' + SCANNER)
        self.wait_until_it_runs(process, name)
        start, finish = rospy.ServiceProxy(name + '/start', StartScan), rospy.ServiceProxy(name + '/finish', FinishCloud)

        def wait_in_vain():
            try:
                finish(profiles=1, timeout=rospy.Duration(2))
            except rospy.ServiceException:  # the node has ended
                pass

        self.assertTrue(start(scan_id='amid a call').success)
        call = threading.Thread(target=wait_in_vain)
        call.start()
        wait_for(lambda: not start(scan_id='amid a call').success, 'the call has begun')
        self.end(process, name, signal.SIGTERM, 'laser_triangulation_node')
        call.join()

    def test_each_nodelet_on_its_own_ends_cleanly(self):
        for nodelet, words in NODELETS.items():
            for number in SIGNALS:
                process, name = self.start('nodelet', 'nodelet', 'standalone', nodelet, *words)
                self.wait_until_it_runs(process, name)
                self.end(process, name, number, nodelet)

    def test_a_manager_with_all_of_them_ends_cleanly(self):
        for number in SIGNALS:
            manager, name = self.start('nodelet', 'nodelet', 'manager')
            for nodelet, words in NODELETS.items():
                _, loaded = self.start('nodelet', 'nodelet', 'load', nodelet, name, *words)
                wait_for(lambda: self.has_loaded(name, loaded) or manager.poll() is not None,
                         '%s is loaded' % nodelet)
            self.wait_until_bound(name, len(NODELETS))
            self.end(manager, name, number, 'manager')

    def test_a_manager_ends_cleanly_when_its_nodelets_are_unloaded(self):
        manager, name = self.start('nodelet', 'nodelet', 'manager')
        self.wait_until_it_runs(manager, name)
        before = self.offers(name)
        loader, nodelet = self.start('nodelet', 'nodelet', 'load', 'cloud_preprocess/Floor', name)
        wait_for(lambda: nodelet + '/output' in self.offers(name), 'the nodelet is loaded')
        loader.send_signal(signal.SIGINT)  # it makes the manager unload the nodelet
        wait_for(lambda: nodelet + '/output' not in self.offers(name), 'the nodelet is unloaded')
        self.assertTrue(before <= self.offers(name))
        self.end(manager, name, signal.SIGTERM, 'manager')


if __name__ == '__main__':
    rostest.rosrun('scan_cell_demo', 'node_endings', NodeEndings)
