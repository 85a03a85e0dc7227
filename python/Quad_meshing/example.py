#!/usr/bin/env python3
"""A quad mesh of a triangle mesh, its stages and its measures in pictures.

usage: example.py MESH [PICTURE]

Needs the module quad_meshing in PYTHONPATH, numpy and matplotlib.
"""

import sys

import matplotlib
import numpy as np

import quad_meshing as qm

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection  # noqa: E402


def draw(axes, points, polygons, colors, title):
    """Polygons in three dimensions."""
    axes.add_collection3d(Poly3DCollection(points[polygons], facecolors=colors, edgecolors="k", linewidths=0.2))
    low, high = points.min(axis=0), points.max(axis=0)
    middle, radius = (low + high) / 2, (high - low).max() / 2
    axes.set_xlim(middle[0] - radius, middle[0] + radius)
    axes.set_ylim(middle[1] - radius, middle[1] + radius)
    axes.set_zlim(middle[2] - radius, middle[2] + radius)
    axes.set_axis_off()
    axes.set_title(title)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    points, triangles, repairs = qm.read_mesh(sys.argv[1])
    print("%d triangles" % len(triangles), *repairs)

    # The whole line. The result keeps what its stages made.
    run = qm.quadrangulate(points, triangles, target_quads=1500)
    print(run.message, "%d quads, %d irregular vertices" % (len(run.quads), run.figures["irregular_vertices"]))
    if not run.is_valid:
        sys.exit(1)

    # What it is worth.
    quality = qm.quality(run.points, run.quads)
    deviation = qm.deviation(run.points, run.quads, points, triangles)
    patches, separatrices = qm.base_complex(run.points, run.quads)
    print("mean scaled Jacobian %.3f, distance to the input at most %.2g of its diagonal, %d patches" % (
        quality["mean_scaled_jacobian"], deviation["quads_to_reference_max"], patches.max() + 1))

    # The distance from the first point, on the triangles.
    distance = qm.geodesic_distance(points, triangles, vertices=[int(triangles[0, 0])])

    figure = plt.figure(figsize=(12, 9))
    axes = figure.add_subplot(2, 2, 1, projection="3d")
    finite = np.where(np.isfinite(distance), distance, 0)
    shades = plt.cm.viridis(finite[triangles].mean(axis=1) / max(finite.max(), 1e-300))
    draw(axes, points, triangles, shades, "triangles, by distance from a point")
    axes = figure.add_subplot(2, 2, 2, projection="3d")
    draw(axes, run.points, run.quads, plt.cm.tab20(patches % 20), "quads, by patches of the base complex")
    axes.add_collection3d(Line3DCollection(run.points[separatrices], colors="k", linewidths=0.8))
    axes = figure.add_subplot(2, 2, 3)
    axes.bar(np.arange(5, 195, 10), quality["angle_histogram"], width=9)
    axes.set_xlabel("angle (degrees)")
    axes.set_ylabel("corners of quads")
    axes = figure.add_subplot(2, 2, 4)
    axes.bar(np.arange(0.05, 2.15, 0.1), quality["edge_length_histogram"], width=0.09)
    axes.set_xlabel("edge length over its mean")
    axes.set_ylabel("edges of quads")
    figure.tight_layout()
    figure.savefig(sys.argv[2] if len(sys.argv) > 2 else "quads.png", dpi=100)


if __name__ == "__main__":
    main()
