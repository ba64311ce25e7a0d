"""One-off timers: recreated each time, or reused."""

from __future__ import annotations

from typing import Any

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run


class OneOffTimer(CppNode):
    """Every third callback of its periodic timer starts a timer that fires once, a second later."""

    def __init__(self, name: str = "one_off_timer") -> None:
        super().__init__(name)
        self._count = 0
        self._one_off: Any = None
        self._periodic = self.create_timer(2.0, self._rang)

    def _rang(self) -> None:
        log = self.get_logger()
        log.info("in periodic_timer callback")
        if self._count % 3 == 0:
            log.info("  resetting one off timer")
            self.begin()
        else:
            log.info("  not resetting one off timer")
        self._count += 1

    def begin(self) -> None:
        """Create the one-off timer."""
        if self._one_off is not None:
            self.destroy_timer(self._one_off)
        self._one_off = self.create_timer(1.0, self.rang_once)

    def rang_once(self) -> None:
        """Log the callback, and cancel the timer."""
        self.get_logger().info("in one_off_timer callback")
        self._one_off.cancel()


class ReuseTimer(OneOffTimer):
    """The same with one timer that is reset."""

    def __init__(self) -> None:
        super().__init__("reuse_timer")
        self._one_off = self.create_timer(1.0, self.rang_once)
        self._one_off.cancel()

    def begin(self) -> None:
        """Reset the timer."""
        self._one_off.reset()


def one_off(args: list[str] | None = None) -> int:
    """Run the recreated timer."""
    return run(OneOffTimer, args)


def reuse(args: list[str] | None = None) -> int:
    """Run the reused timer."""
    return run(ReuseTimer, args)
