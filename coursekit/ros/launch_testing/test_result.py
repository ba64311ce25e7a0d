"""The results of a run: unittest's results, and the duration of each test."""

from __future__ import annotations

import time
import unittest
from collections.abc import Collection
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .loader import TestRun


class FailResult(unittest.TestResult):
    """The result of a run whose launch ended too early: all tests have failed with `message`."""

    def __init__(self, test_run: TestRun, message: str) -> None:
        super().__init__()
        for case in test_run.all_cases():
            self.addFailure(case, (Exception, Exception(message), None))  # type: ignore[arg-type]
            self.testsRun += 1

    @property
    def testCases(self) -> list[unittest.TestCase]:
        """The tests."""
        return [case for case, _ in self.failures]

    @property
    def testTimes(self) -> dict[unittest.TestCase, float]:
        """The duration of each test: 0 seconds."""
        return dict.fromkeys(self.testCases, 0)

    def wasSuccessful(self) -> bool:
        """Return False, also when there were no tests."""
        return False


class SkipResult(unittest.TestResult):
    """The result of a run that was skipped for `skip_reason`."""

    def __init__(self, test_run: TestRun, skip_reason: str = "") -> None:
        super().__init__()
        for case in test_run.all_cases():
            self.addSkip(case, skip_reason)
            self.testsRun += 1

    @property
    def testCases(self) -> list[unittest.TestCase]:
        """The tests."""
        return [case for case, _ in self.skipped]

    @property
    def testTimes(self) -> dict[unittest.TestCase, float]:
        """The duration of each test: 0 seconds."""
        return dict.fromkeys(self.testCases, 0)

    def wasSuccessful(self) -> bool:
        """Return True: nothing has failed."""
        return True


class TestResult(unittest.TextTestResult):
    """The result of tests that ran."""

    __test__ = False  # pytest: this is not a test case

    def __init__(self, stream: Any = None, descriptions: Any = None, verbosity: Any = None, **options: Any) -> None:
        self.__began: dict[Any, float] = {}
        self.__times: dict[Any, float] = {}
        super().__init__(stream, descriptions, verbosity, **options)

    @property
    def testCases(self) -> Collection[unittest.TestCase]:
        """The tests that were started."""
        return self.__times.keys()

    @property
    def testTimes(self) -> dict[unittest.TestCase, float]:
        """The duration of each test in seconds."""
        return dict(self.__times)

    def startTest(self, test: unittest.TestCase) -> None:
        """Start the timer of a test."""
        self.__began[test] = time.time()
        self.__times[test] = 0
        super().startTest(test)

    def stopTest(self, test: unittest.TestCase) -> None:
        """Stop the timer of a test."""
        self.__times[test] = time.time() - self.__began.pop(test)
        super().stopTest(test)

    def append(self, results: TestResult) -> None:
        """Add the results of other tests."""
        self.__times.update(results.testTimes)
        self.testsRun += results.testsRun
        for name in ("failures", "errors", "skipped", "expectedFailures", "unexpectedSuccesses"):
            getattr(self, name).extend(getattr(results, name))
