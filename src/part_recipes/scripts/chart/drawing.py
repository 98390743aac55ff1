# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The picture: for each characteristic its values and moving ranges over the runs, then the refusals."""
import io

from matplotlib import rcParams
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator

from .words import RULE_TEXTS, capability_text, limits_text, shown

rcParams['text.parse_math'] = False  # names are text, also with a dollar sign
rcParams['axes.unicode_minus'] = False
rcParams['axes.titley'] = 1.0  # there is room: nothing has to be measured to find it

BLUE, ORANGE, GREY = '#1f5f99', '#c25e00', '0.45'
RULE_MARKS = {1: '^', 2: 's', 3: 'D', 4: 'p'}  # shape and number tell them apart, not colour alone
STATE_STYLES = {'refused': {'marker': 'x', 'c': 'black'},
                'unusable': {'marker': 's', 'facecolors': 'none', 'edgecolors': 'black'}}
CHANGE_STYLES = {'time_went_back': ':', 'recipe_changed': '-.'}
MOST_LABELS = 60  # more would cover each other

# Layout in inches from the top: the space above a panel, for its title and the numbers of the panel
# above it, and its height. With matplotlib's own layout, which measures every text, 10,000 runs
# took 6 s of processor time instead of 2.6 s.
WIDTH, RIGHT, BOTTOM = 11, 1.1, 0.3
LETTER = 0.075  # of a reason; the widest that the margin has to hold
LEGEND, VALUES, RANGES = (0.4, 0.6), (0.65, 2.0), (0.1, 0.65)
BARS_ABOVE, BAR = 0.75, 0.22


def draw_line(axes, value, style, text):
    if value is None:
        return
    axes.axhline(value, **style)
    axes.annotate(text, (1.005, value), xycoords=('axes fraction', 'data'), va='center', fontsize=7)


def draw_states(axes, data):
    """Draws the runs that were not accepted, at their place on the axis."""
    for state, style in STATE_STYLES.items():
        where = [i + 1 for i, run in enumerate(data['runs']) if run['state'] == state]
        if where:
            axes.scatter(where, [0.04] * len(where), s=26, linewidths=1.2, clip_on=False, zorder=4,
                         transform=axes.get_xaxis_transform(), **style)


def draw_changes(axes, data):
    for key, style in CHANGE_STYLES.items():
        where = [i + 0.5 for i, run in enumerate(data['runs']) if run[key]]
        if where:
            axes.add_collection(LineCollection([((x, 0), (x, 1)) for x in where], linestyles=style, linewidths=1,
                                               colors=GREY, transform=axes.get_xaxis_transform()), autolim=False)


def draw_breaks(axes, chart):
    values = chart['values']
    for rule, mark in RULE_MARKS.items():
        at = [broken['at'] for broken in chart['rule_breaks'] if broken['rule'] == rule]
        if not at:
            continue
        axes.scatter(at, [values[i - 1] for i in at], marker=mark, s=70, facecolors='none', edgecolors=ORANGE,
                     linewidths=1.4, zorder=5)
        for i in at if len(at) <= MOST_LABELS else ():
            axes.annotate(str(rule), (i, values[i - 1]), xytext=(4, 5), textcoords='offset points', fontsize=7)


def draw_values(axes, chart, data):
    accepted = [run['state'] == 'accepted' for run in data['runs']]
    for counted, style in ((True, {'marker': '.', 'ls': '-', 'lw': 0.6, 'c': BLUE}),
                           (False, {'marker': 'd', 'ls': 'none', 'mfc': 'none', 'mec': 'black', 'ms': 5})):
        points = [(i + 1, value) for i, value in enumerate(chart['values'])
                  if value is not None and accepted[i] is counted]
        if points:
            axes.plot(*zip(*points), **style)


def draw_individuals(axes, chart, data):
    limits, unit = chart['limits'], chart['unit']
    draw_values(axes, chart, data)
    if limits is not None:
        draw_line(axes, limits['mean'], {'c': BLUE, 'lw': 1}, f'mean {shown(limits["mean"], limits)}')
        for key, name in (('upper', 'UCL'), ('lower', 'LCL')):
            draw_line(axes, limits[key], {'c': ORANGE, 'lw': 1, 'ls': '--'}, f'{name} {shown(limits[key], limits)}')
    for value, name in zip(chart['tolerance'] or (), ('- tolerance', '+ tolerance')):
        draw_line(axes, value, {'c': 'black', 'lw': 1, 'ls': (0, (1, 1))}, name)
    draw_breaks(axes, chart)
    draw_states(axes, data)
    draw_changes(axes, data)
    axes.margins(y=0.15)
    kind = 'deviation at ' if chart['kind'] == 'place' else ''
    axes.set_title(f'{kind}{chart["name"]}: {limits_text(chart)}\n{capability_text(chart)}', fontsize=9, loc='left')
    axes.set_ylabel(f'[{unit}]' if unit else '')


