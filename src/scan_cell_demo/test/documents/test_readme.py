#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The commands of the README, as written, on their own simulated cell."""
import glob
import json
import os
import shutil
import tempfile
import unittest

import numpy
import rostest

from readme_user import ROOT, SIMULATOR, User, commands, readme_command

OBJECT_WORLD = os.path.join(SIMULATOR, 'object_frame.yaml')
SETTINGS = os.path.join(ROOT, 'src/scan_cell_demo/config/demo.yaml')
MAX_CLOUD_RMS = 0.1  # [mm]
MAX_PATH_RMS = 0.2  # [mm]
MAX_TIP_RMS = 0.3  # [mm]


def positions(path):
    """Waypoints of a CSV path [mm]."""
    table = numpy.genfromtxt(path, delimiter=',', names=True, dtype=None, encoding='utf-8')
    return numpy.stack([table['x'], table['y'], table['z']], axis=1) * 1e3


class Readme(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.user = User(tempfile.mkdtemp(prefix='readme_'))
        cls.addClassCleanup(shutil.rmtree, cls.user.folder)
        cell = cls.user.start(readme_command('roslaunch launch/scan_cell.launch sim:=true') +
                              ' record:=$PWD/out/demo.bag settings:=' + SETTINGS, 'cell.log')
        try:
            cls.codes = {}
            for name, command in (('demo', 'rosrun scan_cell_demo demo --output out'),
                                  ('scan', readme_command('rosrun scan_cell scan ')),
                                  ('adapt', readme_command('rosrun scan_cell adapt ')),
                                  ('new', readme_command('rosrun part_recipes recipe new ')),
                                  ('run', readme_command('rosrun part_recipes run ')),
                                  ('history', readme_command('rosrun part_recipes history list ')),
                                  ('preview', readme_command('rosrun scan_cell preview_work ')),
                                  ('dry', commands('README.md', 'rosrun scan_cell work ')[0]),
                                  ('work', commands('README.md', 'rosrun scan_cell work ')[1])):
                cls.codes[name] = cls.user.run(command, name + '.log')
        finally:
            cls.user.end(cell)

    def expect_well(self, name):
        self.assertEqual(self.codes[name], 0, self.user.log(name + '.log') + self.user.log('cell.log'))

    def expect_true_path(self, *names):
        """The demo saves the simulator's truth of the same object."""
        difference = positions(self.user.path(*names)) - positions(self.user.path('out', 'true_path.csv'))
        self.assertLess(numpy.sqrt((difference ** 2).sum(axis=1).mean()), MAX_PATH_RMS)

    def test_demo_meets_its_goals_on_a_bent_part(self):
        self.expect_well('demo')
        report = json.loads(self.user.text('out/report.json'))
        self.assertEqual(report['verdict'], 'accepted')
        self.assertEqual(report['goals_missed'], [])
        self.assertLess(report['cloud_rms_mm'], MAX_CLOUD_RMS)
        self.assertLess(report['path_rms_mm'], MAX_PATH_RMS)
        self.assertLess(report['tip_rms_mm'], MAX_TIP_RMS)
        self.expect_true_path('out', 'adapted_path.csv')

    def test_scan_leaves_the_raw_and_the_clean_cloud(self):
        self.expect_well('scan')
        self.assertGreater(len(self.user.text('raw.ply')), len(self.user.text('part.ply')))
        judged = self.user.run('rosrun scan_cell_sim ground_truth cloud --part frame --world %s --cloud part.ply '
                               '--json judged.json' % OBJECT_WORLD, 'judge.log')
        self.assertEqual(judged, 0, self.user.log('judge.log'))
        cloud = json.loads(self.user.text('judged.json'))
        self.assertGreater(cloud['points'], 10000)
        self.assertLess(cloud['rms_mm'], MAX_CLOUD_RMS)

    def test_adapt_brings_two_passes_together_and_leaves_a_true_path(self):
        self.expect_well('adapt')
        report = json.loads(self.user.text('out/adapted/report.json'))
        self.assertEqual(report['verdict'], 'accepted')
        self.assertIn([1, 2], [pair['passes'] for pair in report['passes']['overlaps']], 'it is a scan of two passes')
        self.assertEqual(report['passes']['agreement'], 'mended')
        self.expect_true_path('out', 'adapted', 'adapted_path.csv')

    def test_recipe_makes_a_run_with_a_true_path_and_a_report(self):
        for name in ('new', 'run', 'history'):
            self.expect_well(name)
        runs = glob.glob(self.user.path('runs', '2*'))
        self.assertEqual(len(runs), 1)
        self.expect_true_path(runs[0], 'adapted_path.csv')
        self.assertIn(b'DEF frame', self.user.text(os.path.join(runs[0], 'programs', 'frame.src')))
        self.assertGreater(len(self.user.text(os.path.join(runs[0], 'report.html'))), 100000)
        self.assertIn('accepted', self.user.log('history.log'))

    def test_cell_runs_the_path_dry_and_then_really(self):
        self.assertIn('--dry-run', commands('README.md', 'rosrun scan_cell work ')[0])
        self.expect_well('preview')
        self.assertIn('0 faults', self.user.log('preview.log'))
        for name in ('dry', 'work'):
            self.expect_well(name)
            self.assertRegex(self.user.log(name + '.log'), r'(\d+) of \1 waypoints passed')

    def test_stretch_needs_no_master(self):
        code = self.user.run(readme_command('rosrun tool_path_stretcher stretch '), 'stretch.log')
        self.assertEqual(code, 0, self.user.log('stretch.log'))
        self.assertEqual(json.loads(self.user.text('report.json'))['verdict'], 'accepted')
        self.expect_true_path('adapted.csv')
        code = self.user.run(readme_command('rosrun tool_path_programs export_path '), 'export.log')
        self.assertEqual(code, 0, self.user.log('export.log'))
        self.assertIn('read back the same', self.user.log('export.log'))
        self.assertIn(b'DEF part', self.user.text('part.src'))

    def test_replay_gives_the_same_bytes_each_time_it_is_started(self):
        command = readme_command('roslaunch launch/replay.launch ')
        self.assertIn('output:=$PWD/out/replay', command)
        for name in ('first', 'second'):
            self.user.run(command.replace('out/replay', name), name + '.log')
            self.assertTrue(os.path.exists(self.user.path(name, 'adapted_path.csv')), self.user.log(name + '.log'))
        for name in ('object.ply', 'adapted_path.csv'):
            self.assertTrue(self.user.text('first/' + name) == self.user.text('second/' + name), name)
        self.expect_true_path('first', 'adapted_path.csv')


if __name__ == '__main__':
    rostest.rosrun('scan_cell_demo', 'readme', Readme)
