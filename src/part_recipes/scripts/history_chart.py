#!/usr/bin/python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws control charts of a recipe's runs from what `history chart-data` writes, as PNG or as a page."""

import argparse
import base64
import html
import io
import json
import math
import os
import sys

import matplotlib

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402 (the backend is chosen first: there may be no display)
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.ticker import MaxNLocator  # noqa: E402
from scan_cell_common.command_line import add_version  # noqa: E402

plt.rcParams['text.parse_math'] = False  # names are text, also with a dollar sign
plt.rcParams['axes.unicode_minus'] = False

BLUE, ORANGE, GREY = '#1f5f99', '#c25e00', '0.45'
RULE_MARKS = {1: '^', 2: 's', 3: 'D', 4: 'p'}  # shape and number tell them apart, not colour alone
RULE_TEXTS = {1: 'beyond 3 sigma', 2: '2 of 3 beyond 2 sigma', 3: '4 of 5 beyond 1 sigma',
              4: '8 on one side of the mean'}
STATE_STYLES = {'refused': {'marker': 'x', 'c': 'black'},
                'unusable': {'marker': 's', 'facecolors': 'none', 'edgecolors': 'black'}}
CHANGE_STYLES = {'time_went_back': ':', 'recipe_changed': '-.'}
MOST_LABELS = 60  # more would cover each other
MOST_ROWS = 200  # of a table of the page
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
    broken = [f'rule {rule} ({count} {"time" if count == 1 else "times"})' for rule in RULE_MARKS
              for count in [sum(b['rule'] == rule for b in chart['rule_breaks'])] if count]
    rules = f'; broken: {", ".join(broken)}' if broken else '; no rule is broken'
    return f'limits of {limits["count"]} accepted runs{note}{rules}'


def draw_line(axes, value, style, text):
    if value is None:
        return
    axes.axhline(value, **style)
    axes.annotate(text, (1.005, value), xycoords=('axes fraction', 'data'), va='center', fontsize=7)


def draw_states(axes, data):
    """Runs that were not accepted, at their place on the axis."""
    for state, style in STATE_STYLES.items():
        where = [i + 1 for i, run in enumerate(data['runs']) if run['state'] == state]
        if where:
            axes.scatter(where, [0.04] * len(where), s=26, linewidths=1.2, clip_on=False, zorder=4,
                         transform=axes.get_xaxis_transform(), **style)


def draw_changes(axes, data):
    for i, run in enumerate(data['runs']):
        for key, style in CHANGE_STYLES.items():
            if run[key]:
                axes.axvline(i + 0.5, ls=style, lw=1, c=GREY)


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
    """What the marks mean, once for all panels."""
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


def draw(data):
    """The figure: for each characteristic its values and moving ranges over the runs, then the refusals."""
    charts = data['charts']
    heights = [0.6] + [ratio for _ in charts for ratio in (2.4, 0.8)] + [0.4 + 0.22 * len(data['refusals'])]
    figure = plt.figure(figsize=(11, 1.05 * sum(heights) + 0.6), layout='constrained')
    panels = figure.subplots(len(heights), 1, gridspec_kw={'height_ratios': heights})
    draw_legend(panels[0])
    for i, chart in enumerate(charts):
        values, ranges = panels[2 * i + 1], panels[2 * i + 2]
        draw_individuals(values, chart, data)
        draw_ranges(ranges, chart)
        for axes in (values, ranges):
            axes.set_xlim(0.5, len(data['runs']) + 0.5)
            axes.xaxis.set_major_locator(MaxNLocator(integer=True))
        values.tick_params(labelbottom=False)
    panels[-2].set_xlabel('run, in the order in which they were added', fontsize=8)
    draw_refusals(panels[-1], data)
    figure.suptitle(data['recipe'].replace('\n', ' '), fontsize=12)
    return figure


def png(data):
    with io.BytesIO() as file:
        draw(data).savefig(file, format='png', dpi=100)
        return file.getvalue()


