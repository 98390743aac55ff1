# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The packing and colouring of the page, compared with closed forms; without a browser."""
import base64
import os
import re
import sys
import types
import unittest

import numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), '../../scripts'))

from report import colours, sections, view_data, waypoints, words  # noqa: E402 (found beside the script)

TOLERANCE = 0.0005
# Machado, Oliveira and Fernandes 2009, severity 1, on linear RGB
BLINDNESS = {'protanopia': [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
             'deuteranopia': [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
             'tritanopia': [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]}


def linear(rgb):
    rgb = numpy.asarray(rgb, dtype=float) / 255
    return numpy.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)


def lab(rgb):
    """CIE L*a*b* of linear sRGB."""
    xyz = numpy.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]) @ numpy.clip(rgb, 0, 1)
    f = numpy.where(xyz / [0.9505, 1, 1.089] > 0.008856, numpy.cbrt(xyz / [0.9505, 1, 1.089]), 7.787 * xyz / [0.9505, 1, 1.089] + 16 / 116)
    return numpy.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


class Colours(unittest.TestCase):
    def test_differ_for_each_colour_blindness(self):
        table = colours.table()
        for name, projection in BLINDNESS.items():
            low, tolerated, middle, above, high = (lab(numpy.array(projection) @ linear(table[i])) for i in (0, 64, 128, 191, 255))
            for one, other in ((low, high), (low, middle), (high, middle), (tolerated, above)):
                self.assertGreater(numpy.linalg.norm(one - other), 20, name)  # a difference of 2 can just be seen

    def test_get_darker_to_both_ends_so_that_greys_show_how_much(self):
        light = numpy.array([lab(linear(each))[0] for each in colours.table()])
        self.assertTrue((numpy.diff(light[:128:8]) > 0).all() and (numpy.diff(light[128::8]) < 0).all())

    def test_are_those_of_rviz(self):
        file = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../../scan_cell_common/src/core/colours/colour_scale.cpp')
        with open(file, encoding='utf-8') as text:
            stops = re.findall(r'0x([0-9a-f]{6})', text.read())
        page = [[255 * part for part in colours.MAP(i / (len(stops) - 1))[:3]] for i in range(len(stops))]
        rviz = [[int(stop[i:i + 2], 16) for i in (0, 2, 4)] for stop in stops]
        self.assertEqual(len(rviz), 7)
        self.assertLess(numpy.abs(numpy.array(rviz) - page).max(), 2)  # the map has 256 steps

    def test_marks_tell_the_median_of_each_cell(self):
        x, y = (each.ravel() for each in numpy.meshgrid(numpy.arange(40) * 0.001, numpy.arange(40) * 0.001))
        points = numpy.stack([x, y, numpy.zeros_like(x)], axis=1)
        deviations = numpy.where(x < 0.0095, 0.0006, numpy.where(x < 0.0195, -0.0006, numpy.where(x < 0.0295, 0.0004, numpy.nan)))
        deviations[::7] = 0.05  # loose points
        indices, kinds = colours.marks(points, deviations, TOLERANCE, across=4)
        expected = {0: colours.PLUS, 1: colours.MINUS, 2: colours.WITHIN, 3: colours.NOT_KNOWN}
        self.assertGreaterEqual(len(indices), 16)
        for index, kind in zip(indices, kinds):
            column = min(3, int(points[index, 0] / 0.00975))
            self.assertEqual(kind, expected[column])


class Packed(unittest.TestCase):
    def test_places_come_back_to_half_a_step(self):
        points = numpy.random.default_rng(2).uniform([-0.2, 0.3, 1], [0.2, 0.4, 1.05], (1000, 3))
        box = view_data.Box([points, None])
        steps = numpy.frombuffer(base64.b64decode(box.steps(points)), '<i2').reshape(-1, 3)
        back = steps / view_data.STEPS * box.half + box.middle
        self.assertLessEqual(numpy.abs(back - points).max(), 0.5001 * box.half / view_data.STEPS)
        self.assertLess(box.half / view_data.STEPS, 1e-5)  # [m]

    def test_deviations_keep_their_range_and_what_is_not_known(self):
        points = numpy.random.default_rng(3).uniform(0, 0.1, (5, 3))
        scene = types.SimpleNamespace(object_points=points, deviations=numpy.array([0, numpy.nan, -0.004, 0.0001, 0.002]))
        run = types.SimpleNamespace(tolerance=lambda: TOLERANCE)
        packed = view_data.pack_object(run, scene, view_data.Box([points]))
        steps = numpy.frombuffer(base64.b64decode(packed['deviations']), '<i2')
        self.assertEqual(steps[1], view_data.NOT_KNOWN)
        back = steps * packed['step']
        self.assertLess(numpy.abs(back - scene.deviations)[[0, 2, 3, 4]].max(), 1e-7)

    def test_the_scale_of_colours_does_not_depend_on_the_data(self):
        points = numpy.random.default_rng(4).uniform(0, 0.1, (50, 3))
        run = types.SimpleNamespace(tolerance=lambda: TOLERANCE)
        scales = []
        for largest in (0.0001, 0.02):
            scene = types.SimpleNamespace(
                object_points=points, deviations=numpy.linspace(-largest, largest, 50), reference_points=None, paths=None, mapped=True,
                reference_path=lambda: None, adapted_path=lambda: None, shift_of_reference=lambda: numpy.zeros(3))
            view = view_data.pack(run, scene, [])
            scales.append((view['span'] * view['tolerance'], view['colours']))
        self.assertEqual(scales[0], scales[1])


