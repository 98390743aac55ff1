#!/usr/bin/python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws control charts of a recipe's runs from what `history chart-data` writes, as PNG or as a page."""

import argparse
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

from scan_cell_common.command_line import add_version  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    add_version(parser)
    parser.add_argument('data', help='JSON from history chart-data')
    parser.add_argument('--output', required=True, help='.html or .png')
    names = parser.parse_args()
    from chart.drawing import png  # after --help: they take half a second to load
    from chart.page import page
    makers = {'.html': page, '.png': png}
    maker = makers.get(os.path.splitext(names.output)[1].lower())
    if maker is None:
        sys.exit(f"history_chart.py: {names.output}: unknown extension; give .html or .png")
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
