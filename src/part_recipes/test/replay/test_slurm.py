#!/usr/bin/env python3
# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""Recorded runs are run again by a real Slurm: a controller and two node daemons on this machine. One node dies in mid
work; no run is lost, and none is done twice."""
import getpass
import glob
import json
import os
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import unittest

import numpy

JOBS = 5
LEASE = 8  # [s] a job of a dead worker is given to another after it
PATIENCE = 300  # [s]
CONFIGURATION = """
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/none
CredType=cred/none
SlurmctldPort={ports[0]}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/controller.pid
SlurmdPidFile={folder}/%n.pid
SlurmctldLogFile={folder}/controller.log
SlurmdLogFile={folder}/%n.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/linear
SlurmdTimeout=10
MpiDefault=none
NodeName=one NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[1]} CPUs=1
NodeName=two NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[2]} CPUs=1
PartitionName=all Nodes=one,two Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count):
    probes = [socket.socket() for _ in range(count)]
    for probe in probes:
        probe.bind(('127.0.0.1', 0))
    ports = [probe.getsockname()[1] for probe in probes]
    for probe in probes:
        probe.close()
    return ports


def wait_for(condition, what):
    end = time.time() + PATIENCE
    while not condition():
        if time.time() > end:
            raise AssertionError('waited in vain for ' + what)
        time.sleep(0.1)


def rosrun(*command):
    done = subprocess.run(['rosrun', 'part_recipes'] + [str(word) for word in command], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True, check=False)
    if done.returncode != 0:
        raise AssertionError('%s: %s' % (command, done.stdout))
    return done.stdout


def write_part(path, shift):
    """A plate of 120 x 80 mm with a step, a cone and a ridge: points 1 mm apart [m]."""
    x, y = [axis.ravel() for axis in numpy.meshgrid(numpy.arange(0, 0.12, 0.001), numpy.arange(0, 0.08, 0.001))]
    cone = numpy.maximum(0, 0.010 - 0.8 * numpy.hypot(x - 0.03, y - 0.055))
    ridge = numpy.where((y < 0.02) & (x < 0.06), 0.006 * numpy.sin(numpy.pi * x / 0.06), 0)
    top = numpy.stack([x, y, 0.012 * (x > 0.075) + cone + ridge], axis=1)
    y, z = [axis.ravel() for axis in numpy.meshgrid(numpy.arange(0, 0.08, 0.001), numpy.arange(0.001, 0.012, 0.001))]
    flank = numpy.stack([numpy.full(len(y), 0.0755), y, z], axis=1)
    points = numpy.concatenate([top, flank]) + [shift, 0, 0]
    with open(path, 'w') as file:
        file.write('ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\n'
                   'end_header\n' % len(points))
        numpy.savetxt(file, points, fmt='%.6f')


def have_an_address():
    """Slurm looks up names only if there is an address besides 127.0.0.1, which a test's own
    network lacks."""
    known = subprocess.check_output(['ip', '-4', '-o', 'address'], universal_newlines=True)
    if all(' 127.' in line for line in known.splitlines()):
        subprocess.check_call(['ip', 'address', 'add', '192.0.2.1/32', 'dev', 'lo'])  # RFC 5737: of documents


