"""ament_cmake's commands. What must hold was printed by ament_cmake 1.5.2 and colcon of Debian, with the same workspace."""

from __future__ import annotations

import os
import re
import shutil
from pathlib import Path

import pytest

from coursekit.packages.overlay import overlay_environment
from tests.needs import compiler_or_skip, posix
from tests.packages.test_cpp_workspace import colcon, sourced

WORKSPACE = Path(__file__).parents[1] / "fixtures" / "ament_ws"
VARIABLES = [
    *("sums_FOUND=[1]", "sums_VERSION=[1.4.2]", "sums_TARGETS=[sums::sums]", "sums_DEFINITIONS=[-DSUMS_FLAG=7]"),
    *("sums_LINK_FLAGS=[-Wl,--as-needed]", "sums_FOUND_AMENT_PACKAGE=[TRUE]", "sums_DIR=[INSTALL/sums/share/sums/cmake]"),
    *("nines_FOUND=[1]", "nines_VERSION=[1.4.2]", "nines_TARGETS=[nines::nines]", "nines_DEFINITIONS=[]"),
    "nines_FOUND_AMENT_PACKAGE=[TRUE]",
    *("eights_FOUND=[1]", "eights_VERSION=[1.4.2]"),
    *("eights_FOUND_AMENT_PACKAGE=[TRUE]", "eights_LIBRARIES=[INSTALL/eights/lib/libeights.a]"),
]
SAID = """
extras of sums in INSTALL/sums/share/sums/cmake
hello you of asker
INDEX has=INSTALL/sums content=one;two all=sums
INDEX nobody=FALSE
unique=a;b
path=/a/c/d
ends=TRUE
XML v=1.4.2 m=a <a@example.com> b=ament_cmake bd=sums;nines bed=sums;nines be= ed=sums;nines \
td=ament_cmake_gtest;ament_cmake_gmock;ament_cmake_pytest
""".strip().splitlines()
INSTALLED = [
    *("include/sums/sums/sums.hpp", "include/sums/sums/version.h", "lib/libsums.so", "lib/sums/go.py"),
    *("share/ament_index/resource_index/files/sums", "share/ament_index/resource_index/named/other"),
    *("share/ament_index/resource_index/packages/sums", "share/ament_index/resource_index/things/sums"),
    *("share/sums/cmake/plain.cmake", "share/sums/cmake/post.cmake", "share/sums/cmake/sums-extras.cmake"),
    *("share/sums/cmake/sumsConfig-version.cmake", "share/sums/cmake/sumsConfig.cmake", "share/sums/cmake/sumsExport.cmake"),
    *("share/sums/environment/sums.dsv", "share/sums/environment/sums.sh", "share/sums/package.xml"),
]
RESULTS = """
Testing/NOW/Test.xml: 13 tests, 0 errors, 6 failures, 1 skipped
test_results/asker/test_bad.gtest.xml: 2 tests, 0 errors, 1 failure, 0 skipped
test_results/asker/test_cmd.xml: 1 test, 1 error, 0 failures, 0 skipped
test_results/asker/test_cmd_bad.xml: 1 test, 1 error, 0 failures, 0 skipped
test_results/asker/test_dir.xunit.xml: 2 tests, 0 errors, 0 failures, 1 skipped
test_results/asker/test_gen.xml: 1 test, 0 errors, 0 failures, 0 skipped
test_results/asker/test_good.gtest.xml: 4 tests, 0 errors, 0 failures, 2 skipped
test_results/asker/test_mock.gtest.xml: 1 test, 0 errors, 0 failures, 0 skipped
test_results/asker/test_py.xunit.xml: 2 tests, 0 errors, 1 failure, 0 skipped
test_results/asker/test_skipped.gtest.xml: 1 test, 0 errors, 0 failures, 1 skipped
test_results/asker/two.gtest.xml: 4 tests, 0 errors, 1 failure, 2 skipped
""".strip().splitlines()

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    """The workspace, built, with what its build said in `said.txt`."""
    compiler_or_skip()
    folder = tmp_path_factory.mktemp("ament") / "ws"
    shutil.copytree(WORKSPACE, folder)
    built = colcon(folder, "build", "--event-handlers", "console_cohesion+")
    assert built.returncode == 0, built.stdout + built.stderr
    (folder / "said.txt").write_text(built.stdout.replace(str(folder / "install"), "INSTALL"))
    return folder


