"""Figures of the stages, each on the same two models."""

import math

from figure_tools import MODELS, read_off, write_lines, write_off

QUADS = ("--target-quads", "2000")
COARSE = ("--target-quads", "500")  # where single crosses and triangles are to be seen
FEATURES = {"fandisk": ",sharp edges", "elephant": ""}  # those of the elephant are noise


def introduction(maker):
    """The quads of both models."""
    maker.sheet("introduction", [[maker.quads(name, *QUADS) for name in MODELS]], (600, 450))


def stages(maker):
    """What each of the stages makes."""
    maker.sheet("stages", [[maker.quads(name, *COARSE, "--show", layers + FEATURES[name])
                            for layers in ("triangles", "cross field,singularities", "integer grid,seamless map,singularities", "quads,irregular")]
                           for name in MODELS], (320, 240), ("triangles", "cross field", "integer grid", "quads"))


def working_mesh(maker):
    """Triangles as they come and those that are worked on: needles, many, and few."""
    rows = []
    for name in ("joint",) + MODELS:
        maker.quads(name, *QUADS, "--save-uv", maker.file("map.obj"), "--save-field", maker.file("field.rosy"))
        rows.append([maker.picture("quad_mesh_statistics", path, may_fail=True)
                     for path in (maker.model(name), maker.file("field.triangles.obj"))])
    maker.sheet("working_mesh", rows, captions=("input", "working mesh for 2000 quads"))


def fields(maker):
    """Cross fields with their singularities, without and with the directions in which the surface bends least."""
    maker.sheet("cross_fields", [[maker.quads(name, *COARSE, "--curvature-alignment", weight, "--show",
                                              "cross field,integer grid,seamless map,singularities" + FEATURES[name])
                                  for weight in ("0", "1")] for name in MODELS],
                (560, 420), ("smoothness alone", "along the curvature"))


def maps(maker):
    """Integer grids on the triangles."""
    maker.sheet("integer_grids", [[maker.quads(name, *QUADS, "--show", "integer grid,seamless map,singularities" + FEATURES[name])
                                   for name in MODELS]], (560, 420))


def t_meshes(maker):
    """T-meshes for 2000 quads."""
    images = []
    for name in MODELS:
        path = maker.file("t_mesh.png")
        maker.run("t_mesh_example", maker.model(name), path)
        images.append(maker.open(path))
    maker.sheet("t_meshes", [images], (560, 420))


def extraction(maker):
    """Quads as the map has them, and after smoothing."""
    maker.sheet("extraction", [[maker.quads(name, *QUADS, *smoothing) for smoothing in (("--smoothing", "0"), ())]
                               for name in MODELS], captions=("extracted", "smoothed"))


def structure(maker):
    """Base complexes before and after their optimization."""
    rows = []
    for name in MODELS:
        maker.quads(name, *QUADS)
        maker.run("optimize_quad_structure", maker.file("quads.obj"), maker.file("optimized.obj"), "--reference", maker.model(name))
        rows.append([maker.picture("quad_mesh_statistics", maker.file(quads), "--color-by", "patch")
                     for quads in ("quads.obj", "optimized.obj")])
    maker.sheet("base_complexes", rows, captions=("before", "after"))


def semi_regular(maker):
    """Patches of meshes that are made along their base complex."""
    maker.sheet("semi_regular", [[maker.quads(name, *QUADS, "--semi-regular", "--color-by", "patch") for name in MODELS]])


def sharp_edges(points, faces, degrees):
    """The ends of the edges whose faces differ by more than an angle."""
    def normal(f):
        p, q, r = (points[i] for i in f[:3])
        a, b = [q[k] - p[k] for k in range(3)], [r[k] - p[k] for k in range(3)]
        n = [a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2] for k in range(3)]
        length = math.sqrt(sum(x * x for x in n))
        return [x / length for x in n] if length > 0 else [0, 0, 0]
    beside = {}
    for f in faces:
        for i, v in enumerate(f):
            beside.setdefault(frozenset((v, f[i - 1])), []).append(normal(f))
    return [tuple(e) for e, n in beside.items()
            if len(n) == 2 and sum(x * y for x, y in zip(*n)) < math.cos(math.radians(degrees))]


