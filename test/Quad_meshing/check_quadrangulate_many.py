#!/usr/bin/env python3
"""Runs quadrangulate_many on a folder with a failing, a hanging and a killed model, kills it on the way, and lets it go on:
nothing is lost, nothing that ended is run twice, and the table tells how each model ended.

usage: check_quadrangulate_many.py SCRIPT PROGRAM

The exit code is 77 where GNU parallel is not installed.
"""

import collections
import os
import shutil
import signal
import stat
import subprocess
import sys
import time

SKIPPED = 77
CUBE = ("OFF\n8 12 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n"
        "3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n")
GOOD = ["a cube.off", "b'quoted'$HOME.off", "c.off", "d.off", "e.off"]
# Some models meet a program that behaves badly. Every start is written down.
WRAPPER = """#!/bin/sh
echo "$(basename "$1")" >>"%(starts)s"
case "$1" in
  */hanging.off) trap '' TERM; while :; do sleep 1; done ;;
  */killed.off) kill -9 $$ ;;
  */crashing.off) kill -SEGV $$ ;;
  */slow.off) sleep 4 ;;
  */c.off) ulimit -v >"%(starts)s.memory" ;;
esac
exec "%(program)s" "$@"
"""

failures = []


def check(condition, what):
    if not condition:
        failures.append(what)
        print("FAILED: " + what)


def starts():
    with open("starts", encoding="utf-8") as file:
        return collections.Counter(file.read().splitlines())


def table(out):
    with open(os.path.join(out, "figures.tsv"), encoding="utf-8") as file:
        lines = [line.rstrip("\n").split("\t") for line in file]
    return {row[0]: dict(zip(lines[0], row)) for row in lines[1:]}


def main():
    script, program = map(os.path.abspath, sys.argv[1:3])
    if shutil.which("parallel") is None:
        print("skipped: GNU parallel is not installed")
        return SKIPPED
    for name in ("models", "out", "parts"):
        shutil.rmtree(name, ignore_errors=True)
    os.mkdir("models")
    open("starts", "w", encoding="utf-8").close()
    for name in GOOD + ["hanging.off", "killed.off", "crashing.off", "slow.off"]:
        with open(os.path.join("models", name), "w", encoding="ascii") as file:
            file.write(CUBE)
    with open("models/damaged.off", "w", encoding="ascii") as file:
        file.write("OFF\n3 1 0\n0 0 0\n1 0 0\n")
    with open("wrapper", "w", encoding="ascii") as file:
        file.write(WRAPPER % {"starts": os.path.abspath("starts"), "program": program})
    os.chmod("wrapper", os.stat("wrapper").st_mode | stat.S_IXUSR)
    models = set(os.listdir("models"))
    command = [script, "models", "out", "--program", "wrapper", "--jobs", "2", "--time-limit", "20", "--memory-limit", "4000",
               "--", "--target-quads", "100"]

    # Killed while the slow model runs, without a chance to clean up.
    first = subprocess.Popen(command, start_new_session=True)
    end = time.time() + 200
    while starts()["slow.off"] == 0 and first.poll() is None and time.time() < end:
        time.sleep(0.2)
    check(first.poll() is None, "the first call ended before it could be killed")
    os.killpg(first.pid, signal.SIGKILL)
    first.wait()
    before, ended = starts(), set(os.listdir("out/status"))
    print("killed after %d starts and %d ends" % (sum(before.values()), len(ended)))
    check(0 < len(ended) < len(models), "the first call was not interrupted in the middle")

    second = subprocess.run(command, check=False)
    check(second.returncode == 1, "exit code %d of the second call" % second.returncode)
    after = starts()
    check(set(after) == models, "started were %s" % sorted(after))
    for name in models:
        most = 1 if name in ended or before[name] == 0 else 2
        check(after[name] <= most, "%s was started %d times" % (name, after[name]))
    with open("starts.memory", encoding="ascii") as file:
        check(file.read().split() == ["4096000"], "the limit of memory is not in force")

    rows = table("out")
    check(set(rows) == models, "the table has the rows %s" % sorted(rows))
    expected = {"hanging.off": "time limit", "killed.off": "ended by SIGKILL", "crashing.off": "ended by SIGSEGV",
                "damaged.off": "unusable input"}
    for name in models:
        outcome = expected.get(name, "valid")
        check(rows.get(name, {}).get("outcome") == outcome, "%s ended so: %s" % (name, rows.get(name)))
        if outcome == "valid":
            for ending in ("quads.obj", "figures.json", "picture.png", "log.txt"):
                path = "out/results/%s.%s" % (name, ending)
                check(os.path.exists(path) and os.path.getsize(path) > 0, path + " is missing")
            check(int(rows[name]["quads"]) > 50 and rows[name]["valid"] == "yes", "the figures of %s are wrong" % name)
    check("damaged.off: " in rows["damaged.off"]["message"], "no message of the damaged model")
    with open("out/index.html", encoding="utf-8") as file:
        index = file.read()
    check(index.count("<img ") == len(models) - len(expected) and "10 models, 6 valid" in index, "the index is wrong")
    check(not os.path.exists("out/partial"), "there are left-over files")

    # Nothing is left to do; then the failures once more; other options are refused.
    check(subprocess.run(command, check=False).returncode == 1 and starts() == after, "a third call runs models again")
    retry = command[:3] + ["--retry"] + command[3:]
    retry[retry.index("--time-limit") + 1] = "2"
    subprocess.run(retry, check=False)
    again = dict(starts() - after)
    check(again == {name: 1 for name in expected}, "started again were %s" % again)
    other = subprocess.run(command[:-1] + ["200"], stderr=subprocess.PIPE, check=False)
    check(other.returncode == 2 and b"another request" in other.stderr, "results of other options are mixed")

    # Two tasks of an array, which another call completes.
    for name in expected:
        os.remove(os.path.join("models", name))
    count = sum(starts().values())
    parts = [script, "models", "parts", "--program", program, "--jobs", "1"]
    behind = ["--", "--target-quads", "100"]
    for part in ("1/2", "2/2"):
        done = subprocess.run(parts + ["--part", part] + behind, check=False)
        check(done.returncode == 0 and not os.path.exists("parts/figures.tsv"), "part " + part + " failed")
    check(len(os.listdir("parts/status")) == 6, "the parts are not all")
    done = subprocess.run(parts + ["--pages"] + behind, check=False)
    check(done.returncode == 0 and len(table("parts")) == 6 and count == sum(starts().values()), "no table of the parts")

    print("%d failures" % len(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
