#!/usr/bin/env python3
"""Lists each failed test with the start of its reason, and each test skipped without a reason.

A suite whose set-up failed skips its tests like this, and nothing else shows it. The exit code is 1 if there are any.

Usage: failed_tests.py DIR

DIR is the folder of result files from `make test` (build/test_results)."""

import pathlib
import sys
import xml.etree.ElementTree as ElementTree


def failures(file):
    """Yields `test: reason` for each failure in a JUnit result file."""
    try:
        root = ElementTree.parse(file).getroot()
    except ElementTree.ParseError as error:
        yield f"unreadable: {error}"
        return
    for case in root.iter("testcase"):
        for mark in [*case.findall("failure"), *case.findall("error")]:
            reason = (mark.get("message") or mark.text or "").strip()
            reason = " ".join(reason.split())[:160]
            yield f"{case.get('classname', '')}.{case.get('name')}: {reason}"
        for mark in case.findall("skipped"):
            text = mark.get("message") or mark.text or ""
            place, _, reason = text.strip().partition("\n")
            if not reason and (not place or place.startswith("/")):  # gtest begins with file and line
                yield f"{case.get('classname', '')}.{case.get('name')}: skipped without a reason; was its suite set up?"


def main():
    """Prints the failures of all result files below the folder given."""
    folder = pathlib.Path(sys.argv[1])
    status = 0
    for file in sorted(folder.rglob("*.xml")):
        for line in failures(file):
            print(f"FAILED {file.relative_to(folder)} {line}")
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
