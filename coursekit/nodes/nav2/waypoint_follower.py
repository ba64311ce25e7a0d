"""`ros2 run nav2_waypoint_follower waypoint_follower`: goes to one pose after the other."""

from __future__ import annotations

from typing import Any

from nav2_msgs.action import FollowWaypoints, NavigateToPose
from rclpy.lifecycle import LifecycleState, TransitionCallbackReturn

from coursekit.nodes.nav2.errands import Errand
from coursekit.nodes.nav2.parameters import declare, no_such_plugin
from coursekit.nodes.nav2.running import Server, pause, run

_SERVER: dict[str, Any] = {
    "stop_on_failure": True,
    "loop_rate": 20,
    "waypoint_task_executor_plugin": "wait_at_waypoint",
}
_WAIT: dict[str, Any] = {"plugin": "nav2_waypoint_follower::WaitAtWaypoint", "enabled": True, "waypoint_pause_duration": 0}

_KINDS, _BASE = ("nav2_waypoint_follower::WaitAtWaypoint",), "nav2_core::WaypointTaskExecutor"


class WaypointFollower(Server):
    """Serves the action follow_waypoints."""

    def __init__(self) -> None:
        super().__init__("waypoint_follower")
        declare(self, _SERVER)

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Create the action server; return FAILURE for an invalid parameter."""
        self.get_logger().info("Configuring")
        try:
            self._given = declare(self, _SERVER)
            wait = declare(self, _WAIT, self._given["waypoint_task_executor_plugin"])
            if wait["plugin"] not in _KINDS:
                name = self._given["waypoint_task_executor_plugin"]
                raise ValueError(no_such_plugin("waypoint task executor", name, wait["plugin"], _BASE, _KINDS))
        except ValueError as fault:
            self.get_logger().error(str(fault))
            return TransitionCallbackReturn.FAILURE
        self._pause = wait["waypoint_pause_duration"] * 1e-3 if wait["enabled"] else 0.0
        self._go = Errand(self, NavigateToPose, "navigate_to_pose")
        self._action = self.serve(FollowWaypoints, "follow_waypoints", self._follow)
        return super().on_configure(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Destroy the client and the action server."""
        self._go.destroy()
        return super().on_cleanup(state)

    async def _follow(self, handle: Any) -> Any:
        """Go to all poses and report missed ones; with `stop_on_failure`, the first missed pose aborts the goal."""
        result, log = FollowWaypoints.Result(), self.get_logger()
        poses, missed = handle.request.poses, []
        log.info(f"Received follow waypoint request with {len(poses)} waypoints.")

        def stop() -> bool:
            return bool(handle.is_cancel_requested or self._action.replaced(handle))

        for number, pose in enumerate(poses):
            handle.publish_feedback(FollowWaypoints.Feedback(current_waypoint=number))
            good = await self._go.do(NavigateToPose.Goal(pose=pose), stop)
            if stop():
                handle.canceled() if handle.is_cancel_requested else handle.abort()
                return result
            if good:
                log.info(f"Succeeded processing waypoint {number}, moving to next.")
                if self._pause > 0:
                    await pause(self, self._pause)
                continue
            missed.append(number)
            log.warning(
                f"Failed to process waypoint {number}" + (", moving to next." if not self._given["stop_on_failure"] else "")
            )
            if self._given["stop_on_failure"]:
                result.missed_waypoints = missed
                handle.abort()
                return result
        log.info(f"Completed all {len(poses)} waypoints requested.")
        result.missed_waypoints = missed
        handle.succeed()
        return result


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(WaypointFollower, args)
