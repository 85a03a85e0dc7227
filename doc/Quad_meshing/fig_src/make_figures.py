#!/usr/bin/env python3
"""Makes figures of the manual with the programs, so that they show what the programs do.

usage: make_figures.py PROGRAMS MESHES FIGURES [NAME...]

PROGRAMS is the folder of the programs, MESHES that of CGAL's data, FIGURES receives the pictures. NAME: car, gallery, guides, page; by
default all. Needs Debian's python3-pil; the page needs chromium, too. A table of the gallery is printed.
"""

import json
import math
import os
import shutil
import subprocess
import sys
import tempfile

from PIL import Image, ImageDraw

GALLERY = ("fandisk", "elephant", "bear", "mushroom", "armadillo", "anchor_dense", "knot1", "bunny00", "rotor",
           "handle", "joint", "sphere966")
QUADS = "2000"
TILE, COLUMNS = (300, 225), 3     # pixels, pictures per row
LARGEST_PICTURE = 150000          # bytes


def save(image, path):
    """A picture of so few colors that it is small."""
    for colors in (256, 128, 64, 32):
        image.quantize(colors, dither=0).save(path, optimize=True)
        if os.path.getsize(path) <= LARGEST_PICTURE:
            return
    sys.exit("%s has more than %d bytes" % (path, LARGEST_PICTURE))


def gallery(programs, meshes, figures, folder):
    """Quads by the patches of their base complexes, with their numbers, in two pictures."""
    tiles = []
    print("| model | triangles | quads | irregular vertices | seconds | message |\n|---|---|---|---|---|---|")
    for name in GALLERY:
        quads, picture, figure = (os.path.join(folder, name + e) for e in (".obj", ".png", ".json"))
        subprocess.run([os.path.join(programs, "quadrangulate"), os.path.join(meshes, name + ".off"), quads, "--target-quads", QUADS,
                        "--picture", picture, "--color-by", "patch", "--json", figure], check=False,
                       stdout=subprocess.DEVNULL)
        with open(figure, encoding="utf-8") as file:
            f = json.load(file)
        print("| %s | %d | %d | %d | %.1f | %s |" % (name, f["input_faces"], f["quads"], f["irregular_vertices"],
                                                    f["total_seconds"], f["message"]))
        tile = Image.open(picture).convert("RGB").resize(TILE, Image.LANCZOS)
        ImageDraw.Draw(tile).text((4, TILE[1] - 14), "%s: %d quads, %d irregular" % (name, f["quads"], f["irregular_vertices"]),
                                  fill=(0, 0, 0))
        tiles.append(tile)
    half = len(tiles) // 2
    for number in range(2):
        part = tiles[number * half:(number + 1) * half]
        sheet = Image.new("RGB", (COLUMNS * TILE[0], (half + COLUMNS - 1) // COLUMNS * TILE[1]), (255, 255, 255))
        for i, tile in enumerate(part):
            sheet.paste(tile, (i % COLUMNS * TILE[0], i // COLUMNS * TILE[1]))
        save(sheet, os.path.join(figures, "gallery_%d.png" % (number + 1)))


def read_points(path):
    """The points of a file of CGAL's data."""
    with open(path, encoding="ascii") as file:
        words = [w for line in file for w in line.split("#")[0].split()]
    return [tuple(map(float, words[4 + 3 * i:7 + 3 * i])) for i in range(int(words[1]))]


def write_lines(path, rows):
    with open(path, "w", encoding="ascii") as file:
        file.writelines(" ".join("%r" % x for x in row) + "\n" for row in rows)


def guides(programs, meshes, figures, folder):
    """A model without and with each kind of guide, side by side."""
    name = "bear"
    model = os.path.join(meshes, name + ".off")
    points = read_points(model)
    low, high = ([f(p[c] for p in points) for c in range(3)] for f in (min, max))
    center = [(a + b) / 2 for a, b in zip(low, high)]
    reach = max(b - a for a, b in zip(low, high))

    def around(turns, rise, steps=60):
        """A helix around the belly, in a plane if it does not rise."""
        radius, height = 0.25 * reach, center[1] - 0.13 * reach
        return [(center[0] + radius * math.cos(2 * math.pi * turns * t / steps), height + rise * reach * (t / steps - 0.5),
                 center[2] + radius * math.sin(2 * math.pi * turns * t / steps)) for t in range(steps + 1)]

    files = {k: os.path.join(folder, k + ".txt") for k in ("curves", "strokes", "singularities", "sizes")}
    write_lines(files["curves"], around(1, 0))
    write_lines(files["strokes"], around(0.5, 0.25))
    corners = [(sx, sy, sz) for sx in (-0.25, 0.25) for sy in (-0.2, 0.2) for sz in (-0.25, 0.25)]
    write_lines(files["singularities"], [tuple(center[c] + s[c] * reach for c in range(3)) + (1,) for s in corners])
    write_lines(files["sizes"], [(center[0], high[1], center[2], 0.25 * reach, 0.008 * reach)])

    def picture(result, *options):
        path = os.path.join(folder, result + ".png")
        subprocess.run([os.path.join(programs, "quadrangulate"), model, os.path.join(folder, result + ".obj"), "--target-quads", QUADS,
                        "--picture", path, "--color-by", "mean edge" if "sizes" in result else "scaled", *options], check=True)
        return Image.open(path).convert("RGB").resize((480, 360), Image.LANCZOS)

    before = picture("before")
    for kind, path in files.items():
        after = picture("after_" + kind, "--" + kind, path)
        sheet = Image.new("RGB", (960, 360), (255, 255, 255))
        sheet.paste(before, (0, 0))
        sheet.paste(after, (480, 0))
        save(sheet, os.path.join(figures, "guides_before_after_%s.png" % kind))


def car(programs, _meshes, figures, folder):
    """A car with a layout that was made by hand."""
    mesh, layout, picture = (os.path.join(folder, "car" + e) for e in (".off", ".txt", ".png"))
    subprocess.run([os.path.join(programs, "car_layout_example"), mesh, layout], check=True)
    subprocess.run([os.path.join(programs, "quadrangulate_layout"), mesh, layout, os.path.join(folder, "quads.off"), "--quads", QUADS,
                    "--sharp-angle", "20", "--align", "tagged", "--picture", picture, "--color-by", "patch"], check=True)
    save(Image.open(picture).convert("RGB"), os.path.join(figures, "layout_car.png"))


def page(programs, meshes, figures, folder):
    """A page in a browser."""
    browser = shutil.which("chromium") or sys.exit("chromium is not installed")
    html, picture = os.path.join(folder, "page.html"), os.path.join(folder, "page.png")
    subprocess.run([os.path.join(programs, "quadrangulate"), os.path.join(meshes, "fandisk.off"), os.path.join(folder, "q.obj"),
                    "--html", html], check=True)
    subprocess.run([browser, "--headless", "--no-sandbox", "--disable-dev-shm-usage", "--use-gl=angle", "--use-angle=swiftshader",
                    "--enable-unsafe-swiftshader", "--window-size=1250,640", "--virtual-time-budget=5000",
                    "--screenshot=" + picture, "file://" + html], check=True, stderr=subprocess.DEVNULL)
    save(Image.open(picture).convert("RGB"), os.path.join(figures, "page_fandisk.png"))


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    makers = {"car": car, "gallery": gallery, "guides": guides, "page": page}
    with tempfile.TemporaryDirectory() as folder:
        for name in sys.argv[4:] or sorted(makers):
            makers[name](*sys.argv[1:4], folder)


if __name__ == "__main__":
    main()
