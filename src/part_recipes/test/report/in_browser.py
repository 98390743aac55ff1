# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of the page: runs that are made once, and one browser. Set REPORT_PAGES to a
folder to keep them."""
import atexit
import functools
import json
import os
import shutil
import subprocess
import tempfile
import unittest

import numpy

import made_runs
from browser import Browser

HERE = os.path.dirname(os.path.realpath(__file__))
SCRIPT = os.path.join(HERE, '../../scripts/report_page.py')
VIEW_IS_DRAWN = 'return typeof reportView !== "undefined" && reportView.frames > 0 && !reportView.waiting'
# Of the view's pixels, except the ground
SUMMED = '''const c = document.getElementById("view"), s = document.createElement("canvas");
    s.width = c.width; s.height = c.height;
    const d = s.getContext("2d"); d.drawImage(c, 0, 0);
    const p = d.getImageData(0, 0, s.width, s.height).data; let hash = 0, lit = 0; const seen = new Set();
    for (let i = 0; i < p.length; i += 4) {
      const rgb = p[i] << 16 | p[i + 1] << 8 | p[i + 2];
      hash = (Math.imul(hash, 31) + rgb) | 0;
      if (rgb !== 0x14171b) { ++lit; seen.add(rgb); }
    }
    return {hash, lit, colours: seen.size};'''


def draw(run, *options):
    """Calls the script. @return exit code and what it said"""
    command = ['/usr/bin/python3', SCRIPT, run, '--tools', os.path.dirname(made_runs.tool('part_recipes', 'report_scene'))]
    done = subprocess.run(command + list(options), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    return done.returncode, done.stdout.decode()


def json_of(run, name):
    with open(os.path.join(run, name), encoding='utf-8') as file:
        return json.load(file)


def page_of(run):
    with open(os.path.join(run, 'report.html'), encoding='utf-8') as file:
        return file.read()


@functools.lru_cache(maxsize=None)
def browser():
    started = Browser()
    atexit.register(started.close)
    return started


@functools.lru_cache(maxsize=None)
def maker():
    kept = os.environ.get('REPORT_PAGES')
    folder = os.path.join(kept or tempfile.mkdtemp(prefix='report_page_'), 'runs')
    shutil.rmtree(folder, ignore_errors=True)
    if not kept:
        atexit.register(shutil.rmtree, os.path.dirname(folder))
    return made_runs.RunMaker(folder)


OBJECTS = {
    'accepted': lambda: made_runs.scanned(missing=lambda x, y: (x < -0.02) & (y > 0.01) & (y < 0.035)),
    'not_scanned': lambda: made_runs.scanned(missing=lambda x, y: numpy.abs(x - 0.02) < 0.02),
    'no_pose': lambda: made_runs.scanned(step=0.02),
    'unusable': lambda: None,
}


@functools.lru_cache(maxsize=None)
def run_of(name):
    """Folder of one of OBJECTS' runs, with its page."""
    run = maker().make(name, OBJECTS[name]())
    code, said = draw(run)
    assert code == 0, said
    return run


class InBrowser(unittest.TestCase):
    def open(self, run):
        browser().open(os.path.join(run, 'report.html'))
        return browser()

    def drawn(self, run):
        """Opens the page and waits until its view is drawn."""
        self.open(run).until(VIEW_IS_DRAWN)
        return browser()

    def settled(self, before):
        """The view after it was redrawn."""
        browser().until('return reportView.frames > %d && !reportView.waiting' % before)
        return browser().run(SUMMED)

    def frames(self):
        return browser().run('return reportView.frames')
