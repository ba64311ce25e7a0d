"""Guard conditions: flags that a program triggers to run a callback in the executor."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rclpy._rclpy_pybind11 import GuardCondition as _Handle

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.context import Context


class GuardCondition:
    """A guard condition, created by `Node.create_guard_condition`."""

    def __init__(
        self, callback: Callable[[], Any] | None, callback_group: CallbackGroup | None, context: Context | None = None
    ) -> None:
        self._handle = _Handle()
        self.callback = callback
        self.callback_group = callback_group
        self._executor_event = False

    def trigger(self) -> None:
        """Run the callback in the executor."""
        self._handle.trigger_guard_condition()

    @property
    def handle(self) -> _Handle:
        """The guard condition's handle."""
        return self._handle

    def destroy(self) -> None:
        """Use `Node.destroy_guard_condition` instead."""
        self._handle.destroy_when_not_in_use()

    def _sources(self) -> list[Any]:
        return [self._handle.core]

    def _take(self) -> Any:
        return self.callback if self._handle.core.take() else None