def draw_ranges(axes, chart):
    limits = chart['limits']
    axes.set_ylabel('moving\nrange', fontsize=8)
    axes.tick_params(labelsize=7)
    if limits is None:
        return
    axes.plot(*zip(*limits['moving_ranges']), marker='.', ls='-', lw=0.6, c=BLUE)
    draw_line(axes, limits['moving_range_mean'], {'c': BLUE, 'lw': 1}, shown(limits['moving_range_mean'], limits))
    draw_line(axes, limits['moving_range_upper'], {'c': ORANGE, 'lw': 1, 'ls': '--'},
              f'UCL {shown(limits["moving_range_upper"], limits)}')
    ranges = dict(map(tuple, limits['moving_ranges']))
    wide = limits['wide_ranges']
    axes.scatter(wide, [ranges[i] for i in wide], marker='^', s=60, facecolors='none', edgecolors=ORANGE, zorder=5)
    axes.set_ylim(bottom=0)


def draw_legend(axes):
    """Explains the marks, once for all panels."""
    def mark(shape, edge, text, size=7):
        return Line2D([], [], marker=shape, ls='none', mfc='none', mec=edge, ms=size, label=text)

    axes.set_axis_off()
    axes.legend(handles=[
        Line2D([], [], marker='.', lw=0.6, c=BLUE, label='accepted run'),
        mark('d', 'black', 'value of another run: does not count', 5), mark('x', 'black', 'refused run', 5),
        mark('s', 'black', 'unusable run', 5), *(mark(RULE_MARKS[rule], ORANGE, f'rule {rule}: {RULE_TEXTS[rule]}')
                                                  for rule in RULE_MARKS),
        Line2D([], [], ls=CHANGE_STYLES['time_went_back'], c=GREY, label='the clock went back'),
        Line2D([], [], ls=CHANGE_STYLES['recipe_changed'], c=GREY, label='the recipe changed'),
    ], loc='center', ncol=4, fontsize=8)


def draw_refusals(axes, data):
    refusals = data['refusals']
    axes.set_title(f'not accepted: {sum(refusals.values())} of {len(data["runs"])} runs', fontsize=9, loc='left')
    bars = axes.barh(list(refusals), list(refusals.values()), color='0.7', edgecolor='black')
    axes.bar_label(bars, fontsize=8, padding=3)
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.tick_params(labelsize=8)
    if not refusals:
        axes.set_axis_off()


def panels(heights, left):
    """A figure and its axes, one below the other, from (space above, height) and the left margin
    [in]."""
    height = sum(map(sum, heights)) + BOTTOM
    figure = Figure(figsize=(WIDTH, height))
    bottom = height
    axes = []
    for above, own in heights:
        bottom -= above + own
        axes.append(figure.add_axes((left / WIDTH, bottom / height, (WIDTH - left - RIGHT) / WIDTH, own / height)))
    return figure, axes


def draw(data):
    charts = data['charts']
    bars = (BARS_ABOVE, 0.1 + BAR * max(1, len(data['refusals'])))
    left = max(1, 0.2 + LETTER * max(map(len, data['refusals']), default=0))
    figure, axes = panels([LEGEND] + [VALUES, RANGES] * len(charts) + [bars], left)
    draw_legend(axes[0])
    for i, chart in enumerate(charts):
        pair = values, ranges = axes[2 * i + 1], axes[2 * i + 2]
        draw_individuals(values, chart, data)
        draw_ranges(ranges, chart)
        for panel in pair:
            panel.set_xlim(0.5, len(data['runs']) + 0.5)
            panel.xaxis.set_major_locator(MaxNLocator(integer=True))
        values.tick_params(labelbottom=False)
    if charts:
        axes[-2].set_xlabel('run, in the order in which they were added', fontsize=8)
    draw_refusals(axes[-1], data)
    figure.suptitle(data['recipe'].replace('\n', ' '), fontsize=12, y=1 - 0.12 / figure.get_figheight(), va='top')
    return figure


def png(data):
    with io.BytesIO() as file:
        draw(data).savefig(file, format='png', dpi=100)
        return file.getvalue()
