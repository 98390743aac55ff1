# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Fixed pictures for paper, and for browsers that cannot draw the view: deviations seen from above,
the paths seen from one side, and a histogram of the deviations. No text written by a person is
drawn."""
import base64
import io

import numpy
from matplotlib import rc_context
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from PIL import Image

from . import colours
from .scene import thin

MOST = 60000  # points of a cloud in a picture
DPI = 130  # dots per inch on paper
GROUND = '#d5d8dc'  # behind white points
INK, GREY, ORANGE, BLUE, RED = '#1b1f24', '#8a9099', '#c25100', '#0b4fa8', '#b3001b'
GLYPHS = {colours.PLUS: '+', colours.MINUS: '_', colours.WITHIN: '.', colours.NOT_KNOWN: 'x'}
LINES_SHOWN = 40  # correspondences


class View:
    """A view of a cloud: its longest side lies across the picture."""

    def __init__(self, points, elevation=90.0):
        """elevation: [deg] of the eye over the cloud's plane"""
        self.middle = points.mean(axis=0)
        _, axes = numpy.linalg.eigh(numpy.cov((points - self.middle).T))
        across, up = axes[:, 2], axes[:, 0]
        up = up if up[2] >= 0 else -up
        across = across if across[numpy.abs(across).argmax()] >= 0 else -across
        along = numpy.cross(up, across)
        lean = numpy.radians(elevation)
        self.right = across
        self.top = numpy.sin(lean) * along + numpy.cos(lean) * up
        self.towards = numpy.cross(self.right, self.top)

    def __call__(self, points):
        """[mm] in the picture, and the depth: greater is nearer"""
        local = (points - self.middle) * 1e3
        return local @ self.right, local @ self.top, local @ self.towards


def png(figure):
    """A data URL, with 128 colours: a third of the size."""
    raw = io.BytesIO()
    figure.savefig(raw, dpi=DPI, format='png')
    small = io.BytesIO()
    Image.open(raw).convert('RGB').quantize(128).save(small, format='png', optimize=True)
    return 'data:image/png;base64,' + base64.b64encode(small.getvalue()).decode('ascii')


def empty_axes(width, height, right=0.1):
    """Axes of a figure of this size, with this margin on the right [in]. The layout is fixed: to
    find one, matplotlib would draw all texts twice more."""
    left, bottom, top = 0.45, 0.4, 0.1
    figure = Figure(figsize=(width, height))
    axes = figure.add_axes((left / width, bottom / height, 1 - (left + right) / width, 1 - (bottom + top) / height))
    axes.set_facecolor(GROUND)
    axes.set_aspect('equal')
    axes.tick_params(labelsize=7)
    axes.set_xlabel('mm', fontsize=7)
    return figure, axes


def scatter(axes, view, points, size, **look):
    """Draws far points first, so that near ones lie over them."""
    x, y, depth = view(points)
    order = numpy.argsort(depth)
    if isinstance(look.get('c'), numpy.ndarray):
        look['c'] = look['c'][order]
    return axes.scatter(x[order], y[order], s=size, linewidths=0, rasterized=True, **look)


def of_deviations(run, scene):
    """The object from above in the colours of its deviations, with marks of their sign; None without any."""
    if scene.deviations is None:
        return None
    tolerance = run.tolerance()
    view = View(scene.object_points)
    chosen = thin(len(scene.object_points), MOST)
    points, values = scene.object_points[chosen], scene.deviations[chosen]
    known = numpy.isfinite(values)
    figure, axes = empty_axes(7.4, 4.1, right=0.95)
    if scene.mapped and (scene.scanned == 0).any():
        scatter(axes, view, scene.reference_points[scene.scanned == 0], 2, c=GREY)
    scatter(axes, view, points[~known], 1.2, c=colours.UNKNOWN)
    span = colours.SPAN * tolerance * 1e3
    dots = scatter(axes, view, points[known], 1.2, c=values[known] * 1e3, cmap=colours.MAP, norm=Normalize(-span, span))
    indices, kinds = colours.marks(scene.object_points, scene.deviations, tolerance, across=26)
    for kind, glyph in GLYPHS.items():
        x, y, _ = view(scene.object_points[indices[kinds == kind]])
        axes.scatter(x, y, s=7 if glyph == '.' else 22, marker=glyph, c=INK, linewidths=0.8 if glyph != '.' else 0)
    bar = figure.colorbar(dots, cax=figure.add_axes((0.9, 0.15, 0.02, 0.75)), extend='both',
                          ticks=numpy.linspace(-span, span, 5))
    bar.set_label('deviation [mm]: + material added', fontsize=7)
    bar.ax.tick_params(labelsize=7)
    return png(figure)


