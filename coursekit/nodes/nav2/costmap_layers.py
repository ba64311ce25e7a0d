"""The combined layers of a costmap node."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from nav_msgs.msg import OccupancyGrid

from coursekit.geometry.plane import Pose2D
from coursekit.nav.costmap import FREE, UNKNOWN, Costmap, combine, static_costs
from coursekit.nav.footprint import Footprint
from coursekit.nav.inflation import Inflation
from coursekit.nav.movers import Movers
from coursekit.nav.obstacles import ObstacleLayer
from coursekit.nodes.nav2.cloud_source import CloudSource
from coursekit.nodes.nav2.costmap_filters import filters
from coursekit.nodes.nav2.costmap_parameters import KINDS, layers, sources
from coursekit.nodes.nav2.cpp_layer import CppLayer, foreign_layer
from coursekit.nodes.nav2.map_message import MAP_QOS, from_message
from coursekit.nodes.nav2.range_source import RangeSource
from coursekit.nodes.nav2.scan_source import ScanSource, Source, in_server_space, layer_of
from coursekit.nodes.nav2.transform_lookup import TransformLookup

if TYPE_CHECKING:
    from coursekit.nodes.nav2.costmap_node import CostmapNode


class Layers:
    """Map, obstacles and inflation of a costmap node; `costmap` is the latest result."""

    def __init__(self, node: CostmapNode, where: TransformLookup, given: dict[str, Any], robot: Footprint) -> None:
        self.node, self.given, self.robot = node, given, robot
        size = given["width"], given["height"], given["resolution"], given["origin_x"], given["origin_y"]
        self.empty = UNKNOWN if given["track_unknown_space"] else FREE
        self.costmap = Costmap.of_size(*size, fill=self.empty)
        looks_ahead = given["rolling_window"] and given["predicted_seconds"] > 0
        self._movers = Movers(given["predicted_seconds"]) if looks_ahead else None
        self._static: Costmap | None = None
        self._map: OccupancyGrid | None = None
        self.obstacles: list[tuple[ObstacleLayer, dict[str, Any]]] = []
        self._sources: list[Source] = []
        self._heard: list[Any] = []
        self._given: dict[str, dict[str, Any]] = {}
        self._inflation: dict[str, Any] | None = None
        self.has_static = False
        self.foreign: list[CppLayer] = []
        self._first_above = 0
        """The number of foreign layers below the inflation."""
        for name, kind, layer in layers(node, given["plugins"]):
            self._given[name] = layer
            getattr(self, f"_add_{kind}")(name, layer, where)
        self._filters = filters(node, given["filters"], where)
        where.buffer.call_after_each(self._wake)

    def _add_static(self, _name: str, layer: dict[str, Any], _where: TransformLookup) -> None:
        self.has_static, self._static_given = True, layer
        topic = layer["map_topic"] or self.given["map_topic"]
        topic = in_server_space(self.node, topic)
        self._heard.append(self.node.create_subscription(OccupancyGrid, topic, self._take_map, MAP_QOS))

    def _add_obstacles(self, name: str, layer: dict[str, Any], where: TransformLookup) -> None:
        given = sources(self.node, name, layer["observation_sources"])
        obstacle_layer = layer_of(self.costmap, given)
        self.obstacles.append((obstacle_layer, layer))
        frame = self.given["global_frame"]
        kinds = {"LaserScan": ScanSource, "PointCloud2": CloudSource}
        self._sources += [kinds[source["data_type"]](self.node, where, frame, obstacle_layer, source) for source in given]

    def _add_ranges(self, name: str, layer: dict[str, Any], where: TransformLookup) -> None:
        if not layer["topics"]:
            raise ValueError(f"{name}.topics is empty: name those of the sensors, as topics: [/sonar]")
        obstacle_layer = ObstacleLayer(self.costmap)
        self.obstacles.append((obstacle_layer, {**layer, "footprint_clearing_enabled": True}))
        frame = self.given["global_frame"]
        self._sources += [
            RangeSource(self.node, where, frame, obstacle_layer, {**layer, "topic": topic}) for topic in layer["topics"]
        ]

    def _add_foreign(self, name: str, layer: dict[str, Any], _where: TransformLookup) -> None:
        self.foreign.append(foreign_layer(self.node, name, layer["plugin"], KINDS))
        self._first_above += self._inflation is None

    def _add_inflation(self, name: str, layer: dict[str, Any], _where: TransformLookup) -> None:
        self._inflation = layer
        self._make_spread(self.given["resolution"])
        if layer["inflation_radius"] < self.robot.inscribed:
            self.node.get_logger().error(
                f"The configured inflation radius ({layer['inflation_radius']:.3f}) is smaller than the computed inscribed "
                f"radius ({self.robot.inscribed:.3f}) of your footprint, it is highly recommended to set inflation radius "
                "to be at least as big as the inscribed radius to avoid collisions"
            )

    def _make_spread(self, resolution: float) -> None:
        if self._inflation is not None:
            radius, scaling = self._inflation["inflation_radius"], self._inflation["cost_scaling_factor"]
            self._spread = Inflation(radius, scaling, self.robot.inscribed, resolution)

    @property
    def inflation(self) -> dict[str, Any] | None:
        """Return the inflation parameters, or None if there is no enabled inflation layer."""
        return self._inflation if self._inflation is not None and self._inflation["enabled"] else None

    def read(self, given: dict[str, Any], robot: Footprint) -> None:
        """Read the parameters of the node and of all layers again."""
        for name, _, fresh in layers(self.node, given["plugins"]):
            self._given.get(name, {}).update(fresh)
        self.given, self.robot = given, robot
        self._make_spread(self.costmap.resolution)

    def close(self) -> None:
        """Drop the subscriptions."""
        for heard in self._heard:
            self.node.destroy_subscription(heard)
        for source in self._sources:
            source.close()
        for zones in self._filters:
            zones.close()
        for layer in self.foreign:
            layer.close()

    def _wake(self) -> None:
        for source in self._sources:
            source.filter.try_waiting()

    @property
    def ready(self) -> bool:
        """Whether the map, if one is needed, has arrived."""
        return self._static is not None or not self.has_static

    def _take_map(self, msg: OccupancyGrid) -> None:
        """Handle a map: the costmap takes its size, and keeps scan obstacles where the old and new ones overlap."""
        if self._map is not None and self._map.header == msg.header and self._map.data == msg.data:
            return
        try:
            grid = from_message(msg)
        except ValueError as fault:
            self.node.get_logger().error(f"Received map message is malformed. Rejecting. ({fault})")
            return
        self._map = msg
        costs = static_costs(
            grid.cells, lethal=self.given["lethal_cost_threshold"], unknown=self.given["track_unknown_space"],
            trinary=self.given["trinary_costmap"],
        )  # fmt: skip
        self._static = Costmap(np.ascontiguousarray(costs), grid.resolution, grid.origin[0], grid.origin[1])
        self.node.get_logger().info(
            f"StaticLayer: Resizing costmap to {costs.shape[1]} X {costs.shape[0]} at {grid.resolution:f} m/pix", once=True
        )
        if not self.given["rolling_window"]:
            self._resize(self._static)

    def _resize(self, like: Costmap) -> None:
        changed = (like.cells.shape, like.resolution, like.x, like.y) != _shape(self.costmap)
        self.costmap = like.like(self.empty)
        if not changed:
            return
        for layer, _ in self.obstacles:
            layer.map = like.like(UNKNOWN)
        self._make_spread(like.resolution)

    def update(self, x: float, y: float, yaw: float, now: float) -> Costmap:
        """Return the costs at time `now` [s], for a robot at this pose."""
        if self.given["rolling_window"]:
            self._roll(x, y)
        costmap = self.costmap.like(self.empty)
        if self._static is not None and self._static_given["enabled"]:
            self._lay_static(costmap)
        outline = self.robot.at(x, y, yaw)
        for layer, given in self.obstacles:
            if not given["enabled"]:
                continue
            if given["footprint_clearing_enabled"]:
                layer.free(outline)
            combine(costmap.cells, layer.map.cells)
        if self._movers is not None:
            self._movers.see(costmap, now)
        at = Pose2D(x, y, yaw)
        for foreign in self.foreign[: self._first_above]:
            foreign.update(costmap, self.robot, at)
        for zones in self._filters:  # before the inflation, so that the whole robot stays out of the zones
            zones.apply(costmap, self.given["global_frame"], (x, y))
        if self.inflation is not None:
            self._spread.spread(costmap.cells, self.inflation["inflate_unknown"])
        for foreign in self.foreign[self._first_above :]:
            foreign.update(costmap, self.robot, at)
        if self._movers is not None:
            self._movers.mark(costmap, self.robot.inscribed)
        self.costmap = costmap
        return costmap

    def _roll(self, x: float, y: float) -> None:
        rows, columns = self.costmap.cells.shape
        half_x, half_y = columns * self.costmap.resolution / 2, rows * self.costmap.resolution / 2
        self.costmap = self.costmap.moved_to(x - half_x, y - half_y, self.empty)
        for layer, _ in self.obstacles:
            layer.map = layer.map.moved_to(x - half_x, y - half_y, UNKNOWN)

    def _lay_static(self, costmap: Costmap) -> None:
        static = self._static
        assert static is not None
        if static.cells.shape == costmap.cells.shape and not self.given["rolling_window"]:
            costmap.cells[:] = static.cells
            return
        rows = np.floor(
            (costmap.y + (np.arange(costmap.cells.shape[0]) + 0.5) * costmap.resolution - static.y) / static.resolution
        )
        columns = np.floor(
            (costmap.x + (np.arange(costmap.cells.shape[1]) + 0.5) * costmap.resolution - static.x) / static.resolution
        )
        good_rows = (rows >= 0) & (rows < static.cells.shape[0])
        good_columns = (columns >= 0) & (columns < static.cells.shape[1])
        part = static.cells[np.ix_(rows[good_rows].astype(int), columns[good_columns].astype(int))]
        costmap.cells[np.ix_(good_rows, good_columns)] = part


def _shape(costmap: Costmap) -> tuple[tuple[int, ...], float, float, float]:
    return costmap.cells.shape, costmap.resolution, costmap.x, costmap.y
