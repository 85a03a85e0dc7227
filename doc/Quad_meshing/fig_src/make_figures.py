#!/usr/bin/env python3
"""Makes figures of the manual with the programs, so that they show what the programs do.

usage: make_figures.py PROGRAMS MESHES FIGURES [NAME...]

PROGRAMS is the folder of the programs, MESHES that of CGAL's data, FIGURES receives the pictures. NAME: gallery or page; by default
both. Needs Debian's python3-pil; the page needs chromium, too. A table of the gallery is printed.
"""

import json
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
    makers = {"gallery": gallery, "page": page}
    with tempfile.TemporaryDirectory() as folder:
        for name in sys.argv[4:] or sorted(makers):
            makers[name](*sys.argv[1:4], folder)


if __name__ == "__main__":
    main()
