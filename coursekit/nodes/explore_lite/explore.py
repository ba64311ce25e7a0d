"""`ros2 run explore_lite explore`: sends nav2 to the map's frontiers, one after the other, until there are none."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from action_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped
from nav2_msgs.action import NavigateToPose
from rclpy.action import ActionClient
from rclpy.node import Node
from std_msgs.msg import Bool
from tf2_ros import TransformException
from visualization_msgs.msg import MarkerArray

from coursekit.geometry.plane import Pose2D
from coursekit.nav.frontiers import Frontier, frontiers
from coursekit.nodes.explore_lite.costmap import CostmapClient
from coursekit.nodes.explore_lite.markers import markers
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.nav2.transform_lookup import TransformLookup, stamped
from coursekit.nodes.running import run

if TYPE_CHECKING:
    from rclpy.task import Future

_DEFAULTS: dict[str, Any] = {
    "planner_frequency": 1.0, "progress_timeout": 30.0, "visualize": False, "potential_scale": 1e-3,
    "orientation_scale": 0.0, "gain_scale": 1.0, "min_frontier_size": 0.5, "return_to_init": False,
    "robot_base_frame": "base_link", "costmap_topic": "costmap", "costmap_updates_topic": "costmap_updates",
    "transform_tolerance": 0.3,
}  # fmt: skip
_NEAR_CELLS = 5
"""The distance in cells within which a goal is abandoned along with an already abandoned one."""


class Explore(Node):
    """Repeatedly chooses the cheapest frontier; abandons one without progress.

    ValueError for an invalid parameter.
    """

    def __init__(self) -> None:
        super().__init__("explore_node")
        self._given = given = declare(self, _DEFAULTS)
        if not given["planner_frequency"] > 0:
            raise ValueError(f"planner_frequency is {given['planner_frequency']}: give Hz, for example 0.25")
        self._where = TransformLookup(self, given["robot_base_frame"])
        self._costmap = CostmapClient(self, given["costmap_topic"], given["costmap_updates_topic"])
        self._navigator = ActionClient(self, NavigateToPose, "navigate_to_pose")
        self._goal: tuple[float, float] | None = None
        self._errand: Any = None
        self._given_up: list[tuple[float, float]] = []
        self._distance, self._progress_ns, self._shown = 0.0, 0, 0
        self._home: Pose2D | None = None
        self._connected = False
        if given["visualize"]:
            self._markers = self.create_publisher(MarkerArray, "explore/frontiers", 10)
        self.create_subscription(Bool, "explore/resume", self._resume, 10)
        self.get_logger().info("Waiting to connect to move_base nav2 server")
        self._timer = self.create_timer(1.0 / given["planner_frequency"], self._plan)

    # -- planning

    def _pose(self) -> Pose2D | None:
        """Return the robot's pose; None while map, transform or navigation are unavailable."""
        if self._costmap.grid is None or not self._navigator.server_is_ready():
            return None
        try:
            here = self._where.robot(self._costmap.frame)
        except TransformException as fault:
            self.get_logger().warning(f"Where the robot is, is not known: {fault}", throttle_duration_sec=5.0)
            return None
        if not self._connected:
            self._connected, self._home = True, here
            self.get_logger().info("Connected to move_base nav2 server")
        return here

    def _plan(self) -> None:
        here = self._pose()
        if here is None or self._costmap.grid is None:
            return
        scales = self._given["min_frontier_size"], self._given["potential_scale"], self._given["gain_scale"]
        try:
            candidates = frontiers(self._costmap.grid, (here.x, here.y), *scales)
        except ValueError as fault:
            self.get_logger().error(str(fault))
            candidates = []
        self._show(candidates)
        if not candidates:
            self._stop("No frontiers found, stopping.")
            return
        self._pursue(candidates)

    def _pursue(self, candidates: list[Frontier]) -> None:
        """Continue to the best frontier that was not abandoned."""
        best = next((frontier for frontier in candidates if not self._lost(frontier.centroid)), None)
        if best is None:
            self._stop("All frontiers traversed/tried out, stopping.")
            return
        now, same = self.get_clock().now().nanoseconds, best.centroid == self._goal
        if not same or best.distance < self._distance:
            self._progress_ns, self._distance = now, best.distance
        elif now - self._progress_ns > self._given["progress_timeout"] * 1e9:
            self._give_up(best.centroid)
            self._pursue(candidates)
            return
        if not same:
            self._goal = best.centroid
            self._send(Pose2D(*best.centroid, 0.0), best.centroid)

    def _lost(self, goal: tuple[float, float]) -> bool:
        assert self._costmap.grid is not None
        near = _NEAR_CELLS * self._costmap.grid.resolution
        return any(abs(goal[0] - x) < near and abs(goal[1] - y) < near for x, y in self._given_up)

    def _give_up(self, goal: tuple[float, float]) -> None:
        self._given_up.append(goal)
        self.get_logger().debug("Adding current goal to black list")

    def _show(self, candidates: list[Frontier]) -> None:
        if not self._given["visualize"]:
            return
        stamp, lost = self.get_clock().now().to_msg(), [self._lost(frontier.centroid) for frontier in candidates]
        self._markers.publish(markers(candidates, lost, self._costmap.frame, stamp, self._shown))
        self._shown = 2 * len(candidates)

    # -- driving

    def _send(self, pose: Pose2D, goal: tuple[float, float] | None) -> None:
        there: PoseStamped = stamped(pose, self._costmap.frame, self.get_clock().now().to_msg())
        asked = self._navigator.send_goal_async(NavigateToPose.Goal(pose=there))
        asked.add_done_callback(partial(self._answered, goal))

    def _answered(self, goal: tuple[float, float] | None, future: Future) -> None:
        handle = future.result()
        if handle is None or not handle.accepted:
            self.get_logger().warning("Goal was rejected", throttle_duration_sec=5.0)
            self._goal = None if goal == self._goal else self._goal
            return
        self._errand = handle
        if goal is not None:
            handle.get_result_async().add_done_callback(partial(self._ended, goal))

    def _ended(self, goal: tuple[float, float], future: Future) -> None:
        """Abandon a goal that nav2 aborted; a goal replaced by a newer one is not abandoned."""
        if self._goal != goal or future.result() is None:
            return
        if future.result().status == GoalStatus.STATUS_ABORTED:
            self._give_up(goal)
        elif future.result().status == GoalStatus.STATUS_SUCCEEDED and not self._timer.is_canceled():
            self._plan()

    def _stop(self, why: str = "") -> None:
        """Stop driving; return to the start if configured and everything is explored."""
        log = self.get_logger()
        if why:
            log.warning(why)
        log.info("Exploration stopped.")
        self._timer.cancel()
        self._goal = None
        if self._errand is not None:
            self._errand.cancel_goal_async()
        if why and self._given["return_to_init"] and self._home is not None:
            log.info("Returning to initial pose.")
            self._send(self._home, None)

    def _resume(self, msg: Bool) -> None:
        if not msg.data:
            self._stop()
            return
        self.get_logger().info("Exploration resuming.")
        self._timer.reset()
        self._plan()


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(Explore, args, refuses=(ValueError,))