def test_the_next_package_finds_what_this_one_exports(workspace):
    said = re.findall(r"^-- (?:VAR )?(.*)$", (workspace / "said.txt").read_text(), re.M)
    assert [variable for variable in [*VARIABLES, *SAID] if variable not in said] == []


def test_programs_have_the_version_and_no_flags_of_targets(workspace):
    for program in ("use", "use2", "use3"):
        assert sourced(workspace, f"ros2 run asker {program}").stdout == "7 8 9 1.4.2 1\n"
    assert sourced(workspace, "ros2 run sums go.py").stdout == "go 3\n"


def test_what_is_installed_stands_where_ament_puts_it(workspace):
    prefix = workspace / "install" / "sums"
    assert [name for name in INSTALLED if not (prefix / name).is_file()] == []
    assert {path.name for path in prefix.rglob("*-packages/*")} >= {"alone.py", "sums"}
    index = prefix / "share" / "ament_index" / "resource_index"
    texts = [(index / name).read_text() for name in ("things/sums", "files/sums", "named/other")]
    assert texts == ["one;two", "a thing\n", "x"]


def test_sourcing_runs_the_hooks_of_a_package(workspace):
    paths = str(workspace / "install" / "sums" / "share" / "sums")
    said = sourced(workspace, 'echo "$SUMS_DSV $SUMS_PATHS"').stdout
    assert said == f"sums {paths}\n"
    env = overlay_environment(workspace / "install", os.environ)
    assert (env["SUMS_DSV"], env["SUMS_PATHS"]) == ("sums", paths)


@pytest.mark.skipif(not os.path.isfile("/usr/include/gtest/gtest.h"), reason="needs libgtest-dev")
def test_ctest_runs_all_kinds_of_tests(workspace):
    tested = colcon(workspace, "test")
    assert tested.returncode == 0 and "1 package had test failures: asker" in tested.stdout
    told = colcon(workspace, "test-result", "--all")
    *results, _, summary = re.sub(r"Testing/[\d-]+/", "Testing/NOW/", told.stdout).splitlines()
    assert [result.removeprefix(f"build{os.sep}asker{os.sep}") for result in results] == RESULTS
    assert summary == "Summary: 32 tests, 2 errors, 9 failures, 7 skipped" and told.returncode == 1
    assert (workspace / "build" / "asker" / "cmd.txt").read_text() == "helped\n"
    assert "- asker.Bad fails" in colcon(workspace, "test-result", "--verbose").stdout
    colcon(workspace, "test", "--packages-select", "asker", "--test-result-base", "kept", "--ctest-args", "-L", "gmock")
    assert (workspace / "kept" / "asker" / "test_mock.gtest.xml").is_file()
    log = (workspace / "log" / "latest_test" / "asker" / "stdout.log").read_text()
    assert re.search(r"^100% tests passed.* out of 1$", log, re.M), log


@pytest.mark.skipif(not os.path.isfile("/usr/include/gtest/gtest.h"), reason="needs libgtest-dev")
def test_tests_that_are_not_compiled_are_not_run(workspace):
    source = workspace / "src" / "asker" / "test" / "test_mock.cpp"
    right = source.read_text()
    source.write_text(right + "int after = 1\nint more = 2;\n")
    tested = colcon(workspace, "test", "--packages-select", "asker")
    source.write_text(right)
    assert re.search(r"test_mock\.cpp:[45]:\d+: error: expected", tested.stderr), tested.stderr
    assert re.search(r"hint: .*test_mock\.cpp.*: a statement ends with ;", tested.stderr), tested.stderr
    assert "1 package failed: asker" in tested.stdout and tested.returncode != 0


