#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Opens rviz with settings of one's own: a copy of SETTINGS below ROS_HOME (~/.ros), made where there is none yet. What a
person saves in rviz goes there, and SETTINGS stays as it is. To begin anew, remove the copy."""
import argparse
import os
import shutil
import sys
import tempfile

import rospkg
from scan_cell_common.command_line import add_version


def own_copy(settings):
    """The file below ROS_HOME; it is there whole, or not at all."""
    folder = os.path.join(rospkg.get_ros_home(), 'scan_cell_rviz')
    own = os.path.join(folder, os.path.basename(settings))
    if os.path.exists(own):
        return own
    os.makedirs(folder, exist_ok=True)
    with open(settings, 'rb') as source, tempfile.NamedTemporaryFile(dir=folder, delete=False) as copy:
        shutil.copyfileobj(source, copy)
    os.chmod(copy.name, 0o644)
    os.rename(copy.name, own)
    return own


def main():
    parser = argparse.ArgumentParser(description=__doc__, allow_abbrev=False)
    parser.add_argument('settings', metavar='SETTINGS', help='such as launch/cell.rviz')
    add_version(parser)
    options, others = parser.parse_known_args()  # the others are rviz's and roslaunch's
    try:
        own = own_copy(options.settings)
    except OSError as error:
        sys.exit('own_rviz.py: %s: %s; give a file of settings that is there, and a ROS_HOME that can be written'
                 % (error.filename, error.strerror))
    print('settings of rviz: %s; remove it to begin anew with %s' % (own, options.settings), flush=True)
    os.execvp('rosrun', ['rosrun', 'rviz', 'rviz', '-d', own] + others)


if __name__ == '__main__':
    main()
