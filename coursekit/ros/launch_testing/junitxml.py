"""Results as JUnit XML, which colcon and build servers read."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any
from xml.etree.ElementTree import Element, ElementTree, SubElement

_OUTCOMES = {"failure": "failures", "error": "errors", "skipped": "skipped"}


def unittestResultsToXml(*, name: str = "launch_test", test_results: Mapping[Any, Any] = {}) -> ElementTree:
    """Return the results of runs, by run, as one document."""
    root = Element("testsuites", name=name)
    results = test_results.values()
    root.set("tests", str(sum(result.testsRun for result in results)))
    root.set("failures", str(sum(len(result.failures) for result in results)))
    root.set("errors", str(sum(len(result.errors) for result in results)))
    root.extend(unittestResultToXml(str(run), result) for run, result in test_results.items())
    return ElementTree(root)


def unittestResultToXml(name: str, test_result: Any) -> Element:
    """Return the result of one run."""
    suite = Element("testsuite", name=name, tests=str(test_result.testsRun))
    for key in _OUTCOMES.values():
        suite.set(key, str(len(getattr(test_result, key))))
    suite.set("time", str(round(sum(test_result.testTimes.values()), 3)))
    suite.extend(unittestCaseToXml(test_result, case) for case in test_result.testCases)
    return suite


def unittestCaseToXml(test_result: Any, test_case: Any) -> Element:
    """Return the result of one test."""
    kind = type(test_case)
    element = Element("testcase", classname=f"{kind.__module__}.{kind.__name__}", name=test_case._testMethodName)
    element.set("time", str(round(test_result.testTimes[test_case], 3)))
    for tag, key in _OUTCOMES.items():
        for case, text in getattr(test_result, key):
            if case == test_case:
                SubElement(element, tag, message=text)
    return element