def geodesics(maker):
    """Distances from a point and from curves: sharp edges of the one model, a ring around the other one."""
    rows = []
    for name in MODELS:
        points, faces = read_off(maker.model(name))
        row = [maker.picture("geodesic_distance", maker.model(name), maker.file("distances.txt"), "--vertices", "0")]
        if name == "fandisk":
            row.append(maker.picture("geodesic_distance", maker.model(name), maker.file("distances.txt"), "--sharp-edges", "40"))
        else:
            low, high = ([f(p[c] for p in points) for c in range(3)] for f in (min, max))
            center = [(a + b) / 2 for a, b in zip(low, high)]
            ring = [(center[0] + 0.5 * (high[0] - low[0]) * math.cos(t * math.pi / 12),
                     center[1] + 0.5 * (high[1] - low[1]) * math.sin(t * math.pi / 12), center[2]) for t in range(24)]
            path = write_lines(maker.file("ring.txt"), ring + ring[:1])
            row.append(maker.picture("geodesic_distance", maker.model(name), maker.file("distances.txt"), "--polyline", path))
        rows.append(row)
    maker.sheet("geodesics", rows, captions=("from a vertex", "from curves"))


def sheared_box(n):
    """The sides of a sheared cube with n x n squares each, as triangles, and its corners with its sides as squares."""
    def shear(p):
        return (p[0] + 0.5 * p[1], p[1], p[2] + 0.3 * p[1])
    meshes = []
    for steps in (n, 1):
        number, points, faces = {}, [], []
        for axis in range(3):
            for end in (0, steps):
                for i in range(steps):
                    for j in range(steps):
                        corners = []
                        for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                            p = [0, 0, 0]
                            p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = end, a, b
                            if tuple(p) not in number:
                                number[tuple(p)] = len(points)
                                points.append(shear([x / steps for x in p]))
                            corners.append(number[tuple(p)])
                        if end == 0:
                            corners.reverse()
                        faces += [corners] if steps == 1 else [corners[:3], [corners[0], corners[2], corners[3]]]
        meshes.append((points, faces))
    return meshes


PLATE_LAYOUT = """quad_layout 1
node 0 0 0
node 1 0 0
node 3 0 0
node 3 0.8 0
node 3 2 0
node 1 2 0
node 0 2 0
node 1 1.2 0
arc 0 1
arc 1 2
arc 2 3
arc 3 4
arc 4 5
arc 5 6
arc 6 0
arc 1 7
arc 7 5
arc 7 3 aligned
patch +0 / +7 +8 / +5 / +6
patch +1 / +2 / -9 / -7
patch +9 / +3 / +4 / -8
"""


def layouts(maker):
    """A sheared cube along its sides with two kinds of charts, and a plate whose layout has a T-vertex."""
    (points, faces), (corners, sides) = sheared_box(12)
    write_off(maker.file("cube.off"), points, faces)
    write_off(maker.file("sides.off"), corners, sides)
    plate = [(i / 4, j / 4, 0) for j in range(9) for i in range(13)]
    triangles = [t for j in range(8) for i in range(12) for a in (13 * j + i,)
                 for t in ((a, a + 1, a + 14), (a, a + 14, a + 13))]
    write_off(maker.file("plate.off"), plate, triangles)
    with open(maker.file("plate.layout"), "w", encoding="ascii") as file:
        file.write(PLATE_LAYOUT)

    def picture(mesh, layout, quads, *options):
        return maker.picture("quadrangulate_layout", maker.file(mesh), maker.file(layout), maker.file("quads.obj"), "--quads", quads,
                             *options)
    maker.sheet("layouts", [[picture("cube.off", "sides.off", 600, "--charts", charts, "--align", "tagged", "--sharp-angle", 180)
                             for charts in ("rectangle", "quadrilateral")] +
                            [picture("plate.off", "plate.layout", 200)]], (400, 300),
                ("rectangles", "quadrilaterals", "a T-vertex"))


def choices(maker):
    """What the most important parameters do."""
    maker.sheet("choices", [[maker.quads(name, *options) for options in
                             (("--target-quads", "500"), ("--target-quads", "4000"),
                              ("--target-quads", "2000", "--sizing", "curvature"))] for name in MODELS], (400, 300),
                ("500 quads", "4000 quads", "2000 quads, --sizing curvature"))
