#!/usr/bin/python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws an adapted path: both clouds, both paths, and the error against the ground truth."""

import argparse

import matplotlib

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402 (the backend must be chosen first: there may be no display)
import numpy as np  # noqa: E402
from scan_cell_common.command_line import add_version  # noqa: E402
from scan_cell_common.ply import read_points  # noqa: E402

MAX_POINTS = 15000
MM = 1e3


def read_path(path):
    """Positions [m], one row per waypoint."""
    table = np.genfromtxt(path, delimiter=',', names=True, dtype=None, encoding='utf-8')
    return np.stack([table['x'], table['y'], table['z']], axis=1)


def thin(points):
    return points[:: max(1, len(points) // MAX_POINTS)]


def show_both(axes, reference, object_cloud, path, adapted):
    shift = np.array([0, np.ptp(reference[:, 1]) * 0.6 + np.ptp(object_cloud[:, 1]) * 0.6, 0])
    left, right = thin(reference) * MM, thin(object_cloud + shift) * MM
    axes.scatter(*left.T, s=0.6, c='0.6', linewidths=0)
    axes.scatter(*right.T, s=0.6, c='steelblue', linewidths=0)
    start, end = path * MM, (adapted + shift) * MM
    axes.plot(*start.T, c='black', lw=1.2, label='path on the reference')
    axes.plot(*end.T, c='crimson', lw=1.2, label='adapted path on the object')
    for i in range(0, len(start), max(1, len(start) // 25)):
        axes.plot(*np.stack([start[i], end[i]]).T, c='limegreen', lw=0.6)
    everything = np.vstack([left, right])
    for set_limits, values in zip((axes.set_xlim, axes.set_ylim, axes.set_zlim), everything.T):
        set_limits(values.min(), values.max())
    axes.set_box_aspect(np.ptp(everything, axis=0), zoom=1.05)
    axes.view_init(elev=40, azim=-20)
    axes.set_axis_off()
    axes.legend(loc='upper left', fontsize=8)


def show_top(axes, object_cloud, adapted, truth):
    error = np.linalg.norm(adapted - truth, axis=1) * MM
    cloud = thin(object_cloud) * MM
    axes.scatter(cloud[:, 0], cloud[:, 1], s=0.3, c='0.75', linewidths=0)
    dots = axes.scatter(adapted[:, 0] * MM, adapted[:, 1] * MM, s=7, c=error, cmap='viridis')
    plt.colorbar(dots, ax=axes, label='error of the waypoint [mm]', shrink=0.8)
    axes.set_aspect('equal')
    axes.set_xlabel('x [mm]')
    axes.set_ylabel('y [mm]')
    axes.set_title('adapted path against the ground truth')


def distances_to_line(points, line):
    """Distance of each point from the nearest point of a line [m]."""
    start, step = line[:-1], np.diff(line, axis=0)
    squared = np.maximum((step ** 2).sum(axis=1), 1e-30)
    nearest = []
    for point in points:
        share = np.clip(((point - start) * step).sum(axis=1) / squared, 0, 1)
        nearest.append(np.linalg.norm(start + share[:, None] * step - point, axis=1).min())
    return np.array(nearest)


def show_errors(axes, adapted, truth, traced):
    difference = (adapted - truth) * MM
    axes.plot(np.linalg.norm(difference, axis=1), c='black', lw=1, label='total')
    axes.plot(np.abs(difference[:, 2]), c='crimson', lw=0.8, label='along z')
    if traced is not None:
        axes.plot(distances_to_line(truth, traced) * MM, c='royalblue', lw=1, label="the tool's true tip")
    axes.set_xlabel('waypoint')
    axes.set_ylabel('error [mm]')
    axes.set_ylim(bottom=0)
    axes.legend(fontsize=8)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    add_version(parser)
    for name in ('reference', 'object', 'path', 'adapted', 'truth', 'output'):
        parser.add_argument('--' + name, required=True)
    parser.add_argument('--traced', help="path of the tool's true tip; default: not drawn")
    names = parser.parse_args()
    reference, object_cloud = read_points(names.reference), read_points(names.object)
    path, adapted, truth = (read_path(p) for p in (names.path, names.adapted, names.truth))

    figure = plt.figure(figsize=(14, 6.5))
    grid = figure.add_gridspec(2, 2, width_ratios=[1.5, 1], height_ratios=[2.2, 1])
    show_both(figure.add_subplot(grid[:, 0], projection='3d'), reference, object_cloud, path, adapted)
    show_top(figure.add_subplot(grid[0, 1]), object_cloud, adapted, truth)
    show_errors(figure.add_subplot(grid[1, 1]), adapted, truth, read_path(names.traced) if names.traced else None)
    figure.tight_layout()
    figure.savefig(names.output, dpi=110)


if __name__ == '__main__':
    main()
