"""Send goals to other servers, and call services, from a coroutine."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from action_msgs.msg import GoalStatus
from rclpy.action import ActionClient

from coursekit.nodes.nav2.running import AsyncRate

if TYPE_CHECKING:
    from rclpy.client import Client
    from rclpy.node import Node


class ActionCaller:
    """An action client for one goal after another."""

    def __init__(self, node: Node, kind: type[Any], name: str) -> None:
        self.node, self.name = node, name
        self.client = ActionClient(node, kind, name)
        self._handle: Any = None
        self._result: Any = None

    def destroy(self) -> None:
        """Destroy the client."""
        self.client.destroy()

    async def begin(self, goal: object) -> bool:
        """Send a goal. Returns whether it was accepted."""
        self._result = None
        if not self.client.server_is_ready():
            self.node.get_logger().error(f'"{self.name}" action server not available: is its node running and active?')
            return False
        handle = await self.client.send_goal_async(goal)
        if not handle.accepted:
            self.node.get_logger().error(f'Goal was rejected by the action server "{self.name}"')
            return False
        self._handle, self._result = handle, handle.get_result_async()
        return True

    @property
    def ended(self) -> bool:
        """Whether the last goal has ended, or was rejected."""
        return self._result is None or self._result.done()

    @property
    def succeeded(self) -> bool:
        """Whether the last goal succeeded."""
        done = self._result is not None and self._result.done()
        return bool(done and self._result.result().status == GoalStatus.STATUS_SUCCEEDED)

    @property
    def result(self) -> Any:
        """Return the last goal's result, once it has ended."""
        return self._result.result().result

    async def cancel(self) -> None:
        """Cancel the current goal, if there is one, and wait until it has ended."""
        if not self.ended:
            await self._handle.cancel_goal_async()
            await self._result

    async def do(self, goal: object, stop: Callable[[], bool] = lambda: False) -> bool:
        """Send a goal and wait until it ends. Returns whether it succeeded. It is cancelled when `stop()` is true."""
        if not await self.begin(goal):
            return False
        rate = AsyncRate(self.node, 0.05)
        try:
            while not self.ended:
                if stop():
                    await self.cancel()
                    return False
                await rate.sleep()
        finally:
            rate.destroy()
        return self.succeeded


async def call(node: Node, client: Client, request: object = None) -> Any:
    """Return a service's response, or None if the service is not available."""
    if not client.service_is_ready():
        node.get_logger().warning(f"{client.srv_name} is not available")
        return None
    return await client.call_async(request or client.srv_type.Request())
