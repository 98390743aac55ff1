#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Every launch file loads in every combination of its switches, and refers only to what exists."""
import functools
import glob
import itertools
import os
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import roslaunch.config
import roslib.packages
import rospkg
import rostest
import yaml

FOLDER = os.path.realpath(os.path.join(os.path.dirname(os.path.realpath(__file__)), '../../../../launch'))
SIMULATOR = os.path.join(rospkg.RosPack().get_path('scan_cell_sim'), 'config')
# A user's values for arguments that have no default, or need a file without sim.
GIVEN = {
    'scanner': os.path.join(SIMULATOR, 'scanner.yaml'),
    'cell': os.path.join(SIMULATOR, 'cell.yaml'),
    'world': os.path.join(SIMULATOR, 'reference_frame.yaml'),
    'controller': '192.168.0.10',
    'camera': '192.168.1.20',
    'port': '/dev/parport0',
    'input': '/cloud',
    'bag': '/tmp/scan.bag',
    'reference': '/tmp/reference.ply',
    'path': '/tmp/path.csv',
    'output': '/tmp/out',
}
OWN_PORT = 0  # no master is asked


def launch_files():
    return sorted(glob.glob(os.path.join(FOLDER, '*.launch')))


def arguments(path):
    """The arguments that a caller may set: name to default."""
    root = ElementTree.parse(path).getroot()
    return {arg.get('name'): arg for arg in root.findall('arg') if arg.get('value') is None}


def switches(path):
    return [name for name, arg in arguments(path).items() if arg.get('default') in ('true', 'false')]


def combinations(path):
    """All settings of the switches, each with the minimum of other arguments."""
    names = switches(path)
    for values in itertools.product(('false', 'true'), repeat=len(names)):
        given = dict(zip(names, values))
        for name, arg in arguments(path).items():
            needs_file = name in ('scanner', 'cell') and given.get('sim') != 'true'
            if arg.get('default') is None or needs_file:
                given[name] = GIVEN[name]
        yield given


def load(path, /, **given):
    return roslaunch.config.load_config_default(
        [(path, ['%s:=%s' % pair for pair in given.items()])], OWN_PORT, verbose=False)


@functools.lru_cache(maxsize=None)
def loaded():
    """Every file in every combination: its name, and roslaunch's result."""
    every = []
    for path in launch_files():
        for given in combinations(path):
            words = [os.path.basename(path)] + ['%s:=%s' % pair for pair in given.items()]
            every.append((' '.join(words), load(path, **given)))
    return every


