#!/usr/bin/env python3
"""Fails if the rooms of a package (folders below src/core and src/ros) include each other in a circle.

A header in include/ counts as part of the room that holds its source.

Usage: check_rooms.py [--print]     from the project's root; --print lists every include between rooms"""

import collections
import pathlib
import re
import sys

INCLUDE = re.compile(r'^#include ["<]([^">]+)[">]', re.MULTILINE)
SUFFIXES = (".cpp", ".h")


def files_by_room(package, layer):
    """Maps each file of src/<layer> to its room, and each API header to the room of its source."""
    root = package / "src" / layer
    rooms = {file: str(file.parent.relative_to(root)) for file in root.rglob("*") if file.suffix in SUFFIXES}
    sources = {file.stem: room for file, room in rooms.items()}
    for header in (package / "include" / package.name).rglob("*.h"):
        if ("ros" in header.parts) == (layer == "ros") and header.stem in sources:
            rooms[header] = sources[header.stem]
    return rooms


def arrows(package, layer):
    """Yields (room, other room, file, header) for each include that leaves its room."""
    rooms = files_by_room(package, layer)
    by_name = {}
    for file in rooms:
        base = package / ("include" if "include" in file.parts else f"src/{layer}")
        by_name[str(file.relative_to(base))] = file
    for file, room in rooms.items():
        for name in INCLUDE.findall(file.read_text(encoding="utf-8")):
            header = by_name.get(name)
            if header and rooms[header] != room:
                yield room, rooms[header], file, header


def circles(graph):
    """Returns the arrows that are part of a circle."""

    def reaches(start, goal, seen):
        seen.add(start)
        return start == goal or any(reaches(room, goal, seen) for room in graph[start] if room not in seen)

    return [(room, other) for room in list(graph) for other in graph[room] if reaches(other, room, set())]


def main():
    """Checks each package; the exit code is 1 if there is a circle."""
    status = 0
    for package in sorted(path.parent for path in pathlib.Path("src").glob("*/package.xml")):
        for layer in ("core", "ros"):
            graph, why = collections.defaultdict(set), {}
            for room, other, file, header in arrows(package, layer):
                graph[room].add(other)
                why[room, other] = f"{file} includes {header}"
            if "--print" in sys.argv:
                for room in sorted(graph):
                    print(f"{package.name}/{layer}/{room} -> {' '.join(sorted(graph[room]))}")
            for room, other in circles(graph):
                print(f"{package.name}/{layer}: {room} and {other} include each other: {why[room, other]}")
                status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
