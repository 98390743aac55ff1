#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""rviz gets a person's own copy of the settings. A fake rviz records how it was called."""
import os
import resource
import subprocess
import tempfile
import unittest

SCRIPT = os.path.join(os.path.dirname(os.path.realpath(__file__)), '../../scripts/own_rviz.py')
PLAYED = '#!/bin/sh\necho "$@" > "$CALLED"\n'


def text_of(name):
    with open(name, encoding='utf-8') as file:
        return file.read()


def save(name, text):
    with open(name, 'w', encoding='utf-8') as file:
        file.write(text)


class OwnRviz(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.settings, self.called = self.file('cell.rviz'), self.file('called')
        self.own = self.file('home/scan_cell_rviz/cell.rviz')
        save(self.settings, 'as it came\n')
        save(self.file('rosrun'), PLAYED)
        os.chmod(self.file('rosrun'), 0o755)

    def file(self, name):
        return os.path.join(self.folder, name)

    def start(self, *words, **more):
        environment = dict(os.environ, PATH=self.folder + ':' + os.environ['PATH'], CALLED=self.called, ROS_HOME=self.file('home'))
        return subprocess.run([SCRIPT, *words], env=environment, capture_output=True, text=True, check=False, **more)

    def test_are_a_copy_at_first_and_then_stay_the_persons(self):
        started = self.start(self.settings, '__name:=rviz')
        self.assertEqual(started.returncode, 0, started.stderr)
        self.assertEqual(text_of(self.called).split(), ['rviz', 'rviz', '-d', self.own, '__name:=rviz'])
        self.assertEqual(text_of(self.own), 'as it came\n')
        self.assertIn(self.own, started.stdout)
        save(self.own, 'as a person likes it\n')
        self.assertEqual(self.start(self.settings).returncode, 0)
        self.assertEqual(text_of(self.own), 'as a person likes it\n')
        self.assertEqual(text_of(self.settings), 'as it came\n')
        self.assertEqual(os.listdir(os.path.dirname(self.own)), ['cell.rviz'])

    def test_begin_anew_where_the_copy_was_removed(self):
        self.start(self.settings)
        os.remove(self.own)
        save(self.settings, 'as a later version has it\n')
        self.start(self.settings)
        self.assertEqual(text_of(self.own), 'as a later version has it\n')

    def test_begin_anew_where_the_copy_is_empty(self):
        self.start(self.settings)
        save(self.own, '')
        self.start(self.settings)
        self.assertEqual(text_of(self.own), 'as it came\n')

    def test_leave_nothing_behind_where_they_cannot_be_written(self):
        started = self.start(self.settings, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4, 4)))  # [bytes]
        self.assertNotEqual(started.returncode, 0)
        self.assertIn(self.own + ': File too large', started.stderr)
        self.assertEqual(os.listdir(os.path.dirname(self.own)), [])
        self.assertFalse(os.path.exists(self.called))

    def test_say_that_those_that_came_are_newer_than_the_copy(self):
        self.assertNotIn('newer', self.start(self.settings).stdout)
        later = os.path.getmtime(self.own) + 1
        os.utime(self.settings, (later, later))
        self.assertIn(self.settings + ' is newer', self.start(self.settings).stdout)
        os.remove(self.settings)
        self.assertEqual(self.start(self.settings).returncode, 0)

    def test_say_what_is_missing(self):
        started = self.start(self.file('none.rviz'))
        self.assertNotEqual(started.returncode, 0)
        self.assertIn('none.rviz: No such file', started.stderr)
        self.assertFalse(os.path.exists(self.called))
        self.assertEqual(os.listdir(os.path.dirname(self.own)), [])


if __name__ == '__main__':
    unittest.main()
