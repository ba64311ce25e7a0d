"""Checks of the set-up and of the graph, and their results."""

from __future__ import annotations

from typing import Any

from coursekit.cli import checks, graph_report


class Result:
    """The number of errors and warnings of a check."""

    __slots__ = ("error", "warning")

    def __init__(self) -> None:
        self.error = 0
        self.warning = 0

    def add_error(self) -> None:
        """Count an error."""
        self.error += 1

    def add_warning(self) -> None:
        """Count a warning."""
        self.warning += 1


class Report:
    """A table: its name and (key, value) pairs.

    >>> report = Report("DISTRIBUTION")
    >>> report.add_to_report("name", "humble")
    >>> report.items
    [('name', 'humble')]
    """

    __slots__ = ("items", "name")

    def __init__(self, name: str) -> None:
        self.name = name
        self.items: list[tuple[str, Any]] = []

    def add_to_report(self, item_name: str, item_info: Any) -> None:
        """Add a line."""
        self.items.append((item_name, item_info))


class DoctorCheck:
    """The base class of checks that packages add."""

    def category(self) -> str:
        """The name of the check."""
        raise NotImplementedError()

    def check(self) -> Result:
        """Run the check."""
        raise NotImplementedError()


class DoctorReport:
    """The base class of reports that packages add."""

    def category(self) -> str:
        """The name of the report."""
        raise NotImplementedError()

    def report(self) -> Report:
        """Make the table."""
        raise NotImplementedError()


def run_checks(*, include_warnings: bool = False) -> tuple[set[str], int, int]:
    """The names of the failed checks, the number of failed checks, and the number of all checks."""
    results = [*checks.run_all(), graph_report.compatibility(), graph_report.both_ends()]
    bad = {result.name for result in results if result.fault and (include_warnings or not result.only_warning)}
    return bad, len(bad), len(results)


def generate_reports(*, categories: Any = None) -> list[Report]:
    """The tables of `ros2 doctor --report`: all, or those of `categories`."""
    reports = []
    for title, lines in (*checks.report(), *graph_report.report()):
        report = Report(title)
        for key, value in lines:
            report.add_to_report(key, value)
        if categories is None or title in categories:
            reports.append(report)
    return reports
