#!/usr/bin/env python3
"""Runs the programs on inputs of the kinds on which quad meshing programs have been reported to fail, generated here, and checks
the answers: two-sided faces, sheets that meet, noise of zero, slivers, many holes, high genus, poles, fans, quads as input,
vertices without faces, distances to lines across faces, integers with large coefficients, and formats.

usage: check_reports.py FOLDER

FOLDER holds the programs.
"""

import collections
import math
import os
import resource
import struct
import subprocess
import sys

failures = []


def check(condition, what):
    if not condition:
        failures.append(what)
        print("FAILED: " + what)


def processor_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(program, *arguments, code=0, seconds=100):
    begin = processor_time()
    done = subprocess.run([os.path.join(sys.argv[1], program)] + [str(a) for a in arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, universal_newlines=True, timeout=600, check=False)
    taken = processor_time() - begin
    print("%s %s: %d, %.1f s\n%s%s" % (program, " ".join(map(str, arguments)), done.returncode, taken, done.stdout, done.stderr))
    check(done.returncode == code, "exit code %d of %s" % (done.returncode, arguments))
    check(taken < seconds, "%s takes %.0f s" % (arguments, taken))
    return done.stdout + done.stderr


# Meshes are pairs of points and faces.

def merged(*meshes):
    """Some meshes as one; points with the same coordinates become one."""
    number, points, faces = {}, [], []
    for p, f in meshes:
        for face in f:
            faces.append([])
            for v in face:
                if p[v] not in number:
                    number[p[v]] = len(points)
                    points.append(p[v])
                faces[-1].append(number[p[v]])
    return points, faces


def triangles(mesh):
    return mesh[0], [[f[0], f[k], f[k + 1]] for f in mesh[1] for k in range(1, len(f) - 1)]


def grid(n, m, point):
    """The image of a grid of n x m squares under a function of two numbers of [0, 1]."""
    points = [point(i / n, j / m) for j in range(m + 1) for i in range(n + 1)]
    return points, [[v, v + 1, v + n + 2, v + n + 1] for j in range(m) for i in range(n) for v in (j * (n + 1) + i,)]


def voxels(is_full, sizes):
    """The surface of the unit cubes for which is_full holds, as squares, outwards."""
    number, points, faces = {}, [], []
    for x in range(sizes[0]):
        for y in range(sizes[1]):
            for z in range(sizes[2]):
                if not is_full(x, y, z):
                    continue
                for axis in range(3):
                    for end in (0, 1):
                        n = [x, y, z]
                        n[axis] += 2 * end - 1
                        if all(0 <= n[k] < sizes[k] for k in range(3)) and is_full(*n):
                            continue
                        face = []
                        for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                            p = [x, y, z]
                            p[axis] += end
                            p[(axis + 1) % 3] += a
                            p[(axis + 2) % 3] += b
                            face.append(number.setdefault(tuple(p), len(number)))
                        faces.append(face if end else face[::-1])
    points = [tuple(map(float, p)) for p in sorted(number, key=number.get)]
    return points, faces


def turned(mesh):
    return mesh[0], [f[::-1] for f in mesh[1]]


def box(n, low=(0.0, 0.0, 0.0), size=1.0):
    p, f = voxels(lambda x, y, z: True, (n, n, n))
    return [tuple(low[k] + size * q[k] / n for k in range(3)) for q in p], f


def smoothed(mesh, rounds):
    points, faces = mesh
    beside = [set() for _ in points]
    for f in faces:
        for i, v in enumerate(f):
            beside[v] |= {f[i - 1], f[(i + 1) % len(f)]}
    for _ in range(rounds):
        points = [tuple(sum(points[w][k] for w in beside[v]) / len(beside[v]) for k in range(3)) for v in range(len(points))]
    return points, faces


def subdivided(mesh):
    points, faces, middle, result = list(mesh[0]), mesh[1], {}, []

    def mid(*vertices):
        key = frozenset(vertices)
        if key not in middle:
            middle[key] = len(points)
            points.append(tuple(sum(points[v][k] for v in vertices) / len(vertices) for k in range(3)))
        return middle[key]
    for f in faces:
        center = mid(*f)
        result += [[v, mid(v, f[(i + 1) % 4]), center, mid(v, f[i - 1])] for i, v in enumerate(f)]
    return points, result


def write_off(name, mesh):
    with open(name, "w", encoding="ascii") as file:
        file.write("OFF\n%d %d 0\n" % (len(mesh[0]), len(mesh[1])))
        file.writelines("%r %r %r\n" % p for p in mesh[0])
        file.writelines(" ".join(map(str, [len(f)] + f)) + "\n" for f in mesh[1])


def stl_text(mesh, change=str):
    text = "solid part\n"
    for f in mesh[1]:
        text += "facet normal 0 0 0\nouter loop\n" + "".join("vertex %r %r %r\n" % mesh[0][v] for v in f) + "endloop\nendfacet\n"
    return change(text + "endsolid part\n")


def write(name, data):
    with open(name, "wb") as file:
        file.write(data if isinstance(data, bytes) else data.encode("utf-8"))


def read_obj(name):
    points, faces = [], []
    with open(name, encoding="ascii") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                points.append(tuple(map(float, words[1:4])))
            if words[:1] == ["f"]:
                faces.append([int(w.split("/")[0]) - 1 for w in words[1:]])
    return points, faces


class Quads:
    """The result of a run, with what is measured on it."""

    def __init__(self, name, *options, seconds=100):
        self.said = run("quadrangulate", name, "quads.obj", *options, seconds=seconds)
        self.points, self.faces = read_obj("quads.obj")
        self.name = name + " " + " ".join(map(str, options))
        check(all(len(f) == 4 for f in self.faces), self.name + ": faces that are no quads")
        edges = collections.Counter(frozenset((f[i], f[i - 1])) for f in self.faces for i in range(4))
        self.border = sum(n == 1 for n in edges.values())
        self.euler = len({v for f in self.faces for v in f}) - len(edges) + len(self.faces)
        on_border = {v for e, n in edges.items() if n == 1 for v in e}
        valence = collections.Counter(v for e in edges for v in e)
        self.irregular = sum(n != (3 if v in on_border else 4) for v, n in valence.items())
        self.areas = sorted(self.area(f) for f in self.faces)

    def area(self, f):
        p, q, r, s = (self.points[v] for v in f)
        a, b = [r[k] - p[k] for k in range(3)], [s[k] - q[k] for k in range(3)]
        return 0.5 * math.sqrt(sum((a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2]) ** 2 for k in range(3)))

    def expect(self, euler, border=False, number=None, evenness=None, irregular=None):
        """`number`: of quads, within a tenth; `evenness`: the largest ratio of areas; `irregular`: the most irregular vertices."""
        check(self.euler == euler, "%s: Euler number %d" % (self.name, self.euler))
        check((self.border > 0) == border, "%s: %d edges on the border" % (self.name, self.border))
        if number is not None:
            check(abs(len(self.faces) - number) <= 0.1 * number, "%s: %d quads" % (self.name, len(self.faces)))
        if evenness is not None:
            ratio = self.areas[-1] / self.areas[0]
            check(ratio <= evenness, "%s: areas %.0f : 1" % (self.name, ratio))
        if irregular is not None:
            check(self.irregular <= irregular, "%s: %d irregular vertices" % (self.name, self.irregular))
        check("not followed" not in self.said and "inverted" not in self.said, self.name + ": " + self.said)
        return self


