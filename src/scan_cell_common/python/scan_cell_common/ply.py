# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads the PLY files that the suite writes: binary, little-endian, vertices first."""
import numpy

TYPES = {'float': '<f4', 'double': '<f8', 'uchar': 'u1', 'ushort': '<u2', 'int': '<i4', 'uint': '<u4'}


def read_vertices(path):
    """A structured array with one record per vertex, fields named as in the file."""
    with open(path, 'rb') as file:
        header, _, body = file.read().partition(b'end_header\n')
    lines = [line.split() for line in header.decode('ascii').splitlines()]
    if ['format', 'binary_little_endian', '1.0'] not in lines:
        raise ValueError('%s: not a binary little-endian PLY file' % path)
    count, fields = 0, []
    for words in lines:
        if words[0] == 'element' and words[1] != 'vertex':
            break
        if words[0] == 'element':
            count = int(words[2])
        elif words[0] == 'property':
            fields.append((words[2], TYPES[words[1]]))
    return numpy.frombuffer(body, fields, count)


def read_points(path):
    """x, y, z in the file's unit, one row per point."""
    vertices = read_vertices(path)
    return numpy.stack([vertices[name] for name in 'xyz'], axis=1).astype(float)
