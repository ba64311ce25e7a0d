"""QoS events: counters that change on a missed deadline, an expired lease, or incompatible QoS of two endpoints."""

from __future__ import annotations

from typing import Any

from .ready_queue import Source

DEADLINE, LIVELINESS, INCOMPATIBLE, MESSAGE_LOST, MATCHED = "deadline", "liveliness", "incompatible", "lost", "matched"


class Status(Source):
    """One event of one endpoint: totals, and the changes since the last `take`."""

    __slots__ = ("change", "changed", "last_policy", "not_alive", "not_alive_change", "total")

    def __init__(self) -> None:
        super().__init__()
        self.total = 0
        self.change = 0
        self.not_alive = 0
        self.not_alive_change = 0
        self.last_policy = 1
        self.changed = False

    def has_work(self) -> bool:
        """Whether there is a change to take."""
        return self.changed

    def add(self, total: int = 1, not_alive: int = 0, policy: int | None = None) -> None:
        """Count an event."""
        self.total += total
        self.change += total
        self.not_alive += not_alive
        self.not_alive_change += not_alive
        if policy is not None:
            self.last_policy = policy
        self.changed = True
        self.signal()
        if self.listener is not None:
            self.listener(total)

    def take(self) -> dict[str, Any]:
        """Return the counters and reset the changes to zero.

        >>> status = Status()
        >>> status.add(); status.add()
        >>> [(taken["total"], taken["change"]) for taken in (status.take(), status.take())]
        [(2, 2), (2, 0)]
        """
        taken = {
            "total": self.total,
            "change": self.change,
            "not_alive": self.not_alive,
            "not_alive_change": self.not_alive_change,
            "last_policy": self.last_policy,
        }
        self.change = self.not_alive_change = 0
        self.changed = False
        return taken
