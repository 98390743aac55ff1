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


def is_there(own):
    """Whether the copy exists. rviz leaves an empty file if it is killed while saving."""
    return os.path.exists(own) and os.path.getsize(own) > 0


def copy_whole(settings, own):
    """Copies the whole file or nothing, and leaves nothing else behind."""
    with open(settings, 'rb') as source, tempfile.TemporaryDirectory(dir=os.path.dirname(own)) as folder:
        copy = os.path.join(folder, 'copy')
        with open(copy, 'wb') as target:
            shutil.copyfileobj(source, target)
        os.rename(copy, own)


def own_copy(settings):
    """Returns the copy below ROS_HOME; makes it if needed."""
    own = os.path.join(rospkg.get_ros_home(), 'scan_cell_rviz', os.path.basename(settings))
    if is_there(own):
        return own
    os.makedirs(os.path.dirname(own), exist_ok=True)
    try:
        copy_whole(settings, own)
    except OSError as error:
        raise error if error.filename else OSError(error.errno, error.strerror, own)
    return own


def is_newer(settings, own):
    """Whether SETTINGS is newer than the copy. False if SETTINGS no longer exists."""
    return os.path.exists(settings) and os.path.getmtime(settings) > os.path.getmtime(own)


def main():
    parser = argparse.ArgumentParser(description=__doc__, allow_abbrev=False)
    parser.add_argument('settings', metavar='SETTINGS', help='such as launch/cell.rviz')
    add_version(parser)
    options, others = parser.parse_known_args()  # the others are rviz's and roslaunch's
    try:
        own = own_copy(options.settings)
    except OSError as error:
        sys.exit('own_rviz.py: %s: %s; give an existing file of settings, and a ROS_HOME that can be written'
                 % (error.filename, error.strerror))
    print('settings of rviz: %s; remove it to start again with %s' % (own, options.settings), flush=True)
    if is_newer(options.settings, own):
        print('own_rviz.py: %s is newer than that copy' % options.settings, flush=True)
    os.execvp('rosrun', ['rosrun', 'rviz', 'rviz', '-d', own] + others)


if __name__ == '__main__':
    main()
