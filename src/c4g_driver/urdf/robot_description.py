#!/usr/bin/python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""robot_description.py [NAME=VALUE ...]   prints smart5_six.urdf with the scanner's bracket as it is set up.

Each laser (laser_0, laser_1):
  laser_0_half_distance   [m] along the profile, from the camera to where its light comes out
  laser_0_height          [m] of that point above the flange
  laser_0_tilt            [rad] of its light towards the camera; 0: along the camera's axis
The camera:
  camera_body             generic, photonfocus_mv1 or bluecougar
Without arguments it is the file as it stands. What is drawn has no effect on a scan: the scanner model has the poses."""
import difflib
import os
import sys
import xml.etree.ElementTree as ElementTree

MODEL = os.path.join(os.path.dirname(os.path.realpath(__file__)), 'smart5_six.urdf')
PROFILE_TOP = 0.050  # [m] above the flange, of the 40 x 40 mm profile on its plate of 10 mm
BELOW_LIGHT = 0.031  # [m] from the light's exit down to the housing's clamp
OUTWARDS = 0.012  # [m] from there outwards to the middle of the clamp
LENGTHS = {  # least and most
    'half_distance': (0.05, 0.3, 'm'),  # beside the camera; to the end of the 600 mm profile
    'height': (0.085, 0.5, 'm'),  # with 4 mm of clamp; chosen
    'tilt': (-1.4, 1.4, 'rad'),  # 80 degrees; chosen
}
# [m] width and height across the lens, length along it: from the makers' data sheets, in whole millimetres
BODIES = {'generic': None, 'photonfocus_mv1': (0.055, 0.055, 0.051), 'bluecougar': (0.040, 0.040, 0.035)}
BODY_BACK = -0.034  # [m] below the lens's frame: on the profile
LENS = (0.018, 0.032)  # [m] radius and length
NAMES = ['laser_%d_%s' % (laser, length) for laser in (0, 1) for length in LENGTHS] + ['camera_body']


class BadArgument(Exception):
    """Refuses an argument, with its name, its value and the cure."""


def number(name, text):
    least, most, unit = LENGTHS[name.split('_', 2)[2]]
    try:
        value = float(text)
    except ValueError:
        value = float('nan')
    if not least <= value <= most:
        raise BadArgument("%s: '%s'; give %g .. %g %s" % (name, text, least, most, unit))
    return value


def parse(words):
    """Arguments by name."""
    given = {}
    for word in words:
        name, colon, text = word.partition('=')
        if not colon:
            raise BadArgument("'%s': no argument; write NAME=VALUE" % word)
        if name not in NAMES:
            near = difflib.get_close_matches(name, NAMES, 1)
            cure = 'did you mean %s?' % near[0] if near else 'give one of %s' % ', '.join(NAMES)
            raise BadArgument('%s: no such argument; %s' % (name, cure))
        if name in given:
            raise BadArgument('%s: given twice; give it once' % name)
        if name == 'camera_body' and text not in BODIES:
            raise BadArgument("camera_body: '%s'; give %s" % (text, ', '.join(BODIES)))
        given[name] = text if name == 'camera_body' else number(name, text)
    return given


def element(robot, kind, name):
    return next(found for found in robot.findall(kind) if found.get('name') == name)


def numbers(values):
    return ' '.join('%.10g' % value for value in values)


def place_laser(robot, laser, given):
    """Housing and clamp of a laser; laser_0 is on the side of the flange's negative x."""
    side = -1 if laser == 0 else 1
    origin = element(robot, 'joint', 'laser_housing_%d_joint' % laser).find('origin')
    x, _, z = (float(text) for text in origin.get('xyz').split())
    turn = float(origin.get('rpy').split()[1])
    half = given.get('laser_%d_half_distance' % laser, side * x)
    height = given.get('laser_%d_height' % laser, z)
    tilt = given.get('laser_%d_tilt' % laser, -side * turn)
    origin.set('xyz', numbers((side * half, 0, height)))
    origin.set('rpy', numbers((0, -side * tilt, 0)))
    clamp = element(robot, 'link', 'bracket').findall('visual')[4 + laser]
    top = height - BELOW_LIGHT
    clamp.find('origin').set('xyz', numbers((side * (half + OUTWARDS), 0, (PROFILE_TOP + top) / 2)))
    box = clamp.find('geometry/box')
    box.set('size', numbers([float(text) for text in box.get('size').split()[:2]] + [top - PROFILE_TOP]))


def place_camera(robot, size):
    """Body on the profile, with the lens at its front."""
    body, lens = element(robot, 'link', 'camera_body').findall('visual')
    body.find('origin').set('xyz', numbers((0, 0, BODY_BACK + size[2] / 2)))
    body.find('geometry/box').set('size', numbers(size))
    radius, length = LENS
    lens.find('origin').set('xyz', numbers((0, 0, BODY_BACK + size[2] + length / 2)))
    lens.find('geometry/cylinder').set('radius', numbers((radius,)))
    lens.find('geometry/cylinder').set('length', numbers((length,)))


def described(given):
    robot = ElementTree.parse(MODEL).getroot()
    for laser in (0, 1):
        if any(name.startswith('laser_%d_' % laser) for name in given):
            place_laser(robot, laser, given)
    size = BODIES[given.get('camera_body', 'generic')]
    if size:
        place_camera(robot, size)
    return ElementTree.tostring(robot, encoding='unicode')


def main():
    if sys.argv[1:] in (['--help'], ['-h']):
        print(__doc__)
        return
    try:
        print(described(parse(sys.argv[1:])))
    except BadArgument as bad:
        sys.exit('bracket: %s' % bad)


if __name__ == '__main__':
    main()
