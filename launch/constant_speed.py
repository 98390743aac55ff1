#!/usr/bin/python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""constant_speed.py SETTINGS   stops roslaunch before it starts anything if the binder would calculate poses along a
motion that the settings do not describe. Otherwise prints the binder's method."""
import sys

import yaml

SECTION = 'pose_frame_binder/constant_speed/'
NEEDED = ('start', 'end', 'speed', 'frame_rate')


def names(tree, prefix=''):
    """Full names of the parameters in a nested mapping."""
    if not isinstance(tree, dict):
        return {prefix.strip('/')}
    return {name for key, value in tree.items() for name in names(value, '%s/%s' % (prefix, key))}


def given(path):
    if not path:
        return set()
    with open(path) as settings:
        return names(yaml.safe_load(settings))


def main():
    missing = [name for name in NEEDED if SECTION + name not in given(sys.argv[1])]
    if missing:
        sys.exit('binding constant_speed: the motion is not given: no %s; give settings:=FILE with\n'
                 '  pose_frame_binder: {constant_speed: {start: [x, y, z, qx, qy, qz, qw], end: [...], '
                 'speed: M_PER_S, frame_rate: HZ}}\n'
                 'or use binding:=interpolate' % ', '.join(missing))
    sys.stdout.write('constant_speed')  # the value, without a newline


if __name__ == '__main__':
    try:
        main()
    except (OSError, yaml.YAMLError) as error:
        sys.exit('settings: %s' % error)
