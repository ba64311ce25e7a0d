"""ros2launch.api: what programs import that look for launch files, show them or run them."""

from argparse import Namespace

import pytest
from ament_index_python.packages import PackageNotFoundError
from ros2launch.api import (
    LaunchFileNameCompleter,
    MultipleLaunchFilesError,
    get_share_file_path_from_package,
    is_launch_file,
    launch_a_launch_file,
    parse_launch_arguments,
    print_arguments_of_launch_file,
)
from ros2launch.api.api import get_launch_file_paths

from coursekit.processes.session import Session

TEXT = """<launch><arg name="who" default="you" description="whom to greet"/><log message="hello $(var who)"/></launch>"""


@pytest.fixture
def share(tmp_path, monkeypatch):
    """The share folder of a package `greeter` with a launch file, and a file whose name is there twice."""
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    index = tmp_path / "share/ament_index/resource_index/packages"
    index.mkdir(parents=True)
    (index / "greeter").touch()
    folder = tmp_path / "share/greeter"
    for name in ("launch/greet_launch.xml", "launch/twice.txt", "config/twice.txt"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(TEXT)
    return folder


def test_a_file_is_found_in_its_package(share):
    path = get_share_file_path_from_package(package_name="greeter", file_name="greet_launch.xml")
    assert path == str(share / "launch/greet_launch.xml") and is_launch_file(path) and is_launch_file(path=path)
    assert get_launch_file_paths(path=str(share)) == [path]
    assert LaunchFileNameCompleter()("", Namespace(package_name="greeter")) == ["greet_launch.xml"]
    assert LaunchFileNameCompleter()("", Namespace(package_name="nobody")) == []


def test_what_is_not_there_or_there_twice_is_an_error_of_its_kind(share):
    with pytest.raises(FileNotFoundError, match="file 'x.launch.py' was not found in the share directory"):
        get_share_file_path_from_package(package_name="greeter", file_name="x.launch.py")
    with pytest.raises(MultipleLaunchFilesError, match="more than once") as raised:
        get_share_file_path_from_package(package_name="greeter", file_name="twice.txt")
    assert len(raised.value.paths) == 2
    with pytest.raises(PackageNotFoundError):
        get_share_file_path_from_package(package_name="nobody", file_name="x")


def test_arguments_are_read_or_refused():
    assert list(parse_launch_arguments(["a:=1", "b:=x:=y", "a:=2"])) == [("a", "2"), ("b", "x:=y")]
    with pytest.raises(RuntimeError, match="malformed launch argument 'a=1'"):
        parse_launch_arguments(["a=1"])


def test_a_file_is_shown_and_run(share, capsys):
    path = str(share / "launch/greet_launch.xml")
    print_arguments_of_launch_file(launch_file_path=path)
    assert "'who':" in capsys.readouterr().out
    with Session(virtual=True).use() as session:
        process = session.start(
            lambda: launch_a_launch_file(launch_file_path=path, launch_file_arguments=["who:=all"]), name="program"
        )
        assert process.wait(10.0) == 0 and "hello all" in process.output
