# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The clouds and paths of a run in one frame [m], by the tool report_scene, which knows every format of the suite."""
import json
import os
import subprocess
import tempfile

import numpy
from scan_cell_common.ply import read_vertices


class Scene:
    """What can be drawn; None is not known.

    object_points (n, 3), deviations (n,) with NaN; reference_points, scanned (NaN: not known), rim;
    paths as report_scene writes them; mapped: whether the reference lies where the similarity puts it."""

    def __init__(self, run, tools):
        self.run, self.tools = run, tools
        self.object_points = self.deviations = None
        self.reference_points = self.scanned = self.rim = None
        self.paths = None
        self._load_object()
        has_pose = bool(run.report) and (run.report.get('transform') is not None or bool(run.report.get('candidates')))
        self.mapped = has_pose and self.object_points is not None
        with tempfile.TemporaryDirectory(prefix='report_page_') as folder:
            self._load_reference(os.path.join(folder, 'scene.ply'))
            self._load_paths(os.path.join(folder, 'paths.json'))

    def _load_object(self):
        vertices = self.run.cloud('deviation.ply')
        if vertices is None or 'deviation' not in vertices.dtype.names:
            vertices = self.run.cloud('object.ply')
        if vertices is None:
            return
        self.object_points = points_of(vertices)
        if 'deviation' in vertices.dtype.names:
            self.deviations = vertices['deviation'].astype(float)

    def _call(self, what, output, arguments):
        """Whether the tool wrote its output; if not, the page says why."""
        command = [os.path.join(self.tools, 'report_scene'), what, '--output', output] + arguments
        try:
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        except OSError as error:
            self.run.note('%s not drawn: report_scene cannot be run: %s' % (what, error))
            return False
        if done.returncode != 0:
            lines = done.stdout.decode('utf-8', 'replace').strip().splitlines()
            self.run.note('%s not drawn: %s' % (what, lines[-1] if lines else 'no reason given'))
        return done.returncode == 0

    def _report(self):
        return ['--report', self.run.path('report.json')] if self.mapped else []

    def _load_reference(self, output):
        file, units = self.run.input('reference')
        if file is None:
            return
        arguments = ['--reference', file, '--reference-units', units, '--tolerance', repr(self.run.tolerance())]
        if self.mapped:
            arguments += ['--object', self.run.path('object.ply')] + self._report()
        if not self._call('surface', output, arguments):
            self.mapped = False
            return
        vertices = read_vertices(output)
        self.reference_points = points_of(vertices)
        self.scanned, self.rim = vertices['scanned'].astype(float), vertices['rim'] == 1

    def _load_paths(self, output):
        file, units = self.run.input('path')
        if file is None:
            return
        arguments = ['--path', file, '--path-units', units] + self.run.path_options() + self._report()
        if self.run.adapted():
            arguments += ['--adapted', self.run.adapted()]
        if self._call('paths', output, arguments):
            with open(output, encoding='utf-8') as text:
                self.paths = json.load(text)

    def reference_path(self):
        """(n, 3) where the reference is drawn, or None."""
        if self.paths is None:
            return None
        if self.mapped and self.paths['mapped'] is not None:
            return numpy.array(self.paths['mapped'], dtype=float).reshape(-1, 3)
        return numpy.array(self.paths['reference'], dtype=float).reshape(-1, 3)

    def adapted_path(self):
        """(n, 3) or None"""
        if self.paths is None or self.paths['adapted'] is None:
            return None
        return numpy.array(self.paths['adapted'], dtype=float).reshape(-1, 3)

    def shift_of_reference(self):
        """[m] by which the reference and its path are shifted beside the object if no pose is
        known."""
        if self.mapped or self.object_points is None or self.reference_points is None:
            return numpy.zeros(3)
        low, high = self.object_points.min(axis=0), self.object_points.max(axis=0)
        own_low, own_high = self.reference_points.min(axis=0), self.reference_points.max(axis=0)
        gap = 0.1 * max((high - low).max(), (own_high - own_low).max())
        return numpy.array([high[0] + gap - own_low[0], (low + high)[1] / 2 - (own_low + own_high)[1] / 2,
                            low[2] - own_low[2]])


def points_of(vertices):
    return numpy.stack([vertices[name] for name in 'xyz'], axis=1).astype(float)


def thin(count, most):
    """Indices of at most `most` of `count` points, evenly spread."""
    return numpy.arange(count) if count <= most else numpy.linspace(0, count - 1, most).astype(int)