def lines(axes, view, points, segment_of, **look):
    """A path: its segments are not joined."""
    breaks = numpy.flatnonzero(numpy.diff(segment_of)) + 1 if len(segment_of) == len(points) else []
    for i, part in enumerate(numpy.split(points, breaks)):
        x, y, _ = view(part)
        axes.plot(x, y, **dict(look, label=look.get('label') if i == 0 else None))


def of_paths(scene, concerned):
    """Both paths over the clouds from one side, lines between corresponding waypoints, and the waypoints that the
    verdict names; None without a cloud and a path."""
    shift = scene.shift_of_reference()
    clouds = [points for points in (scene.object_points, None if scene.reference_points is None
                                    else scene.reference_points + shift) if points is not None]
    path, adapted = scene.reference_path(), scene.adapted_path()
    if not clouds and path is None:
        return None
    view = View(numpy.concatenate([cloud[thin(len(cloud), 5000)] for cloud in clouds] or [path]), elevation=48)
    figure, axes = empty_axes(7.4, 3.7)
    if scene.reference_points is not None:
        scatter(axes, view, scene.reference_points[thin(len(scene.reference_points), 20000)] + shift, 1, c='#9aa1aa')
    if scene.object_points is not None:
        shown = thin(len(scene.object_points), 30000)
        scatter(axes, view, scene.object_points[shown], min(6, max(0.8, 20000 / len(shown))), c='#8fb3d1')
    segment_of = numpy.array((scene.paths or {}).get('segment_of') or [])
    if path is not None:
        path = path + shift
        lines(axes, view, path, segment_of, c=INK, lw=0.9, ls='--', label='path on the reference')
    if adapted is not None:
        lines(axes, view, adapted, segment_of, c=ORANGE, lw=1.3, label='adapted path on the object')
        if len(adapted) == len(path):
            for i in thin(len(path), LINES_SHOWN):
                x, y, _ = view(numpy.stack([path[i], adapted[i]]))
                axes.plot(x, y, c=BLUE, lw=0.5)
    named = adapted if adapted is not None else path
    if named is not None and concerned:
        x, y, _ = view(named[[i for i in concerned if i < len(named)]])
        axes.scatter(x, y, s=28, marker='X', c=RED, edgecolors='white', linewidths=0.5, zorder=5, label='named by the verdict')
    if path is not None:
        axes.legend(loc='upper right', fontsize=7, framealpha=0.9)
    return png(figure)


def histogram(run, scene):
    """SVG histogram of the deviations, with the tolerance; None without any."""
    if scene.deviations is None or not numpy.isfinite(scene.deviations).any():
        return None
    tolerance, span = run.tolerance() * 1e3, colours.SPAN * run.tolerance() * 1e3
    values = scene.deviations[numpy.isfinite(scene.deviations)] * 1e3
    edges = numpy.linspace(-span, span, 41)
    counts = numpy.histogram(values, edges)[0]
    step = edges[1] - edges[0]
    counts = numpy.concatenate([[(values < -span).sum()], counts, [(values > span).sum()]]) / len(values) * 100
    middles = numpy.concatenate([[edges[0] - 1.5 * step], (edges[:-1] + edges[1:]) / 2, [edges[-1] + 1.5 * step]])
    with rc_context({'svg.fonttype': 'none', 'font.family': 'sans-serif', 'svg.hashsalt': 'report'}):
        figure = Figure(figsize=(7.4, 2.1))
        axes = figure.add_axes((0.08, 0.24, 0.91, 0.72))
        axes.bar(middles, counts, step, color=colours.MAP(Normalize(-span, span)(middles)), edgecolor=INK, linewidth=0.4)
        for limit in (-tolerance, tolerance):
            axes.axvline(limit, color=INK, lw=1.1, ls='--')
        axes.set_xlabel('deviation [mm]; dashed: tolerance; outermost bars: all beyond', fontsize=8)
        axes.set_ylabel('points [%]', fontsize=8)
        axes.tick_params(labelsize=8)
        text = io.StringIO()
        figure.savefig(text, format='svg', metadata={'Date': None, 'Creator': None})
    return text.getvalue()[text.getvalue().index('<svg'):]