class LaunchFiles(unittest.TestCase):
    cell = os.path.join(FOLDER, 'scan_cell.launch')

    def test_are_all_looked_at(self):
        names = [os.path.basename(path) for path in launch_files()]
        for name in ('scan_cell.launch', 'calibration.launch', 'devices.launch', 'replay.launch', 'stages.launch',
                     'preprocess.launch', 'simulator.launch'):
            self.assertIn(name, names)
        self.assertEqual(len(list(combinations(self.cell))), 2 ** len(switches(self.cell)))

    def test_say_what_each_argument_is_for(self):
        for path in launch_files():
            for name, arg in arguments(path).items():
                self.assertTrue(arg.get('doc'), '%s: %s has no doc' % (path, name))

    def test_load_without_complaint(self):
        for what, config in loaded():
            self.assertEqual(config.config_errors, [], what)

    def test_start_only_programs_that_are_built(self):
        for what, config in loaded():
            self.assertTrue(config.nodes, what)
            for node in config.nodes:
                found = roslib.packages.find_node(node.package, node.type)
                self.assertTrue(found, '%s: no %s in %s' % (what, node.type, node.package))

    def test_load_only_nodelets_that_are_declared(self):
        declared = set()
        for description in glob.glob(os.path.join(FOLDER, '../src/*/*.xml')):
            for element in ElementTree.parse(description).getroot().iter('class'):
                declared.add(element.get('name'))
        for what, config in loaded():
            for node in config.nodes:
                words = node.args.split()
                if node.type == 'nodelet' and words[0] == 'load':
                    self.assertIn(words[1], declared, what)

    def test_name_only_files_that_exist(self):
        """rosparam reads its files while loading; these are read by the nodes."""
        for what, config in loaded():
            texts = [param.value for param in config.params.values() if isinstance(param.value, str)]
            texts += [word for node in config.nodes for word in node.args.split()]
            files = [text for text in texts if text.startswith('/') and
                     os.path.splitext(text)[1] in ('.yaml', '.rviz', '.xml', '.urdf')]
            for name in files:
                self.assertTrue(os.path.isfile(name), '%s: no %s' % (what, name))

    def test_open_rviz_with_a_persons_own_settings(self):
        opened = [node for _, config in loaded() for node in config.nodes if 'rviz' in node.type]
        self.assertTrue(opened)
        for node in opened:
            self.assertEqual((node.package, node.type), ('scan_cell_rviz', 'own_rviz.py'))

    def test_never_give_a_node_an_empty_file_name(self):
        for what, config in loaded():
            for name, param in config.params.items():
                if name.endswith(('/scanner', '/scanner_file', '/cell_file', '/scanner_model')):
                    self.assertTrue(param.value, '%s: %s is empty' % (what, name))

    def nodes(self, **given):
        return {node.name: node for node in load(self.cell, **given).nodes}

    @staticmethod
    def real(**given):
        return dict(given, sim='false', scanner=GIVEN['scanner'], cell=GIVEN['cell'])

    def test_starts_what_its_switches_ask_for_and_nothing_else(self):
        plain = set(self.nodes(sim='true'))
        self.assertEqual(set(self.nodes(sim='true', rviz='true')) - plain, {'rviz'})
        self.assertEqual(set(self.nodes(sim='true', videe='true')) - plain, {'videe'})
        self.assertEqual(set(self.nodes(sim='true', record='/tmp/a.bag')) - plain, {'record'})
        self.assertEqual(plain - set(self.nodes(**self.real())), {'scan_cell_sim'})

    def test_puts_the_chain_into_one_manager_where_asked(self):
        plain, in_one = self.nodes(sim='true'), self.nodes(sim='true', nodelets='true')
        self.assertEqual(set(in_one) - set(plain), {'chain'})
        self.assertEqual(set(plain) - set(in_one), set())
        self.assertEqual((in_one['chain'].type, in_one['chain'].args), ('nodelet', 'manager'))
        chain = {'camera': 'tecnogamma_camera/Camera',
                 'pose_frame_binder': 'pose_frame_binder/Binder',
                 'laser_triangulation': 'laser_triangulation/Triangulation'}
        for name, node in in_one.items():
            if name in chain:
                self.assertEqual((node.type, node.args), ('nodelet', 'load %s chain' % chain[name]))
                self.assertEqual(node.remap_args, plain[name].remap_args)
            elif name != 'chain':
                self.assertEqual((node.type, node.args), (plain[name].type, plain[name].args))
        parameters = {key: value.value for key, value in load(self.cell, sim='true').params.items()}
        self.assertEqual({key: value.value for key, value in
                          load(self.cell, sim='true', nodelets='true').params.items()}, parameters)

    def test_puts_the_stages_of_a_replay_into_one_manager_where_asked(self):
        replay = os.path.join(FOLDER, 'replay.launch')
        given = {name: GIVEN[name] for name in ('bag', 'reference', 'path', 'output')}
        nodes = {node.name: node
                 for node in load(replay, sim='true', nodelets='true', **given).nodes}
        self.assertEqual(nodes['pose_frame_binder'].args, 'load pose_frame_binder/Binder chain')
        self.assertEqual(nodes['laser_triangulation'].args,
                         'load laser_triangulation/Triangulation chain')
        self.assertEqual((nodes['chain'].type, nodes['chain'].args), ('nodelet', 'manager'))

    def test_lets_the_simulator_keep_its_truth_and_the_cell_know_only_what_was_calibrated(self):
        params = load(self.cell, sim='true').params
        truth = params['/scan_cell_sim/scanner'].value
        self.assertEqual(os.path.basename(truth), 'scanner.yaml')
        for name in ('/laser_triangulation/scanner', '/calibrated_frames/scanner_file', '/camera/scanner_model'):
            self.assertEqual(os.path.basename(params[name].value), 'calibrated_scanner.yaml')

    def test_draws_the_light_of_the_lasers_that_the_trigger_switches(self):
        remaps = dict(self.nodes(sim='true')['calibrated_frames'].remap_args)
        self.assertEqual(remaps, {'trigger_state': '/laser_trigger/state', 'trigger_events': '/laser_trigger/events'})
        with open(os.path.join(FOLDER, 'cell.rviz')) as file:
            displays = yaml.safe_load(file)['Visualization Manager']['Displays']
        self.assertIn('/calibrated_frames/light_sheets', [display.get('Marker Topic') for display in displays])

    def test_draws_the_bracket_that_is_asked_for_and_refuses_another_by_name(self):
        plain = load(self.cell, sim='true').params['/robot_description'].value
        self.assertIn('xyz="-0.250 0 0.097" rpy="0 0.4735 0"', plain)
        set_up = load(self.cell, sim='true', bracket='laser_0_tilt=0.3 camera_body=bluecougar')
        self.assertIn('xyz="-0.25 0 0.097" rpy="0 0.3 0"', set_up.params['/robot_description'].value)
        with self.assertRaises(Exception):
            load(self.cell, sim='true', bracket='laser_0_tlit=0.3')

    def test_calibrates_without_a_scanner_model(self):
        path = os.path.join(FOLDER, 'calibration.launch')
        params = load(path, sim='true', videe='true').params
        self.assertNotIn('/camera/scanner_model', params)
        self.assertEqual(params['/camera/live_ratio'].value, 1)
        self.assertTrue(os.path.isfile(params['/videe/calibration/poses'].value))

    def test_records_what_replay_plays(self):
        recorded = self.nodes(sim='true', record='/tmp/a.bag')['record'].args.split()
        for topic in ('/tf', '/laser_trigger/events', '/camera/profiles', '/scan_cell/state', '/scan_cell/runs'):
            self.assertIn(topic, recorded)

    def test_reaches_the_hardware_only_without_the_simulator(self):
        port = '/laser_trigger/port'
        self.assertEqual(load(self.cell, sim='true').params[port].value, 'loopback')
        given = self.real(port='/dev/parport7', controller='192.168.0.10')
        params = load(self.cell, **given).params
        self.assertEqual(params[port].value, 'parallel')
        self.assertEqual(params['/laser_trigger/device'].value, '/dev/parport7')
        self.assertEqual(params['/c4g_driver/address'].value, '192.168.0.10')

    def test_lets_settings_override_any_parameter(self):
        with tempfile.NamedTemporaryFile('w', suffix='.yaml') as settings:
            settings.write('camera: {exposure: 0.0123}\nlaser_trigger: {port: parallel}\n')
            settings.flush()
            params = load(self.cell, sim='true', settings=settings.name).params
        self.assertEqual(params['/camera/exposure'].value, 0.0123)
        self.assertEqual(params['/laser_trigger/port'].value, 'parallel')

    def test_refuses_settings_that_are_not_there(self):
        with self.assertRaises(Exception):
            load(self.cell, sim='true', settings='/no/such/settings.yaml')

    def test_binds_as_it_is_told_without_more(self):
        for binding in ('interpolate', 'first_pose', 'constant_speed'):
            params = load(self.cell, sim='true', binding=binding).params
            self.assertEqual(params['/pose_frame_binder/method'].value, binding)

    def test_starts_what_died_again_only_where_asked(self):
        names = ('c4g_driver', 'camera', 'laser_trigger', 'scan_cell', 'scan_cell_sim', 'videe')
        for asked in (False, True):
            nodes = self.nodes(sim='true', videe='true', respawn=str(asked).lower())
            self.assertEqual({name: nodes[name].respawn for name in names}, dict.fromkeys(names, asked))


if __name__ == '__main__':
    rostest.rosrun('scan_cell_demo', 'launch_files', LaunchFiles)