def files():
    cube, square = triangles(box(2)), triangles(grid(3, 3, lambda u, v: (u + 3.0, v, 0.0)))
    write_off("two_sided.off", merged(cube, turned(cube)))
    Quads("two_sided.off", "--target-quads", 100).expect(2)
    write_off("two_sided_sheet.off", merged(square, turned(square)))
    Quads("two_sided_sheet.off", "--target-quads", 40).expect(1, border=True)
    write_off("two_sided_and_one_sided.off", merged(cube, turned(cube), square))
    Quads("two_sided_and_one_sided.off", "--target-quads", 100).expect(3, border=True)
    # every triangle with vertices of its own
    loose = triangles(merged(box(2), box(2, (1.0, 1.0, 0.0))))
    write("loose.obj", "".join("v %r %r %r\n" % loose[0][v] for f in loose[1] for v in f) +
          "".join("f %d %d %d\n" % (3 * i + 1, 3 * i + 2, 3 * i + 3) for i in range(len(loose[1]))))
    Quads("loose.obj", "--target-quads", 200).expect(4)
    # zero and almost zero; a double edge count would make the box open
    noisy = "".join(line.replace(" 0.0\n", " %s\n" % ("6e-17" if i % 3 else "0.0")) for i, line in
                    enumerate(stl_text(cube).splitlines(True)))
    write("noisy_zero.stl", noisy)
    Quads("noisy_zero.stl", "--target-quads", 150).expect(2)
    write("bom.stl", b"\xef\xbb\xbf" + stl_text(cube).encode())
    Quads("bom.stl", "--target-quads", 100).expect(2)
    write("upper_case.stl", stl_text(cube, str.upper))
    Quads("upper_case.stl", "--target-quads", 100).expect(2)
    write("bom.obj", b"\xef\xbb\xbf" + ("".join("v %r %r %r\n" % p for p in cube[0]) +
                                        "".join("f %d %d %d\n" % tuple(v + 1 for v in f) for f in cube[1])).encode())
    Quads("bom.obj", "--target-quads", 100).expect(2)
    head = "ply\nformat %s 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\nelement %s\nend_header\n"
    write("ushort.ply", (head % ("binary_little_endian", len(cube[0]), "face %d\nproperty list uint8 uint16 vertex_indices" %
                                 len(cube[1]))).encode() + b"".join(struct.pack("<3f", *p) for p in cube[0]) +
          b"".join(struct.pack("<B3H", 3, *f) for f in cube[1]))
    Quads("ushort.ply", "--target-quads", 100).expect(2)
    write("strips.ply", head % ("ascii", 6, "tristrips 1\nproperty list int int vertex_indices") +
          "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n6 0 1 2 3 4 5\n")
    Quads("strips.ply", "--target-quads", 8).expect(1, border=True)


