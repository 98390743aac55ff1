# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The contents of a run's folder. Only run.json is required: a missing file is None, a broken one
is None and noted."""
import glob
import json
import os

import numpy
from scan_cell_common.ply import read_vertices

# Options of stretch for what a path's file does not say about itself
PATH_OPTIONS = ('--euler', '--process-values', '--rotation-vector', '--degrees', '--radians', '--program-files', '--no-motion',
                '--dialect', '--program-in-base')

# Required kinds of entries that are present; numbers and texts may be anything, and are shown as
# such
SHAPES = {'run.json': {'outcome': dict, 'recipe': dict, 'stages': list, 'files': dict, 'calibration': dict},
          'report.json': {'quality': list, 'files': dict, 'waypoints_concerned': list, 'candidates': list, 'passes': dict},
          'deviation.json': {'places': list}, 'scan.json': {'binding': dict, 'passes': dict}, 'sight.json': {'best': list}}
LISTS_OF_RECORDS = ('stages', 'quality', 'places', 'best')


class UnusableRun(Exception):
    """The folder is no run: the thing, the value and the cure."""


def without_nan(text):
    """JSON knows no NaN; Python's reader does."""
    raise ValueError('%s is not a JSON number' % text)


def wrong_in(name, value):
    """What is of the wrong kind, in words, or None."""
    if not isinstance(value, dict):
        return 'is not a JSON object'
    for key, kind in SHAPES[name].items():
        part = value.get(key)
        if part is not None and not isinstance(part, kind):
            return '%s has the wrong type' % key
        if key in LISTS_OF_RECORDS and not all(isinstance(each, dict) for each in part or []):
            return '%s has an entry that is not a JSON object' % key
    return None


class RunFolder:
    def __init__(self, folder):
        self.folder = folder
        self.notes = []  # for the reader of the page: what could not be shown, and why
        try:
            with open(self.path('run.json'), encoding='utf-8') as file:
                self.record = json.load(file, parse_constant=without_nan)
        except FileNotFoundError:
            raise UnusableRun('%s: no run.json; give the folder of a run' % folder) from None
        except (ValueError, UnicodeDecodeError) as error:
            raise UnusableRun('%s: %s; give the folder of a run that was not changed'
                              % (self.path('run.json'), error)) from None
        wrong = wrong_in('run.json', self.record) or (None if self.record.get('outcome') else 'has no outcome')
        if wrong:
            raise UnusableRun('%s: %s; give the folder of a run' % (self.path('run.json'), wrong))
        self.report = self._json('report.json')
        self.deviation = self._json('deviation.json')
        self.scan = self._json('scan.json')
        self.sight = self._json('sight.json')

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def has(self, *names):
        return os.path.isfile(self.path(*names))

    def note(self, text):
        self.notes.append(text)

    def _json(self, name):
        if not self.has(name):
            return None
        try:
            with open(self.path(name), encoding='utf-8') as file:
                value = json.load(file, parse_constant=without_nan)
        except (OSError, ValueError) as error:
            self.note('%s cannot be read: %s' % (name, error))
            return None
        wrong = wrong_in(name, value)
        if wrong:
            self.note('%s cannot be read: %s' % (name, wrong))
        return None if wrong else value

    def cloud(self, name):
        """The vertices of a PLY file, or None."""
        if not self.has(name):
            return None
        try:
            vertices = read_vertices(self.path(name))
            finite = numpy.isfinite(vertices['x']) & numpy.isfinite(vertices['y']) & numpy.isfinite(vertices['z'])
            return vertices[finite] if finite.any() else None
        except (OSError, ValueError, KeyError, IndexError) as error:
            self.note('%s cannot be read: %s' % (name, error))
            return None

    def log(self, stage):
        """Lines that a stage printed, or None."""
        try:
            with open(self.path('stages', stage + '.log'), encoding='utf-8', errors='replace') as file:
                return [line.rstrip() for line in file if line.strip()]
        except OSError:
            return None

    def tolerance(self):
        """[m], above 0"""
        value = (self.deviation or {}).get('tolerance') or self.record.get('tolerance')
        return value if isinstance(value, (int, float)) and value > 0 else 0.0005

    def concerned(self):
        """Numbers of the waypoints that the verdict names."""
        return [i for i in (self.report or {}).get('waypoints_concerned') or [] if isinstance(i, int) and i >= 0]

    def _stretch_command(self):
        for stage in self.record.get('stages') or []:
            if stage.get('name') == 'stretch':
                return stage.get('command') or []
        return []

    def input(self, role):
        """(file, units) of 'reference' or 'path': from the call of stretch, else from its report,
        else from the file's name; (None, None) if there is none."""
        command = self._stretch_command()
        reported = ((self.report or {}).get('files') or {}).get(role) or {}
        names = [after(command, '--' + role), reported.get('name')]
        names += [os.path.basename(name) for name in sorted(glob.glob(self.path('inputs', role + '.*')))]
        units = after(command, '--%s-units' % role) or after(command, '--units') or reported.get('units') or 'm'
        for name in names:
            if name and not os.path.isabs(name) and self.has('inputs', name):
                return self.path('inputs', name), units
        return None, None

    def adapted(self):
        """File of the adapted path, or None. Further files may lie beside a program: the path has
        the extension of its input."""
        found = sorted(glob.glob(self.path('adapted_path.*')))
        extension = os.path.splitext(self.input('path')[0] or '')[1].lower()
        return next((file for file in found if file.lower().endswith(extension)), None)

    def path_options(self):
        """Options for the path's file in the call of stretch."""
        options, taken = [], False
        for word in self._stretch_command():
            if word.startswith('--'):
                taken = word in PATH_OPTIONS
            if taken:
                options.append(word)
        return options


def after(command, option):
    """The value of an option, or None."""
    return command[command.index(option) + 1] if option in command[:-1] else None
