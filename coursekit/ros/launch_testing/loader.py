"""Loading of launch tests: a launch description, tests during the launch and tests after it."""

from __future__ import annotations

import unittest
from collections.abc import Callable, Iterable, Iterator, Mapping
from types import ModuleType
from typing import Any

from launch import LaunchDescription

from .actions import ReadyToTest
from .binding import bind_arguments, give_attributes, iterate_tests

NO_READY = (
    "generate_test_description functions must return a LaunchDescription containing a ReadyToTest action: "
    "add launch_testing.actions.ReadyToTest()"
)


def find_ready_actions(entities: Iterable[Any]) -> Iterator[ReadyToTest]:
    """Yield the ReadyToTest actions among entities and their sub-entities."""
    for entity in entities:
        if isinstance(entity, ReadyToTest):
            yield entity
        yield from find_ready_actions(entity.describe_sub_entities())
        for _, conditional in entity.describe_conditional_sub_entities():
            yield from find_ready_actions(conditional)


class TestRun:
    """One launch and its tests; with `param_args`, the tests are named after these values."""

    __test__ = False  # pytest: this is not a test case

    def __init__(
        self,
        name: str,
        test_description_function: Callable[..., Any],
        param_args: Mapping[str, Any],
        pre_shutdown_tests: Any,
        post_shutdown_tests: Any,
    ) -> None:
        self.name = name
        self._test_description_function = test_description_function
        self.param_args = param_args
        self.pre_shutdown_tests = pre_shutdown_tests
        self.post_shutdown_tests = post_shutdown_tests
        self._name_after_values()
        for suite in (*_suites(pre_shutdown_tests), *_suites(post_shutdown_tests)):
            suite._removeTestAtIndex = lambda index: None  # type: ignore[attr-defined] # results need the tests afterwards

    def _name_after_values(self) -> None:
        for case in self.all_cases() if self.param_args else ():
            method = getattr(case, case._testMethodName)
            case._testMethodName += self._values()
            setattr(case, case._testMethodName, method)

    @property
    def markers(self) -> dict[str, Any]:
        """The marks of `launch_testing.markers` on the description."""
        return getattr(self._test_description_function, "__markers__", {})

    def normalized_test_description(self, ready_fn: Callable[[], object]) -> tuple[LaunchDescription, dict[str, Any]]:
        """Return the launch description and the context for the tests; `ready_fn` is called when the tests may begin.

        Raises:
            Exception: when the description has no ReadyToTest action.
        """
        result = self._test_description_function()
        description, context = result if isinstance(result, tuple) else (result, {})
        ready = next(find_ready_actions(description.entities), None)
        if ready is None:
            raise Exception(NO_READY)
        ready._add_callback(ready_fn)
        return description, context

    def get_launch_description(self) -> LaunchDescription:
        """Return the launch description for inspection."""
        return self.normalized_test_description(ready_fn=lambda: None)[0]

    def bind(
        self,
        tests: Any,
        injected_attributes: Mapping[str, Any] = {},
        injected_args: Mapping[str, Any] = {},
    ) -> None:
        """Add attributes to tests (`self.proc_info`), and pass arguments to parameters of the same name."""
        give_attributes(injected_attributes, tests)
        bind_arguments(injected_args, tests)

    def all_cases(self) -> Iterator[Any]:
        """Yield all tests, those during the launch first."""
        yield from iterate_tests(self.pre_shutdown_tests)
        yield from iterate_tests(self.post_shutdown_tests)

    def __str__(self) -> str:
        return self.name + self._values()

    def _values(self) -> str:
        return f"[{', '.join(map(str, self.param_args.values()))}]" if self.param_args else ""


def LoadTestsFromPythonModule(module: ModuleType, *, name: str = "launch_tests") -> list[TestRun]:
    """Return the runs of a module with `generate_test_description`: one, or one per parameter value."""
    describe = module.generate_test_description
    descriptions = describe() if hasattr(describe, "__parametrized__") else [(describe, {})]
    return [
        TestRun(
            name,
            function,
            values,
            PreShutdownTestLoader().loadTestsFromModule(module),
            PostShutdownTestLoader().loadTestsFromModule(module),
        )
        for function, values in descriptions
    ]


def PreShutdownTestLoader() -> unittest.TestLoader:
    """Return a loader of the tests that run during the launch."""
    return _Loader(after=False)


def PostShutdownTestLoader() -> unittest.TestLoader:
    """Return a loader of the tests that run after the launch has ended."""
    return _Loader(after=True)


class _Loader(unittest.TestLoader):
    """Loads tests of one kind, each time into new classes, because each run gives them different attributes."""

    def __init__(self, *, after: bool) -> None:
        super().__init__()
        self._after = after

    def loadTestsFromTestCase(self, testCaseClass: type[unittest.TestCase]) -> unittest.TestSuite:
        if getattr(testCaseClass, "__post_shutdown_test__", False) != self._after:
            return unittest.TestSuite()
        own = type(
            testCaseClass.__name__,
            (testCaseClass,),
            {"__module__": testCaseClass.__module__, "__qualname__": testCaseClass.__qualname__},
        )
        return super().loadTestsFromTestCase(own)


def _suites(tests: Any) -> Iterator[unittest.TestSuite]:
    if isinstance(tests, unittest.TestSuite):
        yield tests
        for test in tests:
            yield from _suites(test)
