"""ament_index_python: what is installed, read anew at each call."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from ament_index_python import (
    PackageNotFoundError,
    get_package_prefix,
    get_package_share_directory,
    get_packages_with_prefixes,
    get_resource,
    get_resource_types,
    get_resources,
    get_search_paths,
    has_resource,
)
from ament_index_python.resources import InvalidResourceNameError, InvalidResourceTypeNameError

from coursekit.interfaces.find import UNDERLAY


@pytest.fixture
def prefix(tmp_path, monkeypatch):
    index = tmp_path / "share" / "ament_index" / "resource_index"
    for name in ("packages/mine", "packages/std_msgs", "colours/red"):
        (index / name).parent.mkdir(parents=True, exist_ok=True)
        (index / name).write_text("content")
    monkeypatch.setenv("AMENT_PREFIX_PATH", os.pathsep.join([str(tmp_path), str(UNDERLAY)]))
    return tmp_path


def test_the_underlay_is_searched_when_nothing_is_sourced(tmp_path):
    """Also behind a workspace that was sourced before: a program finds what a sourced ROS gives."""
    shows = "import ament_index_python as a; print(*a.get_search_paths(), a.get_package_share_path('std_msgs'), sep='\\n')"
    for sourced, searched in ((None, [UNDERLAY]), (tmp_path, [tmp_path, UNDERLAY])):
        environ = {key: value for key, value in os.environ.items() if key != "AMENT_PREFIX_PATH"}
        environ.update({} if sourced is None else {"AMENT_PREFIX_PATH": str(sourced)})
        out = subprocess.run([sys.executable, "-c", shows], env=environ, capture_output=True, encoding="utf-8", check=True)
        assert out.stdout.splitlines() == [*map(str, searched), str(UNDERLAY / "share" / "std_msgs")]


def test_what_a_program_sets_itself_is_all_that_is_searched(tmp_path, monkeypatch):
    monkeypatch.setenv("AMENT_PREFIX_PATH", os.pathsep.join([str(tmp_path), "/not/there"]))
    assert get_search_paths() == [str(tmp_path)]
    assert get_packages_with_prefixes() == {}


@pytest.mark.parametrize("value", ["", None])
def test_no_prefix_at_all_is_an_error(value, monkeypatch):
    if value is None:
        monkeypatch.delenv("AMENT_PREFIX_PATH", raising=False)
    else:
        monkeypatch.setenv("AMENT_PREFIX_PATH", value)
    with pytest.raises(OSError, match="'AMENT_PREFIX_PATH' is not set or empty"):
        get_search_paths()
    with pytest.raises(OSError, match="'AMENT_PREFIX_PATH' is not set or empty"):
        get_resource_types()


def test_a_sourced_prefix_comes_first(prefix):
    assert get_search_paths() == [str(prefix), str(UNDERLAY)]
    assert get_package_prefix("std_msgs") == str(prefix)
    assert get_packages_with_prefixes()["geometry_msgs"] == str(UNDERLAY)


def test_resources_are_found(prefix):
    assert get_resource("colours", "red") == ("content", str(prefix))
    assert get_resources("colours") == {"red": str(prefix)}
    assert {"packages", "colours", "rosidl_interfaces"} <= get_resource_types()
    assert has_resource("colours", "blue") is False
    with pytest.raises(LookupError, match="Could not find the resource 'blue' of type 'colours'"):
        get_resource("colours", "blue")


def test_bad_names_are_refused():
    with pytest.raises(InvalidResourceTypeNameError):
        get_resources("a/b")
    with pytest.raises(InvalidResourceNameError):
        get_resource("packages", "../x")
    with pytest.raises(ValueError, match="is not a valid package name"):
        get_package_prefix("_")


def test_an_unknown_package_names_the_places_searched(prefix):
    with pytest.raises(PackageNotFoundError) as caught:
        get_package_prefix("nope")
    assert caught.value.args[0] == f"package 'nope' not found, searching: {[str(prefix), str(UNDERLAY)]}"
    assert isinstance(caught.value, KeyError)


def test_a_missing_share_folder_is_warned_about(prefix):
    with pytest.warns(UserWarning, match="does not exist"):
        assert get_package_share_directory("mine") == str(Path(prefix) / "share" / "mine")
