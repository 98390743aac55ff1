#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The triangulation node on real topics."""
import io
import os
import struct
import subprocess
import tempfile
import time
import unittest

import rosbag
import rospy
import rostest
from scan_cell_common.ply import read_vertices
from scan_cell_msgs.msg import BoundProfile, ScanRun
from scan_cell_msgs.srv import FinishCloud, StartRun, StartRunRequest, StartScan
from sensor_msgs.msg import PointCloud2

ROWS = 50
FIRST_ROW = 300


def profile(number, laser=0, frame='world', pass_index=0):
    """Every fifth row without a peak; the flange stands at x = number [mm]."""
    bound = BoundProfile()
    bound.header.stamp = rospy.Time(1700000000, number * 1000000)
    bound.header.frame_id = frame
    bound.profile.frame_counter = number
    bound.profile.laser = laser
    bound.pass_index = pass_index
    bound.profile.first_row = FIRST_ROW
    bound.profile.position = [float('nan') if row % 5 == 0 else 520 + row for row in range(ROWS)]
    bound.profile.width = [4] * ROWS
    bound.profile.intensity = [number] * ROWS
    bound.pose.position.x = number / 1000.0
    bound.pose.orientation.w = 1
    return bound


def expected(number):
    """Closed form without distortion, for the plane of test/scanner.yaml."""
    points = []
    for row in range(ROWS):
        if row % 5 == 0:
            continue
        x, y = (520 + row - 500) / 800.0, (FIRST_ROW + row - 400) / 800.0
        depth = -0.2 / (0.8 * x - 0.6)
        points.append((x * depth + number / 1000.0, y * depth, depth + 0.1, number, 0, 0, 4))
    return points


def points_of(cloud):
    return [struct.unpack_from('<ffffBB2xf12x', cloud.data, i * cloud.point_step)
            for i in range(cloud.width)]


def triangulate(folder, *options):
    """From the folder's bound.bag to its cloud.ply."""
    scanner = os.path.dirname(os.path.abspath(__file__)) + '/scanner.yaml'
    return subprocess.run(['rosrun', 'laser_triangulation', 'triangulate', '--scanner', scanner,
                           '--output', folder + '/cloud.ply', '--bag', folder + '/bound.bag',
                           *options], stderr=subprocess.PIPE, timeout=60)


