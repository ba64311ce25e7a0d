"""Tests that a CMakeLists.txt names: those in Python are run by `colcon test`, those in C++ are named."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from coursekit.packages.cmake_run import read_project
from coursekit.packages.cmake_tests import commands, left_out, selection
from coursekit.packages.cmake_text import CMakeError

BIN = Path(sys.executable).parent
ISOLATED = """project(app)
if(BUILD_TESTING)
  find_package(launch_testing_ament_cmake REQUIRED)
  function(add_ros_isolated_launch_test path)
    set(RUNNER "${ament_cmake_ros_DIR}/run_test_isolated.py")
    add_launch_test("${path}" RUNNER "${RUNNER}" ${ARGN})
  endfunction()
  add_ros_isolated_launch_test(test/test_it.py TARGET named TIMEOUT 60 ARGS "speed:=2" LABELS slow)
  ament_add_pytest_test(math test/test_math.py TIMEOUT 5)
  ament_add_gtest(in_cpp test/test_it.cpp)
endif()
"""


MANIFEST = """<package format="3"><name>app</name><version>0.0.0</version><description>d</description>
<maintainer email="a@example.com">a</maintainer><license>Apache-2.0</license>
<export><build_type>ament_cmake</build_type></export></package>"""


def colcon(root, *words):
    """Run colcon in a folder, without a workspace that is sourced."""
    env = {key: value for key, value in os.environ.items() if not key.endswith("_PREFIX_PATH") and key != "PYTHONPATH"}
    env |= {"PATH": f"{BIN}{os.pathsep}{env['PATH']}"}
    command = [str(BIN / "colcon"), "--log-base", "log", *words]
    return subprocess.run(command, cwd=root, env=env, capture_output=True, encoding="utf-8", check=False)


@pytest.fixture
def package(tmp_path):
    def write(cmake, **tests):
        files = {"CMakeLists.txt": cmake, **{f"test/{name}.py": text for name, text in tests.items()}}
        for name, text in files.items():
            (tmp_path / "src/app" / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / "src/app" / name).write_text(text)
        return tmp_path / "src/app"

    return write


def test_a_function_of_the_file_passes_its_words_on(package, tmp_path):
    folder = package(ISOLATED, test_it="", test_math="")
    reading = read_project(folder, testing=True)
    launch, python = commands(reading, tmp_path)
    assert (launch.name, python.name, left_out(reading)) == ("named", "math", ["in_cpp"])
    assert launch.command[3:] == [
        str(folder / "test/test_it.py"), f"--junit-xml={tmp_path / 'app' / 'named.xunit.xml'}",
        "--package-name=app", "speed:=2",
    ]  # fmt: skip
    assert python.command[1:4] == ["-m", "pytest", str(folder / "test/test_math.py")]


def test_a_build_does_not_look_at_tests(package):
    assert read_project(package(ISOLATED)).tests == []


@pytest.mark.parametrize(
    ("cmake", "reason"),
    [
        ("ament_add_pytest_test(a test/nope.py)", "there is no"),
        ("add_launch_test()", "needs a path"),
        ("function(f)\nf()\nendfunction()\nf()", "calls itself without an end"),
    ],
)
def test_what_cannot_be_run_is_told_with_its_line(package, tmp_path, cmake, reason):
    with pytest.raises(CMakeError, match=reason):
        commands(read_project(package("project(app)\n" + cmake), testing=True), tmp_path)


@pytest.mark.slow
def test_colcon_runs_them_and_counts_what_fails(package, tmp_path):
    folder = package(
        "project(app)\nif(BUILD_TESTING)\n  ament_add_pytest_test(math test/test_math.py)\n"
        "  ament_add_pytest_test(broken test/test_broken.py)\nendif()\n",
        test_math="def test_math():\n    assert 2 + 2 == 4\n\n\ndef test_wrong():\n    assert 2 + 2 == 5\n",
        test_broken="import os\nos._exit(3)\n",
    )
    (folder / "package.xml").write_text(MANIFEST)
    said = [colcon(tmp_path, *words).stdout for words in (["build"], ["test"], ["test-result", "--all"])]
    assert "Summary: 3 tests, 1 error, 1 failure, 0 skipped" in said[-1], said


TWO = """project(app)
if(BUILD_TESTING)
  ament_add_pytest_test(of_maps test/test_maps.py)
  ament_add_pytest_test(of_scans test/test_scans.py)
endif()
"""


@pytest.mark.parametrize(
    ("words", "ran", "told"),
    [
        ("-R scan", ["of_scans"], ""),
        ("-E scan", ["of_maps"], ""),
        ("tests", ["of_maps", "of_scans"], ""),
        ("-R nothing", [], "Skipped tests of app: none has a name that --ctest-args choose\n"),
    ],
)
def test_ctest_args_choose_tests_by_name(package, tmp_path, words, ran, told):
    folder = package(TWO, test_maps="def test_it(): pass\n", test_scans="def test_it(): pass\n")
    (folder / "package.xml").write_text(MANIFEST)
    assert colcon(tmp_path, "build").returncode == 0
    tested = colcon(tmp_path, "test", "--ctest-args", *words.split(), "--packages-select", "app")
    assert tested.returncode == 0 and told in tested.stdout
    reports = (tmp_path / "build/app/test_results/app").glob("*.xml")
    assert sorted(path.name.split(".")[0] for path in reports) == ran


def test_a_pattern_of_ctest_that_is_none_is_told():
    with pytest.raises(ValueError, match="--ctest-args: '\\(' is no pattern"):
        selection(["-R", "("])
