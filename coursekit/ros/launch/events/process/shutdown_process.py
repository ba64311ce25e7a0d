"""The event that ends processes step by step."""

from __future__ import annotations

from .process_targeted_event import ProcessTargetedEvent


class ShutdownProcess(ProcessTargetedEvent):
    """A request to end the process: SIGINT first, then SIGTERM, then SIGKILL."""

    name = "launch.events.process.ShutdownProcess"
