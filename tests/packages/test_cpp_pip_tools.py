"""The compiler, CMake and ninja of `coursekit[cpp]` alone build and run the course's sixteen nodes: the system's are hidden.

CI installs them for this file, with `pip install ".[cpp]"`; elsewhere it is skipped where they are missing.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys

import pytest

from tests.packages import course_cpp
from tests.packages.pip_tools import pip_tools_or_skip
from tests.packages.test_cpp_workspace import BIN, ENV

pytestmark = [pytest.mark.slow, pytest.mark.timeout(1200)]


@pytest.fixture(scope="module")
def tools(tmp_path_factory):
    return pip_tools_or_skip(tmp_path_factory.mktemp("bin"))


def test_coursekit_cpp_makes_the_runtime(tools):
    command = [os.path.join(BIN, "coursekit"), "cpp"]
    done = subprocess.run(command, env=tools, capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0 and "C++ is ready" in done.stdout and "ziglang" in done.stdout, done.stdout + done.stderr


@pytest.fixture(scope="module")
def workspace(tools, tmp_path_factory):
    folder = tmp_path_factory.mktemp("pip_tools")
    course_cpp.lay_out(folder)
    course_cpp.build(folder, tools)
    return folder


@pytest.mark.parametrize("virtual", [True, False], ids=["virtual", "wall"])
@pytest.mark.parametrize("what", ["PAIRS", "SERVICES", "INTERFACES", "STATES"])
def test_the_sixteen_nodes_run_and_meet_their_twins(workspace, what, virtual):
    said = course_cpp.told(workspace, ENV, getattr(course_cpp, what), virtual).splitlines()
    assert said == course_cpp.RIGHT[what], said


def test_nothing_of_the_system_was_used(workspace):
    cache = (workspace / "build" / "s2_cpp_pubsub" / "CMakeCache.txt").read_text(encoding="utf-8")
    assert re.search(r"^CMAKE_CXX_COMPILER:\w+=[^;\n]*ziglang/zig(;|$)", cache, re.M)
    assert os.path.dirname(sys.executable) in cache
