"""`ros2 run nav2_smoother smoother_server`: smooths paths without bringing them closer to obstacles."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from nav2_msgs.action import SmoothPath
from nav2_msgs.msg import Costmap as CostmapMessage
from nav_msgs.msg import Path
from rclpy.lifecycle import LifecycleState, TransitionCallbackReturn

from coursekit.nav.costmap import INSCRIBED, UNKNOWN, Costmap
from coursekit.nav.planner import smoothed
from coursekit.nodes.nav2.map_message import MAP_QOS
from coursekit.nodes.nav2.parameters import Obedience, declare, no_such_plugin
from coursekit.nodes.nav2.running import Beat, Server, run
from coursekit.nodes.nav2.whereabouts import path_message
from coursekit.nodes.scanning.planar import plane

if TYPE_CHECKING:
    from collections.abc import Sequence

    from geometry_msgs.msg import PoseStamped
    from rclpy.action.goal_handle import ServerGoalHandle

_SERVER: dict[str, Any] = {
    "costmap_topic": "global_costmap/costmap_raw",
    "footprint_topic": "global_costmap/published_footprint",
    "robot_base_frame": "base_link",
    "transform_tolerance": 0.1,
    "smoother_plugins": ["simple_smoother"],
}
PATIENCE = 30
"""The maximum time that a goal waits for the first costmap, in tenths of a second."""
_PLUGIN: dict[str, Any] = {
    "plugin": "nav2_smoother::SimpleSmoother",
    "tolerance": 1e-10,
    "max_its": 1000,
    "do_refinement": True,
}


_KINDS = (
    "nav2_smoother::SimpleSmoother", "nav2_smoother::SavitzkyGolaySmoother", "nav2_constrained_smoother/ConstrainedSmoother",
)  # fmt: skip


class SmootherServer(Server):
    """Serves the action smooth_path."""

    def __init__(self) -> None:
        super().__init__("smoother_server")
        declare(self, _SERVER)

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Create the action server; return FAILURE for an invalid parameter."""
        self.get_logger().info("Configuring smoother server")
        try:
            given = declare(self, _SERVER)
            self._make_plugins()
        except ValueError as fault:
            self.get_logger().error(str(fault))
            return TransitionCallbackReturn.FAILURE
        self._obedience = Obedience(self, self._make_plugins)
        self._costs: Costmap | None = None
        self._heard = self.create_subscription(CostmapMessage, given["costmap_topic"], self._take, MAP_QOS)
        self._plan_out = self.create_lifecycle_publisher(Path, "plan_smoothed", 1)
        self.serve(SmoothPath, "smooth_path", self._smooth)
        return super().on_configure(state)

    def _make_plugins(self) -> None:
        """Read the parameters; raises ValueError if they are invalid."""
        rounds = {}
        for name in declare(self, _SERVER)["smoother_plugins"]:
            given = declare(self, _PLUGIN, name)
            if given["plugin"] not in _KINDS:
                raise ValueError(no_such_plugin("smoother", given["plugin"], "nav2_core::Smoother", _KINDS))
            rounds[name] = given["max_its"]
        self._rounds = rounds

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Destroy the subscription, the publisher and the action server."""
        self._obedience.end()
        self.destroy_subscription(self._heard)
        self.destroy_lifecycle_publisher(self._plan_out)
        return super().on_cleanup(state)

    def _take(self, msg: CostmapMessage) -> None:
        meta = msg.metadata
        cells = np.array(msg.data, dtype=np.uint8).reshape(meta.size_y, meta.size_x)
        self._costs = Costmap(cells, float(f"{meta.resolution:.6g}"), meta.origin.position.x, meta.origin.position.y)

    async def _smooth(self, handle: ServerGoalHandle) -> Any:
        request, result, begin = handle.request, SmoothPath.Result(), self.get_clock().now()
        beat = Beat(self, 0.1)
        for _ in range(PATIENCE):
            if self._costs is None:
                await beat.next()
        beat.stop()
        name = request.smoother_id or next(iter(self._rounds))
        if name not in self._rounds or not request.path.poses or self._costs is None:
            self.get_logger().error(self._fault(name, request.path.poses))
            handle.abort()
            return result
        poses = np.array([plane(pose.pose.position, pose.pose.orientation) for pose in request.path.poses], dtype=float)
        poses = smoothed(self._costs, poses, self._rounds[name])
        result.path = path_message(poses, request.path.header.frame_id, request.path.header.stamp)
        result.was_completed, result.smoothing_duration = True, (self.get_clock().now() - begin).to_msg()
        if request.check_for_collisions and self._touches(poses):
            self.get_logger().error("Smoothed path leads to a collision")
            handle.abort()
            return result
        self._plan_out.publish(result.path)
        handle.succeed()
        return result

    def _fault(self, name: str, poses: Sequence[PoseStamped]) -> str:
        if name not in self._rounds:
            return f"SmoothPath called with smoother name {name}, which does not exist. Known: {', '.join(self._rounds)}"
        return "Smoother: the path is empty" if not poses else "Smoother: no costmap has been heard yet"

    def _touches(self, poses: np.ndarray) -> bool:
        assert self._costs is not None
        return any(INSCRIBED <= self._costs.cost(x, y) < UNKNOWN for x, y, _ in poses.tolist())


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(SmootherServer, args)
