"""The zones of a collision monitor, with nav2's parameters."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from geometry_msgs.msg import Point32, PolygonStamped
from rcl_interfaces.msg import ParameterDescriptor

from coursekit.nav.zones import Speeds, Zone, pace
from coursekit.nodes.nav2.parameters import declare

if TYPE_CHECKING:
    from coursekit.geometry.plane import Array
    from coursekit.nodes.nav2.collision_monitor import CollisionMonitor

ACTIONS = ("stop", "slowdown", "approach", "limit")
_ZONE = {
    "type": "polygon", "action_type": "stop", "enabled": True, "max_points": 3, "min_points": 0, "radius": 0.0,
    "slowdown_ratio": 0.5, "linear_limit": 0.5, "angular_limit": 0.5, "time_before_collision": 2.0,
    "simulation_time_step": 0.1, "footprint_topic": "local_costmap/published_footprint", "visualize": False,
}  # fmt: skip


class RobotZone:
    """A zone, by its name in the parameters; an `approach` zone without points uses the footprint topic."""

    def __init__(self, node: CollisionMonitor, name: str) -> None:
        self.node, self.name = node, name
        self.given = declare(node, {**_ZONE, "polygon_pub_topic": name}, name)
        if not node.has_parameter(f"{name}.points"):
            node.declare_parameter(f"{name}.points", [], ParameterDescriptor(dynamic_typing=True))
        self.action = self.given["action_type"]
        self._ear: Any = None
        self._zone = self._make()
        self._out = self._open() if self.given["visualize"] else None

    def _make(self) -> Zone:
        given = self.given
        if self.action not in ACTIONS:
            raise ValueError(f"[{self.name}]: Unknown action type: {self.action}. Write one of {', '.join(ACTIONS)}")
        if given["type"] not in ("polygon", "circle"):
            raise ValueError(f"[{self.name}]: Unknown polygon type: {given['type']}. Write polygon or circle")
        if not (given["simulation_time_step"] > 0 and given["time_before_collision"] > 0):
            raise ValueError(f"[{self.name}]: simulation_time_step and time_before_collision should be greater than 0")
        zone = Zone(
            self.action, given["min_points"] or given["max_points"] + 1, ratio=given["slowdown_ratio"],
            linear_limit=given["linear_limit"], angular_limit=given["angular_limit"], ahead=given["time_before_collision"],
            step=given["simulation_time_step"],
        )  # fmt: skip
        if given["type"] == "circle":
            zone.radius = self._radius()
        elif self._points() or self.action != "approach":
            zone.corners = self._corners()
        else:
            self._ear = self.node.create_subscription(PolygonStamped, given["footprint_topic"], self._take, 10)
        return zone

    def _points(self) -> list[Any]:
        points: list[Any] = list(self.node.get_parameter(f"{self.name}.points").value)
        return points

    def _radius(self) -> float:
        radius: float = self.given["radius"]
        if not radius > 0:
            raise ValueError(f"[{self.name}]: a circle needs its radius in metres. Write radius: 0.3")
        return radius

    def _corners(self) -> Any:
        points = self._points()
        if len(points) < 6 or len(points) % 2 or not all(isinstance(point, (int, float)) for point in points):
            raise ValueError(
                f"[{self.name}]: Polygon has incorrect points description: give x and y of at least three corners in turn, "
                'as points: [0.4, 0.3, 0.4, -0.3, 0.0, 0.0] (a text with pairs, "[[0.4, 0.3], ...]", is newer than Humble)'
            )
        return np.array(points, float).reshape(-1, 2)

    def _take(self, msg: PolygonStamped) -> None:
        """Handle a footprint published by a costmap, at the robot's pose; convert it to the robot's frame."""
        corners = np.array([(point.x, point.y) for point in msg.polygon.points]).reshape(-1, 2)
        around = self.node.around_robot(corners, msg.header) if len(corners) >= 3 else None
        if around is not None:
            self._zone.corners = around

    def wish(self, points: Array, speeds: Speeds) -> Speeds | None:
        """Return the speeds that the zone allows, or None if nothing is in the way."""
        known = self._zone.corners is not None or self._zone.radius > 0
        enabled = self.node.get_parameter(f"{self.name}.enabled").value
        return self._zone.wish(points, speeds) if enabled and known else None

    def words(self, best: Speeds, wish: Speeds) -> str:
        """Describe the action taken, in nav2's words."""
        if self.action == "stop":
            return f"Robot to stop due to {self.name} polygon"
        if self.action == "slowdown":
            return f"Robot to slowdown for {self.given['slowdown_ratio'] * 100:f} percents due to {self.name} polygon"
        if self.action == "limit":
            return f"Robot to limit speed due to {self.name} polygon"
        left = self.given["time_before_collision"] * (pace(best) / (pace(wish) or 1.0)) ** 0.5
        return f"Robot to approach for {left:f} seconds away from collision"

    # -- visualisation

    def _open(self) -> Any:
        return self.node.create_lifecycle_publisher(PolygonStamped, self.given["polygon_pub_topic"], 1)

    def show(self) -> None:
        """Publish the outline, if it is to be visualised."""
        if self._out is None:
            return
        angles = np.arange(16) * np.pi / 8
        circle = self._zone.radius * np.column_stack([np.cos(angles), np.sin(angles)])
        corners = circle if self._zone.radius > 0 else self._zone.corners
        if corners is None:
            return
        msg = PolygonStamped()
        msg.header.frame_id = self.node.get_parameter("base_frame_id").value
        msg.header.stamp = self.node.get_clock().now().to_msg()
        msg.polygon.points = [Point32(x=float(x), y=float(y)) for x, y in corners]
        self._out.publish(msg)

    def close(self) -> None:
        """Destroy the subscription and the publisher."""
        if self._ear is not None:
            self.node.destroy_subscription(self._ear)
        if self._out is not None:
            self.node.destroy_lifecycle_publisher(self._out)


__all__ = ["RobotZone"]
