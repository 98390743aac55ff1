# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The table of waypoints in a real browser, and the page on paper."""
import json
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import made_runs  # noqa: E402 (beside this file)
from browser import Keys, pages_of  # noqa: E402
from in_browser import InBrowser, browser, draw, json_of, maker, run_of  # noqa: E402


class Table(InBrowser):
    def shown(self, column):
        return browser().texts('#waypoints tbody td:nth-child(%d)' % (column + 1))

    def numbers(self, column):
        return [float(text) for text in self.shown(column) if text != '–']

    def test_sorts_by_mouse_and_keys(self):
        page = self.open(run_of('accepted'))
        shift, number = 4, 0
        page.find('#waypoints button[data-column="4"]').click()
        self.assertEqual(self.numbers(shift), sorted(self.numbers(shift), reverse=True))
        self.assertEqual(page.run('return document.querySelectorAll("#waypoints th")[4].getAttribute("aria-sort")'), 'descending')
        page.run('document.querySelector("#waypoints button[data-column=\\"4\\"]").focus()')
        page.press(Keys.ENTER)
        self.assertEqual(self.numbers(shift), sorted(self.numbers(shift)))
        self.assertGreater(len(set(self.shown(shift))), 5)
        page.find('#waypoints button[data-column="0"]').click()
        self.assertEqual(self.numbers(number), [float(i) for i in range(len(self.shown(number)))])

    def test_filters(self):
        page = self.open(run_of('accepted'))
        quality = json_of(run_of('accepted'), 'report.json')['quality']
        air = [i for i, each in enumerate(quality) if each['in_air']]
        self.assertTrue(air)
        page.find('#filter-state').send_keys('in the air')
        self.assertEqual(self.shown(0), [str(i) for i in air])
        self.assertEqual(page.texts('#row-count'), ['%d of %d waypoints' % (len(air), len(quality))])
        page.find('#filters button').click()
        page.until('return document.querySelectorAll("#waypoints tbody tr").length === %d' % len(quality))
        page.find('#filter-segment').send_keys('EDGE</u> 2')
        self.assertEqual(set(self.shown(1)), {made_runs.NAMES['segment'] + ' 2'})
        page.find('#filter-segment').clear()
        limit = sorted(each['displacement'] for each in quality)[len(quality) // 2] * 1e3
        page.find('#filter-shift').send_keys('%.4f' % limit)
        self.assertAlmostEqual(len(self.shown(0)), len(quality) / 2, delta=3)

    def test_says_what_the_scan_could_see(self):
        run = maker().copy(run_of('accepted'), 'with_sight')
        count = len(json_of(run, 'report.json')['quality'])
        best = [{'sight': 'seen', 'fault': 'none', 'obstacle': None} for _ in range(count)]
        best[1] = {'sight': 'shadowed', 'fault': 'light', 'obstacle': [0.1, -0.2, 0.3]}
        with open(os.path.join(run, 'sight.json'), 'w', encoding='utf-8') as file:
            json.dump({'waypoints': count, 'seen': count - 1, 'best': best}, file)
        code, said = draw(run)
        self.assertEqual(code, 0, said)
        page = self.open(run)
        last = len(page.texts('#waypoints thead th')) - 1
        self.assertEqual(self.shown(last)[:3], ['seen', 'shadowed: light, by 0.100 -0.200 0.300 m', 'seen'])
        self.assertIn('%d of %d waypoints seen' % (count - 1, count), page.run('return document.querySelector("main").innerText'))
        page.find('#waypoints button[data-column="%d"]' % last).click()
        self.assertEqual(self.shown(0)[0], '1')
        self.assertIn(pages_of(page.pdf()), (1, 2, 3, 4))

    def test_goes_from_row_to_row_by_keys_and_shows_the_waypoint(self):
        page = self.drawn(run_of('accepted'))
        page.run('document.querySelector("#waypoints tbody tr").focus()')
        before = self.frames()
        page.press(Keys.ARROW_DOWN)
        self.assertEqual(page.run('return document.activeElement.dataset.number'), '1')
        one = self.settled(before)['hash']
        before = self.frames()
        page.press(Keys.END)
        self.assertNotEqual(self.settled(before)['hash'], one)

    def test_everything_is_reached_by_tab(self):
        page = self.drawn(run_of('accepted'))
        reached, last = set(), 60
        for _ in range(last):
            page.press(Keys.TAB)
            reached.add(page.run('const e = document.activeElement; return e.id || e.tagName + (e.dataset.column || e.textContent.trim() || (e.parentElement || e).textContent.trim())'))
        for wanted in ('view', 'BUTTONTop', 'filter-state', 'filter-segment', 'BUTTON4'):
            self.assertTrue(any(wanted == each for each in reached), (wanted, reached))
        self.assertGreaterEqual(len([each for each in reached if each.startswith('INPUT')]), 9)


class Paper(InBrowser):
    def test_takes_at_most_four_pages(self):
        for run in (run_of('accepted'), run_of('not_scanned'), run_of('no_pose'), run_of('unusable')):
            count = pages_of(self.open(run).pdf())
            print('%s: %d pages' % (os.path.basename(run), count))
            self.assertIn(count, (1, 2, 3, 4), run)

    def test_takes_no_more_with_long_texts_and_many_of_everything(self):
        run = maker().copy(run_of('accepted'), 'long')
        record = json_of(run, 'run.json')
        record['note'] = record['outcome']['message'] = 'a long story, ' * 900
        record['recipe']['name'] = 'x' * 700
        record['stages'] = record['stages'] * 40
        record['files'].update({'programs/%s_%d.pdl' % ('long' * 20, i): {'sha256': 'c' * 64, 'bytes': i} for i in range(90)})
        with open(os.path.join(run, 'run.json'), 'w', encoding='utf-8') as file:
            json.dump(record, file)
        summary = json_of(run, 'deviation.json')
        summary['places'] = [dict(summary['places'][0], name='place %d %s' % (i, 'y' * 80)) for i in range(90)]
        with open(os.path.join(run, 'deviation.json'), 'w', encoding='utf-8') as file:
            json.dump(summary, file)
        with open(os.path.join(run, 'stages', 'clean.log'), 'w', encoding='utf-8') as file:
            file.write('a stage that says something\n' * 500)
        code, said = draw(run)
        self.assertEqual(code, 0, said)
        self.assertLessEqual(pages_of(self.open(run).pdf()), 4)


if __name__ == '__main__':
    unittest.main()
