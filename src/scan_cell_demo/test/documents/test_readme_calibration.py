#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The calibration of the README, as written, on its own simulated cell."""
import json
import os
import shutil
import tempfile
import unittest

import numpy
import rostest
import yaml

from readme_user import SIMULATOR, User, readme_command

MAX_PLANE_RMS = 0.1  # [mm] held out
MAX_HAND_EYE_ERROR = 0.3  # [mm]


class ReadmeCalibration(unittest.TestCase):
    def test_calibration_finds_the_simulated_scanner_and_can_be_computed_again(self):
        user = User(tempfile.mkdtemp(prefix='readme_'))
        self.addCleanup(shutil.rmtree, user.folder)
        cell = user.start(readme_command('roslaunch launch/calibration.launch sim:=true'), 'cell.log')
        try:
            code = user.run(readme_command('rosrun scan_cell calibrate_cell '), 'calibrate.log')
        finally:
            user.end(cell)
        self.assertEqual(code, 0, user.log('calibrate.log') + user.log('cell.log'))
        in_the_cell = yaml.safe_load(user.text('out/scanner.yaml'))
        with open(os.path.join(SIMULATOR, 'scanner.yaml')) as file:
            truth = yaml.safe_load(file)
        error = numpy.subtract(in_the_cell['flange_to_camera']['translation'], truth['flange_to_camera']['translation'])
        self.assertLess(numpy.linalg.norm(error) * 1e3, MAX_HAND_EYE_ERROR)

        again = user.run(readme_command('rosrun scan_calibration calibrate '), 'again.log')
        self.assertEqual(again, 0, user.log('again.log'))
        self.assertEqual(yaml.safe_load(user.text('out/scanner.yaml')), in_the_cell)
        self.assertIn(b'<html', user.text('out/calibration.html'))
        planes = json.loads(user.text('out/calibration.json'))['laser_plane_rms_mm']
        for laser in ('laser_0', 'laser_1'):
            self.assertLess(planes[laser]['held_out'], MAX_PLANE_RMS)


if __name__ == '__main__':
    rostest.rosrun('scan_cell_demo', 'readme_calibration', ReadmeCalibration)
