#!/usr/bin/env python3
"""Makes all figures of the manual with the programs and their option --picture, so that they show what the programs do.

usage: make_figures.py PROGRAMS MESHES FIGURES [NAME...]

PROGRAMS is the folder of the programs, MESHES that of CGAL's data, FIGURES receives the pictures. NAME: one or several of the
figures below; by default all, which takes some minutes. Needs Debian's python3-pil; the page needs chromium, too. A table of
the gallery is printed.

"""

import shutil
import subprocess
import sys
import tempfile

import stage_figures
from figure_tools import Maker
from guide_figures import KINDS, Bear

GALLERY = ("fandisk", "elephant", "bear", "mushroom", "armadillo", "anchor_dense", "knot1", "bunny00", "rotor",
           "handle", "joint", "sphere966")


def gallery(maker):
    """Quads by the patches of their base complexes, with their numbers, in two pictures."""
    tiles, captions = [], []
    print("| model | triangles | quads | irregular vertices | patches | seconds | message |\n|---|---|---|---|---|---|---|")
    for name in GALLERY:
        image, f = maker.figures_of(name, "--target-quads", "2000", "--color-by", "patch")
        maker.run("quad_mesh_statistics", maker.file("quads.obj"), "--json", maker.file("statistics.json"), may_fail=True)
        patches = maker.json("statistics.json")["base_complex"]
        print("| %s | %d | %d | %d | %d | %.1f | %s |" % (name, f["input_faces"], f["quads"], f["irregular_vertices"], patches,
                                                         f["total_seconds"], f["message"]))
        tiles.append(image)
        captions.append("%s: %d quads, %d irregular vertices, %d patches" % (name, f["quads"], f["irregular_vertices"], patches))
    half = len(tiles) // 2
    for number in range(2):
        begin = number * half
        rows = [range(i, min(i + 3, begin + half)) for i in range(begin, begin + half, 3)]
        maker.sheet("gallery_%d" % (number + 1), [[tiles[i] for i in row] for row in rows], (320, 240),
                    [[captions[i] for i in row] for row in rows])


def page(maker):
    """A page in a browser."""
    browser = shutil.which("chromium") or sys.exit("chromium is not installed")
    html, picture = maker.file("page.html"), maker.file("page.png")
    maker.run("quadrangulate", maker.model("fandisk"), maker.file("quads.obj"), "--html", html)
    subprocess.run([browser, "--headless", "--no-sandbox", "--disable-dev-shm-usage", "--use-gl=angle", "--use-angle=swiftshader",
                    "--enable-unsafe-swiftshader", "--window-size=1250,640", "--virtual-time-budget=5000",
                    "--screenshot=" + picture, "file://" + html], check=True, stderr=subprocess.DEVNULL)
    maker.save(maker.open(picture), "page_fandisk")


def car(maker):
    """A car with a layout that was made by hand."""
    maker.run("car_layout_example", maker.file("car.off"), maker.file("layout.txt"))
    maker.run("quadrangulate_layout", maker.file("car.off"), maker.file("layout.txt"), maker.file("quads.off"), "--quads", "2000",
              "--sharp-angle", "20", "--align", "tagged", "--picture", maker.file("car.png"), "--color-by", "patch")
    maker.save(maker.open(maker.file("car.png")), "layout_car")


MAKERS = {f.__name__: f for f in (
    stage_figures.introduction, stage_figures.stages, stage_figures.working_mesh, stage_figures.fields, stage_figures.maps, stage_figures.t_meshes,
    stage_figures.extraction, stage_figures.structure, stage_figures.semi_regular, stage_figures.geodesics, stage_figures.layouts,
    stage_figures.choices, car, gallery, page)}
MAKERS.update(KINDS)


def main():
    names = sys.argv[4:] or list(MAKERS)
    if len(sys.argv) < 4 or any(name not in MAKERS for name in names):
        sys.exit(__doc__ + "\n".join("%-14s %s" % (name, maker.__doc__) for name, maker in MAKERS.items()))
    with tempfile.TemporaryDirectory() as folder:
        maker = Maker(*sys.argv[1:4], folder)
        for name in names:
            MAKERS[name](Bear(maker) if name in KINDS else maker)


if __name__ == "__main__":
    main()
