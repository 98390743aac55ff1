# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Command-line options of every script of the suite."""
import argparse


class _Version(argparse.Action):
    def __call__(self, parser, *_):
        import rospkg  # slow to load, and not needed otherwise
        print(parser.prog, rospkg.RosPack().get_manifest('scan_cell_common').version)
        parser.exit()


def add_version(parser):
    """Adds --version, which prints the suite's version, that of every package.xml."""
    parser.add_argument('--version', action=_Version, nargs=0, help="print the suite's version")