class Slurm:
    """A cluster of two nodes on this machine."""

    def __init__(self, folder):
        self.folder = folder
        have_an_address()
        os.mkdir(os.path.join(folder, 'state'))
        with open(os.path.join(folder, 'slurm.conf'), 'w') as file:
            file.write(CONFIGURATION.format(host=socket.gethostname(), user=getpass.getuser(), folder=folder,
                                            ports=free_ports(3)))
        self.environment = dict(os.environ, SLURM_CONF=file.name, PATH=os.environ['PATH'] + ':/usr/sbin')
        self.daemons = {'controller': self.start('slurmctld', '-D'), 'one': self.start('slurmd', '-D', '-N', 'one'),
                        'two': self.start('slurmd', '-D', '-N', 'two')}
        wait_for(lambda: self.ask('sinfo', '-h', '-t', 'idle', '-o', '%D').strip() == '2', 'two idle nodes')

    def start(self, *command):
        return subprocess.Popen(command, env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def ask(self, *command):
        return subprocess.run(command, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              universal_newlines=True, check=False).stdout

    def node_of(self, process):
        """The node that started a process, by its environment; None: no node did, or it is gone."""
        try:
            with open('/proc/%d/environ' % process, 'rb') as file:
                variables = file.read().split(b'\0')
        except OSError:
            return None
        names = [entry.split(b'=')[1].decode() for entry in variables if entry.startswith(b'SLURMD_NODENAME=')]
        return names[0] if names else None

    def kill_node(self, name):
        """Ends the node as if its plug were pulled."""
        self.daemons[name].kill()
        for process in [int(entry) for entry in os.listdir('/proc') if entry.isdigit()]:
            if self.node_of(process) == name:
                os.kill(process, signal.SIGKILL)

    def end(self):
        for daemon in self.daemons.values():
            daemon.kill()
            daemon.wait()
        for name in ('one', 'two'):
            self.kill_node(name)


class ReplayBySlurm(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix='slurm_', dir='/tmp')
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.record_runs()
        self.cluster = Slurm(self.folder)
        self.addCleanup(self.cluster.end)

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def record_runs(self):
        write_part(self.path('reference.ply'), 0)
        with open(self.path('path.csv'), 'w') as file:
            file.write('x,y,z,qx,qy,qz,qw\n')
            file.writelines('0.09,%.3f,0.012,1,0,0,0\n' % y for y in numpy.arange(0.01, 0.07, 0.002))
        with open(self.path('cleaning.yaml'), 'w') as file:
            file.write('floor: {automatic: false}\noutliers: {automatic: false}\nisolate: {select: all}\ngrid: false\n')
        rosrun('recipe', '--recipes', self.path('recipes'), 'new', 'plate', '--reference', self.path('reference.ply'),
               '--path', self.path('path.csv'), '--cleaning', self.path('cleaning.yaml'))
        for i in range(JOBS):
            write_part(self.path('scan.ply'), 0.01 * i)
            rosrun('run', 'plate', '--recipes', self.path('recipes'), '--runs', self.path('runs'), '--scan',
                   self.path('scan.ply'))

    def claimed_by(self, node):
        """Whether a worker of the node has a job."""
        for claim in glob.glob(self.path('jobs', 'claims', '2*')):
            try:
                with open(claim) as file:
                    process = int(file.read().split()[1])
            except (OSError, IndexError):
                continue
            if self.cluster.node_of(process) == node:
                return True
        return False

    def test_no_run_is_lost_or_done_twice_though_a_node_dies(self):
        rosrun('history', 'replay', '--jobs', self.path('jobs'), '--runs', self.path('runs'), '--recipe',
               self.path('recipes', 'plate'), '--only-add')
        submitted = self.cluster.ask(
            'sbatch', '--array=1-2', '--output', self.path('task-%a.log'), '--wrap',
            'rosrun part_recipes history replay --jobs %s --workers 1 --lease %d' % (self.path('jobs'), LEASE))
        self.assertIn('Submitted', submitted)
        wait_for(lambda: self.claimed_by('two'), 'a job on the second node')
        self.cluster.kill_node('two')
        done = self.path('jobs', 'done', '*.json')
        # The first node's worker may have ended before the dead one's claim was free: the next call
        # takes it.
        wait_for(lambda: self.cluster.ask('squeue', '-h', '-w', 'one').strip() == '', 'the first node')
        wait_for(lambda: 'left' not in subprocess.run(
            ['rosrun', 'part_recipes', 'history', 'replay', '--jobs', self.path('jobs'), '--workers', '1', '--lease',
             str(LEASE)], stdout=subprocess.PIPE, universal_newlines=True, check=False).stdout, 'the last job')
        results = []
        for file in glob.glob(done):
            with open(file) as text:
                results.append(json.load(text)['run'])
        self.assertEqual(len(results), JOBS, 'each is done')
        self.assertEqual(len(set(results)), JOBS, 'by a run of its own')
        recorded = set(os.path.basename(run) for run in glob.glob(self.path('runs', '2*')))
        again = []
        for name in results:
            with open(self.path('jobs', 'runs', name, 'run.json')) as text:
                again.append(json.load(text)['again_of'])
        self.assertEqual(sorted(again), sorted(recorded), 'each recorded run once')


if __name__ == '__main__':
    unittest.main()
