#!/usr/bin/env python3
"""Runs quadrangulate_many on another machine by ssh, which here is this one: a server of its own, with keys of its own, at a
free port.

usage: check_many_over_ssh.py SCRIPT PROGRAM

The exit code is 77 where GNU parallel or OpenSSH's server is not installed, or the server does not let this user in.
"""

import getpass
import os
import shutil
import socket
import subprocess
import sys
import time

SKIPPED = 77
SQUARE = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"
MODELS = ["plain.off", "with a blank and 'quotes'.off"]


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


def start_server(folder, server, port):
    for name in ("host", "user"):
        subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", os.path.join(folder, name)], check=True)
    config = os.path.join(folder, "config")
    with open(config, "w", encoding="ascii") as file:
        file.write("Port %d\nListenAddress 127.0.0.1\nHostKey %s/host\nAuthorizedKeysFile %s/user.pub\nStrictModes no\n"
                   "UsePAM no\nPidFile none\nPermitRootLogin prohibit-password\n" % (port, folder, folder))
    if os.getuid() == 0:
        os.makedirs("/run/sshd", exist_ok=True) # the server wants it
    return subprocess.Popen([server, "-D", "-f", config], stderr=subprocess.DEVNULL)


def main():
    script, program = map(os.path.abspath, sys.argv[1:3])
    server = shutil.which("sshd") or shutil.which("/usr/sbin/sshd")
    if server is None or shutil.which("ssh") is None or shutil.which("parallel") is None:
        print("skipped: GNU parallel or OpenSSH's server is not installed")
        return SKIPPED
    for name in ("keys", "models", "out"):
        shutil.rmtree(name, ignore_errors=True)
        if name != "out":
            os.mkdir(name)
    os.chmod("keys", 0o700)
    for name in MODELS:
        with open(os.path.join("models", name), "w", encoding="ascii") as file:
            file.write(SQUARE)
    with open("models/damaged.off", "w", encoding="ascii") as file:
        file.write("OFF\n3 1 0\n")
    folder, port = os.path.abspath("keys"), free_port()
    daemon = start_server(folder, server, port)
    try:
        login = ("ssh -p %d -i %s/user -o BatchMode=yes -o StrictHostKeyChecking=no -o UserKnownHostsFile=%s/known %s@127.0.0.1"
                 % (port, folder, folder, getpass.getuser()))
        for _ in range(50):
            if subprocess.run(login.split() + ["true"], stderr=subprocess.DEVNULL, check=False).returncode == 0:
                break
            time.sleep(0.2)
        else:
            print("skipped: the server lets nobody in")
            return SKIPPED
        done = subprocess.run([script, "models", "out", "--program", program, "--jobs", "1", "--sshlogin", login, "--",
                               "--target-quads", "100"], check=False)
    finally:
        daemon.terminate()
        daemon.wait()
    with open("out/figures.tsv", encoding="utf-8") as file:
        rows = [line.rstrip("\n").split("\t") for line in file]
    outcomes = {row[0]: row[1] for row in rows[1:]}
    expected = dict({name: "valid" for name in MODELS}, **{"damaged.off": "unusable input"})
    with open("out/joblog.tsv", encoding="utf-8") as file:
        was_remote = all("127.0.0.1" in line for line in file.read().splitlines()[1:])
    if done.returncode == 1 and outcomes == expected and was_remote:
        return 0
    print("FAILED: exit code %d, outcomes %s, by ssh: %s" % (done.returncode, outcomes, was_remote))
    return 1


if __name__ == "__main__":
    sys.exit(main())
