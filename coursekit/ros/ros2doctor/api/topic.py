"""The topics of the graph: the numbers of their publishers and subscriptions."""

from __future__ import annotations

from coursekit.cli import graph_report
from ros2doctor.api import DoctorCheck, DoctorReport, Report, Result


class TopicCheck(DoctorCheck):
    """Warns of topics with more publishers than subscriptions, or fewer."""

    def category(self) -> str:
        """The name of the check."""
        return "topic"

    def check(self) -> Result:
        """Count a warning for each of these topics."""
        result = Result()
        for _ in graph_report.both_ends().fault.splitlines():
            result.add_warning()
        return result


class TopicReport(DoctorReport):
    """The topics, with the number of their publishers and subscriptions."""

    def category(self) -> str:
        """The name of the report."""
        return "topic"

    def report(self) -> Report:
        """Make the table."""
        report = Report("TOPIC LIST")
        for key, value in graph_report.counts():
            report.add_to_report(key, value)
        return report
