#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""A recipe from a first scan to a run in the simulated cell, with typed commands and with the action."""
import csv
import glob
import json
import os
import shutil
import subprocess
import unittest

import actionlib
import rosbag
import rospy
import rostest
from geometry_msgs.msg import Point
from scan_cell_msgs.msg import CellState, RecipeState, RunRecipeAction, RunRecipeGoal, RunRecipeResult, TriggerState
from scan_cell_msgs.srv import (ApproveRun, CheckProgram, DescribeRun, DesignPath, DesignPathRequest, EditProgram,
                                ListRecipes)
from visualization_msgs.msg import Marker, MarkerArray

PATIENCE = 240  # [s] a scan takes 10 to 20 s, as does the work


def rosrun(*command):
    return subprocess.run(['rosrun'] + list(command), check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout


class Recipes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.recipes = rospy.get_param('/part_recipes/recipes')
        cls.runs = rospy.get_param('/part_recipes/runs')
        for folder in (cls.recipes, cls.runs):
            shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(cls.recipes)
        cls.file = staticmethod(lambda name: os.path.join(os.path.dirname(cls.recipes), name))
        package = subprocess.check_output(['rospack', 'find', 'scan_cell'], universal_newlines=True).strip()
        program = package + '/config/both_lasers.yaml'
        rosrun('scan_cell', 'scan', '--program', program, '--output', cls.file('raw.ply'), '--clean', cls.file('part.ply'))
        rosrun('scan_cell_sim', 'ground_truth', 'tool_path', '--world', rospy.get_param('/scan_cell_sim/world'), '--part', 'frame',
               '--output', cls.file('path.csv'))
        for name, side in (('frame', 'into_part'), ('from_below', 'out_of_part')):
            rosrun('part_recipes', 'recipe', '--recipes', cls.recipes, 'new', name, '--reference', cls.file('part.ply'),
                   '--path', cls.file('path.csv'), '--program', program, '--work', 'waypoint_z=' + side)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(os.path.dirname(cls.recipes))

    def setUp(self):
        self.lasers = None
        rospy.Subscriber('/laser_trigger/state', TriggerState, self.on_trigger)
        self.client = actionlib.SimpleActionClient('/part_recipes/run', RunRecipeAction)
        self.assertTrue(self.client.wait_for_server(rospy.Duration(PATIENCE)))

    def on_trigger(self, message):
        self.lasers = message

    def run_recipe(self, **goal):
        self.client.send_goal(RunRecipeGoal(**goal))
        self.assertTrue(self.client.wait_for_result(rospy.Duration(PATIENCE)))
        return self.client.get_result()

    def list(self):
        rospy.wait_for_service('/part_recipes/list', PATIENCE)
        return {recipe.name: recipe for recipe in rospy.ServiceProxy('/part_recipes/list', ListRecipes)().recipes}

    def test_a_scan_by_the_cell_becomes_a_run_that_work_can_go_by(self):
        result = self.run_recipe(recipe='frame', note='first')
        self.assertEqual(result.outcome, RunRecipeResult.ACCEPTED, result.message)
        with open(os.path.join(result.folder, 'run.json')) as file:
            run = json.load(file)
        self.assertEqual(run['note'], 'first')
        self.assertEqual([stage['name'] for stage in run['stages']][:3], ['scan', 'clean', 'stretch'])
        self.assertLess(abs(run['figures']['scale'] - 1), 1e-3)
        with open(os.path.join(result.folder, 'report.json')) as file:
            report = json.load(file)
        self.assertEqual(report['calibration']['scanner']['name'], rospy.get_param('/calibrated_frames/scanner_file'))
        self.assertEqual(run['calibration']['scanner'], report['calibration']['scanner']['sha256'])
        self.assertGreater(report['scanned'], 0)
        self.assertTrue(os.path.exists(os.path.join(result.folder, 'report.html')))
        again = subprocess.run(['rosrun', 'part_recipes', 'run', '--again', result.folder, '--runs', self.runs])
        self.assertEqual(again.returncode, 0)

    def test_a_recipe_is_proven_by_the_cell_and_refused_after_another_calibration(self):
        result = self.run_recipe(recipe='frame', prove=True)
        self.assertEqual(result.outcome, RunRecipeResult.ACCEPTED, result.message)
        self.assertTrue(result.proven)
        self.assertEqual(self.list()['frame'].state, RecipeState.PROVEN)
        proof_file = os.path.join(self.recipes, 'frame', 'proof.json')
        with open(proof_file) as file:
            text = file.read()
        proof = json.loads(text)
        self.assertIn('scanner', proof['calibration'])
        proof['calibration']['scanner'] = '0' * 64
        with open(proof_file, 'w') as file:
            json.dump(proof, file)
        armed = self.lasers.arming
        result = self.run_recipe(recipe='frame')
        self.assertEqual(result.outcome, RunRecipeResult.NONE)
        self.assertIn('recipe prove', result.message)
        self.assertEqual(self.lasers.arming, armed, 'it scanned before it was refused')
        with open(proof_file, 'w') as file:
            file.write(text)

    def test_a_run_that_is_cancelled_in_its_scan_leaves_nothing_and_no_laser_on(self):
        before = sorted(glob.glob(self.runs + '/*'))
        scanning = []
        self.client.send_goal(RunRecipeGoal(recipe='frame'),
                              feedback_cb=lambda feedback: scanning.append(feedback.stage))
        end = rospy.Time.now() + rospy.Duration(PATIENCE)
        while not (self.lasers and self.lasers.lasers):
            self.assertLess(rospy.Time.now(), end)
            rospy.sleep(0.02)
        self.assertEqual(scanning, ['scan'])
        self.client.cancel_goal()
        self.assertTrue(self.client.wait_for_result(rospy.Duration(PATIENCE)))
        self.assertEqual(self.client.get_state(), actionlib.GoalStatus.PREEMPTED)
        self.assertEqual(self.client.get_result().outcome, RunRecipeResult.NONE)
        while self.lasers.lasers:
            self.assertLess(rospy.Time.now(), end)
            rospy.sleep(0.02)
        self.assertEqual(sorted(glob.glob(self.runs + '/*')), before)
        self.assertEqual(glob.glob(self.runs + '/.2*'), [])

    def test_a_part_is_worked_once_its_path_was_run_dry(self):
        result = self.run_recipe(recipe='frame', work=RunRecipeGoal.WORK)
        self.assertEqual(result.outcome, RunRecipeResult.ACCEPTED, result.message)
        self.assertFalse(result.worked)
        self.assertIn('dry', result.work_message)
        for work, name in ((RunRecipeGoal.DRY_RUN, 'dry_run'), (RunRecipeGoal.WORK, 'work')):
            result = self.run_recipe(recipe='frame', work=work)
            self.assertEqual(result.outcome, RunRecipeResult.ACCEPTED, result.message)
            self.assertTrue(result.worked, result.work_message)
            with open('%s.%s.json' % (result.folder, name)) as file:
                record = json.load(file)
            self.assertTrue(record['finished'])
            self.assertEqual(record['dry_run'], name == 'dry_run')
            with open(os.path.join(result.folder, 'report.json')) as file:
                waypoints = len(json.load(file)['quality'])
            self.assertEqual([each['waypoint'] for each in record['passed']], list(range(waypoints)))

    def test_a_run_is_worked_later_unless_a_person_refused_it(self):
        run = os.path.basename(self.run_recipe(recipe='frame').folder)
        approve = rospy.ServiceProxy('/part_recipes/approve', ApproveRun)
        self.assertTrue(approve(run=run, approved=False, name='Ada', note='clamp was loose').success)
        result = self.run_recipe(run=run, work=RunRecipeGoal.DRY_RUN)
        self.assertEqual(result.outcome, RunRecipeResult.NONE)
        self.assertIn('clamp was loose', result.message)
        self.assertTrue(approve(run=run, approved=True, name='Ada').success)
        for record in ('dry_run', 'dry_run_2'):
            result = self.run_recipe(run=run, work=RunRecipeGoal.DRY_RUN)
            self.assertEqual(os.path.basename(result.folder), run)
            self.assertTrue(result.worked, result.work_message)
            with open('%s.%s.json' % (result.folder, record)) as file:
                self.assertTrue(json.load(file)['finished'])
        self.assertIn('NO_WORK', self.run_recipe(run=run).message)
        self.assertIn('name', approve(run='../frame', approved=True, name='Ada').message)
        self.assertIn('run.json', approve(run='nothing', approved=True, name='Ada').message)

    def test_a_path_edited_by_hand_is_a_run_that_needs_a_dry_run_of_its_own(self):
        first = self.run_recipe(recipe='frame', work=RunRecipeGoal.DRY_RUN)
        self.assertTrue(first.worked, first.work_message)
        run = os.path.basename(first.folder)
        edits = 'edits: [{delete: {waypoints: [0, 4]}}, {move: {waypoints: 0, by: [0, 0, -0.001]}}]'
        edited = self.run_recipe(run=run, path_edits=edits, note='clear of the clamp')
        self.assertEqual(edited.outcome, RunRecipeResult.ACCEPTED, edited.message)
        self.assertNotEqual(edited.folder, first.folder)
        rospy.wait_for_service('/part_recipes/describe', PATIENCE)
        describe = rospy.ServiceProxy('/part_recipes/describe', DescribeRun)
        before, after = (sum(len(segment.waypoints) for segment in describe(run=os.path.basename(folder)).path.segments)
                         for folder in (first.folder, edited.folder))
        self.assertEqual(after, before - 5)
        described = describe(run=os.path.basename(edited.folder))
        self.assertEqual(len(described.expected_errors), after)
        self.assertEqual(described.path.process_names[-1], 'edited')
        self.assertEqual(described.path.segments[0].waypoints[0].process_values[-1], 1)
        result = self.run_recipe(run=os.path.basename(edited.folder), work=RunRecipeGoal.WORK)
        self.assertFalse(result.worked)
        self.assertIn('dry', result.work_message)
        result = self.run_recipe(run=os.path.basename(edited.folder), work=RunRecipeGoal.DRY_RUN)
        self.assertTrue(result.worked, result.work_message)
        with open(edited.folder + '.dry_run.json') as file:
            self.assertEqual(len(json.load(file)['passed']), after)
        self.assertIn('no waypoint 9999', self.run_recipe(run=run, path_edits='edits: [{delete: {waypoints: 9999}}]').message)
        self.assertIn('path_edits', self.run_recipe(run=run, path_edits='edits: [{cut: 1}]').message)
        self.assertIn('work', self.run_recipe(run=run, path_edits=edits, work=RunRecipeGoal.WORK).message)

    def test_a_run_whose_path_the_robot_cannot_follow_is_accepted_and_not_worked(self):
        result = self.run_recipe(recipe='from_below', work=RunRecipeGoal.DRY_RUN, bag=True)
        self.assertEqual(result.outcome, RunRecipeResult.ACCEPTED, result.message)
        self.assertFalse(result.worked)
        self.assertIn('the workspace is', result.work_message)
        self.assertTrue(os.path.exists(result.folder + '.dry_run.log'))
        with rosbag.Bag(os.path.join(result.folder, 'scan.bag')) as bag:
            states = [message.state for _, message, _ in bag.read_messages('/scan_cell/state')]
            profiles = bag.get_message_count('/camera/profiles')
        self.assertEqual(states[-2:], [CellState.SCANNING, CellState.FINISHED])
        with open(os.path.join(result.folder, 'scan.json')) as file:
            self.assertGreaterEqual(profiles, json.load(file)['binding']['bound'])
        self.check_sight(result.folder)
        self.check_unseen_are_shown(result.folder)
        with open(os.path.join(result.folder, 'report.json')) as file:
            self.check_signs(os.path.basename(result.folder), len(json.load(file)['quality']))
        result = self.run_recipe(recipe='frame', work=7)
        self.assertEqual(result.outcome, RunRecipeResult.NONE)
        self.assertIn('NO_WORK, DRY_RUN or WORK', result.message)

    def check_signs(self, run, waypoints):
        """What rviz shows of a run beside its clouds: the verdict in words, the ends of the scale of the deviations, and each
        waypoint with a colour."""
        signs, expected = [], []
        rospy.Subscriber('/part_recipes/signs', MarkerArray, signs.append)
        rospy.Subscriber('/part_recipes/expected', MarkerArray, expected.append)
        rospy.wait_for_service('/part_recipes/describe', PATIENCE)
        self.assertTrue(rospy.ServiceProxy('/part_recipes/describe', DescribeRun)(run=run).success)
        end = rospy.Time.now() + rospy.Duration(PATIENCE)
        while not any(marker.text.startswith('accepted') for array in signs for marker in array.markers):
            self.assertLess(rospy.Time.now(), end)
            rospy.sleep(0.02)
        texts = [marker.text for marker in signs[-1].markers]
        self.assertIn('-1 mm', texts)
        self.assertIn('+1 mm', texts)
        while not any(len(marker.colors) == waypoints for array in expected for marker in array.markers):
            self.assertLess(rospy.Time.now(), end)
            rospy.sleep(0.02)

    def check_sight(self, folder):
        """The parts of a run's message that tell what its scan could see."""
        said = []
        for name in ('scan.json', 'sight.json', 'report.json'):
            with open(os.path.join(folder, name)) as file:
                said.append(json.load(file))
        self.assertEqual(said[0]['camera_region'], {'x': 336, 'y': 599, 'width': 1024, 'height': 512})
        seen = [i for i, each in enumerate(said[1]['best']) if each['sight'] == 'seen']
        measured = [i for i in seen if said[2]['quality'][i]['measured']]
        print('%d waypoints, %d said to be seen, %d of these measured' % (said[1]['waypoints'], len(seen), len(measured)))
        self.assertGreater(len(seen), 100)
        self.assertGreaterEqual(len(measured), 0.95 * len(seen))

    def check_unseen_are_shown(self, folder):
        """rviz shows each waypoint that the scan could not see by its kind, with a line to what hid it."""
        file = os.path.join(folder, 'sight.json')
        with open(file) as opened:
            sight = json.load(opened)
        hidden, grazing, outside = sight['best'][:3]
        hidden.update(sight='shadowed', obstacle=[0.1, 0.2, 0.3])
        grazing.update(sight='grazing')
        outside.update(sight='out_of_range')
        with open(file, 'w') as opened:
            json.dump(sight, opened)
        unseen = []
        rospy.Subscriber('/part_recipes/unseen', MarkerArray, unseen.append)
        rospy.wait_for_service('/part_recipes/describe', PATIENCE)
        self.assertTrue(rospy.ServiceProxy('/part_recipes/describe', DescribeRun)(run=os.path.basename(folder)).success)
        shown = lambda: {each.ns: [[p.x, p.y, p.z] for p in each.points] for each in unseen[-1].markers} if unseen else {}
        end = rospy.Time.now() + rospy.Duration(PATIENCE)
        while not shown().get('shadowed'):
            self.assertLess(rospy.Time.now(), end)
            rospy.sleep(0.02)
        others = [each['position'] for each in sight['best'][3:] if each['sight'] != 'seen']
        self.assertIn(hidden['position'], shown()['shadowed'])
        self.assertIn(grazing['position'], shown()['grazing'])
        self.assertIn(outside['position'], shown()['out_of_range'])
        self.assertEqual(shown()['obstacles'][:2], [hidden['position'], hidden['obstacle']])
        self.assertEqual(sum(len(shown()[kind]) for kind in ('shadowed', 'grazing', 'out_of_range')), 3 + len(others))

    def test_a_path_picked_on_the_reference_becomes_a_recipe_whose_part_is_accepted(self):
        with open(self.file('path.csv')) as file:
            rows = list(csv.DictReader(file))[:60:12]
        picks = [Point(float(row['x']), float(row['y']), float(row['z'])) for row in rows]
        rospy.wait_for_service('/part_recipes/design', PATIENCE)
        design = rospy.ServiceProxy('/part_recipes/design', DesignPath)
        options = {'parameter_names': ['max_step', 'tool_x'], 'parameter_values': ['0.004', '1 0 0']}
        request = DesignPathRequest(recipe='frame', way=DesignPathRequest.PICKS, make=True, picks=picks, **options)
        answer = design(request)
        self.assertTrue(answer.success, answer.message)
        self.assertIn('closed', [parameter.name for parameter in answer.parameters])
        self.assertGreater(len(answer.path.segments[0].waypoints), len(picks))
        reference = rospy.wait_for_message('/part_recipes/reference', Marker, PATIENCE)
        self.assertGreater(len(reference.points), 3 * 1000, 'triangles')
        self.assertEqual(reference.header.frame_id, answer.frame)
        shown = rospy.wait_for_message('/part_recipes/designed_path', Marker, PATIENCE)
        self.assertEqual(len(shown.points), 2 * (len(answer.path.segments[0].waypoints) - 1), 'ends of lines')
        self.assertEqual(len(rospy.wait_for_message('/part_recipes/picks', Marker, PATIENCE).points), len(picks))
        request.save_as = 'picked'
        self.assertTrue(design(request).success)
        self.assertIn('already exists', design(request).message)
        self.assertEqual(self.list()['picked'].state, RecipeState.MADE)
        result = self.run_recipe(recipe='picked')
        self.assertEqual(result.outcome, RunRecipeResult.ACCEPTED, result.message)
        picks[1].z += 0.01
        answer = design(DesignPathRequest(recipe='frame', way=DesignPathRequest.PICKS, make=True, picks=picks))
        self.assertFalse(answer.success)
        self.assertIn('pick 2', answer.message)
        self.assertIn('no recipe', design(DesignPathRequest(recipe='none')).message)

    def test_passes_that_were_moved_are_the_recipes_once_the_cell_can_scan_them(self):
        rospy.wait_for_service('/part_recipes/program', PATIENCE)
        program = rospy.ServiceProxy('/part_recipes/program', EditProgram)
        check = rospy.ServiceProxy('/scan_cell/check_program', CheckProgram)
        told = program(recipe='from_below')
        self.assertTrue(told.success, told.message)
        self.assertEqual([len(scan_pass.poses) for scan_pass in told.passes], [2])
        self.assertTrue(check(told.frame, told.passes).success)
        told.passes[0].poses[1].position.z += 2
        far = check(told.frame, told.passes)
        self.assertFalse(far.success or far.link_lost, far.message)
        told.passes[0].poses[1].position.z -= 1.999
        self.assertTrue(check(told.frame, told.passes).success)
        self.assertTrue(program('from_below', True, told.frame, told.passes).success)
        now = program(recipe='from_below').passes[0].poses
        self.assertAlmostEqual(now[1].position.z, now[0].position.z + 0.001, 9)
        self.assertEqual(self.list()['from_below'].state, RecipeState.MADE)
        told.passes[0].speed = -1
        self.assertIn('speed', program('from_below', True, told.frame, told.passes).message)

    def test_a_recipe_that_is_not_there_is_named(self):
        result = self.run_recipe(recipe='../frame')
        self.assertEqual(result.outcome, RunRecipeResult.NONE)
        self.assertIn('recipe name', result.message)
        result = self.run_recipe(recipe='elbow')
        self.assertIn('frame', result.message)


if __name__ == '__main__':
    rospy.init_node('test_recipes')
    rostest.rosrun('scan_cell_demo', 'recipes', Recipes)
