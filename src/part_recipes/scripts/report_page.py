#!/usr/bin/python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the page of a run: one HTML file that needs no network and nothing beside it."""
import argparse
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
# PREFIX/lib/part_recipes/report_page.py: a shell that did not source the workspace calls it, too
sys.path.append(os.path.join(os.path.dirname(os.path.realpath(sys.argv[0])), '../python3/dist-packages'))

from scan_cell_common.command_line import add_version  # noqa: E402 (found on the paths above)

THREE = '/usr/share/javascript/three/three.min.js'  # Debian: libjs-three


def save(path, text):
    """Writes the file, whole or not at all."""
    partial = '%s.%d.partial' % (path, os.getpid())
    try:
        with open(partial, 'w', encoding='utf-8', newline='\n') as file:
            file.write(text)
        os.replace(partial, path)
    finally:
        if os.path.exists(partial):
            os.remove(partial)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    add_version(parser)
    parser.add_argument('folder', help='of the run')
    parser.add_argument('--output', help='the page; default: report.html in the folder')
    parser.add_argument('--three', default=THREE, help='three.min.js, for the interactive view')
    parser.add_argument('--tools', default=os.path.dirname(os.path.realpath(sys.argv[0])),
                        help='folder of the tool report_scene; default: that of this script')
    options = parser.parse_args()
    from report.page import render  # after --help: they draw, and take a second to load
    from report.run_folder import RunFolder, UnusableRun
    output = options.output or os.path.join(options.folder, 'report.html')
    if not output.endswith('.html'):
        sys.exit('report_page: %s: not a page; end it with .html' % output)
    try:
        if os.path.exists(output):
            os.remove(output)  # a page that lies there is always of this call
        save(output, render(RunFolder(options.folder), options.tools, options.three))
    except (OSError, UnusableRun) as error:
        sys.exit('report_page: %s' % error)


if __name__ == '__main__':
    main()
