"""Each kind of offence, planted in a small package, is found by scripts/check_includes.py, and nothing else is.

usage: check_includes_test.py CHECK_INCLUDES
"""

import os
import subprocess
import sys
import tempfile

PACKAGE = "include/CGAL/Quad_meshing/"
GOOD = {
    "include/CGAL/Quad_meshing.h": "#include <CGAL/Quad_meshing/quadrangulate.h>\n",
    PACKAGE + "parameters.h": "#include <CGAL/Named_function_parameters.h>\n",
    PACKAGE + "quadrangulate.h": "#include <CGAL/Quad_meshing/Pipeline/run.h>\n",
    PACKAGE + "internal/compatibility.h": "#include <CGAL/version.h>\n#if CGAL_VERSION_NR >= 1060000000\n#endif\n",
    PACKAGE + "internal/shared.h": "#include <CGAL/Quad_meshing/internal/compatibility.h>\n",
    PACKAGE + "Quad_mesh/quality.h": "#include <CGAL/Quad_meshing/Quad_mesh/internal/shape.h>\nclass Shared\n{};\n",
    PACKAGE + "Quad_mesh/internal/shape.h": "#include <CGAL/Quad_meshing/internal/shared.h>\n",
    PACKAGE + "Smoothing/smooth.h": "#include <CGAL/Quad_meshing/Quad_mesh/quality.h>\n// CGAL_VERSION_NR\n",
    PACKAGE + "Pipeline/run.h": "#include <CGAL/Quad_meshing/Smoothing/smooth.h>\n",
    "src/Quad_meshing/Quad_mesh.cpp": "#include <CGAL/Quad_meshing/Quad_mesh/internal/shape.h>\n",
    "examples/Quad_meshing/program.cpp": "#include <CGAL/Quad_meshing.h>\n",
    "test/Quad_meshing/test_shape.cpp": "#include <CGAL/Quad_meshing/Quad_mesh/internal/shape.h>\n",
}

# file, line that is added to it
BAD = [
    (PACKAGE + "Quad_mesh/quality.h", "#include <CGAL/Quad_meshing/Smoothing/smooth.h>"),
    (PACKAGE + "Smoothing/smooth.h", "#include <CGAL/Quad_meshing/Quad_mesh/internal/shape.h>"),
    (PACKAGE + "Smoothing/smooth.h", "#include <CGAL/Quad_meshing/quadrangulate.h>"),
    (PACKAGE + "Smoothing/smooth.h", "#include <CGAL/Quad_meshing.h>"),
    (PACKAGE + "Smoothing/smooth.h", "  #  include <CGAL/Quad_meshing/Cellar/wine.h>"),
    (PACKAGE + "Smoothing/smooth.h", '#include "smooth.h"'),
    (PACKAGE + "Smoothing/smooth.h", "#if CGAL_VERSION_NR >= 1050500000"),
    (PACKAGE + "Smoothing/smooth.h", "#include <CGAL/version.h>"),
    (PACKAGE + "Pipeline/run.h", "#include <CGAL/Quad_meshing/Quad_mesh/internal/shape.h>"),
    (PACKAGE + "internal/shared.h", "#include <CGAL/Quad_meshing/Quad_mesh/quality.h>"),
    (PACKAGE + "internal/shared.h", "#include <CGAL/Quad_meshing/quadrangulate.h>"),
    (PACKAGE + "Smoothing/smooth.h", "class Shared"),
    (PACKAGE + "parameters.h", "#include <CGAL/Quad_meshing/Quad_mesh/quality.h>"),
    ("src/Quad_meshing/Quad_mesh.cpp", "#include <CGAL/Quad_meshing/Smoothing/smooth.h>"),
    ("examples/Quad_meshing/program.cpp", "#include <CGAL/Quad_meshing/internal/shared.h>"),
    ("test/Quad_meshing/test_shape.cpp", "#if CGAL_VERSION_NR >= 1050500000"),
]


def check(files):
    with tempfile.TemporaryDirectory() as root:
        for name, text in files.items():
            path = os.path.join(root, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        done = subprocess.run([sys.executable, sys.argv[1], root], stdout=subprocess.PIPE, universal_newlines=True)
        return done.returncode, done.stdout.splitlines()


def main():
    code, lines = check(GOOD)
    assert code == 0 and lines == ["0 offences"], lines
    for name, line in BAD:
        code, lines = check(dict(GOOD, **{name: GOOD[name] + line + "\n"}))
        where = "%s:%d: " % (name, GOOD[name].count("\n") + 1)
        assert code == 1 and lines[-1] == "1 offences" and lines[0].startswith(where), (name, line, lines)
    print("%d kinds of offences are found" % len(BAD))


if __name__ == "__main__":
    main()
