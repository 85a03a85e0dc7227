#!/usr/bin/env python3
"""Lets the compiler read all sources of a build folder, without making code from them, and counts those with an error or a warning.

usage: check_sources.py BUILD_DIR [--jobs N] [--log FILE] [--skip REGEX] [--only REGEX]

BUILD_DIR was configured with -DCMAKE_EXPORT_COMPILE_COMMANDS=ON, and its target precompiled_headers was built. Paths of sources that
match --skip are left out, those that do not match --only as well. The messages of the compiler are printed, and written to --log with
the seconds that each source took. The last line counts; the exit code is 0 if every source is clean.
"""

import argparse
import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys
import time

# No source of these stands for itself: precompiled.cpp is empty, cmake_pch is a precompiled header, and mistake.cpp must not compile.
NEVER = re.compile(r"/(precompiled\.cpp|mistake\.cpp|cmake_pch\.hxx(\.cxx)?)$")


def syntax_command(entry):
    """The command of an entry that reads the source and writes no file."""
    words = shlex.split(entry["command"])
    while words and not re.search(r"(\+\+|cc|clang|cl)[-0-9.]*$", os.path.basename(words[0])):
        words.pop(0)  # ccache and the like, and its settings
    command, i = [], 0
    while i < len(words):
        if words[i] in ("-o", "-MF", "-MT", "-MQ"):
            i += 2
            continue
        if words[i] not in ("-c", "-MD", "-MMD"):
            command.append(words[i])
        i += 1
    return command + ["-fsyntax-only", "-Werror"]


def check(entry):
    start = time.monotonic()
    done = subprocess.run(syntax_command(entry), cwd=entry["directory"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          universal_newlines=True, errors="replace")
    return entry["file"], done.returncode, done.stdout, time.monotonic() - start


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build_dir")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--log", default=os.devnull)
    parser.add_argument("--skip", default="$^")
    parser.add_argument("--only", default="")
    arguments = parser.parse_args()
    with open(os.path.join(arguments.build_dir, "compile_commands.json"), encoding="utf-8") as file:
        entries = json.load(file)
    skip, only = re.compile(arguments.skip), re.compile(arguments.only)
    entries = [e for e in entries if not NEVER.search(e["file"]) and not skip.search(e["file"]) and only.search(e["file"])]
    if not entries:
        sys.exit("check_sources.py: there is no source to read")
    offences = 0
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool, open(arguments.log, "w", encoding="utf-8") as log:
        for source, code, messages, seconds in pool.map(check, entries):
            log.write(f"{seconds:6.1f} s  {source}\n{messages}")
            log.flush()
            if code != 0:
                offences += 1
                print(f"{source}\n{messages}", end="", flush=True)
    print(f"{len(entries)} sources read, {offences} with errors or warnings.")
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
