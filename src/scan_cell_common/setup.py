# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
from setuptools import setup

from catkin_pkg.python_setup import generate_distutils_setup

setup(**generate_distutils_setup(packages=['scan_cell_common'], package_dir={'': 'python'}))
