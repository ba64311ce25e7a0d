"""`ros2 run nav2_smoother smoother_server`: smooths paths without bringing them closer to obstacles."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from nav2_msgs.action import SmoothPath
from nav2_msgs.msg import Costmap as CostmapMessage
from nav_msgs.msg import Path
from rclpy.duration import Duration
from rclpy.lifecycle import LifecycleState, TransitionCallbackReturn

from coursekit.nav.costmap import INSCRIBED, UNKNOWN, Costmap
from coursekit.nav.planner import smoothed
from coursekit.nodes.compiled.classes import CppFault
from coursekit.nodes.nav2.cpp_plugins import CppPlugins
from coursekit.nodes.nav2.cpp_smoother import CppSmoother
from coursekit.nodes.nav2.map_message import MAP_QOS
from coursekit.nodes.nav2.parameters import Obedience, declare
from coursekit.nodes.nav2.running import AsyncRate, Server, run
from coursekit.nodes.nav2.transform_lookup import TransformLookup, path_message
from coursekit.nodes.scanning.planar import plane

if TYPE_CHECKING:
    from collections.abc import Sequence

    from builtin_interfaces.msg import Duration as DurationMsg
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
        self._foreign = CppPlugins(self)
        self._smoothers: dict[str, int | CppSmoother] = {}
        """Classes, and for our own the number of its iterations."""

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Create the action server; return FAILURE for an invalid parameter."""
        self.get_logger().info("Configuring smoother server")
        self.where = TransformLookup(self, self.text("robot_base_frame"))
        try:
            given = declare(self, _SERVER)
            self._make_plugins()
        except (ValueError, CppFault) as fault:
            self.where.close()
            return self._foreign.refused(fault)
        self._obedience = Obedience(self, self._make_plugins)
        self._costs: Costmap | None = None
        self._heard = self.create_subscription(CostmapMessage, given["costmap_topic"], self._take, MAP_QOS)
        self._plan_out = self.create_lifecycle_publisher(Path, "plan_smoothed", 1)
        self.serve(SmoothPath, "smooth_path", self._smooth)
        return super().on_configure(state)

    def _make_plugins(self) -> None:
        """Read the parameters; raises ValueError if they are invalid."""
        self._smoothers = {name: self._make(name) for name in declare(self, _SERVER)["smoother_plugins"]}
        self._foreign.log_available("Smoother Server", "smoothers", self._smoothers)

    def _make(self, name: str) -> int | CppSmoother:
        kind = declare(self, {"plugin": _PLUGIN["plugin"]}, name)["plugin"]
        if kind not in _KINDS:
            return self._foreign.get(CppSmoother, name, kind, _KINDS)
        self._foreign.log_created(CppSmoother, name, kind)
        rounds: int = declare(self, _PLUGIN, name)["max_its"]
        return rounds

    def activate_parts(self) -> bool:
        """Activate the smoothers."""
        self._foreign.change("activate")
        return True

    def deactivate_parts(self) -> None:
        """Deactivate the smoothers."""
        self._foreign.change("deactivate")

    def clean_parts(self) -> None:
        """Destroy the smoothers, the subscription and the publisher."""
        self._obedience.end()
        self._foreign.retire()
        self.where.close()
        self.destroy_subscription(self._heard)
        self.destroy_lifecycle_publisher(self._plan_out)

    def _take(self, msg: CostmapMessage) -> None:
        meta = msg.metadata
        cells = np.array(msg.data, dtype=np.uint8).reshape(meta.size_y, meta.size_x)
        self._costs = Costmap(cells, float(f"{meta.resolution:.6g}"), meta.origin.position.x, meta.origin.position.y)

    async def _smooth(self, handle: ServerGoalHandle) -> Any:
        request, result, begin = handle.request, SmoothPath.Result(), self.get_clock().now()
        rate = AsyncRate(self, 0.1)
        for _ in range(PATIENCE):
            if self._costs is None:
                await rate.sleep()
        rate.destroy()
        name = request.smoother_id or next(iter(self._smoothers))
        if name not in self._smoothers or not request.path.poses or self._costs is None:
            self.get_logger().error(self._fault(name, request.path.poses))
            handle.abort()
            return result
        try:
            result.path, result.was_completed = self._smoothed(name, request)
        except CppFault as fault:
            self.get_logger().error(str(fault))
            handle.abort()
            return result
        took = self.get_clock().now() - begin
        result.smoothing_duration = took.to_msg()
        if not result.was_completed:
            self.get_logger().info(_late(name, request.max_smoothing_duration, took.nanoseconds))
        if request.check_for_collisions and self._touches(_poses(result.path)):
            self.get_logger().error("Smoothed path leads to a collision")
            handle.abort()
            return result
        self._plan_out.publish(result.path)
        handle.succeed()
        return result

    def _smoothed(self, name: str, request: SmoothPath.Goal) -> tuple[Path, bool]:
        """Return the path, and whether it was done in time. Raises CppFault."""
        smoother, path = self._smoothers[name], request.path
        if isinstance(smoother, CppSmoother):
            return smoother.smooth(path, Duration.from_msg(request.max_smoothing_duration).nanoseconds)
        assert self._costs is not None
        poses = smoothed(self._costs, _poses(path), smoother)
        return path_message(poses, path.header.frame_id, path.header.stamp), True

    def _fault(self, name: str, poses: Sequence[PoseStamped]) -> str:
        if name not in self._smoothers:
            return f"SmoothPath called with smoother name {name}, which does not exist. Known: {', '.join(self._smoothers)}"
        return "Smoother: the path is empty" if not poses else "Smoother: no costmap has been heard yet"

    def _touches(self, poses: np.ndarray) -> bool:
        assert self._costs is not None
        return any(INSCRIBED <= self._costs.cost(x, y) < UNKNOWN for x, y, _ in poses.tolist())


def _poses(path: Path) -> np.ndarray:
    """Return a path's poses (n, 3)."""
    return np.array([plane(pose.pose.position, pose.pose.orientation) for pose in path.poses], dtype=float)


def _late(name: str, most: DurationMsg, took: int) -> str:
    """Return nav2's words for a smoother that has broken off; `took` is in nanoseconds."""
    limit = Duration.from_msg(most).nanoseconds * 1e-9
    return (
        f"Smoother {name} did not complete smoothing in specified time limit({limit:f} seconds) and was interrupted "
        f"after {took * 1e-9:f} seconds"
    )


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(SmootherServer, args)
