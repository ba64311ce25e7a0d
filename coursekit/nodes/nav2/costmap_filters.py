"""Costmap filters: map masks for keepout zones and speed limits."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from nav2_msgs.msg import CostmapFilterInfo, SpeedLimit
from nav_msgs.msg import OccupancyGrid
from tf2_ros import TransformException

from coursekit.geometry.plane import Pose2D
from coursekit.nav.costmap import LETHAL, UNKNOWN, Costmap, combine
from coursekit.nav.map_file import GridMap
from coursekit.nodes.nav2.map_message import MAP_QOS, from_message
from coursekit.nodes.nav2.parameters import declare, no_such_plugin
from coursekit.nodes.nav2.scan_source import in_server_space
from coursekit.nodes.nav2.transform_lookup import TransformLookup

if TYPE_CHECKING:
    from rclpy.node import Node

_GIVEN: dict[str, Any] = {"enabled": True, "filter_info_topic": "costmap_filter_info", "transform_tolerance": 0.1}


class Filter:
    """A mask, configured by a CostmapFilterInfo topic."""

    types: tuple[int, ...] = ()

    def __init__(self, node: Node, name: str, where: TransformLookup) -> None:
        self.node, self.name, self._where = node, name, where
        self.given = declare(node, _GIVEN, name)
        self.info: CostmapFilterInfo | None = None
        self.mask: GridMap | None = None
        self._frame = ""
        topic = in_server_space(node, self.given["filter_info_topic"])
        self._heard = [node.create_subscription(CostmapFilterInfo, topic, self._take_info, MAP_QOS)]

    def close(self) -> None:
        """Drop the subscriptions."""
        for heard in self._heard:
            self.node.destroy_subscription(heard)

    def _take_info(self, msg: CostmapFilterInfo) -> None:
        if msg.type not in self.types:
            known = ", ".join(map(str, self.types))
            self.node.get_logger().error(f"{self.name}: Mode is not supported: type {msg.type}; it takes {known}")
            return
        self.node.get_logger().info(f"{self.name}: Received filter info from {self.given['filter_info_topic']} topic.")
        self.info, self.mask = msg, None
        for heard in self._heard[1:]:
            self.node.destroy_subscription(heard)
        topic = in_server_space(self.node, msg.filter_mask_topic)
        self._heard[1:] = [self.node.create_subscription(OccupancyGrid, topic, self._take_mask, MAP_QOS)]

    def _take_mask(self, msg: OccupancyGrid) -> None:
        self.node.get_logger().info(f"{self.name}: Received filter mask.")
        self.mask, self._frame = from_message(msg), msg.header.frame_id

    def at(self, points: np.ndarray, frame: str) -> np.ndarray:
        """Return the mask's values at points (n, 2) in a frame: 0 to 100, -1 outside the mask."""
        assert self.mask is not None
        x, y, yaw = self.mask.origin
        places = (Pose2D(x, y, yaw).inverse() @ self._where.between(self._frame, frame)).transform(points)
        columns, rows = np.floor(places / self.mask.resolution).astype(int).T
        height, width = self.mask.cells.shape
        inside = (rows >= 0) & (rows < height) & (columns >= 0) & (columns < width)
        values = np.full(len(points), -1, dtype=np.int16)
        values[inside] = self.mask.cells[rows[inside], columns[inside]]
        return values

    def apply(self, costs: Costmap, frame: str, robot: tuple[float, float]) -> None:
        """Apply the filter, with the robot at a position in the costmap."""
        if self.mask is None or self.info is None or not self.given["enabled"]:
            return
        try:
            self.work(costs, frame, robot)
        except TransformException as fault:
            text = f"{self.name}: failed to get costmap frame ({frame}): {fault}"
            self.node.get_logger().error(text, throttle_duration_sec=2.0)

    def work(self, costs: Costmap, frame: str, robot: tuple[float, float]) -> None:
        """Apply the specific filter."""


class Keepout(Filter):
    """The robot may not enter dark areas of the mask, and avoids grey ones."""

    types = (0,)

    def work(self, costs: Costmap, frame: str, robot: tuple[float, float]) -> None:
        """Overlay the mask on the costs."""
        rows, columns = np.indices(costs.cells.shape)
        x, y = costs.x + (columns + 0.5) * costs.resolution, costs.y + (rows + 0.5) * costs.resolution
        said = self.at(np.column_stack([x.ravel(), y.ravel()]), frame).reshape(costs.cells.shape)
        combine(costs.cells, np.where(said < 0, UNKNOWN, said * LETHAL // 100).astype(np.uint8))


class Speed(Filter):
    """The mask value at the robot limits its speed: in percent of the maximum (type 1) or in m/s (type 2)."""

    types = (1, 2)

    def __init__(self, node: Node, name: str, where: TransformLookup) -> None:
        super().__init__(node, name, where)
        topic = declare(node, {"speed_limit_topic": "speed_limit"}, name)["speed_limit_topic"]
        self._out = node.create_publisher(SpeedLimit, in_server_space(node, topic), 10)
        self._before = 0.0

    def work(self, costs: Costmap, frame: str, robot: tuple[float, float]) -> None:
        """Publish the limit when it changes."""
        assert self.info is not None
        said = int(self.at(np.array([robot]), frame)[0])
        limit = self.info.base + self.info.multiplier * said if said > 0 else 0.0
        if limit != self._before:
            self._before = limit
            msg = SpeedLimit(percentage=self.info.type == 1, speed_limit=float(max(limit, 0.0)))
            msg.header.frame_id, msg.header.stamp = frame, self.node.get_clock().now().to_msg()
            self._out.publish(msg)

    def close(self) -> None:
        """Destroy the subscriptions and the publisher."""
        super().close()
        self.node.destroy_publisher(self._out)


_KINDS = {"nav2_costmap_2d::KeepoutFilter": Keepout, "nav2_costmap_2d::SpeedFilter": Speed}


def filters(node: Node, names: list[str], where: TransformLookup) -> list[Filter]:
    """Return a costmap's filters. ValueError for unknown types."""
    costmap_filters = []
    for name in names:
        kind = declare(node, {"plugin": ""}, name)["plugin"]
        if kind not in _KINDS:
            what = f"costmap filter {name} of type '{kind}'"
            raise ValueError(no_such_plugin(what, kind, "nav2_costmap_2d::Layer", _KINDS))
        costmap_filters.append(_KINDS[kind](node, name, where))
    return costmap_filters
