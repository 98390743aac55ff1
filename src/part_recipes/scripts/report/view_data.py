# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Data of the rotatable view, packed as base64: places are 16-bit steps of one box, deviations are
16-bit steps."""
import base64

import numpy

from . import colours
from .scene import thin
from .waypoints import IN_AIR, INFERRED, MEASURED, NOT_JUDGED

MOST_OBJECT, MOST_REFERENCE, MOST_RIM, MOST_WAYPOINTS = 200000, 20000, 8000, 20000  # points drawn
STEPS = 32767  # of a 16-bit number
NOT_KNOWN = -32768
STATES = (MEASURED, INFERRED, IN_AIR, NOT_JUDGED)  # by their numbers in layers.js


def packed(values, kind):
    return base64.b64encode(numpy.ascontiguousarray(values, dtype=kind).tobytes()).decode('ascii')


class Box:
    """The cube around everything that is drawn."""

    def __init__(self, clouds):
        filled = [cloud for cloud in clouds if cloud is not None and len(cloud)]
        low = numpy.min([cloud.min(axis=0) for cloud in filled], axis=0) if filled else numpy.zeros(3)
        high = numpy.max([cloud.max(axis=0) for cloud in filled], axis=0) if filled else numpy.ones(3)
        self.middle = (low + high) / 2
        self.half = max(float((high - low).max()) / 2, 1e-6)

    def steps(self, points):
        return packed(numpy.round((points - self.middle) / self.half * STEPS), '<i2')


def spacing_of(points):
    """Spacing [m], as if the points filled the two longest sides of their box."""
    sides = numpy.sort(numpy.ptp(points, axis=0))[1:]
    return float(numpy.sqrt(max(sides.prod(), 1e-12) / len(points)))


def pack(run, scene, rows):
    """Data for view.js; None if there is nothing to draw."""
    shift = scene.shift_of_reference()
    moved = [None if points is None else points + shift for points in (scene.reference_points, scene.reference_path())]
    reference, path = moved
    adapted = scene.adapted_path()
    if scene.object_points is None and reference is None and path is None:
        return None
    box = Box([scene.object_points, reference, path, adapted])
    data = {'middle': box.middle.tolist(), 'half': box.half, 'tolerance': run.tolerance(), 'span': colours.SPAN,
            'colours': packed(colours.table(), 'u1'), 'unknown': colours.UNKNOWN, 'plain': colours.PLAIN,
            'mapped': scene.mapped, 'object': pack_object(run, scene, box), 'marks': None, 'paths': None,
            'reference': None, 'unscanned': None, 'rim': None}
    if reference is not None:
        pack_reference(scene, reference, box, data)
    if scene.deviations is not None:
        indices, kinds = colours.marks(scene.object_points, scene.deviations, run.tolerance(), across=24)
        data['marks'] = {'places': box.steps(scene.object_points[indices]), 'kinds': packed(kinds, 'u1')}
    if path is not None:
        data['paths'] = pack_paths(scene, path, adapted, rows, box)
    return data


def pack_object(run, scene, box):
    if scene.object_points is None:
        return None
    chosen = thin(len(scene.object_points), MOST_OBJECT)
    points = scene.object_points[chosen]
    packed_object = {'places': box.steps(points), 'points': len(chosen), 'of': len(scene.object_points),
                     'spacing': spacing_of(points), 'deviations': None, 'step': None}
    if scene.deviations is not None:
        values = scene.deviations[chosen]
        known = numpy.isfinite(values)
        step = max(float(numpy.abs(values[known]).max(initial=0)), run.tolerance()) / STEPS
        packed_object['step'] = step
        packed_object['deviations'] = packed(numpy.where(known, numpy.round(numpy.nan_to_num(values) / step), NOT_KNOWN), '<i2')
    return packed_object


def pack_reference(scene, reference, box, data):
    def layer(chosen, most):
        points = reference[chosen]
        return {'places': box.steps(points[thin(len(points), most)])} if len(points) else None
    inside = ~scene.rim
    data['reference'] = layer(inside & ~(scene.scanned == 0), MOST_REFERENCE)
    data['unscanned'] = layer(inside & (scene.scanned == 0), MOST_REFERENCE)
    data['rim'] = layer(scene.rim, MOST_RIM)
    data['reference_spacing'] = spacing_of(reference[inside]) if inside.any() else box.half / 100


def pack_line(scene, points, box):
    """A path as floats in units of the box's half side, from its middle, each waypoint with its
    segment."""
    chosen = thin(len(points), MOST_WAYPOINTS)
    segment_of = numpy.array(scene.paths['segment_of'], dtype=int)
    if len(segment_of) != len(points):  # resampled: its segments are not known here
        segment_of = numpy.zeros(len(points), dtype=int)
    return {'places': packed((points[chosen] - box.middle) / box.half, '<f4'),
            'segments': packed(segment_of[chosen], '<u4'), 'numbers': packed(chosen, '<u4')}


def pack_paths(scene, path, adapted, rows, box):
    """Both lines, and the marks of the waypoints on the adapted line or, without one, on the
    other."""
    drawn = path if adapted is None else adapted
    concerned = [row['number'] for row in rows if row['concerned'] and row['number'] < len(drawn)][:MOST_WAYPOINTS]
    states = None
    if len(rows) == len(drawn):
        numbers = numpy.array([STATES.index(row['state']) for row in rows])
        states = packed(numbers[thin(len(drawn), MOST_WAYPOINTS)], 'u1')
    return {'reference': pack_line(scene, path, box), 'adapted': None if adapted is None else pack_line(scene, adapted, box),
            'paired': adapted is not None and len(adapted) == len(path),
            'concerned': packed((drawn[concerned] - box.middle) / box.half, '<f4'), 'states': states}
