#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The commands of docs/your_own_scanner_and_robot.md, as written, on files in other vendors' formats."""
import csv
import json
import os
import shutil
import tempfile
import unittest

import numpy
import rostest
from scan_cell_common.ply import read_points

from readme_user import SIMULATOR, User, commands

PAGE = 'docs/your_own_scanner_and_robot.md'
REFERENCE_WORLD = os.path.join(SIMULATOR, 'reference_frame.yaml')
OBJECT_WORLD = os.path.join(SIMULATOR, 'object_frame.yaml')
MAX_ERROR = 1.0  # [mm] RMS of a waypoint
MAX_ANGLE = 3.0  # [deg] RMS of the tool's axis
SPEED = 0.02


def read_csv(path):
    with open(path, newline='') as file:
        rows = [row for row in csv.reader(file) if row and not row[0].startswith('#')]
    return rows[0], numpy.array([[float(value) for value in row] for row in rows[1:]])


def write_csv(path, header, rows, separator=','):
    with open(path, 'w') as file:
        file.write(separator.join(header) + '\n')
        for row in rows:
            file.write(separator.join('%.9g' % value for value in row) + '\n')


def matrices(quaternions):
    """Rotation matrices of unit quaternions x y z w."""
    x, y, z, w = quaternions.T
    return numpy.stack([1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),
                        2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
                        2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)], axis=1).reshape(-1, 3, 3)


def turn(axis, angles):
    """Rotation matrices about x, y or z."""
    c, s, result = numpy.cos(angles), numpy.sin(angles), numpy.zeros((len(angles), 3, 3))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    result[:, axis, axis], result[:, i, i], result[:, j, j], result[:, i, j], result[:, j, i] = 1, c, c, -s, s
    return result


def kuka(rotations):
    """A, B, C [deg]: R = Rz(A) Ry(B) Rx(C)."""
    return numpy.degrees(numpy.stack([numpy.arctan2(rotations[:, 1, 0], rotations[:, 0, 0]),
                                      numpy.arcsin(numpy.clip(-rotations[:, 2, 0], -1, 1)),
                                      numpy.arctan2(rotations[:, 2, 1], rotations[:, 2, 2])], axis=1))


def from_kuka(angles):
    a, b, c = numpy.radians(angles).T
    return turn(2, a) @ turn(1, b) @ turn(0, c)


def rotation_vectors(quaternions):
    half = numpy.linalg.norm(quaternions[:, :3], axis=1)
    angle = 2 * numpy.arctan2(half, quaternions[:, 3])
    return quaternions[:, :3] * (angle / numpy.maximum(half, 1e-12))[:, None]


def from_rotation_vectors(vectors):
    angle = numpy.linalg.norm(vectors, axis=1)
    axis = vectors / numpy.maximum(angle, 1e-12)[:, None]
    return matrices(numpy.concatenate([axis * numpy.sin(angle / 2)[:, None], numpy.cos(angle / 2)[:, None]], axis=1))


