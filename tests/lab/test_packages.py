"""Meshes of packages that are built in the student's workspace are found, without anybody sourcing it in the kernel."""

import pytest

from coursekit.lab.magics import workspace_environment
from coursekit.urdf import MeshError, resources
from coursekit.urdf.resources import find_file, take_environment_from

DSV = "source;share/signs/hook/ament_prefix_path.dsv\n"


@pytest.fixture
def workspace(tmp_path, monkeypatch):
    monkeypatch.setenv("COURSEKIT_WORKSPACE", str(tmp_path))
    monkeypatch.setattr(resources, "_environment", [])
    prefix = tmp_path / "install" / "signs"
    for path, text in {
        "share/colcon-core/packages/signs": "",
        "share/signs/package.dsv": DSV,
        "share/signs/hook/ament_prefix_path.dsv": "prepend-non-duplicate;AMENT_PREFIX_PATH;\n",
        "share/signs/meshes/cone.stl": "solid",
    }.items():
        (prefix / path).parent.mkdir(parents=True, exist_ok=True)
        (prefix / path).write_text(text)
    return tmp_path


def test_a_built_package_is_found_once_the_lab_says_where(workspace):
    with pytest.raises(MeshError, match="package 'signs' not found"):
        find_file("package://signs/meshes/cone.stl")
    take_environment_from(workspace_environment)
    path = find_file("package://signs/meshes/cone.stl")
    assert path == workspace / "install/signs/share/signs/meshes/cone.stl"
