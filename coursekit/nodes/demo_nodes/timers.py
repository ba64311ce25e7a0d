"""One-off timers: made anew each time, or one that is used again."""

from __future__ import annotations

from typing import Any

from rclpy.node import Node

from coursekit.nodes.running import run


class OneOffTimer(Node):
    """Every third time that its periodic timer rings, a timer begins that rings once, a second later."""

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
        """Make the timer that rings once."""
        if self._one_off is not None:
            self.destroy_timer(self._one_off)
        self._one_off = self.create_timer(1.0, self.rang_once)

    def rang_once(self) -> None:
        """Tell, and ring no more."""
        self.get_logger().info("in one_off_timer callback")
        self._one_off.cancel()


class ReuseTimer(OneOffTimer):
    """The same with one timer, which is reset."""

    def __init__(self) -> None:
        super().__init__("reuse_timer")
        self._one_off = self.create_timer(1.0, self.rang_once)
        self._one_off.cancel()

    def begin(self) -> None:
        """Let the timer ring once more."""
        self._one_off.reset()


def one_off(args: list[str] | None = None) -> int:
    """A timer made anew each time."""
    return run(OneOffTimer, args)


def reuse(args: list[str] | None = None) -> int:
    """A timer used again."""
    return run(ReuseTimer, args)
