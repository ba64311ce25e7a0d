"""A waitable whose clients, services and subscriptions wait in the executor's queue themselves."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy.waitable import Waitable

if TYPE_CHECKING:
    from rclpy._wait_set import WaitSet


class PartsWait(Waitable):
    """The base of action clients and servers: an executor that waits for one has nothing to do."""

    def is_ready(self, wait_set: WaitSet) -> bool:
        """Always False: its parts become ready themselves."""
        return False

    def take_data(self) -> dict[str, Any]:
        """An empty dict: its parts take their own data."""
        return {}

    async def execute(self, taken_data: Any) -> None:
        """Do nothing."""

    def add_to_wait_set(self, wait_set: WaitSet) -> None:
        """Do nothing: its parts are in the executor's queue."""
