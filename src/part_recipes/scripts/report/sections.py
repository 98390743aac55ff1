# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The page's tables: rows of (what it is, value in words), from what the run recorded."""
import datetime

from . import words


def verdict(run):
    outcome = run.record.get('outcome') or {}
    report = run.report or {}
    state = outcome.get('state')
    meaning_known = isinstance(state, str) and state in words.VERDICTS
    name, mark, meaning = words.VERDICTS.get(state if meaning_known else None, ('Unknown', '?', 'The run does not say how it ended.'))
    reason = outcome.get('reason') or report.get('reason')
    return {'state': state if meaning_known else 'unusable', 'name': name, 'mark': mark, 'meaning': meaning,
            'reason': words.plain(reason), 'message': words.plain(outcome.get('message') or report.get('message')),
            'cure': words.cure_of(reason, report.get('cleaned_away'))}


def identity(run):
    record = run.record
    recipe = record.get('recipe') or {}
    rows = [('Part (recipe)', words.plain(recipe.get('name'))), ('Run', words.plain(record.get('id'))),
            ('Started', words.moment(record.get('started'))), ('Duration', duration(record)),
            ('Host', words.plain(record.get('host'))), ('Version of the suite', words.plain(record.get('version'))),
            ("SHA-256 of the recipe's files", words.plain(recipe.get('sha256'))),
            ('Tolerance', '± ' + words.millimetres(run.tolerance()))]
    if record.get('again_of'):
        rows.append(('Repeats the run', words.plain(record['again_of'])))
    if record.get('note'):
        rows.append(('Note', words.plain(record['note'])))
    return rows


def duration(record):
    try:
        start, end = (datetime.datetime.fromisoformat(record[key].replace('Z', '+00:00')) for key in ('started', 'ended'))
    except (KeyError, ValueError, AttributeError):
        return words.NOT_RECORDED
    return words.seconds((end - start).total_seconds())


def adaptation(run):
    """Rows from the stretcher's report."""
    report = run.report
    if report is None:
        return []
    figures = [('Scale', 'scale', words.plain), ('RMS of the object from the aligned reference', 'rms', words.millimetres),
               ('Share of the object that the reference explains', 'inlier_ratio', words.percent),
               ('Share of the reference that the object covers', 'overlap', words.percent),
               ('Nodes of the deformation (0: none was justified)', 'deformation_nodes', words.plain),
               ('Waypoints measured', 'measured_waypoints', words.plain),
               ('Waypoints inferred over holes', 'inferred_waypoints', words.plain),
               ('Waypoints in the air', 'waypoints_in_air', words.plain),
               ('Largest displacement', 'largest_displacement', words.millimetres),
               ('Largest expected error along the normal', 'largest_expected_error_normal', words.millimetres),
               ('Largest expected error along the surface', 'largest_expected_error_tangential', words.millimetres),
               ('Largest expected error of the orientation', 'largest_expected_error_orientation', words.degrees)]
    rows = [(name, key, write(report.get(key))) for name, key, write in figures]
    rows.append(('Method', 'method', words.plain(report.get('method'))))
    return rows


def deviations(run):
    """Rows from deviation.json."""
    summary = run.deviation
    if summary is None:
        return []
    figures = [('Points', 'points', words.plain), ('of which with no surface near', 'unknown_points', words.plain),
               ('RMS', 'rms', words.millimetres), ('Median', 'median', words.signed_millimetres),
               ('Smallest', 'min', words.signed_millimetres), ('Largest', 'max', words.signed_millimetres),
               ('Within the tolerance', 'within_tolerance_share', words.percent),
               ('Share of the reference that was not scanned', 'unscanned_share', words.percent),
               ('Outside known from', 'outside_known_by', words.plain),
               ('Largest distance at which a surface is near', 'reach', words.millimetres)]
    return [(name, key, write(summary.get(key))) for name, key, write in figures]


def places(run):
    """Name, deviation, its judgement in a word, and points."""
    rows = []
    tolerance = run.tolerance()
    for place in (run.deviation or {}).get('places') or []:
        value = place.get('deviation')
        if not words.is_number(value):
            judgement = 'too few points'
        elif abs(value) <= tolerance:
            judgement = '• within'
        else:
            judgement = '+ above' if value > 0 else '− below'
        rows.append({'name': words.plain(place.get('name')), 'deviation': words.signed_millimetres(value),
                     'judgement': judgement, 'points': words.plain(place.get('points'))})
    return rows


def binding(run):
    """Figures of the binding of frames to poses."""
    counts = (run.scan or {}).get('binding')
    if not isinstance(counts, dict):
        return []
    return [(name, words.plain(counts.get(key)) + unit) for name, key, unit in (
        ('Pulses of the trigger', 'pulses', ''), ('Frames', 'frames', ''), ('Frames bound to a pose', 'bound', ''),
        ('Frames dropped', 'dropped', ''), ('Frames that never arrived', 'never_arrived', ''),
        ('Worst error of a position', 'worst_position_error_mm', ' mm'),
        ('Longest time to a pose', 'worst_time_to_pose_ms', ' ms'))]


def sight(run):
    """What the scan could see, in words; None if that was not checked."""
    if run.sight is None:
        return None
    said = run.log('sight') or []
    return words.plain(said[-1] if said else '%s of %s waypoints seen' % (run.sight.get('seen'), run.sight.get('waypoints')))


def passes(run):
    """Overlaps of passes, and their disagreement there."""
    told = (run.report or {}).get('passes') or (run.scan or {}).get('passes')
    if not isinstance(told, dict):
        return None
    overlaps = [{'passes': ' and '.join(words.plain(each) for each in pair.get('passes') or []),
                 'places': words.plain(pair.get('places')), 'median': words.plain(pair.get('median_mm')),
                 'most': words.plain(pair.get('within_95_percent_mm'))} for pair in told.get('overlaps') or []]
    return {'agreement': words.plain(told.get('agreement')), 'message': words.plain(told.get('message')),
            'overlaps': overlaps}


def edits(run):
    """What a person changed by hand, in words."""
    told = (run.report or {}).get('edits')
    done = told.get('done') if isinstance(told, dict) else None
    return [words.plain(each) for each in done] if isinstance(done, list) else []


def warnings(run):
    told = (run.scan or {}).get('warnings')
    return [words.plain(each) for each in (told if isinstance(told, list) else [told] if told else [])]


def stages(run):
    return [{'name': words.plain(stage.get('name')), 'exit_code': words.plain(stage.get('exit_code')),
             'seconds': words.seconds(stage.get('seconds')), 'command': ' '.join(map(str, stage.get('command') or []))}
            for stage in run.record.get('stages') or []]


def files(run):
    rows = [{'name': name, 'sha256': words.plain((entry or {}).get('sha256')), 'bytes': words.plain((entry or {}).get('bytes'))}
            for name, entry in sorted((run.record.get('files') or {}).items())]
    calibration = run.record.get('calibration') or {}
    return rows + [{'name': 'calibration: ' + name, 'sha256': words.plain(value), 'bytes': ''}
                   for name, value in sorted(calibration.items())]