def table(head, rows):
    """Of texts, with what people named as text."""
    left = len(rows) - MOST_ROWS
    lines = [''.join(f'<td>{html.escape(str(cell))}</td>' for cell in row) for row in rows[:MOST_ROWS]]
    more = f'<p>and {left} more: <code>history chart-data</code> has all of them</p>' if left > 0 else ''
    return (f'<table><tr>{"".join(f"<th>{html.escape(cell)}</th>" for cell in head)}</tr>'
            + ''.join(f'<tr>{line}</tr>' for line in lines) + f'</table>{more}')


def tables(data):
    runs, charts = data['runs'], data['charts']
    keys = ('mean', 'lower', 'upper', 'moving_range_mean', 'moving_range_upper')
    figures = [(c['name'], c['unit'], *(shown((c['limits'] or {}).get(key), c['limits']) for key in keys),
                limits_text(c), capability_text(c)) for c in charts]
    breaks = [(c['name'], f'{b["rule"]}: {RULE_TEXTS[b["rule"]]}', b['at'], runs[b['at'] - 1]['id'],
               ' '.join(map(str, b['points']))) for c in charts for b in c['rule_breaks']]
    breaks += [(c['name'], 'moving range beyond its limit', i, runs[i - 1]['id'], f'{i}') for c in charts
               for i in (c['limits'] or {}).get('wide_ranges', ())]
    others = [(i + 1, run['started'], run['state'], run['reason'], run['id']) for i, run in enumerate(runs)
              if run['state'] != 'accepted']
    notes = [(i + 1, run['started'], text, run['id']) for i, run in enumerate(runs)
             for key, text in (('time_went_back', 'started before the run in front of it: the clock went back, or the '
                                'run was added later'), ('recipe_changed', "the recipe's files changed"))
             if run[key]]
    return ('<h2>Limits and capability</h2>'
            + table(('of', 'unit', 'mean', 'LCL', 'UCL', 'mean moving range', 'its UCL', 'limits', 'capability'),
                    figures)
            + '<h2>Rules that are broken</h2>'
            + (table(('of', 'rule', 'at run', 'id', 'runs that break it'), breaks) if breaks else '<p>none</p>')
            + '<h2>Runs that were not accepted</h2>'
            + (table(('run', 'started (UTC)', 'state', 'reason', 'id'), others) if others else '<p>none</p>')
            + '<h2>Changes</h2>'
            + (table(('run', 'started (UTC)', 'what', 'id'), notes) if notes else '<p>none</p>'))


STYLE = ('body{font:15px/1.4 sans-serif;max-width:75em;margin:1em auto;padding:0 1em;color:#111;background:#fff}'
         'table{border-collapse:collapse}td,th{border:1px solid #999;padding:.2em .5em;text-align:left;'
         'max-width:30em;overflow-wrap:break-word}img{max-width:100%}')


def page(data):
    """One file without any other."""
    name = html.escape(data['recipe'])
    picture = base64.b64encode(png(data)).decode()
    repeats = data['repeats_left_out']
    left_out = f'; {repeats} runs that repeat another one are left out' if repeats else ''
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>Runs of {name}</title>'
            f'<style>{STYLE}</style></head><body><h1>Runs of {name}</h1>'
            f'<p>{len(data["runs"])} runs in the order in which they were added, '
            f'{sum(data["refusals"].values())} of them not accepted{left_out}. Limits, rules and capability are those '
            'of the accepted runs.</p>'
            f'<img alt="control charts; the tables below have their figures" src="data:image/png;base64,{picture}">'
            f'{tables(data)}</body></html>\n').encode()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    add_version(parser)
    parser.add_argument('data', help='JSON from history chart-data')
    parser.add_argument('--output', required=True, help='.html or .png')
    names = parser.parse_args()
    makers = {'.html': page, '.png': png}
    maker = makers.get(os.path.splitext(names.output)[1].lower())
    if maker is None:
        sys.exit(f"history_chart.py: {names.output}: no such kind; write .html or .png")
    try:
        with open(names.data, encoding='utf-8') as file:
            data = json.load(file)
        content = maker(data)
        with open(names.output + '.partial', 'wb') as file:
            file.write(content)
        os.replace(names.output + '.partial', names.output)
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f'history_chart.py: {error!r}; give what history chart-data wrote and a folder to write to')


if __name__ == '__main__':
    main()
