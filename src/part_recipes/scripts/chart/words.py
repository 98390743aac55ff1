# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the charts say in words, for the picture and for the page's tables."""
import math

RULE_TEXTS = {1: 'beyond 3 sigma', 2: '2 of 3 beyond 2 sigma', 3: '4 of 5 beyond 1 sigma',
              4: '8 on one side of the mean'}
PROVISIONAL = 25  # values, as for a capability: docs/run_history.md


def shown(value, limits):
    """A number as people read it, to a tenth of the values' spread; a dash for none."""
    if value is None:
        return '-'
    spread = limits['moving_range_mean']
    decimals = min(9, max(0, 1 - math.floor(math.log10(spread)))) if spread > 0 else 6
    return f'{value:.{decimals}f}'


def capability_text(chart):
    capability = chart['capability']
    if 'none' in capability:
        return 'no capability: ' + capability['because']
    interval = [f'{capability[name]:.2f} ({capability[name + "_interval"][0]:.2f} to '
                f'{capability[name + "_interval"][1]:.2f})' for name in ('cp', 'cpk')]
    return (f'Cp {interval[0]}, Cpk {interval[1]}; in brackets 95 % intervals, of {capability["count"]} runs from run '
            f'{capability["from"]} on')


def limits_text(chart):
    limits = chart['limits']
    if limits is None:
        return 'fewer than two values: no limits'
    note = ', provisional' if limits['count'] < PROVISIONAL else ''
    broken = [f'rule {rule} ({count} {"time" if count == 1 else "times"})' for rule in RULE_TEXTS
              for count in [sum(b['rule'] == rule for b in chart['rule_breaks'])] if count]
    rules = f'; broken: {", ".join(broken)}' if broken else '; no rule is broken'
    return f'limits of {limits["count"]} accepted runs{note}{rules}'