class Words(unittest.TestCase):
    def test_numbers_are_written_without_powers(self):
        self.assertEqual(words.millimetres(0.0000412345), '0.04123 mm')
        self.assertEqual(words.millimetres(0.0059), '5.900 mm')
        self.assertEqual(words.millimetres(0), '0 mm')
        self.assertEqual(words.millimetres(123.4567), '123457 mm')
        self.assertEqual(words.signed_millimetres(-0.0000004), '-0.000 mm')
        for nothing in (None, float('nan'), float('inf'), 'x', True):
            self.assertEqual(words.millimetres(nothing), words.NOT_RECORDED)

    def test_each_reason_has_a_cure(self):
        for reason in ('accepted', 'unusable_input', 'too_few_points', 'path_off_reference', 'wrong_part', 'ambiguous', 'scale_at_bound',
                       'path_not_scanned', 'tolerance_exceeded', 'cancelled', 'fold_over', 'mirrored_part', 'orientation_uncertain',
                       'position_uncertain'):
            self.assertNotEqual(words.cure_of(reason), 'See the message.')
        self.assertIn('stages/clean.log', words.cure_of('clean_failed'))

    def test_the_cure_is_the_cleaning_where_that_took_the_points(self):
        refused = types.SimpleNamespace(record={'outcome': {'state': 'refused', 'reason': 'path_not_scanned'}}, report={})
        self.assertNotIn('cleaning', sections.verdict(refused)['cure'])
        refused.report = {'cleaned_away': [3, 4]}
        self.assertIn('cleaning', sections.verdict(refused)['cure'])


class Sections(unittest.TestCase):
    def test_tell_how_a_scan_by_the_cell_was_bound_and_how_its_passes_agree(self):
        passes = {'agreement': 'agree', 'message': '<b>0.038 mm</b>', 'corrections': [],
                  'overlaps': [{'passes': [1, 2], 'lasers': [0, 1], 'places': 7922, 'median_mm': 0.0376569, 'within_95_percent_mm': 0.110096}]}
        scan = {'binding': {'pulses': 1200, 'frames': 1198, 'bound': 1195, 'dropped': 3, 'never_arrived': 2, 'worst_position_error_mm': 0.0125,
                            'worst_time_to_pose_ms': 1.5}, 'warnings': ['lamp is <i>old</i>'], 'passes': passes}
        for report in ({'passes': passes}, {}):
            run = types.SimpleNamespace(scan=scan, report=report)
            told = sections.passes(run)
            self.assertEqual((told['agreement'], told['message']), ('agree', '<b>0.038 mm</b>'))
            self.assertEqual(told['overlaps'], [{'passes': '1 and 2', 'places': '7922', 'median': '0.0376569', 'most': '0.110096'}])
        self.assertEqual([value for _, value in sections.binding(run)], ['1200', '1198', '1195', '3', '2', '0.0125000 mm', '1.50000 ms'])
        self.assertEqual(sections.warnings(run), ['lamp is <i>old</i>'])

    def test_of_a_given_cloud_tell_nothing_of_frames(self):
        run = types.SimpleNamespace(scan=None, report=None)
        self.assertEqual((sections.binding(run), sections.passes(run), sections.warnings(run)), ([], None, []))


class Waypoints(unittest.TestCase):
    def rows(self, count, named):
        return [{'number': i, 'segment': '0', 'concerned': i in named, 'state': 'measured', 'seen': '', 'values': [None, None, 1e-3 * i, None, None, None, None]}
                for i in range(count)]

    def test_of_a_long_path_those_that_the_verdict_names_stay(self):
        named = {17, 23456, 39999}
        kept = waypoints.kept(self.rows(40000, named))
        self.assertLessEqual(len(kept), waypoints.MOST)
        self.assertEqual({row['number'] for row in kept if row['concerned']}, named)
        self.assertEqual([row['number'] for row in kept], sorted({row['number'] for row in kept}))

    def test_on_paper_the_named_and_then_the_worst_come_first(self):
        paper = waypoints.on_paper(self.rows(500, {4}))
        self.assertEqual([row['number'] for row in paper[:3]], [4, 499, 498])
        self.assertEqual(len(paper), waypoints.ON_PAPER)

    def test_say_what_hindered_the_scan(self):
        self.assertEqual(waypoints.seen({'sight': 'seen', 'fault': 'none', 'obstacle': None}), 'seen')
        self.assertEqual(waypoints.seen({'sight': 'out_of_range', 'fault': 'not_passed', 'obstacle': None}), 'out of range: not passed')
        self.assertEqual(waypoints.seen({'sight': 3}), '')


if __name__ == '__main__':
    unittest.main()
