#!/usr/bin/env python3
"""Runs a command in a network of its own, which has the loopback device and nothing else.

Tests beside each other then meet neither each other's ROS master nor ports. Where the system forbids such
a network, they wait for each other instead.

Usage: own_network.py COMMAND [ARGUMENT...]"""

import ctypes
import fcntl
import os
import socket
import struct
import sys
import tempfile

CLONE_NEWNET, CLONE_NEWUSER = 0x40000000, 0x10000000  # sched.h
SIOCGIFFLAGS, SIOCSIFFLAGS = 0x8913, 0x8914  # bits/ioctls.h
IFF_UP = 1  # net/if.h
LIBC = ctypes.CDLL(None, use_errno=True)


def leave_network():
    """Whether this process now has its own network; an ordinary user needs a user namespace for that."""
    if LIBC.unshare(CLONE_NEWNET) == 0:
        return True
    user, group = os.getuid(), os.getgid()
    if LIBC.unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0:
        return False
    for name, text in (("setgroups", "deny"), ("uid_map", f"{user} {user} 1"), ("gid_map", f"{group} {group} 1")):
        with open(f"/proc/self/{name}", "w", encoding="ascii") as file:
            file.write(text)
    return True


def start_loopback():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as control:
        request = struct.pack("16sH22x", b"lo", 0)
        flags = struct.unpack_from("H", fcntl.ioctl(control, SIOCGIFFLAGS, request), 16)[0]
        fcntl.ioctl(control, SIOCSIFFLAGS, struct.pack("16sH22x", b"lo", flags | IFF_UP))


def wait_for_the_others():
    """Takes a lock that is inherited, and ends with the command's last process."""
    path = os.path.join(tempfile.gettempdir(), f"scan_cell_tests_{os.getuid()}.lock")
    lock = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
    os.set_inheritable(lock, True)
    fcntl.flock(lock, fcntl.LOCK_EX)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    if leave_network():
        start_loopback()
        os.environ["ROS_HOSTNAME"] = "localhost"  # the machine's name may resolve to an address that is gone
    else:
        wait_for_the_others()
    os.execvp(sys.argv[1], sys.argv[1:])


if __name__ == "__main__":
    main()
