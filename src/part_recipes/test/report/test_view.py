# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The rotatable view, in a real browser that draws in software."""
import os
import sys
import unittest

import numpy

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

import made_runs  # noqa: E402 (beside this file)
from browser import NO_GL, Browser, Keys, pages_of  # noqa: E402
from in_browser import SUMMED, InBrowser, browser, draw, json_of, maker, run_of  # noqa: E402

MOST_BYTES = 4 << 20


class View(InBrowser):
    def test_draws_and_turns_by_keys_and_pointer(self):
        page = self.drawn(run_of('accepted'))
        first = page.run(SUMMED)
        self.assertGreater(first['lit'], 10000)
        self.assertGreater(first['colours'], 100)
        pictures = {first['hash']}
        for key in (Keys.ARROW_LEFT, Keys.ARROW_UP, '+', '-'):
            page.run('document.getElementById("view").focus()')
            before = self.frames()
            page.press(key)
            pictures.add(self.settled(before)['hash'])
        self.assertGreaterEqual(len(pictures), 4)
        before = self.frames()
        page.press(Keys.HOME)
        self.assertEqual(self.settled(before)['hash'], first['hash'])
        before = self.frames()
        page.drag('#view', 120, 40)
        self.assertNotEqual(self.settled(before)['hash'], first['hash'])

    def test_switches_each_layer(self):
        page = self.drawn(run_of('accepted'))
        names = [name.strip() for name in page.texts('#layers label')]
        self.assertEqual(len(names), 9, names)
        for i, name in enumerate(names):
            before, shown = self.frames(), page.run(SUMMED)['hash']
            page.run('document.querySelectorAll("#layers input")[arguments[0]].click()', i)
            self.assertNotEqual(self.settled(before)['hash'], shown, name)

    def test_shows_sign_by_marks_and_by_colours_of_the_tolerance(self):
        data = self.drawn(run_of('accepted')).run('return pageData.view')
        self.assertEqual(data['tolerance'], made_runs.TOLERANCE)
        kinds = browser().run('return [...packed.bytes(pageData.view.marks.kinds)]')
        self.assertGreater(kinds.count(1), 2)  # the bump
        self.assertGreater(kinds.count(2), 2)  # the dent
        self.assertGreater(kinds.count(0), 100)
        places = numpy.array(browser().run('return [...packed.places(pageData.view.marks.places)]')).reshape(-1, 3)
        places = places * data['half'] + data['middle']
        bump = made_runs.on_object(numpy.array([[0.08, -0.045, 0]]))
        off = numpy.linalg.norm((places - bump)[numpy.array(kinds) == 1][:, :2], axis=1)
        self.assertLess(off.max(), 0.02)  # it is above the tolerance within 13 mm, and a cell is 9 mm wide

    def test_marks_the_waypoints_that_the_verdict_names(self):
        page = self.drawn(run_of('not_scanned'))
        named = json_of(run_of('not_scanned'), 'report.json')['waypoints_concerned']
        self.assertGreater(len(named), 3)
        self.assertEqual([int(text) for text in page.texts('#waypoints tr.named td:first-child')], named)
        self.assertTrue(any('verdict names' in name for name in page.texts('#layers label')))
        self.assertEqual(page.run('return packed.numbers(pageData.view.paths.concerned, Float32Array).length'), 3 * len(named))

    def test_without_a_pose_lays_the_reference_beside_the_object(self):
        report = json_of(run_of('no_pose'), 'report.json')
        self.assertIsNone(report['transform'])
        page = self.drawn(run_of('no_pose'))
        self.assertIn('No pose of the part is known', page.run('return document.body.innerText'))
        spans = page.run('return ["object", "reference"].map((name) => { const xs = packed.places(pageData.view[name].places)'
                            '.filter((v, i) => i % 3 === 0); return [Math.min(...xs), Math.max(...xs)]; })')
        self.assertLess(spans[0][1], spans[1][0])

    def test_without_webgl_says_so_and_shows_the_pictures(self):
        page = Browser(NO_GL)
        try:
            page.open(os.path.join(run_of('accepted'), 'report.html'))
            page.until('return document.readyState === "complete"')
            page.until("return !document.getElementById('view-missing').hidden")
            self.assertIn('no WebGL', page.find('#view-missing').text)
            sizes = page.run('return [...document.querySelectorAll(".pictures img")].map((e) => e.naturalWidth)')
            self.assertEqual(len(sizes), 2)
            self.assertGreater(min(sizes), 500)
            self.assertGreater(len(page.texts('#waypoints tbody tr')), 100)
            self.assertFalse([line for line in page.errors() if 'Uncaught' in line])
        finally:
            page.close()

    def test_stays_small_with_200000_points(self):
        run = maker().make('large', made_runs.scanned(step=0.00035), per_segment=300)
        code, said = draw(run)
        self.assertEqual(code, 0, said)
        size = os.path.getsize(os.path.join(run, 'report.html'))
        page = self.drawn(run)
        points = page.run('return [pageData.view.object.points, pageData.view.object.of]')
        self.assertEqual(points[0], 200000)
        self.assertGreater(points[1], 200000)
        self.assertIn('200000 of %d points' % points[1], page.texts('#view-points')[0])
        picture, view = page.run('return [reportView.firstPicture, reportView.firstView]')
        print('200,000 points: %.2f MB, first picture after %.1f s, the view that turns after %.1f s' %
              (size / 1e6, picture / 1e3, view / 1e3))
        self.assertLess(picture, view)
        self.assertFalse(page.find('#poster').is_displayed())
        self.assertLess(size, MOST_BYTES)
        self.assertLessEqual(pages_of(page.pdf()), 4)


if __name__ == '__main__':
    unittest.main()