def shapes():
    # slivers without area along a hole
    def plate(x, y, z):
        return not (2 <= x < 4 and 2 <= y < 4)
    p, f = triangles(voxels(plate, (6, 6, 1)))
    a, b = next((t[0], t[1]) for t in f if p[t[0]][2] == p[t[1]][2] == 1.0)
    beside = next(t for t in f if any((t[k - 1], t[k]) == (b, a) for k in range(3)))
    k = next(k for k in range(3) if (beside[k - 1], beside[k]) == (b, a))
    p.append(tuple((p[a][c] + p[b][c]) / 2 for c in range(3)))
    f[f.index(beside)] = [b, len(p) - 1, beside[(k + 1) % 3]]
    f += [[len(p) - 1, a, beside[(k + 1) % 3]], [a, len(p) - 1, b]]  # the last one has no area
    write_off("slivers.off", (p, f))
    Quads("slivers.off", "--target-quads", 300).expect(0)
    # two quads between holes
    n = 3
    p, f = voxels(lambda x, y, z: x % 3 < 2 or y % 3 < 2, (3 * n + 2, 3 * n + 2, 1))
    write_off("perforated.off", triangles((p, f)))
    q = Quads("perforated.off", "--target-quads", 900, seconds=60).expect(2 - 2 * n * n)
    check(abs(len(q.faces) - 900) < 0.2 * 900, "perforated.off: %d quads" % len(q.faces))
    # a smooth lattice of rods
    def rod(x, y, z):
        return sum(c % 3 == 0 for c in (x, y, z)) >= 2
    sponge = smoothed(subdivided(voxels(rod, (7, 7, 4))), 3)
    write_off("sponge.off", triangles(sponge))
    e = len({frozenset((g[i], g[i - 1])) for g in sponge[1] for i in range(4)})
    euler = len(sponge[0]) - e + len(sponge[1])
    check(euler < -20, "the sponge has the Euler number %d" % euler)
    Quads("sponge.off", "--target-quads", 1500, seconds=60).expect(euler)
    # poles
    sphere = merged(triangles(grid(32, 16, lambda u, v: tuple(round(x, 12) + 0.0 for x in (
        math.sin(math.pi * v) * math.cos(2 * math.pi * u), math.sin(math.pi * v) * math.sin(2 * math.pi * u), -math.cos(math.pi * v))))))
    sphere = sphere[0], [g for g in sphere[1] if len(set(g)) == 3]
    write_off("poles.off", sphere)
    Quads("poles.off", "--target-quads", 600).expect(2, number=600, evenness=12)
    capsule = [(x, y, z + 2.0 if z > 0 else z) for x, y, z in sphere[0]], sphere[1]
    write_off("capsule.off", capsule)
    for number in (1000, 2000):
        # not even: the irregular vertices gather at the poles, and areas differ by 433 to 1
        Quads("capsule.off", "--target-quads", number).expect(2, number=number)
    # fans of needles
    ring = [(round(math.cos(t * math.pi / 30), 12), round(math.sin(t * math.pi / 30), 12)) for t in range(60)]
    p = [(x, y, z) for z in (0.0, 2.0) for x, y in ring] + [(0.0, 0.0, 0.0), (0.0, 0.0, 2.0)]
    f = []
    for t in range(60):
        s = (t + 1) % 60
        f += [[t, s, s + 60], [t, s + 60, t + 60], [s, t, 120], [t + 60, s + 60, 121]]
    write_off("fans.off", (p, f))
    Quads("fans.off", "--target-quads", 1500, seconds=30).expect(2, number=1500, irregular=16)
    # quads as input
    torus = merged(grid(32, 16, lambda u, v: tuple(round(x, 12) + 0.0 for x in (
        (2 + 0.8 * math.cos(2 * math.pi * v)) * math.cos(2 * math.pi * u),
        (2 + 0.8 * math.cos(2 * math.pi * v)) * math.sin(2 * math.pi * u), 0.8 * math.sin(2 * math.pi * v)))))
    write_off("torus.off", torus)
    Quads("torus.off", "--target-quads", 512).expect(0, number=512, irregular=0)


