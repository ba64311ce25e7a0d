"""The Python tests of a CMakeLists.txt (pytest and launch_testing), for packages that were not built by CMake."""

from __future__ import annotations

import argparse
import re
import shutil
import sys
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from pathlib import Path

from coursekit.packages.cmake_run import Call, Reading
from coursekit.packages.cmake_text import CMakeError

_LINTERS = {"copyright": "*", "flake8": "*.py", "pep257": "*.py"}
"""The available linters, with the files that each one checks."""
_LINT_AUTO = "ament_lint_auto_find_test_dependencies"
_LINTS = {_LINT_AUTO, *(f"ament_{kind}" for kind in _LINTERS)}
_WITH_VALUE = ("TARGET", "TIMEOUT", "PYTHON_EXECUTABLE", "RUNNER", "WORKING_DIRECTORY", "LABELS")


@dataclass(frozen=True)
class TestCommand:
    """A test: its name, its command, the file for its results (JUnit XML), and its working directory."""

    name: str
    command: list[str]
    results: Path
    folder: Path | None = None


def commands(reading: Reading, results: Path, depends: Collection[str] = ()) -> list[TestCommand]:
    """Return the tests that can be run here, with their results below a folder; CMakeError for a missing file.

    `depends` are the test dependencies of the package, including linters.
    """
    folder = results / reading.project
    tests = [_RUNNABLE[call.command.name](call, folder) for call in reading.tests if call.command.name in _RUNNABLE]
    return tests + [lint for call in reading.tests if call.command.name in _LINTS for lint in _lints(call, folder, depends)]


def left_out(reading: Reading) -> list[str]:
    """Return the names of the tests that are not in Python: they need CMake."""
    known = {*_RUNNABLE, *_LINTS}
    return [call.words[0] for call in reading.tests if call.words and call.command.name not in known]


def selection(words: Sequence[str]) -> Callable[[str], bool]:
    """Return the filter for test names in `--ctest-args`, as in ctest; ValueError for an invalid pattern.

    >>> chosen = selection(["-R", "map", "-E", "slow"])
    >>> [chosen(name) for name in ("test_map", "test_map_slow", "test_scan")]
    [True, False, False]
    """
    parser = argparse.ArgumentParser(add_help=False, allow_abbrev=False)
    parser.add_argument("-R", "--tests-regex", default="")
    parser.add_argument("-E", "--exclude-regex")
    asked, _ = parser.parse_known_args(list(words))
    try:
        wanted, unwanted = re.compile(asked.tests_regex), re.compile(asked.exclude_regex or r"\b\B")
    except re.error as error:
        raise ValueError(f"--ctest-args: {error.pattern!r} is no pattern of names: {error}") from error
    return lambda name: bool(wanted.search(name)) and not unwanted.search(name)


def _pytest(call: Call, results: Path) -> TestCommand:
    if len(call.words) < 2:
        raise call.command.error("ament_add_pytest_test() needs a name and a path")
    name, path = call.words[0], _file(call, call.words[1])
    file = results / f"{name}.xunit.xml"
    report = [f"--junit-xml={file}", f"--junit-prefix={results.name}", "-o", "cache_dir=.pytest_cache"]
    return TestCommand(name, [sys.executable, "-m", "pytest", str(path), *report], file)


def _launch_test(call: Call, results: Path) -> TestCommand:
    if not call.words:
        raise call.command.error("add_launch_test() needs a path")
    path = _file(call, call.words[0])
    options = dict(zip(call.words[1:], call.words[2:], strict=False))
    name = options.get("TARGET") or call.words[0].replace("/", "_")
    file = results / f"{name}.xunit.xml"
    report = [f"--junit-xml={file}", f"--package-name={results.name}"]
    command = [sys.executable, "-m", "launch_testing.launch_test", str(path), *report, *_arguments(call.words)]
    return TestCommand(name, command, file)


def _lints(call: Call, results: Path, depends: Collection[str]) -> list[TestCommand]:
    """Return the requested linters that are available: one, or all among the package's test dependencies."""
    kinds = [call.command.name.removeprefix("ament_")]
    if call.command.name == _LINT_AUTO:
        asked = {f"ament_cmake_{kind}" for kind in _LINTERS} if "ament_lint_common" in depends else set(depends)
        kinds = [kind for kind in _LINTERS if f"ament_cmake_{kind}" in asked - set(call.words)]
    return [_lint(kind, call.folder, results) for kind in kinds if next(call.folder.rglob(_LINTERS[kind]), None)]


def _lint(kind: str, folder: Path, results: Path) -> TestCommand:
    file = results / f"{kind}.xunit.xml"
    script = shutil.which(f"ament_{kind}", path=str(Path(sys.executable).parent)) or f"ament_{kind}"
    return TestCommand(kind, [script, "--xunit-file", str(file)], file, folder)


def _arguments(words: Sequence[str]) -> list[str]:
    """Return the words after ARGS, up to the next keyword."""
    given = list(words[words.index("ARGS") + 1 :]) if "ARGS" in words else []
    ends = [given.index(word) for word in given if word in _WITH_VALUE]
    return given[: min(ends, default=len(given))]


def _file(call: Call, path: str) -> Path:
    file = call.folder / path
    if not file.exists():
        raise CMakeError(f"{call.command.name}: there is no {file}", call.command.file, call.command.line)
    return file


_RUNNABLE = {
    "ament_add_pytest_test": _pytest,
    "ament_add_ros_isolated_pytest_test": _pytest,
    "add_launch_test": _launch_test,
}
