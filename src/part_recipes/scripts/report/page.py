# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Puts the page together: page.html with everything that it needs inside."""
import os

import jinja2
from markupsafe import Markup

from . import colours, pictures, sections, view_data, waypoints
from .scene import Scene

BROWSER = os.path.join(os.path.dirname(os.path.realpath(__file__)), 'browser')
SCRIPTS = ('packed.js', 'camera.js', 'layers.js', 'view.js', 'waypoints.js')


def script(path):
    """Text of a script, made safe against ending its element."""
    with open(path, encoding='utf-8') as file:
        return Markup(file.read().replace('</script', '<\\/script'))


def three_script(run, path):
    try:
        return script(path)
    except OSError:
        run.note('no interactive view: %s is missing; install libjs-three' % path)
        return None


def content(run, tools, three):
    """Everything that the template shows."""
    scene = Scene(run, tools)
    rows = waypoints.table(run, scene)
    shown = waypoints.kept(rows)
    library = three_script(run, three)
    view = view_data.pack(run, scene, rows)
    return {
        'verdict': sections.verdict(run), 'identity': sections.identity(run), 'tolerance': run.tolerance(),
        'adaptation': sections.adaptation(run), 'deviations': sections.deviations(run), 'places': sections.places(run),
        'binding': sections.binding(run), 'passes': sections.passes(run), 'warnings': sections.warnings(run), 'edits': sections.edits(run),
        'sight': sections.sight(run), 'cleaning': run.log('clean'), 'stages': sections.stages(run), 'files': sections.files(run),
        'map_picture': pictures.of_deviations(run, scene), 'path_picture': pictures.of_paths(scene, run.concerned()),
        'histogram': Markup(pictures.histogram(run, scene) or ''), 'mapped': scene.mapped, 'has_object': scene.object_points is not None,
        'has_reference': scene.reference_points is not None,
        'waypoints': [[row['number'], row['segment'], row['state'], row['concerned']] + row['values'] + [row['seen']] * (run.sight is not None)
                      for row in shown],
        'waypoint_count': len(rows), 'paper_waypoints': waypoints.on_paper(rows), 'view': view, 'three': library,
        'bar': ', '.join('#%02x%02x%02x' % tuple(colour) for colour in colours.table()[::15]), 'span': colours.SPAN,
        'notes': run.notes, 'title': sections.verdict(run)['name'],
        'part': (run.record.get('recipe') or {}).get('name') or run.record.get('id') or 'run',
    }


def render(run, tools, three):
    """The page as text.

    run: a RunFolder; tools: folder of report_scene; three: path of three.min.js"""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(BROWSER), autoescape=True, trim_blocks=True,
                                     lstrip_blocks=True, undefined=jinja2.StrictUndefined)
    with open(os.path.join(BROWSER, 'page.css'), encoding='utf-8') as file:
        style = Markup(file.read())
    scripts = [script(os.path.join(BROWSER, name)) for name in SCRIPTS]
    return environment.get_template('page.html').render(style=style, scripts=scripts, **content(run, tools, three))
