"""A filter's report on /diagnostics."""

from __future__ import annotations

from diagnostic_msgs.msg import DiagnosticStatus
from diagnostic_updater import DiagnosticStatusWrapper, FrequencyStatusParam, HeaderlessTopicDiagnostic, Updater
from rclpy.node import Node

SLACK = 2.0
"""The tolerance of the rate of estimates, in both directions [Hz]."""


class FilterDiagnostics:
    """Reports the rate of estimates, and the problems with messages since the last report."""

    def __init__(self, node: Node, frequency: float) -> None:
        self._complaints: dict[str, str] = {}
        updater = Updater(node)
        updater.setHardwareID("none")
        updater.add("Filter diagnostic updater", self._tell)
        bounds = FrequencyStatusParam({"min": frequency - SLACK, "max": frequency + SLACK}, 0.1, 10)
        self._rhythm = HeaderlessTopicDiagnostic("odometry/filtered", updater, bounds)

    def tick(self) -> None:
        """Record that an estimate was published."""
        self._rhythm.tick()

    def complain(self, about: str, text: str) -> None:
        """Add a problem to the next report."""
        self._complaints[about] = text

    def _tell(self, status: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        fine = "The robot_localization state estimation node appears to be functioning properly."
        status.summary(DiagnosticStatus.OK, fine)
        if self._complaints:
            status.summary(DiagnosticStatus.WARN, "Potentially erroneous data or settings detected for a source.")
        for about, text in self._complaints.items():
            status.add(about, text)
        self._complaints.clear()
        return status
