#!/usr/bin/python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Takes the picture of docs/run_report.md: the top of a run's page as a browser shows it.

Usage: page_picture.py REPORT.html PICTURE.png"""
import io
import os
import sys

from PIL import Image

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

from browser import Browser  # noqa: E402 (beside this file)

SIZE = 1250, 1290  # [pixels] of the window
WIDTH = 1000  # [pixels] of the picture
COLOURS = 128


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    browser = Browser()
    try:
        browser.driver.set_window_size(*SIZE)
        browser.open(os.path.realpath(sys.argv[1]))
        browser.until('return reportView.frames > 0')
        browser.run('reportView.orbit.zoom(0.8)')
        browser.until('return reportView.frames > 1')
        picture = Image.open(io.BytesIO(browser.driver.get_screenshot_as_png())).convert('RGB')
    finally:
        browser.close()
    height = round(picture.height * WIDTH / picture.width)
    picture.resize((WIDTH, height), Image.LANCZOS).quantize(COLOURS).save(sys.argv[2], optimize=True)


if __name__ == '__main__':
    main()
