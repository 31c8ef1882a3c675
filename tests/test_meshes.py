"""Files of a net, read back by other libraries; pictures; what is refused."""

from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import trimesh

from checks.errors import BadInput
from checks.meshes.mesh import Mesh, mesh_of
from checks.meshes.picture import require_picture, write_picture
from checks.meshes.write import FORMATS, require_format, write_mesh
from discrete.exact_angle import ExactAngle
from discrete.greedy import grown
from discrete.greedy_net import GreedyNet, greedy_net
from discrete.greedy_parameters import GreedyParameters

FIELDS = ("angle", "max_curvature", "generation", "sector")


@pytest.fixture(scope="module")
def tree():
    return grown(
        GreedyParameters(
            radius=Fraction(2),
            step=Fraction(1, 10),
            sectors=6,
            cutoff=ExactAngle(half_turns=Fraction(3, 5)),
        )
    )


@pytest.fixture(scope="module")
def net(tree) -> GreedyNet:
    return greedy_net(tree)


@pytest.fixture(scope="module")
def mesh(net: GreedyNet) -> Mesh:
    return mesh_of(net)


def written(folder: Path, net: GreedyNet, kind: str) -> Path:
    path = folder / f"surface.{kind}"
    write_mesh(str(path), net)
    assert [entry.name for entry in folder.iterdir()] == [path.name]
    return path


def test_quads_go_around_the_normals(mesh: Mesh):
    p, normals = mesh.points[mesh.quads], mesh.normals[mesh.quads]
    faces = np.cross(p[:, 2] - p[:, 0], p[:, 3] - p[:, 1])
    assert (np.einsum("ij,ikj->ik", faces, normals) > 0).all()


@pytest.mark.parametrize("kind", ["ply", "obj", "stl", "glb"])
def test_trimesh_reads_one_oriented_surface(tmp_path: Path, net: GreedyNet, mesh: Mesh, kind: str):
    path = written(tmp_path, net, kind)
    found = trimesh.load(path, force="mesh", process=False)
    if kind == "stl":
        found.merge_vertices()
    assert len(found.faces) == 2 * len(mesh.quads)
    assert len(found.vertices) == len(mesh.points)
    found.merge_vertices(merge_norm=True, merge_tex=True)
    assert len(found.vertices) == len(mesh.points)
    assert found.euler_number == 1
    assert found.is_winding_consistent
    assert (found.area_faces > 0).all()
    order = [np.lexsort(np.round(p, 5).T) for p in (found.vertices, mesh.points)]
    gap = found.vertices[order[0]] - mesh.points[order[1]]
    assert np.abs(gap).max() < 2e-5
    if kind in ("stl", "glb"):  # the reader splits quads by a rule of its own
        p = mesh.points[mesh.triangles()]
        area = np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1).sum() / 2
        assert found.area == pytest.approx(area, rel=1e-5)


def test_ply_keeps_quads_and_fields(tmp_path: Path, net: GreedyNet, mesh: Mesh):
    found = trimesh.load(written(tmp_path, net, "ply"), process=False)
    data = found.metadata["_ply_raw"]
    vertices = data["vertex"]["data"]
    assert np.stack([vertices[name] for name in "xyz"], axis=1) == pytest.approx(mesh.points)
    for name in FIELDS:
        assert np.ravel(vertices[name]) == pytest.approx(mesh.fields[name], rel=1e-6)
    assert data["face"]["length"] == len(mesh.quads)


def test_glb_keeps_fields(tmp_path: Path, net: GreedyNet, mesh: Mesh):
    found = trimesh.load(written(tmp_path, net, "glb"), force="mesh", process=False)
    for name in FIELDS:
        values = found.vertex_attributes[f"_{name.upper()}"]
        assert np.ravel(values) == pytest.approx(mesh.fields[name], rel=1e-6)
    assert found.vertices == pytest.approx(mesh.points, abs=1e-6)


def test_vtk_is_read_by_pyvista(tmp_path: Path, net: GreedyNet, mesh: Mesh):
    pyvista = pytest.importorskip("pyvista", reason="the extra `surfaces` is not installed")
    found = pyvista.read(written(tmp_path, net, "vtk"))
    assert found.points == pytest.approx(mesh.points, abs=1e-12)
    assert (found.faces.reshape(-1, 5)[:, 1:] == mesh.quads).all()
    assert found.point_data["normals"] == pytest.approx(mesh.normals, abs=1e-12)
    for name in FIELDS:
        assert found.point_data[name] == pytest.approx(mesh.fields[name], rel=1e-12)


def test_vtk_has_its_blocks_in_order(tmp_path: Path, net: GreedyNet, mesh: Mesh):
    """By hand from the bytes, for machines without the reader."""
    data = written(tmp_path, net, "vtk").read_bytes()
    start = data.index(f"POINTS {len(mesh.points)} double\n".encode())
    start = data.index(b"\n", start) + 1
    found = np.frombuffer(data, dtype=">f8", count=mesh.points.size, offset=start)
    assert found.reshape(-1, 3) == pytest.approx(mesh.points, abs=0)
    start = data.index(f"POLYGONS {len(mesh.quads)} {5 * len(mesh.quads)}\n".encode())
    start = data.index(b"\n", start) + 1
    found = np.frombuffer(data, dtype=">i4", count=5 * len(mesh.quads), offset=start)
    assert (found.reshape(-1, 5)[:, 1:] == mesh.quads).all()


def test_npz_keeps_everything(tmp_path: Path, net: GreedyNet, mesh: Mesh):
    with np.load(written(tmp_path, net, "npz")) as found:
        for name in ("points", "normals"):
            assert (found[name] == getattr(mesh, name)).all()
        assert (found["quads"] == net.quads).all()
        assert (found["disk"] == net.disk).all()
        assert (found["quad_angle"] == net.quad_angles).all()
        for name in FIELDS:
            assert (found[name] == mesh.fields[name]).all()
        assert found["parameters"].tolist() == ["2", "pi/3", "3*pi/5", "1/10"]


@pytest.mark.parametrize("kind", ["png", "svg"])
def test_picture(tmp_path: Path, tree, net: GreedyNet, kind: str):
    pytest.importorskip("matplotlib", reason="the extra `figures` is not installed")
    path = tmp_path / f"disk.{kind}"
    write_picture(str(path), tree, net)
    head = path.read_bytes()[:8]
    assert head == b"\x89PNG\r\n\x1a\n" if kind == "png" else head.startswith(b"<?xml")
    assert [entry.name for entry in tmp_path.iterdir()] == [path.name]


@pytest.mark.parametrize("name", ["surface", "surface.xyz", "surface.ply.gz", ".ply"])
def test_unknown_extension_is_refused(tmp_path: Path, net: GreedyNet, name: str):
    with pytest.raises(BadInput, match=r"expected a name that ends in \.ply, \.obj"):
        write_mesh(str(tmp_path / name), net)
    with pytest.raises(BadInput, match=r"expected a name that ends in \.png, \.svg"):
        require_picture(str(tmp_path / name))
    assert list(tmp_path.iterdir()) == []


def test_extension_may_be_in_capitals():
    assert [require_format(f"A.{kind.upper()}") for kind in FORMATS] == list(FORMATS)


@pytest.mark.parametrize("kind", FORMATS)
def test_failure_leaves_the_old_file(
    tmp_path: Path, net: GreedyNet, monkeypatch: pytest.MonkeyPatch, kind: str
):
    path = tmp_path / f"surface.{kind}"
    path.write_bytes(b"old")

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.fsync", full)
    with pytest.raises(BadInput, match="No space left on device"):
        write_mesh(str(path), net)
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]
