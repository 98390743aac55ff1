# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the page says, in a real browser."""
import csv
import math
import os
import sys
import unittest

import numpy

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import made_runs  # noqa: E402 (beside this file)
from in_browser import VIEW_IS_DRAWN, InBrowser, json_of, run_of  # noqa: E402


def quaternions(path):
    """x y z w, a row a waypoint"""
    with open(path, encoding='utf-8', newline='') as file:
        rows = list(csv.DictReader(file))
    return [[float(row[name]) for name in ('qx', 'qy', 'qz', 'qw')] for row in rows]


def matrix(quaternion):
    x, y, z, w = quaternion
    return numpy.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


class Page(InBrowser):
    def test_asks_for_nothing_but_itself_and_has_no_errors(self):
        for run in (run_of('accepted'), run_of('not_scanned'), run_of('no_pose'), run_of('unusable')):
            page = self.open(run)
            page.until('return document.readyState === "complete"')
            if run != run_of('unusable'):
                page.until(VIEW_IS_DRAWN)
            self.assertEqual(page.requests(), ['file://' + os.path.join(run, 'report.html')])
            self.assertEqual(page.errors(), [], run)

    def test_says_verdict_reason_message_and_cure(self):
        page = self.open(run_of('not_scanned'))
        report = json_of(run_of('not_scanned'), 'report.json')
        self.assertEqual(report['reason'], 'path_not_scanned', report['message'])
        self.assertEqual(page.texts('#verdict, #reason, #message'), ['Refused', 'path_not_scanned', report['message']])
        self.assertIn('Scan the region', page.texts('#cure')[0])
        self.assertEqual(self.open(run_of('accepted')).texts('#verdict'), ['Accepted'])
        self.assertEqual(self.open(run_of('unusable')).texts('#verdict, #reason'), ['Unusable', 'clean_failed'])

    def test_texts_of_people_stay_text(self):
        for run in (run_of('accepted'), run_of('unusable')):
            page = self.open(run)
            self.assertEqual(page.texts('h1'), [made_runs.NAMES['part']])
            self.assertIsNone(page.run('return window.injected === undefined ? null : window.injected'))
            self.assertEqual(page.texts('#injected'), [])
        self.assertIn('no points <i>left</i>', page.texts('#message')[0])
        page = self.open(run_of('accepted'))
        self.assertIn(made_runs.NAMES['place'], page.texts('#places th'))
        self.assertEqual(page.texts('#waypoints tbody tr:first-child td:nth-child(2)'), [made_runs.NAMES['segment'] + ' 0'])

    def test_figures_are_those_of_the_report(self):
        millimetres, degrees, percent = 1e3, 180 / math.pi, 100
        factors = {'rms': millimetres, 'largest_displacement': millimetres, 'largest_expected_error_normal': millimetres,
                   'largest_expected_error_tangential': millimetres, 'largest_expected_error_orientation': degrees,
                   'inlier_ratio': percent, 'overlap': percent, 'unscanned_share': percent, 'within_tolerance_share': percent,
                   'median': millimetres, 'min': millimetres, 'max': millimetres, 'reach': millimetres}
        page = self.open(run_of('accepted'))
        shown = page.run('return [...document.querySelectorAll("[data-key]")].map((e) => [e.closest("#adaptation") '
                            '? "report.json" : "deviation.json", e.dataset.key, e.textContent])')
        self.assertGreater(len(shown), 20)
        for file, key, text in shown:
            value = json_of(run_of('accepted'), file)[key]
            if isinstance(value, str):
                self.assertEqual(text, value)
                continue
            number = float(text.replace('−', '-').split()[0])
            expected = value * factors.get(key, 1)
            self.assertAlmostEqual(number, expected, delta=max(6e-4, abs(expected) * 6e-4), msg=key)

    def test_rows_are_the_waypoints_of_the_report(self):
        page = self.open(run_of('accepted'))
        quality = json_of(run_of('accepted'), 'report.json')['quality']
        rows = page.run('return [...document.querySelectorAll("#waypoints tbody tr")].map((r) => [...r.cells].map((c) => c.textContent))')
        self.assertEqual(len(rows), len(quality))
        for row, each in zip(rows, quality):
            self.assertEqual(row[2], 'in the air' if each['in_air'] else 'measured' if each['measured'] else 'inferred')
            for column, key, factor, digits in ((4, 'displacement', 1e3, 3), (6, 'expected_error_normal', 1e3, 3),
                                                (7, 'expected_error_tangential', 1e3, 3),
                                                (8, 'expected_error_orientation', 180 / math.pi, 2)):
                if each[key] is None:
                    self.assertEqual(row[column], '–')
                else:
                    self.assertAlmostEqual(float(row[column]), each[key] * factor, delta=0.51 * 10 ** -digits)

    def test_turns_are_those_beyond_the_turn_of_the_part(self):
        page = self.open(run_of('accepted'))
        rows = page.texts('#waypoints tbody td:nth-child(10)')
        before, after = (quaternions(os.path.join(run_of('accepted'), name)) for name in ('inputs/path.csv', 'adapted_path.csv'))
        part = numpy.array(json_of(run_of('accepted'), 'report.json')['rotation'])
        self.assertEqual(len(rows), len(before))
        for text, given, adapted in zip(rows, before, after):
            between = (part @ matrix(given)).T @ matrix(adapted)
            angle = math.degrees(math.acos(max(-1, min(1, (numpy.trace(between) - 1) / 2))))
            self.assertAlmostEqual(float(text), angle, delta=0.02)

    def test_deviations_are_those_that_were_drawn(self):
        page = self.open(run_of('accepted'))
        cells = page.run('return [...document.querySelectorAll("#places tbody tr")].map((r) => [...r.cells].map((c) => c.textContent))')
        bump = float(cells[0][1].split()[0])
        self.assertAlmostEqual(bump, 1e3 * made_runs.BUMP, delta=0.15)  # its median within 5 mm
        self.assertEqual(cells[0][2], '+ above')
        self.assertAlmostEqual(float(cells[1][1].split()[0]), 0, delta=0.06)
        self.assertEqual(cells[1][2], '• within')

    def test_says_what_was_not_recorded(self):
        page = self.open(run_of('accepted'))
        text = page.run('return document.querySelector("main").innerText')
        self.assertIn('Binding of frames to poses: not recorded', text)
        self.assertIn('Disagreement of passes: not recorded', text)
        self.assertIn('outliers: 1000000 -> ', text)
        page = self.open(run_of('unusable'))
        text = page.run('return document.querySelector("main").innerText')
        for section in ('Deviations', 'Adaptation', 'Waypoints', 'Counts of the cleaning'):
            self.assertIn(section + ': not recorded', text)

    def test_text_can_be_read_in_light_and_dark(self):
        contrast = '''const rgb = (text) => text.match(/[\\d.]+/g).slice(0, 3).map((v) => { v /= 255;
                return v <= 0.03928 ? v / 12.92 : Math.pow((v + 0.055) / 1.055, 2.4); });
            const light = (text) => rgb(text).reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
            const ground = (e) => { const c = getComputedStyle(e).backgroundColor;
                return c.startsWith("rgba") && c.endsWith(", 0)") ? (e.parentElement ? ground(e.parentElement) : "rgb(255,255,255)") : c; };
            return [...document.querySelectorAll("h1, h2, p, th, td, label, button, .stamp, figcaption, pre")]
              .filter((e) => e.offsetParent && e.textContent.trim() && !e.closest(".stage")).map((e) => {
                const a = light(getComputedStyle(e).color), b = light(ground(e));
                return [(Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), e.tagName + " " + e.textContent.slice(0, 40)]; });'''
        grounds = []
        for scheme in ('light', 'dark'):
            page = self.open(run_of('not_scanned'))
            page.emulate(prefers_color_scheme=scheme)
            grounds.append(page.run('return getComputedStyle(document.body).backgroundColor'))
            for ratio, element in page.run(contrast):
                self.assertGreaterEqual(ratio, 4.5, '%s, %s' % (scheme, element))  # WCAG 2.1, 1.4.3
        page.emulate(prefers_color_scheme='light')
        self.assertNotEqual(grounds[0], grounds[1])


if __name__ == '__main__':
    unittest.main()
