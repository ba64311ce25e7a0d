"""Linters are tests of a package, as ament_lint_auto adds them: of one that CMake builds, and of one without C++."""

from __future__ import annotations

import re

import pytest

from tests.needs import compiler_or_skip
from tests.packages.test_cpp_workspace import colcon

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]
MANIFEST = """<package format="3"><name>linted</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.org">a</maintainer><license>MIT</license><buildtool_depend>ament_cmake</buildtool_depend>
<test_depend>{}</test_depend><export><build_type>ament_cmake</build_type></export></package>"""
CMAKE = """cmake_minimum_required(VERSION 3.8)
project(linted)
find_package(ament_cmake REQUIRED)
{}
if(BUILD_TESTING)
{}
endif()
ament_package()
"""
AUTO = "find_package(ament_lint_auto REQUIRED)\n{}\nament_lint_auto_find_test_dependencies()"
COMMON = {"copyright": (2, 2, 0), "flake8": (1, 0, 1), "pep257": (1, 0, 1)}
"""Tests, failures and skipped ones: flake8 and pydocstyle are not installed here."""


@pytest.fixture(params=["compiled", "files"])
def linted(request, tmp_path, monkeypatch):
    """linted(depend, CMake's lines): what `colcon test` prints, and the counts of each linter."""
    if request.param == "compiled":
        compiler_or_skip()
    monkeypatch.delenv("PYTHONPATH", raising=False)
    folder = tmp_path / "src" / "linted"
    (folder / "launch").mkdir(parents=True)
    (folder / "launch" / "a.launch.py").write_text("import os\n")
    (folder / "b.py").write_text("# Copyright 2024 A\n")  # without a license

    def test(depend, lines):
        target = "add_library(linted INTERFACE)" if request.param == "compiled" else ""
        (folder / "package.xml").write_text(MANIFEST.format(depend))
        (folder / "CMakeLists.txt").write_text(CMAKE.format(target, lines))
        for step in ("build", "test"):
            done = colcon(tmp_path, step)
            assert done.returncode == 0, done.stdout + done.stderr
        results = tmp_path / "build" / "linted" / "test_results" / "linted"
        told = colcon(tmp_path, "test-result", "--all", "--test-result-base", str(results)).stdout.splitlines()
        counts = [re.split(r"[\\/]", line)[-1].split(".xunit.xml: ") for line in told if ".xunit.xml" in line]
        numbers = {name: [int(part.split()[0]) for part in text.split(", ")] for name, text in counts}
        return done.stdout, {name: (tests, failures, skipped) for name, (tests, _, failures, skipped) in numbers.items()}

    return test


def test_all_that_is_common_but_for_what_is_said_to_be_found(linted):
    assert linted("ament_lint_common", AUTO.format(""))[1] == COMMON
    said, counts = linted("ament_lint_common", AUTO.format("set(ament_cmake_copyright_FOUND TRUE)"))
    assert counts.keys() >= {"flake8", "pep257"} and "copyright" not in said


def test_those_that_the_tests_depend_on_and_those_that_are_called(linted):
    assert linted("ament_cmake_copyright", AUTO.format(""))[1] == {"copyright": COMMON["copyright"]}
    lines = "find_package(ament_cmake_copyright REQUIRED)\nament_copyright()"
    assert linted("ament_cmake_copyright", lines)[1] == {"copyright": COMMON["copyright"]}
