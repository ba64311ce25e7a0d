"""The meshes of the course are those that the script makes."""

import numpy as np
import pytest
import trimesh

from robots.make import __main__ as maker
from tests.urdf.oracle import ROBOTS


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp("meshes")
    maker.make(folder)
    return folder


@pytest.mark.parametrize(
    "name", [*(f"{solid}.stl" for solid in maker.SOLIDS), *(f"{painted}.dae" for painted in maker.PAINTED)]
)
def test_a_mesh_file_is_what_the_script_makes(made, name):
    kept, new = (trimesh.load_mesh(folder / name) for folder in (ROBOTS.parent / "meshes", made))
    kept, new = (mesh.to_mesh() if isinstance(mesh, trimesh.Scene) else mesh for mesh in (kept, new))
    np.testing.assert_allclose(kept.bounds, new.bounds, atol=1e-5)
    assert kept.area == pytest.approx(new.area, rel=1e-3)


def test_the_meshes_are_small():
    files = [path for path in (ROBOTS.parent / "meshes").rglob("*") if path.is_file()]
    assert sum(path.stat().st_size for path in files) < 1_000_000
