"""Tests of the Python module quad_meshing: arrays in, arrays out, and what a wrong binding would break."""

import math

import numpy as np
import pytest

import quad_meshing as qm


def box(n, quads=False):
    """The sides of a cube of n x n unit squares each, cut in two triangles or not."""
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
                            points.append(p)
                        c.append(number[tuple(p)])
                    if end == 0:
                        c.reverse()
                    faces += [c] if quads else [[c[0], c[1], c[2]], [c[0], c[2], c[3]]]
    return np.array(points, dtype=float), np.array(faces)


def grid(n):
    """n x n unit squares in the plane, cut in two."""
    points = np.array([[i, j, 0] for j in range(n + 1) for i in range(n + 1)], dtype=float)
    faces = []
    for j in range(n):
        for i in range(n):
            a = j * (n + 1) + i
            faces += [[a, a + 1, a + n + 2], [a, a + n + 2, a + n + 1]]
    return points, np.array(faces)


@pytest.fixture(scope="module")
def run():
    points, triangles = box(3)
    return qm.quadrangulate(points, triangles, target_quads=150)


def test_quadrangulate(run):
    assert run.is_valid and run.status == "valid" and "pure quad mesh" in run.message
    assert run.quads.shape == (run.figures["quads"], 4) and run.points.shape[1] == 3
    assert 112 <= len(run.quads) <= 188 and len(run.quads) % 6 == 0
    # all points on the cube, and the area that of the cube
    assert np.allclose(np.max(np.abs(run.points - 1.5), axis=1), 1.5, atol=1e-9)
    assert math.isclose(qm.quality(run.points, run.quads)["area"], 54, rel_tol=1e-6)
    assert qm.structure(run.points, run.quads)["irregular_vertices"] == 8
    assert run.input_faces.shape == (len(run.points),) and run.input_faces.max() < 108
    ends = run.points[run.feature_edges]
    assert np.isclose(np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).sum(), 36)


