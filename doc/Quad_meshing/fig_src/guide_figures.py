"""Figures of the guides: a model without and with each kind of them, side by side."""

import math

from figure_tools import read_off, write_lines

MODEL = "bear"
QUADS = ("--target-quads", "2000")
SYMMETRIC_MODEL = "mushroom"


class Bear:
    """The model with its measures, from which what is drawn on it follows."""

    def __init__(self, maker):
        self.maker = maker
        self.points, self.faces = read_off(maker.model(MODEL))
        self.low, self.high = ([f(p[c] for p in self.points) for c in range(3)] for f in (min, max))
        self.center = [(a + b) / 2 for a, b in zip(self.low, self.high)]
        self.reach = max(b - a for a, b in zip(self.low, self.high))

    def around(self, turns, rise, steps=60):
        """A helix around the belly, in a plane if it does not rise."""
        radius, height = 0.25 * self.reach, self.center[1] - 0.13 * self.reach
        return [(self.center[0] + radius * math.cos(2 * math.pi * turns * t / steps), height + rise * self.reach * (t / steps - 0.5),
                 self.center[2] + radius * math.sin(2 * math.pi * turns * t / steps)) for t in range(steps + 1)]

    def on_belly(self, right, up):
        """A place on the side of the belly that pictures show."""
        toward, across = (0.59, 0, 0.81), (0.81, 0, -0.59)  # the direction to the eye without its rise, and to the right of it
        return tuple(self.center[c] + self.reach * (0.22 * toward[c] + right * across[c] + (up - 0.13) * (c == 1)) for c in range(3))

    def corners(self, index):
        """Eight places around the center."""
        return [tuple(self.center[c] + s[c] * self.reach for c in range(3)) + index
                for s in ((x, y, z) for x in (-0.25, 0.25) for y in (-0.2, 0.2) for z in (-0.25, 0.25))]

    def before_after(self, name, *options, before=(), colors="scaled", model=MODEL):
        maker = self.maker
        maker.sheet("guides_before_after_" + name,
                    [[maker.quads(model, *QUADS, "--color-by", colors, *before),
                      maker.quads(model, *QUADS, "--color-by", colors, *options)]])


def curves(bear):
    """A ring of quad edges."""
    bear.before_after("curves", "--curves", write_lines(bear.maker.file("curves.txt"), bear.around(1, 0)))


def strokes(bear):
    """A sash that the quads turn to."""
    bear.before_after("strokes", "--strokes", write_lines(bear.maker.file("strokes.txt"), bear.around(0.5, 0.25)))


def singularities(bear):
    """Eight vertices of three quads."""
    bear.before_after("singularities", "--singularities", write_lines(bear.maker.file("places.txt"), bear.corners((1,))))


def sums(bear):
    """Two quarters in a region in which the sum is zero otherwise."""
    place = bear.on_belly(0, 0) + (0.1 * bear.reach, 2)
    bear.before_after("index_sums", "--index-sums", write_lines(bear.maker.file("sums.txt"), [place]))


def connections(bear):
    """Two irregular vertices on the belly, placed in both pictures, and joined."""
    ends = [bear.on_belly(s * 0.1, s * 0.06) for s in (-1, 1)]
    places = write_lines(bear.maker.file("ends.txt"), [end + (-1,) for end in ends])
    pair = write_lines(bear.maker.file("pair.txt"), [ends[0] + ends[1]])
    bear.before_after("connections", "--singularities", places, "--connect", pair, before=("--singularities", places))


def sizes(bear):
    """Short edges around the head."""
    head = write_lines(bear.maker.file("sizes.txt"), [(bear.center[0], bear.high[1], bear.center[2], 0.25 * bear.reach, 0.008 * bear.reach)])
    bear.before_after("sizes", "--sizes", head, colors="mean edge")


def painted_sizes(bear):
    """Lengths of one to four from left to right."""
    painted = write_lines(bear.maker.file("painted.txt"), [(1 if p[0] < bear.center[0] else 4,) for p in bear.points])
    bear.before_after("painted_sizes", "--sizes", painted, colors="mean edge")


def groups(bear):
    """Two materials whose border zigzags along edges of triangles: the worst case."""
    path = bear.maker.file("painted.obj")
    with open(path, "w", encoding="ascii") as file:
        file.writelines("v %r %r %r\n" % p for p in bear.points)
        for is_upper in (False, True):
            file.write("usemtl %s\n" % ("upper" if is_upper else "lower"))
            for f in bear.faces:
                tilted = sum(bear.points[v][1] + 0.3 * bear.points[v][0] for v in f) / 3
                if (tilted > bear.center[1] - 0.05 * bear.reach) == is_upper:
                    file.write("f %d %d %d\n" % tuple(v + 1 for v in f))
    bear.before_after("groups", "--groups", model=path)


def symmetry(bear):
    """A plane that is found."""
    maker = bear.maker
    maker.sheet("guides_before_after_symmetry", [[maker.quads(SYMMETRIC_MODEL, *QUADS), maker.quads(SYMMETRIC_MODEL, *QUADS, "--symmetry", "auto")]])


KINDS = {"guide_" + kind.__name__: kind for kind in
         (curves, strokes, singularities, sums, connections, sizes, painted_sizes, groups, symmetry)}