HOOKED = """cmake_minimum_required(VERSION 3.8)
project(hooked)
find_package(ament_cmake REQUIRED)
set(models share/${PROJECT_NAME}/models)
ament_environment_hooks("${CMAKE_CURRENT_SOURCE_DIR}/env-hooks/${PROJECT_NAME}.dsv.in")
ament_package()
"""


@posix("bash sources the workspace")
def test_a_package_of_files_alone_has_hooks_too_without_a_compiler(tmp_path):
    package = tmp_path / "src" / "hooked"
    (package / "env-hooks").mkdir(parents=True)
    (package / "CMakeLists.txt").write_text(HOOKED)
    (package / "env-hooks" / "hooked.dsv.in").write_text(
        "prepend-non-duplicate;GAZEBO_MODEL_PATH;@models@;share\nset;HOOKED_AT;@CMAKE_INSTALL_PREFIX@/here\n"
    )
    manifest = (WORKSPACE / "src" / "eights" / "package.xml").read_text().replace("eights", "hooked")
    (package / "package.xml").write_text(manifest)
    built = colcon(tmp_path, "build")
    assert built.returncode == 0, built.stderr
    prefix = tmp_path / "install" / "hooked"
    expected = [f"{prefix}/share{os.pathsep}{prefix}/share/hooked/models", f"{prefix}/here"]
    env = overlay_environment(tmp_path / "install", {"GAZEBO_MODEL_PATH": ""})
    assert [env["GAZEBO_MODEL_PATH"], env["HOOKED_AT"]] == expected
    said = sourced(tmp_path, 'echo "$GAZEBO_MODEL_PATH"; echo "$HOOKED_AT"').stdout
    assert [line.rstrip(os.pathsep) for line in said.splitlines()] == expected


GENERATED = """cmake_minimum_required(VERSION 3.8)
project(generated)
find_package(ament_cmake REQUIRED)
add_executable(nothing nothing.cpp)
if(BUILD_TESTING)
  find_package(launch_testing_ament_cmake REQUIRED)
  configure_file(test_made.py.in test_made.py.configured @ONLY)
  file(GENERATE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/test_made_$<CONFIG>.py"
    INPUT "${CMAKE_CURRENT_BINARY_DIR}/test_made.py.configured")
  add_launch_test("${CMAKE_CURRENT_BINARY_DIR}/test_made_$<CONFIG>.py" TARGET test_made TIMEOUT 60 ENV WHO=@who
    APPEND_ENV EXTRA_PATH=/extra APPEND_LIBRARY_DIRS "${CMAKE_CURRENT_BINARY_DIR}")
endif()
ament_package()
"""
MADE = """import os
import unittest

import launch
import launch.actions
import launch_testing.actions


def generate_test_description():
    lasting = launch.actions.ExecuteProcess(cmd=["tail", "-f", "/dev/null"])
    return launch.LaunchDescription([lasting, launch_testing.actions.ReadyToTest()])


class Made(unittest.TestCase):
    def test_environment(self):
        assert os.environ["WHO"] == "@who" and "/extra" in os.environ["EXTRA_PATH"]
"""


@posix("tail lasts until the tests are over")
def test_a_launch_test_may_be_a_file_that_cmake_generates(tmp_path):
    compiler_or_skip()
    package = tmp_path / "src" / "generated"
    package.mkdir(parents=True)
    (package / "CMakeLists.txt").write_text(GENERATED)
    (package / "nothing.cpp").write_text("int main() {}\n")
    (package / "test_made.py.in").write_text(MADE)
    manifest = (WORKSPACE / "src" / "eights" / "package.xml").read_text().replace("eights", "generated")
    (package / "package.xml").write_text(manifest)
    assert colcon(tmp_path, "build").returncode == 0
    tested = colcon(tmp_path, "test")
    assert tested.returncode == 0 and "1 package finished" in tested.stdout, tested.stdout + tested.stderr
    told = colcon(tmp_path, "test-result", "--all").stdout
    assert "test_made.xunit.xml: 1 test, 0 errors, 0 failures, 0 skipped" in told, told
