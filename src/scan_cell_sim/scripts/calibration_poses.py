#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Taught poses for calibrating the simulated cell, as a person would teach them: the camera looks at the board from
several distances, tilted every way and turned about its axis, with the board in all parts of the image.

The scanner is taken as it was drawn, not as it is mounted: nobody who teaches knows better.
"""
import argparse

import numpy
import yaml
from scan_cell_common.command_line import add_version

DISTANCES = (0.42, 0.50, 0.60)  # [m] from the camera to where it looks: the range that is scanned
TILTS = (18, 32)  # [deg] off the board's normal, in turn
AZIMUTHS = 8  # directions of the tilt at each distance
ROLLS = (0, 25, -25, 12, -12)  # [deg] about the camera's axis, in turn
AIM = (0.08, 0.03)  # [m] along the board's x and y, at most, from the board's middle to where the camera looks
TURNED = 4  # poses more, with the lines across the board
CAMERA_ON_FLANGE = 0.085  # [m] along z, as drawn


def rotation(axis, degrees):
    angle = numpy.radians(degrees)
    x, y, z = numpy.asarray(axis, float) / numpy.linalg.norm(axis)
    k = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + numpy.sin(angle) * k + (1 - numpy.cos(angle)) * k @ k


def pose(turn, shift):
    result = numpy.eye(4)
    result[:3, :3] = turn
    result[:3, 3] = shift
    return result


def from_yaml(entry):
    x, y, z, w = entry['rotation']
    angle = 2 * numpy.arctan2(numpy.linalg.norm([x, y, z]), w)
    axis = [x, y, z] if angle else [0, 0, 1]
    return pose(rotation(axis, numpy.degrees(angle)), entry['translation'])


def quaternion(turn):
    """x y z w of a rotation matrix, by its eigenvector of the greatest eigenvalue (Bar-Itzhack 2000)."""
    m = turn
    k = numpy.array([[m[0, 0] - m[1, 1] - m[2, 2], 0, 0, 0],
                     [m[0, 1] + m[1, 0], m[1, 1] - m[0, 0] - m[2, 2], 0, 0],
                     [m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], m[2, 2] - m[0, 0] - m[1, 1], 0],
                     [m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], m[0, 0] + m[1, 1] + m[2, 2]]]) / 3
    vector = numpy.linalg.eigh(k)[1][:, -1]
    return vector if vector[3] >= 0 else -vector


def views():
    """Distance, azimuth, tilt, roll [m, deg] and the point looked at [m from the board's
    middle]."""
    count = 0
    for distance in DISTANCES:
        yield distance, 0, 0, ROLLS[count % len(ROLLS)], (0, 0)
        count += 1
        for i in range(AZIMUTHS):
            azimuth = 360 * i / AZIMUTHS
            aim = numpy.radians(azimuth + 135 * (i + 1))
            yield (distance, azimuth, TILTS[i % len(TILTS)], ROLLS[count % len(ROLLS)],
                   (AIM[0] * numpy.cos(aim), AIM[1] * numpy.sin(aim)))
            count += 1
    for i in range(TURNED):
        yield DISTANCES[1], 45 + 90 * i, TILTS[0], 90, (0, 0)


def flange(board, view):
    """Pose of the flange in the frame that `board` is given in; its z is the camera's, its y along the board's."""
    distance, azimuth, tilt, roll, aim = view
    direction = numpy.radians(azimuth)
    axis = (-numpy.sin(direction), numpy.cos(direction), 0)
    turn = rotation(axis, tilt) @ rotation((0, 0, 1), roll)
    camera = pose(turn, numpy.array([*aim, 0]) - distance * turn[:, 2])
    return board @ camera @ pose(numpy.eye(3), (0, 0, -CAMERA_ON_FLANGE))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    add_version(parser)
    parser.add_argument('--world', required=True, help='world file with the board')
    parser.add_argument('--cell', required=True, help='cell file: where the robot stands')
    parser.add_argument('--output', required=True, help='file of taught poses (CSV)')
    options = parser.parse_args()
    with open(options.world) as world, open(options.cell) as cell:
        board = yaml.safe_load(world)['board']
        base = from_yaml(yaml.safe_load(cell)['base_link_in_world'])
    corners = numpy.array(board['inner_corners']) - 1
    middle = pose(numpy.eye(3), [*(corners * board['square_size'] / 2), 0])
    in_base = numpy.linalg.inv(base) @ from_yaml(board['pose']) @ middle
    with open(options.output, 'w') as output:
        output.write('# Taught poses of the flange about the board in the simulated cell, written by\n'
                     '# rosrun scan_cell_sim calibration_poses.py --world calibration_board.yaml --cell cell.yaml\n'
                     'x,y,z,qx,qy,qz,qw\n')
        for view in views():
            taught = flange(in_base, view)
            numbers = [*taught[:3, 3], *quaternion(taught[:3, :3])]
            output.write(','.join('%.6f' % number for number in numbers) + '\n')


if __name__ == '__main__':
    main()
