"""The course's sixteen nodes in C++, built by colcon, run and launched on both clocks, crossed with Python's."""

from __future__ import annotations

import pytest

from tests.needs import compiler_or_skip
from tests.packages import course_cpp
from tests.packages.test_cpp_workspace import ENV, sourced

pytestmark = [pytest.mark.slow, pytest.mark.timeout(600)]
BOTH_CLOCKS = pytest.mark.parametrize("virtual", [True, False], ids=["virtual", "wall"])


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    compiler_or_skip()
    folder = tmp_path_factory.mktemp("course_cpp")
    course_cpp.lay_out(folder)
    course_cpp.build(folder, ENV)
    return folder


def test_all_sixteen_are_programs(workspace):
    programs = [
        workspace / "install" / package / "lib" / package / name
        for package, names in course_cpp.NODES.items()
        for name in names
    ]
    assert len(programs) == 16 and all(path.is_file() for path in programs)
    assert sourced(workspace, "ros2 pkg executables s3_cpp_srvcli").stdout.split()[1::2] == sorted(
        course_cpp.NODES["s3_cpp_srvcli"]
    )


@BOTH_CLOCKS
@pytest.mark.parametrize("what", ["PAIRS", "SERVICES", "INTERFACES", "STATES"])
def test_they_run_and_meet_their_twins(workspace, what, virtual):
    said = course_cpp.told(workspace, ENV, getattr(course_cpp, what), virtual).splitlines()
    assert said == course_cpp.RIGHT[what], said


@BOTH_CLOCKS
def test_a_launch_file_starts_five_and_a_twin(workspace, virtual):
    clock = "COURSEKIT_STOP_AFTER=3" if virtual else "COURSEKIT_TIME=wall COURSEKIT_STOP_AFTER=8"  # some start slowly
    said = sourced(workspace, f"{clock} ros2 launch s4_cpp_apps all.launch.py").stdout
    assert "[cpp_hs_subscriber_node]: 41 degrees, motors up: motors are warm" in said, said
    assert "[cpp_sphere_subscriber_node]: centre 0.5 0.0 1.0, radius 0.20" in said
    assert "[crossed]" in said and "process has died" not in said


def test_ros2_run_and_parameters_of_a_launch_file(workspace):
    said = sourced(workspace, "COURSEKIT_STOP_AFTER=1.6 ros2 launch s5_cpp_params params.launch.py").stdout
    assert "launched 640x480" in said
    said = sourced(
        workspace, "COURSEKIT_STOP_AFTER=1.6 ros2 run s2_cpp_pubsub publisher_exe --ros-args -r __node:=me"
    ).stderr
    assert "[me]: sending 'C++ says 2'" in said
