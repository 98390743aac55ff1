# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The waypoints of a run: what the report says about each, in SI units, and which come first on
paper."""
import numpy

from . import words

MOST = 5000  # rows of a page; with more it would not stay small
ON_PAPER = 32  # rows that fit on half a page of A4
COLUMNS = ('displacement', 'gap', 'expected_error_normal', 'expected_error_tangential', 'expected_error_orientation',
           'turn', 'distance_to_scan')
MEASURED, INFERRED, IN_AIR, NOT_JUDGED = 'measured', 'inferred', 'in the air', 'not judged'


def state_of(quality):
    return IN_AIR if quality.get('in_air') else MEASURED if quality.get('measured') else INFERRED


def number(value):
    """Rounds to seven digits: further ones have no meaning."""
    return float('%.7g' % value) if words.is_number(value) else None


def seen(sighting):
    """Whether the scan could see the waypoint's place, and what hindered it."""
    sight, fault, obstacle = (sighting.get(key) for key in ('sight', 'fault', 'obstacle'))
    if not isinstance(sight, str):
        return ''
    text = sight.replace('_', ' ')
    if isinstance(fault, str) and fault != 'none':
        text += ': ' + fault.replace('_', ' ')
    if isinstance(obstacle, list) and len(obstacle) == 3 and all(words.is_number(each) for each in obstacle):
        text += ', by %.3f %.3f %.3f m' % tuple(obstacle)
    return text


def table(run, scene):
    """Rows of all waypoints: number, segment, state, concerned, seen, then COLUMNS [m, rad, or None]."""
    report = run.report or {}
    qualities = report.get('quality') or []
    concerned = set(run.concerned())
    paths = scene.paths or {}
    segment_of, segments = paths.get('segment_of') or [], paths.get('segments') or []
    turns = paths.get('turns') or []
    sightings = (run.sight or {}).get('best') or []
    judged = bool(qualities or concerned)  # a path of which the report says nothing makes no table
    count = max(len(qualities), len(segment_of) * judged, max(concerned, default=-1) + 1)
    rows = []
    for i in range(count):
        quality = qualities[i] if i < len(qualities) else None
        told = quality or {}
        segment = told.get('segment', segment_of[i] if i < len(segment_of) else None)
        name = segments[segment] if isinstance(segment, int) and segment < len(segments) else None
        edited = told.get('edited') is True
        seen_as = told.get('unedited_waypoint', i)  # numbers of before a person edited the path
        values = dict(told, turn=turns[i] if i < len(turns) else None)
        rows.append({'number': i, 'segment': words.plain(name or segment) + edited * ', edited', 'concerned': i in concerned,
                     'state': state_of(quality) if quality else NOT_JUDGED,
                     'seen': seen(sightings[seen_as]) if isinstance(seen_as, int) and seen_as < len(sightings) else '',
                     'values': [number(values.get(key)) for key in COLUMNS]})
    return rows


def urgency(row):
    """Sort key: first the waypoints that the verdict names, then by expected errors."""
    normal, tangential = row['values'][2], row['values'][3]
    return (not row['concerned'], row['state'] == IN_AIR, -(max(normal or 0, tangential or 0)), row['number'])


def on_paper(rows):
    chosen = sorted(rows, key=urgency)[:ON_PAPER]
    return [{'number': row['number'], 'segment': row['segment'], 'state': row['state'],
             'concerned': row['concerned'], 'seen': row['seen'].split(',')[0], 'values': cells(row['values'])} for row in chosen]


def cells(values):
    """The values in mm and degrees, as the page writes them."""
    factors = [(1e3, 3)] * 4 + [(180 / numpy.pi, 2)] * 2 + [(1e3, 3)]
    return ['–' if value is None else '%.*f' % (digits, value * factor) for value, (factor, digits) in zip(values, factors)]


def kept(rows):
    """At most MOST rows: those that the verdict names, and then evenly along the path."""
    if len(rows) <= MOST:
        return rows
    first = [row for row in rows if row['concerned']][:MOST // 2]
    others = [row for row in rows if not row['concerned']]
    chosen = numpy.linspace(0, len(others) - 1, MOST - len(first)).astype(int) if others else []
    return sorted(first + [others[i] for i in chosen], key=lambda row: row['number'])
