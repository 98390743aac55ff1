#!/usr/bin/env python3
"""Fails if docs/library.md names a header that is not in include/, or does not name one that is there for programs
outside: one without ROS that neither another package nor another API header includes.

Usage: check_api.py     from the project's root"""

import pathlib
import re
import sys

from check_rooms import INCLUDE, SUFFIXES

TABLE_ROW = re.compile(r"^\| `(\w+)` \| (.*) \|$", re.MULTILINE)
HEADER = re.compile(r"`([\w/]+\.h)`")


def named_headers():
    """The headers in the tables of docs/library.md, as programs include them."""
    text = pathlib.Path("docs/library.md").read_text(encoding="utf-8")
    return {f"{package}/{header}" for package, row in TABLE_ROW.findall(text) for header in HEADER.findall(row)}


def main():
    """The exit code is 1 if documentation and headers differ."""
    headers = {
        "/".join(file.parts[3:]): file  # without src/<package>/include
        for file in pathlib.Path("src").glob("*/include/**/*.h")
        if "ros" not in file.parts
    }
    included = set()
    for file in pathlib.Path("src").rglob("*"):
        if file.suffix not in SUFFIXES:
            continue
        for name in INCLUDE.findall(file.read_text(encoding="utf-8")):
            if name in headers and (file.parts[1] != headers[name].parts[1] or "include" in file.parts):
                included.add(name)
    named = named_headers()
    wrong = [f"docs/library.md: {name} is not in include/" for name in sorted(named - set(headers))]
    wrong += [f"{headers[name]}: nobody else includes it; name it in docs/library.md, or put it beside its source"
              for name in sorted(set(headers) - included - named)]
    print("\n".join(wrong) if wrong else f"{len(headers)} headers of the API, {len(named)} named")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
