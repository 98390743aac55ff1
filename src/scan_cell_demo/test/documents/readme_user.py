# Copyright 2026 the scan cell developers
# SPDX-License-Identifier: BSD-3-Clause
"""A user who types the commands of the README."""
import os
import re
import signal
import socket
import subprocess

import rospkg

ROOT = os.path.realpath(os.path.join(os.path.dirname(os.path.realpath(__file__)), '../../../..'))
SIMULATOR = os.path.join(rospkg.RosPack().get_path('scan_cell_sim'), 'config')
TIMEOUT = 300  # [s] of one command, on a busy computer


def commands(page, start):
    """The commands of a page that begin with `start`."""
    with open(os.path.join(ROOT, page)) as file:
        text = re.sub(r'\\\n\s*', '', file.read())
    return [line.strip() for line in text.splitlines() if line.startswith('    ' + start)]


def readme_command(start):
    """The first command of the README that begins with `start`."""
    return commands('README.md', start)[0]


def free_port():
    with socket.socket() as probe:
        probe.bind(('127.0.0.1', 0))
        return probe.getsockname()[1]


class User:
    """Types commands in a folder in which launch/ and out/ are as in the repository."""

    def __init__(self, folder):
        self.folder = folder
        os.symlink(os.path.join(ROOT, 'launch'), self.path('launch'))
        os.mkdir(self.path('out'))
        self.environment = dict(os.environ, ROS_HOME=self.path('ros'), ROS_IP='127.0.0.1',
                                ROS_MASTER_URI='http://127.0.0.1:%d' % free_port())

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def start(self, command, log):
        with open(self.path(log), 'w') as output:
            return subprocess.Popen(['bash', '-c', 'exec ' + command], cwd=self.folder, env=self.environment,
                                    stdout=output, stderr=subprocess.STDOUT, start_new_session=True)

    def end(self, process):
        """Sends Ctrl-C."""
        process.send_signal(signal.SIGINT)
        return self.wait(process)

    def wait(self, process):
        try:
            return process.wait(TIMEOUT)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            raise

    def run(self, command, log):
        return self.wait(self.start(command, log))

    def text(self, name):
        with open(self.path(name), 'rb') as file:
            return file.read()

    def log(self, name):
        return self.text(name).decode(errors='replace')[-3000:]
