# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Folders of runs, made from a drawn part by the suite's own tools: what they report is real."""
import glob
import hashlib
import json
import os
import shutil
import subprocess

import numpy

SCALE, TURN = 1.02, 0.45  # of the object against the reference; [rad] about z
SHIFT = numpy.array([0.31, -0.12, 0.05])  # [m]
DENT, BUMP, WIDE = -0.0012, 0.0012, 0.014  # [m] at their middles, and to 37 % of that
TOLERANCE = 0.0005  # [m]
NAMES = {'part': 'Größe <b id="injected">4</b> & "Co" </script><script>window.injected=1</script>',
         'place': '<img src=x onerror="window.injected=2">', 'segment': '<u>edge</u>'}


def tool(package, name):
    for prefix in os.environ.get('CMAKE_PREFIX_PATH', '').split(os.pathsep):
        path = os.path.join(prefix, 'lib', package, name)
        if os.access(path, os.X_OK):
            return path
    raise FileNotFoundError('%s/%s: not built, or the workspace is not sourced' % (package, name))


def height(x, y):
    """[m] height of the drawn part: ridges that no turn maps onto each other."""
    ridge = 0.006 * numpy.exp(-((x - 0.03) / 0.012) ** 2) + 0.004 * numpy.exp(-((y + 0.02 - x / 3) / 0.008) ** 2)
    return ridge + 0.005 * numpy.exp(-((x + 0.06) ** 2 + (y - 0.04) ** 2) / 0.015 ** 2)


def grid(step):
    """x and y of a plate of 200 x 140 mm with a hole of 36 mm."""
    x, y = numpy.meshgrid(numpy.arange(-0.1, 0.1001, step), numpy.arange(-0.07, 0.0701, step))
    x, y = x.ravel(), y.ravel()
    outside = numpy.hypot(x - 0.055, y - 0.03) > 0.018
    return x[outside], y[outside]


def on_object(points):
    c, s = numpy.cos(TURN), numpy.sin(TURN)
    return SCALE * points @ numpy.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]).T + SHIFT


def reference(step=0.0012):
    x, y = grid(step)
    return numpy.stack([x, y, height(x, y)], axis=1)


def scanned(step=0.001, missing=None, noise=2e-5):
    """The object with a dent and a bump. missing: function (x, y) -> places that the scan does not
    show"""
    x, y = grid(step)
    if missing is not None:
        seen = ~missing(x, y)
        x, y = x[seen], y[seen]
    z = height(x, y) + (DENT * numpy.exp(-((x + 0.07) ** 2 + (y + 0.045) ** 2) / WIDE ** 2)
                        + BUMP * numpy.exp(-((x - 0.08) ** 2 + (y + 0.045) ** 2) / WIDE ** 2)) / SCALE
    z = z + numpy.random.default_rng(1).normal(0, noise, len(z))
    return on_object(numpy.stack([x, y, z], axis=1))


def save_ply(path, points):
    header = ('ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty float x\nproperty float y\n'
              'property float z\nend_header\n' % len(points))
    with open(path, 'wb') as file:
        file.write(header.encode('ascii') + points.astype('<f4').tobytes())


def save_path(path, per_segment):
    """Four lines over the part, and one waypoint before each in the air."""
    with open(path, 'w', encoding='utf-8') as file:
        file.write('x,y,z,qx,qy,qz,qw,segment\n')
        for i, y in enumerate((-0.055, -0.03, -0.005, 0.055)):
            for x in numpy.linspace(-0.085, 0.085, per_segment):
                lift = 0.03 if x < -0.0849 else 0
                file.write('%.6f,%.6f,%.6f,1,0,0,0,%s %d\n' % (x, y, height(x, y) + lift, NAMES['segment'], i))


def sha256(path):
    with open(path, 'rb') as file:
        return hashlib.sha256(file.read()).hexdigest()


