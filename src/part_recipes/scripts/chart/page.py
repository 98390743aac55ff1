# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""The page: the picture, and its figures as tables."""
import base64
import html

from .drawing import png
from .words import RULE_TEXTS, capability_text, limits_text, shown

MOST_ROWS = 200  # of a table

STYLE = ('body{font:15px/1.4 sans-serif;max-width:75em;margin:1em auto;padding:0 1em;color:#111;background:#fff}'
         'table{border-collapse:collapse}td,th{border:1px solid #999;padding:.2em .5em;text-align:left;'
         'max-width:30em;overflow-wrap:break-word}img{max-width:100%}')


def table(head, rows):
    """A table of texts, with names given by people as plain text."""
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
             for key, text in (('time_went_back', 'started before the previous run: the clock went back, or the run '
                                'was added later'), ('recipe_changed', "the recipe's files changed"))
             if run[key]]
    return ('<h2>Limits and capability</h2>'
            + table(('of', 'unit', 'mean', 'LCL', 'UCL', 'mean moving range', 'its UCL', 'limits', 'capability'),
                    figures)
            + '<h2>Broken rules</h2>'
            + (table(('of', 'rule', 'at run', 'id', 'runs that break it'), breaks) if breaks else '<p>none</p>')
            + '<h2>Runs that were not accepted</h2>'
            + (table(('run', 'started (UTC)', 'state', 'reason', 'id'), others) if others else '<p>none</p>')
            + '<h2>Changes</h2>'
            + (table(('run', 'started (UTC)', 'what', 'id'), notes) if notes else '<p>none</p>'))


def page(data):
    """One self-contained file."""
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
