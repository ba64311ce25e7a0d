"""The execution of nav2's servers: nodes in one executor, and actions that work on one goal at a time."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import TYPE_CHECKING, Any

import rclpy
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.lifecycle import LifecycleNode, LifecycleState, TransitionCallbackReturn
from rclpy.task import Future

from coursekit.nodes.nav2.cpp_plugins import PluginsOwner
from coursekit.nodes.running import spin_to_the_end

if TYPE_CHECKING:
    from rclpy.action.goal_handle import ServerGoalHandle
    from rclpy.node import Node


def run(make: Callable[[], LifecycleNode], args: list[str] | None = None) -> int:
    """Run a node, and its `costmap` if it has one, until Ctrl-C."""
    rclpy.init(args=args)
    node = make()
    return spin_to_the_end(node, *([node.costmap] if hasattr(node, "costmap") else []))


class AsyncRate:
    """rclpy's Rate for coroutines, on the node's clock: `await rate.sleep()`, and `destroy()` in the end."""

    def __init__(self, node: Node, period: float) -> None:
        self._node, self._waiting = node, Future()
        self._timer = node.create_timer(period, self._tick)

    def _tick(self) -> None:
        waiting, self._waiting = self._waiting, Future()
        waiting.set_result(None)

    async def sleep(self) -> None:
        """Wait for the next tick."""
        await self._waiting

    def destroy(self) -> None:
        """Destroy the timer."""
        self._node.destroy_timer(self._timer)


async def pause(node: Node, seconds: float) -> None:
    """Sleep on the node's clock."""
    rate = AsyncRate(node, seconds)
    try:
        await rate.sleep()
    finally:
        rate.destroy()


class SingleGoal:
    """An action server that works on one goal at a time: a new goal replaces the old one.

    `work(handle)` is a coroutine that calls succeed, abort or canceled and returns the action's result. It polls
    `replaced(handle)` and ends when that is true.
    """

    def __init__(self, node: Node, kind: type[Any], name: str, work: Callable[[Any], Awaitable[Any]]) -> None:
        self.node, self.active, self._work = node, False, work
        self.current: Any = None
        self.fresh = True
        """Whether the server was idle when the current goal arrived."""
        self.server = ActionServer(
            node, kind, name, self._run, goal_callback=self._asked, cancel_callback=lambda handle: CancelResponse.ACCEPT
        )  # fmt: skip

    def _asked(self, _goal: object) -> GoalResponse:
        if not self.active:
            self.node.get_logger().error(
                "Action server is inactive. Rejecting the goal. "
                f"Activate it: ros2 lifecycle set {self.node.get_name()} activate"
            )
        return GoalResponse.ACCEPT if self.active else GoalResponse.REJECT

    async def _run(self, handle: ServerGoalHandle) -> Any:
        self.fresh, self.current = self.current is None, handle
        result = await self._work(handle)
        if self.current is handle:
            self.current = None
        return result

    def replaced(self, handle: ServerGoalHandle) -> bool:
        """Whether a newer goal has arrived, or the server has been deactivated."""
        return self.current is not handle or not self.active

    def wake(self) -> None:
        """Accept goals."""
        self.active = True

    def sleep(self) -> None:
        """Reject goals; the current goal ends."""
        self.active = False

    def destroy(self) -> None:
        """Destroy the action server."""
        self.server.destroy()


class Server(PluginsOwner):
    """A managed node with actions, which exist from configuration to cleanup and accept goals while the node is active."""

    def __init__(self, name: str, **options: Any) -> None:
        super().__init__(name, **options)
        self.get_logger().info("Creating")
        self.actions: list[SingleGoal] = []

    def number(self, name: str) -> float:
        """A parameter as a real number; raises ValueError if it is not a number."""
        value = self.get_parameter(name).value
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise ValueError(f"{self.get_name()}: {name} should be a number, not {value!r}")
        return float(value)

    def text(self, name: str) -> str:
        """A parameter as text."""
        return str(self.get_parameter(name).value)

    def serve(self, kind: type[Any], name: str, work: Callable[[Any], Awaitable[Any]]) -> SingleGoal:
        """Create an action server."""
        self.actions.append(SingleGoal(self, kind, name, work))
        return self.actions[-1]

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Activate the parts, and accept goals."""
        self.get_logger().info("Activating")
        if not self.activate_parts():
            return TransitionCallbackReturn.FAILURE
        for action in self.actions:
            action.wake()
        return super().on_activate(state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Reject goals, and deactivate the parts."""
        self.get_logger().info("Deactivating")
        for action in self.actions:
            action.sleep()
        self.deactivate_parts()
        return super().on_deactivate(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Destroy the action servers and the parts."""
        self.get_logger().info("Cleaning up")
        for action in self.actions:
            action.destroy()
        self.actions.clear()
        self.clean_parts()
        return super().on_cleanup(state)

    # -- what a server has besides its actions: a costmap, plugins

    def activate_parts(self) -> bool:
        """Activate the costmap and the plugins; return whether it succeeded."""
        return True

    def deactivate_parts(self) -> None:
        """Deactivate the plugins and the costmap."""

    def clean_parts(self) -> None:
        """Destroy what configuring created."""