class RunMaker:
    """Makes runs below a folder."""

    def __init__(self, folder):
        self.folder = folder

    def make(self, name, object_points=None, per_segment=40, options=(), reference_points=None):
        """A run, as far as the tools get with it. object_points: None makes a run whose cleaning
        failed"""
        run = os.path.join(self.folder, name)
        os.makedirs(os.path.join(run, 'inputs'))
        os.makedirs(os.path.join(run, 'stages'))
        inputs = os.path.join(run, 'inputs')
        save_ply(os.path.join(inputs, 'reference.ply'), reference() if reference_points is None else reference_points)
        save_path(os.path.join(inputs, 'path.csv'), per_segment)
        with open(os.path.join(inputs, 'places.yaml'), 'w', encoding='utf-8') as file:
            json.dump([{'name': NAMES['place'], 'position': [0.08, -0.045, 0], 'radius': 0.005},
                       {'name': 'flat', 'position': [-0.02, 0.05, 0], 'radius': 0.005}], file)
        stages = [{'name': 'clean', 'command': ['clean_cloud'], 'exit_code': 0 if object_points is not None else 1, 'seconds': 0.5}]
        outcome = {'state': 'unusable', 'reason': 'clean_failed', 'message': 'scan.ply: no points <i>left</i>; scan again'}
        if object_points is not None:
            save_ply(os.path.join(run, 'object.ply'), object_points)
            with open(os.path.join(run, 'stages', 'clean.log'), 'w', encoding='utf-8') as file:
                file.write('1000000 points\noutliers: 1000000 -> %d points\n' % len(object_points))
            stages += self._adapt(inputs, options)
            with open(os.path.join(run, 'report.json'), encoding='utf-8') as file:
                report = json.load(file)
            state = {0: 'accepted', 2: 'refused'}.get(stages[1]['exit_code'], 'unusable')
            outcome = {'state': state, 'reason': report['reason'], 'message': report['message']}
        self._record(run, name, stages, outcome)
        return run

    def _adapt(self, inputs, options):
        stretch = self._call('tool_path_stretcher', 'stretch', inputs, [
            '--reference', 'reference.ply', '--object', '../object.ply', '--path', 'path.csv',
            '--output', '../adapted_path.csv', '--report', '../report.json'] + list(options))
        measure = self._call('part_recipes', 'deviations', inputs, [
            '--reference', 'reference.ply', '--object', '../object.ply', '--report', '../report.json', '--places',
            'places.yaml', '--tolerance', str(TOLERANCE), '--output', '../deviation.ply', '--summary', '../deviation.json'])
        return [stretch, measure]

    def _call(self, package, name, folder, arguments):
        with open(os.path.join(folder, '..', 'stages', name + '.log'), 'w', encoding='utf-8') as log:
            code = subprocess.run([tool(package, name)] + arguments, cwd=folder, stdout=log, stderr=log, check=False).returncode
        return {'name': name, 'command': [name] + arguments, 'exit_code': code, 'seconds': 1.25}

    def _record(self, run, name, stages, outcome):
        files = {os.path.relpath(path, run): {'sha256': sha256(path), 'bytes': os.path.getsize(path)}
                 for path in sorted(glob.glob(os.path.join(run, '**'), recursive=True)) if os.path.isfile(path)}
        record = {'format': 1, 'id': '20261125T121314Z_%s_3f2a91' % name,
                  'recipe': {'name': NAMES['part'], 'folder': '/recipes/part', 'sha256': 'ab' * 32},
                  'started': '2026-11-25T12:13:14.123Z', 'ended': '2026-11-25T12:13:17.456Z', 'host': 'cell-7',
                  'version': '0.1.0', 'outcome': outcome, 'stages': stages, 'tolerance': TOLERANCE, 'scan_units': 'm',
                  'figures': {}, 'calibration': {}, 'files': files, 'again_of': None, 'note': ''}
        with open(os.path.join(run, 'run.json'), 'w', encoding='utf-8') as file:
            json.dump(record, file)

    def copy(self, run, name):
        target = os.path.join(self.folder, name)
        shutil.copytree(run, target)
        return target
