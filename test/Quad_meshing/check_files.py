#!/usr/bin/env python3
"""Runs `quadrangulate` with the options for files of other programs, and reads the files back with meshio where it is
installed: patches, pictures of layers, VTK, fields, the largest component, digits, polygons as input.

usage: check_files.py PROGRAM
"""

import re
import subprocess
import sys

failures = []


def check(condition, what):
    if not condition:
        failures.append(what)
        print("FAILED: " + what)


def box(n, low=(0, 0, 0), size=1.0, polygons=False):
    """The sides of a cube with n x n squares each, as squares or triangles."""
    number, points, faces = {}, [], []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for end in (0, n):
            for i in range(n):
                for j in range(n):
                    c = []
                    for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                        p = [0, 0, 0]
                        p[axis], p[u], p[v] = end, a, b
                        if tuple(p) not in number:
                            number[tuple(p)] = len(points)
                            points.append([low[k] + size * p[k] / n for k in range(3)])
                        c.append(number[tuple(p)])
                    if end == 0:
                        c.reverse()
                    faces += [c] if polygons else [[c[0], c[1], c[2]], [c[0], c[2], c[3]]]
    return points, faces


def write_off(name, *meshes):
    points, faces = [], []
    for p, f in meshes:
        faces += [[i + len(points) for i in face] for face in f]
        points += p
    with open(name, "w", encoding="ascii") as file:
        file.write("OFF\n%d %d 0\n" % (len(points), len(faces)))
        file.writelines("%r %r %r\n" % tuple(p) for p in points)
        file.writelines(" ".join(map(str, [len(f)] + f)) + "\n" for f in faces)


