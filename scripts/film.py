#!/usr/bin/env python3
"""Makes the film of the seat for the docs: a shift of the test in the simulated cell, picture by picture.

Usage: film.py OUTPUT.gif     in a sourced workspace with the tests built; takes about two minutes"""
import os
import subprocess
import sys
import tempfile

from PIL import Image

STAGES = ['part', 'teach', 'scan', 'refused', 'clean', 'fit', 'path', 'not_worked', 'work', 'history', 'new_path',
          'passes']  # as in test_shift.cpp
SECONDS = 2.5  # for each; chosen
COLOURS = 64  # enough for widgets; keeps the file small
MAX_BYTES = 3e6


def pictures(folder):
    subprocess.run(['rostest', 'scan_cell_rviz', 'shift.test'], check=True, env={**os.environ, 'SEAT_PICTURES': folder})
    return [Image.open(f'{folder}/seat_{stage}.png').convert('RGB') for stage in STAGES]


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith('-'):
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        frames = [picture.quantize(COLOURS) for picture in pictures(folder)]
        frames[0].save(sys.argv[1], save_all=True, append_images=frames[1:], duration=int(1000 * SECONDS), loop=0)
    size = os.path.getsize(sys.argv[1])
    print(f'{sys.argv[1]}: {len(frames)} pictures, {size / 1e6:.2f} MB')
    if size > MAX_BYTES:
        sys.exit(f'{sys.argv[1]}: larger than {MAX_BYTES / 1e6:g} MB')


if __name__ == '__main__':
    main()
