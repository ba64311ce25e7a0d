"""What the checks of appendix C say is wrong with a place."""

import posixpath
from pathlib import Path

import pytest
from ament_index_python.packages import get_package_prefix, get_package_share_directory

from coursekit.grade.checking import judge
from coursekit.grade.exercise import find
from tests.grade.tried import told_of


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