class OwnScanner(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.user = User(tempfile.mkdtemp(prefix='own_scanner_'))
        cls.addClassCleanup(shutil.rmtree, cls.user.folder)
        cls.make_clouds()
        cls.make_paths()
        cls.make_profiles()
        cls.left = commands(PAGE, 'rosrun ')

    @classmethod
    def simulate(cls, words):
        code = cls.user.run('rosrun scan_cell_sim ground_truth ' + words, 'simulate.log')
        assert code == 0, cls.user.log('simulate.log')

    @classmethod
    def make_clouds(cls):
        """A reference in mm, and a scan with the table as CSV in mm."""
        cls.simulate('sample --part frame --world %s --points 60000 --noise 0.03 --output m.ply' % REFERENCE_WORLD)
        reference = read_points(cls.user.path('m.ply')) * 1e3
        with open(cls.user.path('reference.ply'), 'w') as file:
            file.write('ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\n'
                       'property float z\nend_header\n' % len(reference))
            numpy.savetxt(file, reference, fmt='%.4f')
        cls.simulate('sample --world %s --points 150000 --seed 2 --noise 0.03 --output m.ply' % OBJECT_WORLD)
        scan = read_points(cls.user.path('m.ply')) * 1e3
        write_csv(cls.user.path('scan.csv'), ['x [mm]', 'y [mm]', 'z [mm]', 'intensity'],
                  numpy.column_stack([scan, numpy.full(len(scan), 143)]), ';')

    @classmethod
    def make_paths(cls):
        """One path in the formats of four robots, and the truth on the object [m]."""
        cls.simulate('tool_path --part frame --world %s --spacing 4 --output path.csv' % REFERENCE_WORLD)
        cls.simulate('path --part frame --reference %s --object %s --path path.csv --output true.csv' %
                     (REFERENCE_WORLD, OBJECT_WORLD))
        names, table = read_csv(cls.user.path('path.csv'))
        place = table[:, [names.index(name) for name in 'xyz']]
        quaternions = table[:, [names.index(name) for name in ('qx', 'qy', 'qz', 'qw')]]
        rotations, speed = matrices(quaternions), numpy.full((len(table), 1), SPEED)
        write = lambda name, columns, *parts: write_csv(  # noqa: E731
            cls.user.path(name), columns.split(','), numpy.column_stack(parts + (speed,)))
        write('path_kuka.csv', 'x,y,z,a,b,c,speed', place * 1e3, kuka(rotations))
        write('path_abb.csv', 'x,y,z,q1,q2,q3,q4,speed', place * 1e3, quaternions[:, [3, 0, 1, 2]])
        write('path_ur.csv', 'x,y,z,rx,ry,rz,speed', place, rotation_vectors(quaternions))
        write('path_cam.csv', 'x,y,z,i,j,k,speed', place * 1e3, rotations[:, :, 2])
        names, table = read_csv(cls.user.path('true.csv'))
        cls.true_place = table[:, [names.index(name) for name in 'xyz']]
        cls.true_axis = matrices(table[:, [names.index(name) for name in ('qx', 'qy', 'qz', 'qw')]])[:, :, 2]

    @classmethod
    def make_profiles(cls):
        """A box of 80 x 60 x 20 mm on a table, every half millimetre, with holes [mm]."""
        y, x = numpy.mgrid[0:140:0.5, 0:160:0.5]
        z = numpy.where((abs(x - 80) < 40) & (abs(y - 70) < 30), 20.0, 0.0)
        z += numpy.random.default_rng(1).normal(0, 0.02, z.shape)
        z[::7, ::11] = -32.768
        numpy.savetxt(cls.user.path('profiles.csv'), z, fmt='%.3f', delimiter=',')

    def run_next(self, part):
        """The page's first command that contains `part`."""
        command = next(one for one in self.left if part in one)
        self.left.remove(command)
        code = self.user.run(command, 'run.log')
        self.assertEqual(code, 0, command + '\n' + self.user.log('run.log'))
        return self.user.log('run.log')

    def expect_true(self, name, unit, axes_of):
        """Checks for the same columns, unit and convention, and the part's true place."""
        before, _ = read_csv(self.user.path('path_%s.csv' % name))
        names, table = read_csv(self.user.path('adapted_%s.csv' % name))
        self.assertEqual(names, before)
        off = table[:, :3] / unit - self.true_place
        self.assertLess(1e3 * numpy.sqrt((off ** 2).sum(axis=1).mean()), MAX_ERROR, name)
        cosine = (axes_of(table[:, 3:-1]) * self.true_axis).sum(axis=1)
        self.assertLess(numpy.degrees(numpy.sqrt((numpy.arccos(numpy.clip(cosine, -1, 1)) ** 2).mean())), MAX_ANGLE,
                        name)
        self.assertTrue((table[:, -1] == SPEED).all())
        self.assertEqual(json.loads(self.user.text('report_%s.json' % name))['verdict'], 'accepted')

    def test_every_command_of_the_page(self):
        self.run_next('--input scan.csv')
        self.run_next('--input profiles.csv')
        box = read_points(self.user.path('box.ply')) * 1e3
        self.assertTrue((abs(numpy.mean(box, axis=0) - [80, 70, 20]) < 0.5).all(), numpy.mean(box, axis=0))
        self.assertTrue((abs(numpy.ptp(box[:, :2], axis=0) - [80, 60]) < 3).all(), numpy.ptp(box, axis=0))
        for name, unit, axes_of in (('kuka', 1e3, lambda v: from_kuka(v)[:, :, 2]),
                                    ('abb', 1e3, lambda v: matrices(v[:, [1, 2, 3, 0]])[:, :, 2]),
                                    ('ur', 1, lambda v: from_rotation_vectors(v)[:, :, 2]),
                                    ('cam', 1e3, lambda v: v)):
            with self.subTest(name):
                self.assertIn('accepted', self.run_next('--path path_%s.csv' % name))
                self.expect_true(name, unit, axes_of)
        self.run_next('rosrun tool_path_stretcher picture')
        self.assertEqual(self.user.text('picture.png')[1:4], b'PNG')
        self.assertEqual(self.left, [], 'these were not run')


if __name__ == '__main__':
    rostest.rosrun('scan_cell_demo', 'own_scanner', OwnScanner)
