#!/usr/bin/env python3
"""Checks the manual against the programs: every option that `--help` of a program lists is in the manual, and every option that
the manual names is one of a program or a script. Every picture that the manual shows is there, and is shown.

usage: check_manual.py FOLDER ROOT

FOLDER holds the programs, ROOT is the folder of the package.
"""

import glob
import os
import re
import subprocess
import sys

PROGRAMS = ("quadrangulate", "geodesic_distance", "solve_mixed_integer", "quad_mesh_statistics", "optimize_quad_structure",
            "quadrangulate_layout")
LARGEST_PICTURE = 150000  # bytes

failures = []


def check(condition, what):
    if not condition:
        failures.append(what)
        print("FAILED: " + what)


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def options_in(text):
    return set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", text))


def main():
    folder, root = sys.argv[1:3]
    doc = os.path.join(root, "doc", "Quad_meshing")
    pages = {path: text_of(path) for path in sorted(glob.glob(os.path.join(doc, "*.txt"))) + [os.path.join(root, "README.md")]}
    named = set.union(*(options_in(text) for text in pages.values()))
    known = {"--install", "--prefix", "--preset", "--build", "--target", "--test-dir", "--output-on-failure", "--parallel"}  # of CMake
    known |= {"--array", "--wrap"}  # of Slurm
    for script in glob.glob(os.path.join(root, "scripts", "*")) + glob.glob(os.path.join(root, "benchmark", "*", "*.cpp")):
        known |= options_in(text_of(script))
    for program in PROGRAMS:
        text = subprocess.run([os.path.join(folder, program), "--help"], stdout=subprocess.PIPE, universal_newlines=True,
                              check=True).stdout
        options = set(re.findall(r"^ +(?:-\w \[ )?(--[a-z][a-z-]*)", text, re.MULTILINE))
        check(len(options) > 5, "%s --help lists no options" % program)
        for option in sorted(options - named - {"--help"}):
            check(False, "%s %s is in no page of the manual" % (program, option))
        known |= options
    for path, text in pages.items():
        for option in sorted(options_in(text) - known):
            check(False, "%s: no program has the option %s" % (path, option))

    pictures = {os.path.basename(path): os.path.getsize(path) for path in glob.glob(os.path.join(doc, "fig", "*.png"))}
    text = "".join(pages.values())
    shown = set(re.findall(r"[\w-]+\.png", "".join(re.findall(r"\\image.*|\\cgalFigureBegin.*|\\cgalPkgPicture.*|!\[.*|fig/\S*", text))))
    for name in sorted(shown - set(pictures)):
        check(False, "the picture %s is missing" % name)
    for name, size in sorted(pictures.items()):
        check(name in shown, "the picture %s is shown nowhere" % name)
        check(size <= LARGEST_PICTURE, "the picture %s has %d bytes" % (name, size))
    print("%d options, %d pictures, %d failures" % (len(named), len(pictures), len(failures)))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
