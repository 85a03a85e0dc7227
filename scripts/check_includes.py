#!/usr/bin/env python3
"""Checks who includes whom: the rooms of the package and the arrows between them. And that no two headers define classes of one name.

usage: check_includes.py [ROOT]

ROOT is the folder that holds include/; by default the one above this script. Each offence is printed as
file:line: what is wrong. The last line counts them; the exit code is 0 if there are none.
"""

import os
import re
import sys

# The rooms, and the rooms whose headers each of them may include.
ARROWS = {
    "Linear_algebra": set(),
    "Geodesics": set(),
    "Quad_mesh": set(),
    "IO": set(),
    "Mixed_integer": {"Linear_algebra"},
    "Working_mesh": {"Geodesics"},
    "Smoothing": {"Quad_mesh", "Linear_algebra"},
    "Fields": {"Mixed_integer", "Linear_algebra", "Working_mesh", "Geodesics"},
    "Parameterization": {"Fields", "Mixed_integer", "Linear_algebra"},
    "Layout": {"Parameterization", "Mixed_integer", "Linear_algebra", "Quad_mesh", "Smoothing"},
    "Extraction": {"Parameterization"},
    "Structure": {"Layout", "Smoothing", "Quad_mesh"},
    "Guides": {"Fields", "Parameterization", "Geodesics"},
}
ALL_ROOMS = set(ARROWS)
ARROWS["Pipeline"] = set(ALL_ROOMS)

# Headers in front of all rooms. The ground belongs to everybody; what stands on the rooms is not for them.
GROUND = {"parameters.h", "Default_visitor.h"}
TOP_ARROWS = {"quadrangulate.h": ALL_ROOMS | {"Pipeline"}}

PREFIX = "CGAL/Quad_meshing/"
UMBRELLA = "CGAL/Quad_meshing.h"
COMPATIBILITY = PREFIX + "internal/compatibility.h"
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
CLASS = re.compile(r"^(?:class|struct)\s+(\w+)\s*(?:$|:(?!:)|\{)")
VERSION = re.compile(r"\bCGAL_VERSION(_NR|_MAJOR|_MINOR|_PATCH|_STR)?\b|\bCGAL_(MAJOR|MINOR)_VERSION\b|<CGAL/version\.h>")


def place_of(header):
    """The place of a header of the package: (room, whether it is internal to it), ("", True) for what belongs to
    nobody and no user, or (name, False) for a header in front of all rooms."""
    parts = header[len(PREFIX):].split("/")
    if len(parts) == 1:
        return parts[0], False
    if parts[0] == "internal":
        return "", True
    return parts[0], "internal" in parts[1:-1]


def has_cycle(arrows):
    """Whether one can come back to a room along the arrows."""
    left = dict(arrows)
    while left:
        ground = [room for room, below in left.items() if not below & set(left)]
        if not ground:
            return True
        for room in ground:
            del left[room]
    return False


def judge(place, header):
    """What is wrong about including a header at a place; None if nothing is."""
    room, is_internal = place
    target, target_is_internal = place_of(header)
    if target.endswith(".h"):
        if target in GROUND:
            return None
        if room.endswith(".h") and room not in GROUND:
            return None                       # the headers in front of all rooms know each other
        if room == "Pipeline" and target not in TOP_ARROWS:
            return None
        return "%s stands above what includes it" % target
    if target == "":
        return None                           # what belongs to nobody is for all
    if target not in ARROWS:
        return "%s is not a room of the table" % target
    if room == target:
        return None
    if target_is_internal:
        return "the inside of %s is included from outside" % target
    if room == "":
        return "internal/ includes the room %s" % target
    if room.endswith(".h"):
        if room in GROUND:
            return "%s includes the room %s" % (room, target)
        return None
    if room not in ARROWS:
        return "%s is not a room of the table" % room
    if target not in ARROWS[room]:
        return "there is no arrow from %s to %s" % (room, target)
    return None


def check_file(path, shown, place, is_version_place, offences):
    with open(path, encoding="utf-8") as file:
        lines = file.read().split("\n")
    for number, line in enumerate(lines, 1):
        match = INCLUDE.match(line)
        header = match.group(2) if match else ""
        what = None
        if header.startswith(PREFIX):
            what = judge(place, header) if place is not None else None
        elif match and match.group(1) == '"':
            what = "a header of the package includes another one by a path of its own"
        elif header == UMBRELLA:
            what = "the umbrella is for users"
        if what:
            offences.append((shown, number, what))
        code = line.split("//")[0]
        if not is_version_place and VERSION.search(code):
            offences.append((shown, number, "a version of CGAL outside internal/compatibility.h"))


def check_user(path, shown, stays_outside, offences):
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            match = INCLUDE.match(line)
            if stays_outside and match and match.group(2) != COMPATIBILITY and match.group(2).startswith(PREFIX) and \
               place_of(match.group(2))[1]:
                offences.append((shown, number, "an example includes what is internal"))
            if VERSION.search(line.split("//")[0]):
                offences.append((shown, number, "a version of CGAL outside internal/compatibility.h"))


def check_classes(path, shown, places, offences):
    """Two classes of one name in different files clash where their functions meet in a program, and no compiler says so."""
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            match = CLASS.match(line)
            if match:
                first = places.setdefault(match.group(1), shown)
                if first != shown:
                    offences.append((shown, number, "%s defines a class %s, too" % (first, match.group(1))))


def files_below(folder, endings):
    for base, folders, names in os.walk(folder):
        folders.sort()
        for name in sorted(names):
            if name.endswith(endings):
                yield os.path.join(base, name)


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir)
    if len(sys.argv) > 2 or not os.path.isdir(os.path.join(root, "include", "CGAL", "Quad_meshing")):
        sys.exit("usage: check_includes.py [ROOT], where ROOT/include/CGAL/Quad_meshing is the package")
    assert not has_cycle(ARROWS), "the table of arrows has a cycle"

    offences = []
    classes = {}
    include = os.path.join(root, "include")
    for path in files_below(include, ".h"):
        header = os.path.relpath(path, include).replace(os.sep, "/")
        place = None if header == UMBRELLA else place_of(header)
        check_file(path, "include/" + header, place, header == COMPATIBILITY, offences)
        check_classes(path, "include/" + header, classes, offences)

    # The kernels of a room belong to it.
    source = os.path.join(root, "src", "Quad_meshing")
    for path in files_below(source, ".cpp"):
        name = os.path.basename(path)
        check_file(path, "src/Quad_meshing/" + name, (name[:-len(".cpp")], True), False, offences)

    # Examples use what users use; tests and benchmarks may look inside.
    for folder in ("examples", "benchmark", "test"):
        below = os.path.join(root, folder, "Quad_meshing")
        for path in files_below(below, (".h", ".cpp")):
            shown = os.path.relpath(path, root).replace(os.sep, "/")
            check_user(path, shown, folder == "examples", offences)

    for shown, number, what in offences:
        print("%s:%d: %s" % (shown, number, what))
    print("%d offences" % len(offences))
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
