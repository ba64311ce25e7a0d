"""What the checks of appendix C say is wrong with a place."""

import posixpath
from pathlib import Path

import pytest
from ament_index_python.packages import get_package_prefix, get_package_share_directory

from coursekit.grade.checking import judge
from coursekit.grade.exercise import find
from coursekit.grade.work import Work
from tests.grade.tried import told_of
from tests.needs import posix


def place_of(uri, find, cut):
    if not uri.startswith("package://"):
        raise ValueError
    name, _, rest = uri.removeprefix("package://").partition("/")
    return f"{find(name)}/{cut(rest)}"


@pytest.mark.parametrize(
    ("find_folder", "cut", "cause"),
    [
        (get_package_prefix, str, "share folder"),
        (get_package_share_directory, lambda rest: rest.split("/")[-1], "kept whole"),
    ],
)
def test_a_place_s_fault_is_named(tmp_path, find_folder, cut, cause):
    assert cause in told_of("appc.q1", {"where": lambda uri: place_of(uri, find_folder, cut)}, tmp_path).cause


def test_outside_of_the_folder_the_hint_is_about_its_border(tmp_path):
    def portable(name, package, root, near):
        path = posixpath.normpath(posixpath.join(near, name.removeprefix("file://")))
        root = posixpath.normpath(root)
        return name if name.startswith("package://") else f"package://{package}/{path[len(root) + 1 :]}"

    verdict = judge(find("appc.q3"), {"portable": portable}, tmp_path, tries=2)
    assert "a ValueError" in verdict.expected and verdict.hint == find("appc.q3").hints[1]


def test_a_path_object_is_told_how_to_become_a_text(tmp_path):
    said = told_of("appc.q1", {"where": lambda uri: Path(place_of(uri, get_package_share_directory, str))}, tmp_path)
    assert "`str(...)`" in said.cause


def test_a_package_name_that_was_changed_is_told_to_stay(tmp_path):
    def portable(name, package, root, near):
        path = posixpath.normpath(posixpath.join(near, name.removeprefix("file://")))
        return f"package://{package}/{path[len(posixpath.normpath(root)) + 1 :]}"

    said = judge(find("appc.q3"), {"portable": portable}, tmp_path, tries=2)
    assert "stay as they are" in said.cause and not said.hint


FILES = ("urdf/cone.urdf", "urdf/large_cone.urdf", "meshes/cone.stl", "meshes/large/cone.stl")


@pytest.fixture
def signs(tmp_path):
    """signs(*files) is a workspace whose last build of c_signs installed these; an older one had installed all."""

    def built(*files):
        share = tmp_path / "install/c_signs/share/c_signs"
        index = tmp_path / "install/c_signs/share/ament_index/resource_index/packages/c_signs"
        for file in (index, share / "package.xml", *(share / file for file in FILES)):
            file.parent.mkdir(parents=True, exist_ok=True)
            file.touch()
        build = tmp_path / "build/c_signs"
        build.mkdir(parents=True)
        (build / "colcon_build.rc").write_text("0\n")
        (build / "install.log").write_text("".join(f"{share / file}\n" for file in ("package.xml", *files)))
        return tmp_path

    return built


def test_a_file_that_only_an_older_build_installed_is_not_taken(signs):
    said = told_of("appc.q2", {}, signs(*FILES[:3]))
    assert said.expected == "share/c_signs/meshes/large/cone.stl, installed" and said.points == 1
    assert said.got.endswith(", ".join(FILES[:3])) and "an older build" in said.cause


@pytest.mark.parametrize("make", [pytest.param("link", marks=posix("accounts may not make links")), "no list"])
def test_what_was_linked_or_is_in_no_list_counts(signs, make):
    workspace = signs(*FILES[:3])
    file = workspace / "install/c_signs/share/c_signs" / FILES[3]
    if make == "link":
        file.unlink()
        file.symlink_to(workspace / "cone.stl")
        (workspace / "cone.stl").touch()
    else:
        (workspace / "build/c_signs/install.log").unlink()
    assert Work({}, workspace).installed("c_signs", FILES[3])
