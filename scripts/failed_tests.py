#!/usr/bin/env python3
"""Names each test that failed, with the beginning of its reason.

Usage: failed_tests.py DIR

DIR holds the result files that `make test` leaves (build/test_results)."""

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


def main():
    """Prints the failures of all result files below the folder given."""
    folder = pathlib.Path(sys.argv[1])
    for file in sorted(folder.rglob("*.xml")):
        for line in failures(file):
            print(f"FAILED {file.relative_to(folder)} {line}")


if __name__ == "__main__":
    main()
