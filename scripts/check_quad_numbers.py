#!/usr/bin/env python3
"""Asks for numbers of quads on meshes and tells which results are far from them without saying why.

usage: check_quad_numbers.py PROGRAM MESH... [--numbers 500,1000,4000,16000] [--seconds N]

PROGRAM is quadrangulate. A row for each mesh and number: the quads of the result, what they are over what was asked for, the
seconds of processor time, and
  ok        a valid mesh within ten percent of the number
  said      a valid mesh farther from it, and the message speaks of the number of quads
  SILENT    a valid mesh farther from it, and the message does not speak of it
  invalid   no valid mesh; the message follows
  refused   the input or the number cannot be used; the message follows
  timeout   no result within the seconds of processor time
The last line counts them; the exit code is 1 if one is silent or if the program failed without a message.
"""

import argparse
import collections
import json
import os
import resource
import signal
import subprocess
import sys
import tempfile

TOLERANCE = 0.1  # of the number of quads: what a user may count on (Pipeline/internal/quad_counts.h)
SPEAKS_OF_NUMBER = "quads instead of"


def processor_seconds():
    """What the programs that were run have taken."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run(program, mesh, number, limit, folder):
    """(verdict, quads, seconds, message) of one call."""
    figures, start = os.path.join(folder, "figures.json"), processor_seconds()
    if os.path.exists(figures):
        os.remove(figures)
    done = subprocess.run([program, mesh, os.path.join(folder, "quads.obj"), "--target-quads", str(number), "--json", figures],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 5)))
    seconds = processor_seconds() - start
    # The limit counts ticks of the clock, so that the seconds may be some percent fewer.
    if done.returncode == -signal.SIGXCPU or (done.returncode == -signal.SIGKILL and seconds >= limit):
        return "timeout", 0, seconds, ""
    said = done.stdout.strip().replace("\n", " ")
    if done.returncode == 2:
        return "refused", 0, seconds, said
    if not os.path.exists(figures):
        return "FAILED", 0, seconds, said
    with open(figures, encoding="utf-8") as file:
        result = json.load(file)
    quads, message = result["quads"], result["message"]
    if not result["valid"]:
        return "invalid", quads, seconds, message
    if abs(quads - number) <= TOLERANCE * number:
        return "ok", quads, seconds, message
    return ("said" if SPEAKS_OF_NUMBER in message else "SILENT"), quads, seconds, message


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("meshes", nargs="+")
    parser.add_argument("--numbers", default="500,1000,4000,16000")
    parser.add_argument("--seconds", type=int, default=60)
    arguments = parser.parse_args()
    verdicts = collections.Counter()
    print(f"{'mesh':28s} {'asked':>6s} {'quads':>6s} {'ratio':>6s} {'s':>6s}  verdict")
    with tempfile.TemporaryDirectory() as folder:
        for mesh in arguments.meshes:
            for number in (int(n) for n in arguments.numbers.split(",")):
                verdict, quads, seconds, message = run(arguments.program, mesh, number, arguments.seconds, folder)
                verdicts[verdict] += 1
                name = os.path.splitext(os.path.basename(mesh))[0]
                print(f"{name:28s} {number:6d} {quads:6d} {quads / number:6.2f} {seconds:6.1f}  {verdict}"
                      + ("" if verdict == "ok" else f"  {message}"), flush=True)
    print(", ".join(f"{n} {verdict}" for verdict, n in verdicts.items()))
    return 1 if verdicts["SILENT"] or verdicts["FAILED"] else 0


if __name__ == "__main__":
    sys.exit(main())
