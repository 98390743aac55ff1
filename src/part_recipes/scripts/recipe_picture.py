#!/usr/bin/python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the reference of a recipe and the path on it, so that a person finds the part type."""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402 (the backend is chosen first: there may be no display)
import numpy  # noqa: E402
from scan_cell_common.command_line import add_version  # noqa: E402
from scan_cell_common.ply import read_points  # noqa: E402

MOST = 30000  # points drawn
MM = 1e3


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    add_version(parser)
    parser.add_argument('--reference', required=True)
    parser.add_argument('--reference-units', default='m')
    parser.add_argument('--path', required=True)
    parser.add_argument('--path-units', default='m')
    parser.add_argument('--output', required=True, help='picture: PNG')
    return parser.parse_args()


def read(options, folder):
    """Points of the reference and waypoints of each segment [m], from the tool that knows every
    format."""
    tool = os.path.join(os.path.dirname(os.path.realpath(sys.argv[0])), 'report_scene')
    cloud, path = os.path.join(folder, 'cloud.ply'), os.path.join(folder, 'path.json')
    subprocess.run([tool, 'surface', '--reference', options.reference, '--reference-units', options.reference_units,
                    '--output', cloud], check=True)
    subprocess.run([tool, 'paths', '--path', options.path, '--path-units', options.path_units, '--output', path],
                   check=True)
    with open(path) as file:
        return read_points(cloud), json.load(file)


def segments_of(paths):
    """One array of points [m] per segment."""
    points = numpy.array(paths['reference'], dtype=float).reshape(-1, 3)
    places = numpy.array(paths['segment_of'])
    return [points[places == number] for number in range(len(paths['segments']))]


def draw(points, segments, output):
    figure = plt.figure(figsize=(6, 4.5))
    axes = figure.add_subplot(projection='3d')
    shown = points[:: max(1, len(points) // MOST)] * MM
    axes.scatter(*shown.T, s=0.8, c=shown[:, 2], cmap='Greys_r', linewidths=0, vmax=numpy.max(shown[:, 2]) + 20)
    for segment in segments:
        axes.plot(*(segment * MM).T, c='#c25100', lw=1.4)
    axes.set_box_aspect(numpy.ptp(shown, axis=0) + 1, zoom=1.1)
    axes.view_init(elev=45, azim=-60)
    axes.set_axis_off()
    figure.savefig(output, dpi=100, bbox_inches='tight', format='png')


def main():
    options = arguments()
    with tempfile.TemporaryDirectory(prefix='recipe_picture_') as folder:
        points, paths = read(options, folder)
    draw(points, segments_of(paths), options.output)


if __name__ == '__main__':
    main()
