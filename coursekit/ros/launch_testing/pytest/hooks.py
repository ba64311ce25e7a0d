"""pytest's plugin: a file whose `generate_test_description` has the mark `launch_test` is one test.

Every run of pytest loads this module. Modules that need `launch` are imported when there is such a file.
"""

from __future__ import annotations

import copy
import unittest
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

ENTRY = "generate_test_description"


class LaunchTestFailure(Exception):
    """Raised when tests have failed; `results` has the result of each run."""

    def __init__(self, message: str, results: dict[Any, Any]) -> None:
        super().__init__(message)
        self.message = message
        self.results = results


class LaunchTestItem(pytest.Item):
    """The launches and tests of one file."""

    def __init__(self, *, test_runs: Any = (), runner_cls: Any = None, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.test_runs = test_runs
        self.runner_cls = runner_cls

    def runtest(self) -> None:
        """Run the launches and tests; a plugin may do so several times.

        Raises:
            LaunchTestFailure: when a test has failed.
        """
        from ..test_runner import LaunchTestRunner

        runner = (self.runner_cls or LaunchTestRunner)(
            test_runs=copy.deepcopy(self.test_runs),
            launch_file_arguments=[word for words in self.config.getoption("--launch-args") for word in words],
            debug=self.config.getoption("verbose") > 0,
        )
        runner.validate()
        results = runner.run()
        if not all(result.wasSuccessful() for result in results.values()):
            raise LaunchTestFailure("some test cases have failed", results)

    def repr_failure(self, excinfo: Any, style: Any = None) -> Any:
        """Show each test that failed."""
        if not isinstance(excinfo.value, LaunchTestFailure):
            return super().repr_failure(excinfo, style)
        return "\n\n".join(
            _described(case, text)
            for result in excinfo.value.results.values()
            if not result.wasSuccessful()
            for case, text in (*result.errors, *result.failures)
        )

    def reportinfo(self) -> tuple[Path, int, str]:
        """The path and the name of the item."""
        return self.path, 0, f"launch tests: {self.name}"


def _described(case: Any, text: str) -> str:
    name = case.id() if isinstance(case, unittest.TestCase) else str(case)
    width = max((len(line) for line in text.splitlines()), default=3)
    return f"{'=' * width}\nFAIL: {name}\n{'-' * width}\n{text}"


class LaunchTestModule(pytest.File):
    """A file with launch tests."""

    @classmethod
    def from_parent(cls, parent: Any, **kwargs: Any) -> Any:
        """Create a module; plugins for older versions of pytest pass its path as `fspath`."""
        if "fspath" in kwargs:
            kwargs["path"] = Path(kwargs.pop("fspath"))
        return super().from_parent(parent, **kwargs)

    def makeitem(self, *args: Any, **kwargs: Any) -> Any:
        """Return the file's test; subclasses override it."""
        return LaunchTestItem.from_parent(*args, **kwargs)

    def collect(self) -> Iterator[Any]:
        """Yield the file's test."""
        from ..loader import LoadTestsFromPythonModule

        module = _imported(self.parent, self.path)
        name = module.__name__
        yield self.makeitem(name=name, parent=self, test_runs=LoadTestsFromPythonModule(module, name=name))


def _imported(parent: Any, path: Path) -> Any:
    """Import the file as pytest imports tests."""
    return pytest.Module.from_parent(parent, path=path).obj


def find_launch_test_entrypoint(path: Path, parent: Any) -> Any:
    """Return the `generate_test_description` of a file; None if there is none or the file cannot be imported."""
    if ENTRY.encode() not in path.read_bytes():
        return None
    try:
        return getattr(_imported(parent, path), ENTRY, None)
    except (Exception, pytest.skip.Exception):
        return None  # pytest itself will import the file and report the error


def pytest_pycollect_makemodule(module_path: Path, parent: Any) -> Any:
    """Collect a file of launch tests; leave other files to pytest."""
    entrypoint = find_launch_test_entrypoint(module_path, parent)
    if entrypoint is None:
        return None
    return parent.session.gethookproxy(module_path).pytest_launch_collect_makemodule(
        module_path=module_path, path=module_path, parent=parent, entrypoint=entrypoint
    )


@pytest.hookimpl(trylast=True)
def pytest_launch_collect_makemodule(module_path: Path, parent: Any, entrypoint: Any) -> Any:
    """Collect a file whose description has the mark `launch_test`."""
    return marked_module(LaunchTestModule, "launch_test", module_path, parent, entrypoint)


def marked_module(
    kind: type[LaunchTestModule], mark: str, module_path: Path, parent: Any, entrypoint: Any
) -> LaunchTestModule | None:
    """Return a collector of the kind, with the description's marks; None if `mark` is not among the marks."""
    marks = getattr(entrypoint, "pytestmark", [])
    if not any(given.name == mark for given in marks):
        return None
    module = kind.from_parent(parent, path=module_path)
    for given in marks:
        module.add_marker(getattr(pytest.mark, given.name).with_args(*given.args, **given.kwargs))
    return module  # type: ignore[no-any-return]


def pytest_addhooks(pluginmanager: Any) -> None:
    """Let other plugins collect launch tests of their own kind."""
    from . import hookspecs

    pluginmanager.add_hookspecs(hookspecs)


def pytest_addoption(parser: Any) -> None:
    """Add the option for launch arguments."""
    parser.addoption("--launch-args", action="append", nargs="*", default=[], help="One or more Launch test arguments")


def pytest_configure(config: Any) -> None:
    """Register the mark."""
    config.addinivalue_line(
        "markers",
        "launch_test: mark a generate_test_description function as a launch test entrypoint",
    )
