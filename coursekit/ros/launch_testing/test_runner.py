"""Runs launch tests, one launch after the other."""

from __future__ import annotations

import inspect
import unittest
from collections.abc import Sequence
from typing import Any

from launch.launch_description_entity import LaunchDescriptionEntity

from .loader import TestRun
from .run import LaunchDied
from .run import RunnerWorker as _RunnerWorker
from .session import in_session, own_domain
from .test_result import FailResult, SkipResult


class LaunchTestRunner:
    """Launches the description of each of `test_runs` with `name:=value` arguments, and runs its tests."""

    def __init__(self, test_runs: Sequence[TestRun], launch_file_arguments: Sequence[str] = (), debug: bool = False) -> None:
        self._test_runs = test_runs
        self._launch_file_arguments = list(launch_file_arguments)
        self._debug = debug

    def generate_preamble(self) -> list[LaunchDescriptionEntity]:
        """Return the entities to launch before a test's description; subclasses override it."""
        return []

    def run(self) -> dict[TestRun, Any]:
        """Return the result of each run; if a launch ends before its tests, the remaining runs are left out."""
        results: dict[TestRun, Any] = {}
        for test_run in self._test_runs:
            if len(self._test_runs) > 1:
                print(f"\nStarting test run {test_run}")
            try:
                results[test_run] = self._run(test_run)
            except unittest.SkipTest as reason:
                print(f"{test_run} is skipped: {reason}")
                results[test_run] = SkipResult(test_run, str(reason))
            except LaunchDied:
                results[test_run] = FailResult(test_run, "Launch stopped before the active tests finished.")
                break
        return results

    def _run(self, test_run: TestRun) -> Any:
        with own_domain():
            return in_session(
                lambda: _RunnerWorker(test_run, self.generate_preamble(), self._launch_file_arguments, self._debug).run()
            )

    def validate(self) -> None:
        """Check that each description accepts the arguments that it is given.

        Raises:
            Exception: when a description does not.
        """
        for test_run in self._test_runs:
            _check_arguments(test_run)


def _check_arguments(test_run: TestRun) -> None:
    describe = inspect.unwrap(test_run._test_description_function)
    specification = inspect.getfullargspec(describe)
    taken = [*specification.args, *specification.kwonlyargs]
    for name in test_run.param_args:
        if name not in taken:
            raise Exception(
                f"Could not find an argument in generate_test_description matching prametrized argument '{name}'"
            )
    for name in taken:
        if name not in test_run.param_args:
            raise Exception(f"generate_test_description has unexpected extra argument '{name}'")
