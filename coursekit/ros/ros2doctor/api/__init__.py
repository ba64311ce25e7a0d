"""Checks of the set-up and of the graph, and what they found."""

from __future__ import annotations

from typing import Any

from coursekit.cli import checks, graph_report


class Result:
    """How many errors and warnings a check found."""

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
    """The base of checks that packages add."""

    def category(self) -> str:
        """The name of the check."""
        raise NotImplementedError()

    def check(self) -> Result:
        """Look."""
        raise NotImplementedError()


class DoctorReport:
    """The base of reports that packages add."""

    def category(self) -> str:
        """The name of the report."""
        raise NotImplementedError()

    def report(self) -> Report:
        """Make the table."""
        raise NotImplementedError()


def run_checks(*, include_warnings: bool = False) -> tuple[set[str], int, int]:
    """The names of the checks that failed, how many those are, and how many checks there are."""
    results = [*checks.run_all(), graph_report.compatibility(), graph_report.both_ends()]
    bad = {one.name for one in results if one.fault and (include_warnings or not one.only_warning)}
    return bad, len(bad), len(results)


def generate_reports(*, categories: Any = None) -> list[Report]:
    """The tables of `ros2 doctor --report`, all or those named."""
    made = []
    for title, lines in (*checks.report(), *graph_report.report()):
        report = Report(title)
        for key, value in lines:
            report.add_to_report(key, value)
        if categories is None or title in categories:
            made.append(report)
    return made