def sheets():
    """A box with a wall inside: the edges of the quads with three faces are where those of the box are."""
    p, f = voxels(lambda x, y, z: True, (8, 4, 3))
    wall = grid(4, 3, lambda u, v: (3.0, 4 * u, 3 * v))
    write_off("wall.off", triangles(merged((p, f), wall)))
    q = Quads("wall.off", "--target-quads", 400)
    points = {}
    for x in q.points:
        points.setdefault(x, len(points))
    edges = collections.Counter(frozenset((points[q.points[g[i]]], points[q.points[g[i - 1]]])) for g in q.faces for i in range(4))
    check(set(edges.values()) == {2, 3}, "wall.off: edges with %s faces" % set(edges.values()))
    check("do not meet" not in q.said, "wall.off: " + q.said)


def distances():
    write("unused.off", "OFF\n5 2 0\n100 100 100\n0 0 0\n1 -3 0\n2 0 0\n1 3 0\n3 1 2 3\n3 1 3 4\n")
    run("geodesic_distance", "unused.off", "unused.txt", "--vertices", 3)
    with open("unused.txt", encoding="ascii") as file:
        found = [float(x) for x in file.read().split()]
    right = [math.inf, 2, math.sqrt(10), 0, math.sqrt(10)]
    check(len(found) == 5 and all(x == y or abs(x - y) < 1e-12 for x, y in zip(found, right)), "unused.off: %s" % found)
    write_off("plane.off", triangles(grid(8, 8, lambda u, v: (2 * u - 1, 2 * v - 1, 0.0))))
    write("line.txt", "0.1 0.2 0\n0.8 0.7 0\n")
    run("geodesic_distance", "plane.off", "plane.txt", "--polyline", "line.txt", "--certified", "--enclosures-out", "plane.e")
    with open("plane.e", encoding="ascii") as file:
        widths = [float(h) - float(l) for l, h in (line.split() for line in file)]
    check(len(widths) == 81 and 0 <= min(widths) and max(widths) < 1e-11, "plane.off: intervals of %g" % max(widths))


def integers():
    head = "%%MatrixMarket matrix coordinate real general\n"
    write("A.mtx", head + "2 2 2\n1 1 2\n2 2 2\n")
    write("b.mtx", head + "2 1 0\n")
    write("integers.txt", "0 1\n")
    for first, right in ((1000001, 3000005), (2 ** 30 + 1, 3 * 2 ** 30 + 5)):
        write("C.mtx", head + "1 2 2\n1 1 %d\n1 2 1\n" % first)
        write("d.mtx", head + "1 1 1\n1 1 %d\n" % right)
        for method in ("direct", "greedy", "lattice", "branch-and-bound"):
            run("solve_mixed_integer", "--matrix", "A.mtx", "--rhs", "b.mtx", "--constraints", "C.mtx", "--constraints-rhs", "d.mtx",
                "--integers", "integers.txt", "--method", method, "--out", "x.txt")
            with open("x.txt", encoding="ascii") as file:
                x = [float(w) for w in file.read().split()]
            check(x == [3, 2], "%d x + y = %d by %s: %s" % (first, right, method, x))


def main():
    for part in (files, shapes, sheets, distances, integers):
        part()
    print("%d failures" % len(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
