# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The script that writes the page: bad folders, and what it must never write."""
import os
import re
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

from in_browser import browser, draw, maker, page_of, run_of  # noqa: E402 (beside this file)


class Script(unittest.TestCase):
    def test_refuses_what_is_no_run_and_leaves_no_page(self):
        run = maker().copy(run_of('unusable'), 'broken')
        for text in ('{"format": 1', '[]', '{"outcome": NaN}', '{"outcome": 5}', '{"outcome": {"state": "refused"}, "stages": [7]}'):
            with open(os.path.join(run, 'run.json'), 'w', encoding='utf-8') as file:
                file.write(text)
            code, said = draw(run)
            self.assertEqual(code, 1)
            self.assertEqual(len(said.strip().splitlines()), 1, said)
            self.assertFalse(os.path.exists(os.path.join(run, 'report.html')))
        os.remove(os.path.join(run, 'run.json'))
        self.assertEqual(draw(run)[0], 1)

    def test_never_takes_the_place_of_another_file(self):
        run = run_of('unusable')
        code, said = draw(run, '--output', os.path.join(run, 'run.json'))
        self.assertEqual(code, 1)
        self.assertIn('end it with .html', said)
        self.assertTrue(os.path.exists(os.path.join(run, 'run.json')))

    def test_says_which_files_cannot_be_read(self):
        run = maker().copy(run_of('accepted'), 'torn')
        for name in ('report.json', 'deviation.ply', os.path.join('inputs', 'path.csv')):
            with open(os.path.join(run, name), 'r+b') as file:
                file.truncate(300)
        code, said = draw(run)
        self.assertEqual(code, 0, said)
        page = page_of(run)
        self.assertIn('report.json cannot be read', page)
        self.assertIn('deviation.ply cannot be read', page)
        self.assertRegex(page, r'paths not drawn: [^<]*path\.csv')

    def test_of_a_run_that_says_next_to_nothing_is_a_page(self):
        run = maker().copy(run_of('unusable'), 'empty')
        for name, text in (('run.json', '{"outcome": {"state": 3}}'), ('report.json', '{"quality": [{}], "waypoints_concerned": [1, "x", null]}'),
                           ('deviation.json', '{"places": [{}], "rms": "x"}'), ('scan.json', '{"binding": {}, "warnings": 4}')):
            with open(os.path.join(run, name), 'w', encoding='utf-8') as file:
                file.write(text)
        code, said = draw(run)
        self.assertEqual(code, 0, said)
        browser().open(os.path.join(run, 'report.html'))
        self.assertEqual(browser().texts('#verdict'), ['Unknown'])
        self.assertEqual(browser().errors(), [])

    def test_writes_the_same_bytes_again(self):
        first = page_of(run_of('accepted'))
        self.assertEqual(draw(run_of('accepted'))[0], 0)
        self.assertEqual(page_of(run_of('accepted')), first)

    def test_needs_no_library_for_the_view_to_tell_the_rest(self):
        run = maker().copy(run_of('accepted'), 'no_three')
        self.assertEqual(draw(run, '--three', '/none/three.min.js')[0], 0)
        browser().open(os.path.join(run, 'report.html'))
        browser().until("return !document.getElementById('view-missing').hidden")
        self.assertIn('three.js', browser().find('#view-missing').text)
        self.assertIn('libjs-three', page_of(run))

    def test_has_no_address_in_it_that_a_browser_would_load(self):
        page = re.sub(r'<script>.*?</script>', '', page_of(run_of('accepted')), flags=re.DOTALL)
        self.assertFalse(re.findall(r'<(?:link|iframe|object|embed)\b', page))
        self.assertFalse([each for each in re.findall(r'<(?:script|img)\b[^>]*\bsrc="([^"]*)"', page) if not each.startswith('data:')])


if __name__ == '__main__':
    unittest.main()