class LaserTriangulationNode(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('test_laser_triangulation_node')
        cls.increments = []
        rospy.Subscriber('/triangulation/cloud', PointCloud2, cls.increments.append)
        cls.publisher = rospy.Publisher('/binder/bound_profiles', BoundProfile, queue_size=10000)
        for name in ('start', 'finish'):
            rospy.wait_for_service('/triangulation/' + name, 30)
        cls.start = rospy.ServiceProxy('/triangulation/start', StartScan)
        cls.finish = rospy.ServiceProxy('/triangulation/finish', FinishCloud)
        end = time.time() + 30
        while cls.publisher.get_num_connections() < 2:
            assert time.time() < end, 'the triangulation does not subscribe'
            time.sleep(0.01)

    def scan(self, profiles, announced=None, timeout=30.0, partial=False):
        self.assertTrue(self.start('scan').success)
        for message in profiles:
            self.publisher.publish(message)
        return self.finish(len(profiles) if announced is None else announced,
                           rospy.Duration(timeout), partial)

    def expect_points(self, points, truth):
        self.assertEqual(len(points), len(truth))
        for point, true in zip(points, truth):
            for value, right in zip(point, true):
                self.assertAlmostEqual(value, right, 6)

    def small_messages(self, scan_id, count, **options):
        """A scan by a node whose messages hold a hundred points."""
        call = {name: rospy.ServiceProxy('/small_messages/' + name, service)
                for name, service in (('start', StartScan), ('finish', FinishCloud))}
        for proxy in call.values():
            proxy.wait_for_service(30)
        self.assertTrue(call['start'](scan_id).success)
        for n in range(count):
            self.publisher.publish(profile(n))
        finish = lambda: call['finish'](count, rospy.Duration(30), False)
        return finish(), finish

    def test_writes_a_cloud_that_is_too_large_for_a_message_into_a_file(self):
        whole = []
        rospy.Subscriber('/small_messages/whole_cloud', PointCloud2, whole.append)
        answer, _ = self.small_messages('part 7/left', 10)
        self.assertTrue(answer.success, answer.message)
        self.assertIn(answer.file, answer.message)
        self.assertTrue(answer.file.startswith('/tmp/part_7_left_'), answer.file)
        self.addCleanup(os.remove, answer.file)
        self.assertEqual(answer.cloud.width, 0)
        self.assertEqual(len(answer.cloud.data), 0)
        self.assertEqual(answer.cloud.header.stamp, profile(9).header.stamp)
        self.expect_points(read_vertices(answer.file).tolist(), [p for n in range(10) for p in expected(n)])
        small, _ = self.small_messages('small', 2)  # comes after the other, had it come
        self.assertEqual(small.file, '')
        self.assertEqual(small.cloud.width, 2 * ROWS * 4 // 5)
        end = time.time() + 30
        while not whole:
            self.assertLess(time.time(), end, 'the small cloud does not come')
            time.sleep(0.01)
        self.assertEqual([c.width for c in whole], [small.cloud.width])

    def test_keeps_the_points_where_the_file_cannot_be_written(self):
        answer, again = self.small_messages('x' * 300, 10)
        self.assertFalse(answer.success)
        self.assertIn('finish again', answer.message)
        self.assertEqual(answer.file, '')
        self.assertEqual(again().statistics.points, 10 * ROWS * 4 // 5)

    def test_gives_the_whole_cloud_in_the_order_of_the_frames(self):
        count = 200
        answer = self.scan([profile(n, frame='moulding') for n in range(count)])
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.cloud.header.frame_id, 'moulding')
        self.assertEqual(answer.cloud.header.stamp, profile(count - 1).header.stamp)
        self.assertEqual([f.name for f in answer.cloud.fields],
                         ['x', 'y', 'z', 'intensity', 'laser', 'pass', 'width', 'vp_x', 'vp_y', 'vp_z'])
        points = points_of(answer.cloud)
        truth = [point for n in range(count) for point in expected(n)]
        self.expect_points(points, truth)
        self.assertEqual(answer.statistics.profiles, count)
        self.assertEqual(answer.statistics.points, len(truth))
        self.assertEqual(answer.statistics.rows_without_peak, count * ROWS // 5)
        whole = rospy.wait_for_message('/triangulation/whole_cloud', PointCloud2, 30)
        self.assertEqual(whole.data, answer.cloud.data)
        end = time.time() + 30
        # Increments of a scan before this one may still come.
        mine = lambda: [c for c in self.increments if c.header.frame_id == 'moulding']
        while sum(c.width for c in mine()) < whole.width:
            self.assertLess(time.time(), end, 'the growing cloud is not whole')
            time.sleep(0.01)
        self.assertEqual(b''.join(c.data for c in mine()), whole.data)

    def test_keeps_the_pass_of_each_point_and_compares_the_passes(self):
        profiles = [profile(n, pass_index=p) for p in (0, 3) for n in range(200)]
        answer = self.scan(profiles)
        self.assertTrue(answer.success, answer.message)
        cloud = answer.cloud
        passes = [cloud.data[i * cloud.point_step + 17] for i in range(cloud.width)]
        self.assertEqual(passes, [0] * (cloud.width // 2) + [3] * (cloud.width // 2))
        overlap, = answer.statistics.overlaps
        self.assertEqual((overlap.pass_one, overlap.pass_other), (0, 3))
        self.assertLess(overlap.most, 1e-6, 'the same places twice')

    def test_refuses_a_run_with_a_laser_that_is_not_calibrated(self):
        check = rospy.ServiceProxy('/triangulation/check_run', StartRun)
        self.assertTrue(check(StartRunRequest(run=ScanRun(lasers=1))).success)
        self.assertTrue(check(StartRunRequest(run=ScanRun(lasers=0))).success, 'pulses in the dark')
        for lasers in (2, 3):
            answer = check(StartRunRequest(run=ScanRun(lasers=lasers)))
            self.assertFalse(answer.success)
            self.assertIn('laser_1: not calibrated', answer.message)

    def test_does_not_take_a_scan_for_whole_in_which_a_laser_stayed_dark_in_a_pass(self):
        dark = [profile(n, pass_index=1) for n in range(5)]
        for bound in dark:
            bound.profile.position = [float('nan')] * ROWS
        lit = [profile(n) for n in range(5)]
        answer = self.scan(lit + dark)
        self.assertFalse(answer.success)
        self.assertIn('pass 2: laser_0 gave no line in 5 profiles', answer.message)
        self.assertEqual(len(points_of(answer.cloud)), 5 * ROWS * 4 // 5, 'what was captured is kept')
        answer = self.scan(lit + dark, partial=True)
        self.assertTrue(answer.success, 'a scan that ended early may have had no time for a line')

    def test_gives_the_same_bytes_for_the_same_profiles(self):
        profiles = [profile(n) for n in range(20)]
        self.assertEqual(self.scan(profiles).cloud.data, self.scan(profiles).cloud.data)

    def test_gives_the_same_points_from_a_bag(self):
        with tempfile.TemporaryDirectory() as folder:
            with rosbag.Bag(folder + '/bound.bag', 'w') as bag:
                for n in range(3):
                    bag.write('/pose_frame_binder/bound_profiles', profile(n))
            run = triangulate(folder)
            self.assertEqual(run.returncode, 0, run.stderr.decode())
            truth = [point for n in range(3) for point in expected(n)]
            self.expect_points(read_vertices(folder + '/cloud.ply').tolist(), truth)
            run = triangulate(folder, '--topic', '/other')
            self.assertEqual(run.returncode, 1)
            self.assertIn('no point', run.stderr.decode())
            for name in ('width', 'intensity', 'range'):
                for old, now in (('least', 'min'), ('most', 'max')):
                    run = triangulate(folder, '--%s-%s' % (old, name), '1')
                    self.assertEqual(run.returncode, 1)
                    self.assertIn('--%s-%s: renamed; use --%s-%s' %
                                  (old, name, now, name), run.stderr.decode())

    def test_exits_with_2_where_the_passes_of_a_bag_disagree_and_leaves_the_cloud(self):
        with tempfile.TemporaryDirectory() as folder:
            for apart, code in ((0, 0), (0.003, 2)):
                with rosbag.Bag(folder + '/bound.bag', 'w') as bag:
                    for n in range(400):
                        bound = profile(n % 200, pass_index=n // 200)
                        bound.pose.position.z += apart * (n // 200)
                        bag.write('/pose_frame_binder/bound_profiles', bound)
                run = triangulate(folder)
                self.assertEqual(run.returncode, code, run.stderr.decode())
                self.assertEqual('the passes disagree' in run.stderr.decode(), code == 2)
                self.assertEqual(len(read_vertices(folder + '/cloud.ply')), 400 * ROWS * 4 // 5)

    def test_names_a_bag_that_is_damaged(self):
        whole = io.BytesIO()
        profile(0).serialize(whole)
        with tempfile.TemporaryDirectory() as folder:
            with rosbag.Bag(folder + '/bound.bag', 'w') as bag:
                bag.write('/pose_frame_binder/bound_profiles', (
                    BoundProfile._type, whole.getvalue()[:40], BoundProfile._md5sum, BoundProfile),
                    raw=True)
            run = triangulate(folder)
            self.assertEqual(run.returncode, 1)
            self.assertIn(folder + '/bound.bag: Buffer Overrun; check', run.stderr.decode())
            self.assertEqual(os.listdir(folder), ['bound.bag'])

    def test_publishes_no_cloud_of_a_scan_that_ended_early(self):
        whole = []
        rospy.Subscriber('/triangulation/whole_cloud', PointCloud2, whole.append)
        answer = self.scan([profile(n) for n in range(3)], partial=True)
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(answer.cloud.width, 3 * ROWS * 4 // 5)
        self.scan([profile(n) for n in range(4)], announced=5, timeout=0.5)
        last = self.scan([profile(n) for n in range(6)])  # comes after the others, had they come
        end = time.time() + 30
        while not any(c.data == last.cloud.data for c in whole):
            self.assertLess(time.time(), end, 'the whole cloud does not come')
            time.sleep(0.01)
        widths = [c.width for c in whole]
        self.assertNotIn(answer.cloud.width, widths)
        self.assertNotIn(4 * ROWS * 4 // 5, widths)

    def test_says_when_profiles_are_missing_and_keeps_what_came(self):
        answer = self.scan([profile(n) for n in range(10)], announced=12, timeout=1.0)
        self.assertFalse(answer.success)
        self.assertIn('only 10 of 12', answer.message)
        self.assertEqual(answer.cloud.width, 10 * ROWS * 4 // 5)

    def test_says_when_there_is_no_point(self):
        answer = self.scan([])
        self.assertFalse(answer.success)
        self.assertIn('no point', answer.message)

    def test_refuses_a_laser_that_the_scanner_model_does_not_have(self):
        answer = self.scan([profile(0, laser=255)], timeout=5.0)
        self.assertFalse(answer.success)
        self.assertIn('laser 255', answer.message)

    def test_refuses_to_start_without_a_scanner_model(self):
        for arguments, words in (([], '/bad_triangulation/scanner: not set'),
                                 (['_scanner:=/no/such.yaml'], '/no/such.yaml: no such file')):
            run = subprocess.run(['rosrun', 'laser_triangulation', 'laser_triangulation_node',
                                  '__name:=bad_triangulation'] + arguments, timeout=60,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.assertEqual(run.returncode, 1)
            self.assertIn(words, run.stdout.decode())


if __name__ == '__main__':
    rostest.rosrun('laser_triangulation', 'laser_triangulation_node', LaserTriangulationNode)
