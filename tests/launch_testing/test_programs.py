"""The programs that launch_testing brings for tests of tests."""

import sys
from pathlib import Path

import pytest
from ament_index_python import get_package_prefix, get_package_share_directory
from launch import LaunchDescription, LaunchService
from launch.actions import ExecuteProcess

LIB = Path(get_package_prefix("launch_testing"), "lib", "launch_testing")


@pytest.mark.parametrize(
    ("name", "arguments", "code", "shown"),
    [
        ("terminating_proc", ["--extra"], 0, "Called with arguments ['--extra']"),
        ("terminating_proc", ["--exception"], 1, "Starting Up"),
        ("exit_code_proc", ["--silent"], 1, ""),
    ],
)
@pytest.mark.parametrize("python", [[], [sys.executable]])
def test_programs_end_as_their_names_say(name: str, arguments: list[str], code: int, shown: str, python: list[str]) -> None:
    action = ExecuteProcess(cmd=[*python, str(LIB / name), *arguments], cached_output=True)
    service = LaunchService()
    service.include_launch_description(LaunchDescription([action]))
    assert service.run() == 0
    assert action.return_code == code
    assert shown in action.get_stdout()


def test_the_example_is_there() -> None:
    assert Path(get_package_share_directory("launch_testing"), "examples", "good_proc_launch_test.py").is_file()
