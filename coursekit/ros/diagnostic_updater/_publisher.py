"""Topics whose frequency and stamps are told."""

from __future__ import annotations

from typing import Any

from rclpy.time import Time

from ._diagnostic_updater import CompositeDiagnosticTask, Updater
from ._update_functions import FrequencyStatus, FrequencyStatusParam, TimeStampStatus, TimeStampStatusParam


class HeaderlessTopicDiagnostic(CompositeDiagnosticTask):
    """How often a topic is published; call `tick` each time."""

    def __init__(self, name: str, diag: Updater, freq: FrequencyStatusParam) -> None:
        super().__init__(f"{name} topic status")
        self.diag = diag
        self.freq = FrequencyStatus(freq, clock=diag.node.get_clock())
        self.addTask(self.freq)
        self.diag.add(self)

    def tick(self) -> None:
        """It was published."""
        self.freq.tick()

    def clear_window(self) -> None:
        """Forget what was."""
        self.freq.clear()


class TopicDiagnostic(HeaderlessTopicDiagnostic):
    """How often a topic is published, and how old its stamps are."""

    def __init__(self, name: str, diag: Updater, freq: FrequencyStatusParam, stamp: TimeStampStatusParam) -> None:
        super().__init__(name, diag, freq)
        self.stamp = TimeStampStatus(stamp, clock=diag.node.get_clock())
        self.addTask(self.stamp)

    def tick(self, stamp: Any) -> None:  # type: ignore[override]
        """It was published with that stamp."""
        self.stamp.tick(stamp)
        super().tick()


class DiagnosedPublisher(TopicDiagnostic):
    """A publisher of messages with headers that is watched."""

    def __init__(self, pub: Any, diag: Updater, freq: FrequencyStatusParam, stamp: TimeStampStatusParam) -> None:
        super().__init__(pub.topic_name, diag, freq, stamp)
        self.pub = pub

    def publish(self, message: Any) -> None:
        """Publish."""
        self.tick(Time.from_msg(message.header.stamp))
        self.pub.publish(message)
