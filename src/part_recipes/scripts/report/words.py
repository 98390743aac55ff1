# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers and verdicts in words for a person."""
import math

VERDICTS = {'accepted': ('Accepted', '✔', 'The path was adapted to this part.'),
            'refused': ('Refused', '✖', 'There is no path for this part.'),
            'unusable': ('Unusable', '!', 'The run ended before the part could be judged.')}

# What helps, by the reason of the stretcher (docs/tool_path_stretcher.md, docs/reading_a_verdict.md)
CURES = {
    'accepted': 'Check the figures below before you use the path.',
    'unusable_input': 'Do what the message says about the file that it names.',
    'too_few_points': 'Scan more densely, or lower min_points.',
    'path_off_reference': "Give the path in the reference's frame; raise max_stand_off if the tool moves farther "
                          'above the surface.',
    'wrong_part': 'Check the part. If one whole region differs, remove what lies there: floor, clamps, neighbours. If '
                  'everything differs, it is another part.',
    'ambiguous': "Scan what breaks the part's symmetry, or give an initial pose.",
    'mirrored_part': 'Take the opposite-hand part, or the reference and path of this hand.',
    'scale_at_bound': 'Check the units; widen min_scale and max_scale if the size is right.',
    'path_not_scanned': 'Scan the region of the marked waypoints, or split the path.',
    'tolerance_exceeded': 'Use the general method, which follows a bend; check the part at the marked waypoints.',
    'position_uncertain': 'Scan edges or features that show where the part lies along itself; give scale or initial pose more '
                          'closely; raise max_position_error if the process tolerates it.',
    'orientation_uncertain': 'Scan the surface beside the marked waypoints more densely, to both sides of them; raise '
                             'max_orientation_error if the process tolerates it.',
    'fold_over': 'Check part and scan, or lower deformation_level.',
    'cancelled': 'Run again.',
}
CLEANED_AWAY = ('Look at the cleaning: the raw scan has points at marked waypoints that the clean cloud does not have. Change its '
                'settings if they are of the part. If they are of what is beneath it, scan the region, or split the path.')
NOT_RECORDED = 'not recorded'


def cure_of(reason, cleaned_away=None):
    """cleaned_away: waypoints at which the raw scan has points that the clean cloud does not have."""
    if reason == 'path_not_scanned' and cleaned_away:
        return CLEANED_AWAY
    if reason in CURES:
        return CURES[reason]
    if isinstance(reason, str) and reason.endswith('_failed'):
        return 'See the message, and stages/%s.log in the folder of the run.' % reason[:-len('_failed')]
    return 'See the message.'


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def significant(value, digits=4):
    """Only significant digits, never as a power of ten."""
    if value == 0:
        return '0'
    decimals = max(0, digits - 1 - math.floor(math.log10(abs(value))))
    return '%.*f' % (min(decimals, 12), value)


def scaled(value, factor, unit):
    return '%s %s' % (significant(value * factor), unit) if is_number(value) else NOT_RECORDED


def millimetres(value):
    return scaled(value, 1e3, 'mm')


def signed_millimetres(value):
    """Rounded to a thousandth, with its sign."""
    return '%+.3f mm' % (1e3 * value) if is_number(value) else NOT_RECORDED


def degrees(value):
    return scaled(value, 180 / math.pi, '°')


def percent(value):
    return scaled(value, 100, '%')


def seconds(value):
    return '%.2f s' % value if is_number(value) else NOT_RECORDED


def plain(value):
    """A count or a factor; a text unchanged."""
    if is_number(value):
        return str(value) if isinstance(value, int) else significant(value, 6)
    return NOT_RECORDED if value is None or value == '' else str(value)


def moment(text):
    """2026-11-25T12:13:14.123Z as people write it."""
    if not isinstance(text, str) or len(text) < 19 or text[10] != 'T':
        return plain(text)
    return '%s %s UTC' % (text[:10], text[11:19])
