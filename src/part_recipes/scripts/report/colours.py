# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""One scale for all pictures of deviations: fixed by the tolerance, never by the data.

Blue, white and orange differ for people with any usual colour blindness. In greys both ends look alike, so
marks tell the sign: plus, minus, a dot within the tolerance, a cross where nothing is known."""
import numpy
from matplotlib.colors import LinearSegmentedColormap

SPAN = 2.0  # tolerances to each end of the scale
MAP = LinearSegmentedColormap.from_list(
    'deviation', ['#0b4fa8', '#3d8fe0', '#a6cdf2', '#f4f4f4', '#fcc98f', '#ee8a1d', '#b04f00'])
UNKNOWN = '#cc79a7'  # Okabe and Ito 2008
PLAIN = '#7fa8c9'  # an object without deviations
WITHIN, PLUS, MINUS, NOT_KNOWN = range(4)  # marks


def table():
    """256 x 3 bytes, from -SPAN to +SPAN tolerances."""
    return (MAP(numpy.linspace(0, 1, 256))[:, :3] * 255).round().astype(numpy.uint8)


def marks(points, deviations, tolerance, across=32):
    """Marks spread over a cloud: indices of points, and their kinds. There is one mark per cell of
    a grid, by the median of the cell's known deviations; NOT_KNOWN if most of the cell's deviations
    are unknown.

    across: cells along the longest side"""
    low = points.min(axis=0)
    side = max((points.max(axis=0) - low).max() / across, 1e-9)
    cells = numpy.floor((points - low) / side).astype(int)
    order = numpy.lexsort(cells.T)
    begins = numpy.flatnonzero(numpy.any(numpy.diff(cells[order], axis=0, prepend=cells[order][:1] - 1) != 0, axis=1))
    indices, kinds = [], []
    for members in numpy.split(order, begins[1:]):
        middle = points[members].mean(axis=0)
        indices.append(members[((points[members] - middle) ** 2).sum(axis=1).argmin()])
        kinds.append(kind_of(deviations[members], tolerance))
    return numpy.array(indices, dtype=int), numpy.array(kinds, dtype=numpy.uint8)


def kind_of(deviations, tolerance):
    known = deviations[numpy.isfinite(deviations)]
    if 2 * len(known) < len(deviations):
        return NOT_KNOWN
    median = numpy.median(known)
    return PLUS if median > tolerance else MINUS if median < -tolerance else WITHIN