def test_stages_of_a_run(run):
    p, t = run.working_points, run.working_triangles
    sides = p[t]
    normals = np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0])
    areas = np.linalg.norm(normals, axis=1) / 2
    assert np.isclose(areas.sum(), 54)
    assert np.allclose(np.linalg.norm(run.cross_field, axis=1), 1)
    assert np.allclose(np.einsum("ij,ij->i", run.cross_field, normals), 0, atol=1e-9)
    assert run.singularity_indices.sum() == 8 and run.singularity_indices.shape == (len(p),)
    # the map covers as many cells as there are quads
    g = run.integer_grid_map
    a, b = g[:, 1] - g[:, 0], g[:, 2] - g[:, 0]
    assert g.shape == (len(t), 3, 2)
    assert np.isclose((a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum() / 2, len(run.quads))
    assert run.origins.shape == (len(t),) and 0 <= run.origins.min() and run.origins.max() < 108
    # extraction gives as many quads
    points, quads, _ = qm.extract_quads(p, t, g)
    assert len(quads) == len(run.quads) and len(points) == len(run.points)


def test_options():
    points, triangles = grid(6)
    length = qm.quadrangulate(points, triangles, target_edge_length=1.0)
    assert length.is_valid and abs(len(length.quads) - 36) <= 6
    # directions at 45 degrees turn the quads of a sheet whose border they need not follow
    diagonal = np.tile([1.0, 1.0, 0.0], (len(triangles), 1))
    for directions, expected in ((None, 0.0), (diagonal, 45.0)):
        r = qm.quadrangulate(points, triangles, target_quads=100, align_boundary=directions is None,
                             directions=directions)
        sides = r.points[np.roll(r.quads, -1, axis=1)] - r.points[r.quads]
        angles = np.degrees(np.arctan2(sides[..., 1], sides[..., 0])) % 90
        inner = np.minimum(abs(angles - expected), 90 - abs(angles - expected))
        assert np.median(inner) < 5
    with pytest.raises(ValueError, match="field must be one of"):
        qm.quadrangulate(points, triangles, field="no such")
    with pytest.raises(ValueError, match="target_quads"):
        qm.quadrangulate(points, triangles, target_quads=-1)


def test_bad_arrays():
    points, triangles = box(1)
    with pytest.raises(ValueError, match="shape"):
        qm.quadrangulate(points[:, :2], triangles)
    with pytest.raises(ValueError, match="names point 99"):
        qm.quadrangulate(points, np.where(triangles == 3, 99, triangles))
    with pytest.raises(ValueError, match="manifold"):
        qm.quadrangulate(points, np.vstack([triangles, triangles[:1]]))
    bad = points.copy()
    bad[2, 1] = np.nan
    with pytest.raises(ValueError, match="row 2 is not finite"):
        qm.quadrangulate(bad, triangles)
    with pytest.raises(ValueError, match="feature_edges: row 0"):
        qm.quadrangulate(points, triangles, feature_edges=[[0, 0]])


def test_stage_by_stage():
    points, triangles = box(4)
    edges = qm.feature_edges(points, triangles, 40, 1.0)
    assert len(edges) == 48
    p, t, edges, origins = qm.split_for_alignment(points, triangles, 1.5, edges)
    assert len(origins) == len(t) and origins.max() < len(triangles)
    field = qm.cross_field(p, t, feature_edges=edges)
    assert field.is_valid and field.indices.sum() == 8 and field.directions.shape == (len(t), 3)
    grid_map, is_valid, message = qm.integer_grid_map(field, 1.0)
    assert is_valid, message
    quad_points, quads, _ = qm.extract_quads(p, t, grid_map)
    assert len(quads) == 96 and qm.defects(quad_points, quads) == []
    moved, _ = qm.smooth_quads(quad_points, quads, points, triangles)
    assert moved.shape == quad_points.shape


def test_measures():
    points, quads = box(4, quads=True)
    quality, structure = qm.quality(points, quads), qm.structure(points, quads)
    assert quality["minimal_scaled_jacobian"] == 1 and quality["angle_histogram"].sum() == 4 * 96
    assert structure["patches"] == 6 and structure["sum_of_indices"] == 8 and structure["inner_valences"] == {3: 8}
    patches, separatrices = qm.base_complex(points, quads)
    assert sorted(np.bincount(patches)) == [16] * 6 and separatrices.shape == (48, 2)
    reference = box(2)
    deviation = qm.deviation(points, quads, reference[0] * 2, reference[1])
    assert deviation["quads_to_reference_max"] < 1e-12 and deviation["opposed_quads"] == 0
    assert "192 faces are not quads" in qm.defects(points, box(4)[1])[0]
    coarse_points, coarse_quads, message = qm.optimize_structure(points, quads)
    assert qm.structure(coarse_points, coarse_quads)["euler_characteristic"] == 2 and message
    with pytest.raises(ValueError, match="quads"):
        qm.quality(points, box(4)[1])


def test_geodesics():
    points, triangles = grid(8)
    distances = qm.geodesic_distance(points, triangles, vertices=[0])
    assert np.allclose(distances, np.linalg.norm(points, axis=1))  # a plane
    border = qm.geodesic_distance(points, triangles, border=True)
    assert np.allclose(border, np.min([points[:, 0], 8 - points[:, 0], points[:, 1], 8 - points[:, 1]], axis=0))
    line = [[i, i + 1] for i in range(8)]
    assert np.allclose(qm.geodesic_distance(points, triangles, edges=line), points[:, 1])
    lines = qm.isolines(points, triangles, points[:, 0], 2.5)
    assert len(lines) == 1 and np.allclose(lines[0][:, 0], 2.5)
    with pytest.raises(ValueError, match="no source"):
        qm.geodesic_distance(points, triangles)


def test_mixed_integer():
    # brute force over a small box
    rng = np.random.RandomState(1)
    m = rng.rand(3, 3)
    a, b = m @ m.T + np.eye(3), 10 * rng.rand(3)
    energies = [(0.5 * x @ a @ x - x @ b, tuple(x)) for x in
                np.array(np.meshgrid(*[np.arange(-2, 12)] * 3)).reshape(3, -1).T]
    for method in ("lattice", "branch-and-bound"):
        s = qm.solve_mixed_integer(a, b, [0, 1, 2], method=method)
        assert s.is_valid and s.status == "optimal" and np.isclose(s.energy, min(energies)[0])
    # constraints: x + y = 4, x <= 1
    s = qm.solve_mixed_integer(np.eye(2), np.zeros(2), [0], C=[[1, 1]], d=[4.0], G=[[1, 0]], h=[1.0])
    assert s.is_valid and list(s.x) == [1, 3]
    assert not qm.solve_mixed_integer(np.eye(1), [0.0], [0], lower=[0.2], upper=[0.8]).is_valid
    with pytest.raises(ValueError, match="symmetric"):
        qm.solve_mixed_integer([[1.0, 2.0], [0.0, 1.0]], [0.0, 0.0])


def test_files(run, tmp_path):
    path = tmp_path / "box.off"
    points, triangles = box(1)
    path.write_text("OFF\n8 12 0\n" + "".join("%r %r %r\n" % tuple(p) for p in points) +
                    "".join("3 %d %d %d\n" % tuple(t) for t in triangles))
    read_points, read_triangles, repairs = qm.read_mesh(str(path))
    assert np.array_equal(read_points, points) and np.array_equal(read_triangles, triangles) and repairs == []
    with pytest.raises(ValueError, match="no such"):
        qm.read_mesh("no such file.off")
    run.write_png(str(tmp_path / "box.png"))
    assert (tmp_path / "box.png").read_bytes()[:4] == b"\x89PNG"
    if qm.has_html_viewer():
        run.write_html(str(tmp_path / "box.html"))
        assert "integer grid" in (tmp_path / "box.html").read_text()


def test_docstrings():
    for name in dir(qm):
        if not name.startswith("_"):
            assert len(getattr(qm, name).__doc__) > 20, name
    assert "(m, 3)" in qm.quadrangulate.__doc__


def ball(n):
    """A box of n x n squares a side, blown up to the unit ball."""
    points, triangles = box(n)
    points = points - n / 2
    return points / np.linalg.norm(points, axis=1)[:, None], triangles


def share_on_edges(run, curve):
    """The share of the points of a curve that lie on edges of quads, within a twentieth of an edge."""
    ends = np.unique(np.sort(np.concatenate([run.quads[:, [k, (k + 1) % 4]] for k in range(4)]), axis=1), axis=0)
    a, b = run.points[ends[:, 0]], run.points[ends[:, 1]]
    length = np.linalg.norm(b - a, axis=1)
    on = 0
    for p in curve:
        t = np.clip(((p - a) * (b - a)).sum(axis=1) / length**2, 0, 1)
        on += np.any(np.linalg.norm(a + t[:, None] * (b - a) - p, axis=1) < 0.05 * length)
    return on / len(curve)


def test_guides():
    points, triangles = ball(12)
    t = np.linspace(0, 2, 60)
    curve = np.stack([np.cos(t), 0.8 * np.sin(t), 0.6 * np.sin(t)], axis=1)
    pole = np.array([0, -0.6, 0.8])
    run = qm.quadrangulate(points, triangles, target_quads=800, curves=[curve], indices=[[*pole, 1]])
    assert run.is_valid and run.unmet_guides == [], run.message
    on_surface = curve / np.linalg.norm(curve, axis=1)[:, None]
    assert share_on_edges(run, on_surface * np.linalg.norm(run.points, axis=1).mean()) > 0.95
    # the irregular vertex is where the working mesh has one nearest to the pole
    valence = np.bincount(run.quads.ravel(), minlength=len(run.points))
    edge = np.linalg.norm(run.points[run.quads[:, 0]] - run.points[run.quads[:, 1]], axis=1).mean()
    assert (np.linalg.norm(run.points[valence == 3] - pole, axis=1) < edge).sum() == 1

    half = qm.quadrangulate(points, triangles, target_quads=600, symmetry=["z"])
    assert half.is_valid
    there = set(map(tuple, half.points))
    assert all((x, y, -z) in there for x, y, z in half.points)

    lengths = np.where(points[:, 2] > 0, 1.0, 2.0)
    graded = qm.quadrangulate(points, triangles, target_quads=1000, vertex_lengths=lengths)
    centers = graded.points[graded.quads].mean(axis=1)
    assert graded.is_valid and (centers[:, 2] > 0.2).sum() > 2 * (centers[:, 2] < -0.2).sum()

    # edges of the input, half of which are no curve of their own
    ring = [k for k in range(len(points)) if abs(points[k, 2]) < 1e-12]
    ring.sort(key=lambda k: math.atan2(points[k, 1], points[k, 0]))
    edges = [[ring[i - 1], ring[i]] for i in range(len(ring))]
    run = qm.quadrangulate(points, triangles, target_quads=800, curve_edges=edges)
    assert run.is_valid and run.unmet_guides == [] and share_on_edges(run, points[ring]) > 0.95

    refused = qm.quadrangulate(points, triangles, target_quads=800, indices=[[0, 0, 1, 0, 9]])
    assert not refused.is_valid and refused.status == "refused" and "8 are missing" in refused.message


@pytest.mark.parametrize("wrong", [
    {"curves": [[[0, 0, 1]]]}, {"curves": [np.zeros((3, 2))]}, {"indices": [[0, 0, 1]]},
    {"indices": [[0, 0, 1, 0.5]]}, {"index_sums": [[0, 0, 1, -1, 2]]}, {"size_discs": [[0, 0, 1, 0, 0]]},
    {"symmetry": ["w"]}, {"symmetry": [3]}, {"face_lengths": [1.0]}, {"vertex_lengths": [[1.0]]},
    {"curve_edges": [[0, 0]]}, {"sizing": "none"}, {"strokes": [[[0, 0, 1], [1, 0, 0]]], "stroke_weight": -1}])
def test_wrong_guides(wrong):
    points, triangles = ball(3)
    with pytest.raises(ValueError):
        qm.quadrangulate(points, triangles, target_quads=100, **wrong)