def run(*arguments, code=0):
    done = subprocess.run([sys.argv[1]] + list(arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True, timeout=200, check=False)
    print("%s: %d: %s%s" % (" ".join(arguments), done.returncode, done.stdout, done.stderr))
    check(done.returncode == code, "exit code %d of %s" % (done.returncode, arguments))
    return done


def obj_lines(name):
    lines = {}
    with open(name, encoding="ascii") as file:
        for line in file:
            words = line.split()
            if words:
                lines.setdefault(words[0], []).append(words[1:])
    return lines


def main():
    write_off("cube.off", box(3))
    run("cube.off", "quads.obj", "--target-quads", "150", "--patches", "patches.obj", "--vtk", "quads.vtk", "--save-field",
        "cube.rosy", "--digits", "6")
    quads, patches = obj_lines("quads.obj"), obj_lines("patches.obj")
    corners = [[tuple(map(int, c.split("/"))) for c in f] for f in patches["f"]]
    check(sorted(sorted(str(c[0]) for c in f) for f in corners) == sorted(map(sorted, quads["f"])), "the patches are not the quads")
    texture = [tuple(map(float, t)) for t in patches["vt"]]
    for f in corners:
        t = [texture[c[1] - 1] for c in f]
        area = sum(t[k - 1][0] * t[k][1] - t[k - 1][1] * t[k][0] for k in range(4)) / 2
        check(area == 1 and all(x == round(x) >= 0 for p in t for x in p), "a quad is no square of the grid: %s" % t)
    # each of the six patches is one square of as many quads as it has
    check(max(max(t) for t in texture) == round((len(corners) / 6) ** 0.5), "the grids of the patches are not as large as these")
    names = [g[0] for g in patches["g"]]
    check(names == ["patch_%d" % i for i in range(6)] + ["separatrices"], "the groups are %s" % names)
    length = round((len(quads["f"]) / 6) ** 0.5)
    check(len(patches["l"]) == 12 * length, "there are %d lines" % len(patches["l"]))
    check(all(len(re.sub(r"[-.]|e.*", "", x)) <= 7 for p in quads["v"] for x in p), "there are more than six digits")
    run("cube.off", "quads.obj", "--target-quads", "150")
    check(any(len(x) > 12 for p in obj_lines("quads.obj")["v"] for x in p), "there are no long numbers")

    # --show: pictures of what led to the quads differ from that of the quads, and from each other.
    pictures = {}
    for shown in (None, "triangles", "cross field,singularities", "Quads/quads", "quads,feature"):
        options = [] if shown is None else ["--show", shown]
        done = run("cube.off", "quads.obj", "--target-quads", "150", "--picture", "picture.png", *options)
        check("--show" not in done.stderr, "--show %s: %s" % (shown, done.stderr))
        with open("picture.png", "rb") as file:
            pictures[shown] = file.read()
    check(len(set(pictures.values())) == len(pictures), "pictures of different layers are equal")
    done = run("cube.off", "quads.obj", "--target-quads", "150", "--picture", "picture.png", "--show", "nonsense,quads")
    check("--show: no layer is called 'nonsense'" in done.stderr and "'Quads/base complex'" in done.stderr, "an unknown layer is not named")

    # Materials, texture coordinates and colors reach the quads; the border of the materials is a chain of quad edges.
    points, faces = box(8)
    with open("painted.obj", "w", encoding="ascii") as file:
        file.write("mtllib paint.mtl\n")
        file.writelines("v %r %r %r %r 0 1\n" % (p[0], p[1], p[2], p[0]) for p in points)
        file.writelines("vt %r %r\n" % (p[0] + p[2], p[1]) for p in points)
        for low in (True, False):
            file.write("usemtl %s\n" % ("low" if low else "high"))
            for f in faces:
                if (sum(points[i][2] for i in f) / 3 < 0.375) == low:
                    file.write("f " + " ".join("%d/%d" % (i + 1, i + 1) for i in f) + "\n")
    done = run("painted.obj", "painted_quads.obj", "--groups", "--target-quads", "300")
    check("32 edges lie on borders" in done.stderr and "32 of materials" in done.stderr, "the borders are not told")
    painted, material, levels = obj_lines("painted_quads.obj"), None, {}
    vertices = [tuple(map(float, v)) for v in painted["v"]]
    texture = [tuple(map(float, t)) for t in painted["vt"]]
    check(painted["mtllib"] == [["paint.mtl"]], "the library of materials is lost")
    check(all(abs(v[3] - v[0]) < 1e-6 and v[4] == 0 and abs(v[5] - 1) < 1e-9 for v in vertices), "the colors are wrong")
    with open("painted_quads.obj", encoding="ascii") as file:
        for line in file:
            words = line.split()
            if words[0] == "usemtl":
                material = words[1]
            if words[0] == "f":
                for corner in words[1:]:
                    v, t = (int(x) - 1 for x in corner.split("/"))
                    levels.setdefault(material, []).append(vertices[v][2])
                    expected = (vertices[v][0] + vertices[v][2], vertices[v][1])
                    # corners are seen from a thousandth of the way to the center of the quad, 0.1 away
                    check(max(abs(a - b) for a, b in zip(texture[t], expected)) < 2e-4, "a texture coordinate is wrong")
    check(set(levels) == {"low", "high"} and abs(max(levels["low"]) - 0.375) < 1e-6 and abs(min(levels["high"]) - 0.375) < 1e-6,
          "the border of the materials is not where it was")
    run("painted.obj", "painted_quads.obj", "--groups=colors", code=2)

    # A field goes in again; with the triangles that it lies on, so do its eight singularities.
    with open("cube.rosy", encoding="ascii") as file:
        field = file.read().split("\n")
    triangles = obj_lines("cube.triangles.obj")["f"]
    check(int(field[0]) == len(triangles) and field[1] == "4" and len(field) == len(triangles) + 3, "the field is not whole")
    run("cube.triangles.obj", "again.obj", "--field", "cube.rosy", "--work-on-input", "--target-quads", "150", "--json",
        "again.json")
    with open("again.json", encoding="utf-8") as file:
        check('"singularities": 8' in file.read(), "the field has other singularities")
    done = run("cube.off", "again.obj", "--field", "cube.rosy", code=2)
    check("directions, the mesh 108 faces" in done.stderr, "a field of another mesh is not refused")

    # The largest component alone; faces keep their numbers in messages; polygons are cut, which is said.
    write_off("two.off", box(2, (5, 5, 5), 0.5), box(3))
    done = run("two.off", "one.obj", "--target-quads", "150", "--largest-component")
    check("The largest of 2 components" in done.stderr, "nothing is said about the component")
    points = [[float(x) for x in p] for p in obj_lines("one.obj")["v"]]
    check(max(max(p) for p in points) < 1.0 + 1e-9, "the other component is there")
    write_off("polygons.off", box(2, polygons=True))
    done = run("polygons.off", "polygons.obj", "--target-quads", "100")
    check("triangulated" in done.stderr, "nothing is said about polygons that were cut")

    try:
        import meshio
    except ImportError:
        print("NOTICE: files are not read back by meshio, which is not installed.")
    else:
        mesh = meshio.read("quads.vtk")
        cells = sum(len(block.data) for block in mesh.cells)
        check(cells == len(patches["f"]), "meshio finds %d cells" % cells)
        for key, low, high in (("scaled_Jacobian", 0.5, 1.0), ("patch_of_the_base_complex", 0, 5)):
            values = [x for block in mesh.cell_data[key] for x in block.ravel()]
            check(low <= min(values) and max(values) <= high + 1e-12, "%s is from %g to %g" % (key, min(values), max(values)))
    print("%d failures" % len(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
