"""Diagnostics of topics: frequency and stamps."""

from __future__ import annotations

from typing import Any

from rclpy.time import Time

from ._diagnostic_updater import CompositeDiagnosticTask, Updater
from ._update_functions import FrequencyStatus, FrequencyStatusParam, TimeStampStatus, TimeStampStatusParam


class HeaderlessTopicDiagnostic(CompositeDiagnosticTask):
    """Monitors the frequency of a topic; call `tick` for each message."""

    def __init__(self, name: str, diag: Updater, freq: FrequencyStatusParam) -> None:
        super().__init__(f"{name} topic status")
        self.diag = diag
        self.freq = FrequencyStatus(freq, clock=diag.node.get_clock())
        self.addTask(self.freq)
        self.diag.add(self)

    def tick(self) -> None:
        """Record a published message."""
        self.freq.tick()

    def clear_window(self) -> None:
        """Discard the recorded events."""
        self.freq.clear()


class TopicDiagnostic(HeaderlessTopicDiagnostic):
    """Monitors the frequency of a topic and the age of its stamps."""

    def __init__(self, name: str, diag: Updater, freq: FrequencyStatusParam, stamp: TimeStampStatusParam) -> None:
        super().__init__(name, diag, freq)
        self.stamp = TimeStampStatus(stamp, clock=diag.node.get_clock())
        self.addTask(self.stamp)

    def tick(self, stamp: Any) -> None:  # type: ignore[override]
        """Record a published message with its stamp."""
        self.stamp.tick(stamp)
        super().tick()


class DiagnosedPublisher(TopicDiagnostic):
    """A publisher of messages with headers, with diagnostics."""

    def __init__(self, pub: Any, diag: Updater, freq: FrequencyStatusParam, stamp: TimeStampStatusParam) -> None:
        super().__init__(pub.topic_name, diag, freq, stamp)
        self.pub = pub

    def publish(self, message: Any) -> None:
        """Record and publish a message."""
        self.tick(Time.from_msg(message.header.stamp))
        self.pub.publish(message)
