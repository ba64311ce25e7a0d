"""`ros2 run nav2_waypoint_follower waypoint_follower`: goes to one pose after the other."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from nav2_msgs.action import FollowWaypoints, NavigateToPose
from rclpy.lifecycle import LifecycleState, TransitionCallbackReturn

from coursekit.nodes.compiled.classes import CppFault
from coursekit.nodes.nav2.action_caller import ActionCaller
from coursekit.nodes.nav2.cpp_plugins import CppPlugins
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.nav2.running import Server, run
from coursekit.nodes.nav2.waypoint_tasks import task_of

if TYPE_CHECKING:
    from geometry_msgs.msg import PoseStamped
    from rclpy.action.goal_handle import ServerGoalHandle

_SERVER: dict[str, Any] = {
    "stop_on_failure": True,
    "loop_rate": 20,
    "waypoint_task_executor_plugin": "wait_at_waypoint",
}


class WaypointFollower(Server):
    """Serves the action follow_waypoints."""

    def __init__(self) -> None:
        super().__init__("waypoint_follower")
        declare(self, _SERVER)
        self._foreign = CppPlugins(self)

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Create the action server; return FAILURE for an invalid parameter."""
        self.get_logger().info("Configuring")
        try:
            self._given = declare(self, _SERVER)
            self._task = task_of(self, self._given["waypoint_task_executor_plugin"], self._foreign)
        except (ValueError, CppFault) as fault:
            return self._foreign.refused(fault)
        self._go = ActionCaller(self, NavigateToPose, "navigate_to_pose")
        self._action = self.serve(FollowWaypoints, "follow_waypoints", self._follow)
        return super().on_configure(state)

    def clean_parts(self) -> None:
        """Destroy the client, the task and its subscription."""
        self._go.destroy()
        self._foreign.retire()
        if self._task.subscription is not None:
            self.destroy_subscription(self._task.subscription)

    async def _follow(self, handle: ServerGoalHandle) -> Any:
        """Go to all poses and report missed ones; with `stop_on_failure`, the first missed pose aborts the goal."""
        result, log = FollowWaypoints.Result(), self.get_logger()
        poses = handle.request.poses
        missed: list[int] = []
        log.info(f"Received follow waypoint request with {len(poses)} waypoints.")

        def stop() -> bool:
            return bool(handle.is_cancel_requested or self._action.replaced(handle))

        for number, pose in enumerate(poses):
            handle.publish_feedback(FollowWaypoints.Feedback(current_waypoint=number))
            try:
                good = await self._visit(pose, number, missed, stop)
            except CppFault:
                handle.abort()
                return result
            if stop():
                handle.canceled() if handle.is_cancel_requested else handle.abort()
                return result
            if not good and self._given["stop_on_failure"]:
                result.missed_waypoints = missed
                handle.abort()
                return result
        log.info(f"Completed all {len(poses)} waypoints requested.")
        result.missed_waypoints = missed
        handle.succeed()
        return result

    async def _visit(self, pose: PoseStamped, number: int, missed: list[int], stop: Callable[[], bool]) -> bool:
        """Go to a pose and do the task there; return whether both went well. A pose that was not reached is `missed`."""
        log, goes_on = self.get_logger(), not self._given["stop_on_failure"]
        good = await self._go.do(NavigateToPose.Goal(pose=pose), stop)
        if stop():
            return False
        if not good:
            missed.append(number)
            log.warning(f"Failed to process waypoint {number}" + (", moving to next." if goes_on else ""))
            return False
        log.info(f"Succeeded processing waypoint {number}, processing waypoint task execution")
        try:
            done = await self._task.process(pose, number, stop)
        except CppFault as fault:
            what = "Action server failed while executing action callback"
            log.error(f'[follow_waypoints] [ActionServer] {what}: "{fault}"')
            raise
        log.info(f"Task execution at waypoint {number} {'succeeded' if done else 'failed!'}")
        if done or goes_on:
            log.info(f"Handled task execution on waypoint {number}, moving to next.")
        else:
            log.warning(f"Failed to execute task at waypoint {number}  stop on failure is enabled. Terminating action.")
        return done


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(WaypointFollower, args)
