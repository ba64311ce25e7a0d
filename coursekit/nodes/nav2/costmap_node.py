"""A server's costmap: a lifecycle node of its own (`/local_costmap/local_costmap`) in the server's process."""

from __future__ import annotations

import array
from typing import TYPE_CHECKING

from geometry_msgs.msg import Point32, PolygonStamped
from nav2_msgs.msg import Costmap as CostmapMessage
from nav2_msgs.srv import ClearCostmapAroundRobot, ClearCostmapExceptRegion, ClearEntireCostmap, GetCostmap
from nav_msgs.msg import OccupancyGrid
from rclpy.lifecycle import LifecycleState, TransitionCallbackReturn
from tf2_ros import TransformException

from coursekit.geometry.plane import Pose2D
from coursekit.nav.costmap import Costmap, occupancy
from coursekit.nodes.compiled.classes import CppFault
from coursekit.nodes.nav2.costmap_layers import Layers
from coursekit.nodes.nav2.costmap_parameters import COSTMAP, footprint
from coursekit.nodes.nav2.cpp_plugins import PluginsOwner
from coursekit.nodes.nav2.map_message import MAP_QOS
from coursekit.nodes.nav2.parameters import Obedience, declare
from coursekit.nodes.nav2.transform_lookup import TransformLookup

if TYPE_CHECKING:
    from rclpy.node import Node


class CostmapNode(PluginsOwner):
    """Updates and publishes a costmap while active, and clears it on request."""

    def __init__(self, name: str, parent: Node) -> None:
        space = parent.get_namespace().rstrip("/")
        local = ["--ros-args", "-r", f"__ns:={space}/{name}", "-r", f"__node:={name}"]
        super().__init__(name, namespace=f"{space}/{name}", cli_args=local, context=parent.context)
        if parent.get_parameter("use_sim_time").value:
            self.set_parameters([parent.get_parameter("use_sim_time")])
        self.get_logger().info("Creating Costmap")
        declare(self, COSTMAP)
        self._parent = parent
        self._active, self._published_ns = False, 0
        self.latest: Costmap | None = None

    # -- states

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Read parameters, create topics and services; FAILURE for invalid parameters."""
        self.get_logger().info("Configuring")
        try:
            self._read()
            self.frame = self.given["global_frame"]
            self.where = TransformLookup(self, self.given["robot_base_frame"], self._parent)
            self.layers = Layers(self, self.where, self.given, self.robot)
            self._configure_layers()
        except ValueError as fault:
            self.get_logger().error(str(fault))
            return TransitionCallbackReturn.FAILURE
        self._obedience = Obedience(self, self._read_again)
        self._make_topics()
        return super().on_configure(state)

    def _configure_layers(self) -> None:
        """Configure the C++ layers. CppFault when one throws."""
        try:
            for layer in self.layers.foreign:
                layer.configure()
                self.get_logger().info(f'Initialized plugin "{layer.name}"')
        except CppFault:
            self.layers.close()
            self.where.close()
            raise

    def _read(self) -> None:
        """Read the parameters. ValueError for invalid ones."""
        given = declare(self, COSTMAP)
        self.robot = footprint(given)
        self.given = given

    def _read_again(self) -> None:
        self._read()
        self.layers.read(self.given, self.robot)

    def _make_topics(self) -> None:
        name = self.get_name()
        self._grid_out = self.create_publisher(OccupancyGrid, "costmap", MAP_QOS)
        self._raw_out = self.create_publisher(CostmapMessage, "costmap_raw", MAP_QOS)
        self._robot_out = self.create_publisher(PolygonStamped, "published_footprint", 1)
        self._services_made = [
            self.create_service(ClearEntireCostmap, f"clear_entirely_{name}", self._clear),
            self.create_service(ClearCostmapAroundRobot, f"clear_around_{name}", self._clear_around),
            self.create_service(ClearCostmapExceptRegion, f"clear_except_{name}", self._clear_except),
            self.create_service(GetCostmap, "get_costmap", self._get),
        ]

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Start updating once the robot's pose is known."""
        self.get_logger().info("Activating")
        self.get_logger().info("Checking transform")
        self.where.wait_for_robot(self.frame, self._tell_no_pose)
        self._active = True
        self._change_layers("activate")
        self._timer = self.create_timer(1.0 / max(self.given["update_frequency"], 0.1), self._work)
        return super().on_activate(state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Stop updating."""
        self.get_logger().info("Deactivating")
        self._active = False
        self.destroy_timer(self._timer)
        self._change_layers("deactivate")
        return super().on_deactivate(state)

    def _change_layers(self, what: str) -> None:
        for layer in self.layers.foreign:
            layer.change(what)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Destroy everything."""
        self.get_logger().info("Cleaning up")
        self._obedience.end()
        self.layers.close()
        self.where.close()
        for service in self._services_made:
            self.destroy_service(service)
        for publisher in (self._grid_out, self._raw_out, self._robot_out):
            self.destroy_publisher(publisher)
        self.latest = None
        return super().on_cleanup(state)

    # -- updates

    def pose(self) -> Pose2D:
        """Return the robot's pose in the costmap's frame, or raise TransformException if it is unknown."""
        return self.where.robot(self.frame)

    def fresh(self) -> Costmap | None:
        """Return the costs from everything received so far, or None while the map or the robot's pose is missing."""
        if not self.layers.ready:
            return None
        try:
            here = self.pose()
        except TransformException as fault:
            self._tell_no_pose(str(fault))
            return None
        self.latest = self.layers.update(*here, self.get_clock().now().nanoseconds * 1e-9)
        return self.latest

    def _tell_no_pose(self, fault: str) -> None:
        self.get_logger().info(
            f"Timed out waiting for transform from {self.given['robot_base_frame']} to {self.frame} to become "
            f"available, tf error: {fault}", throttle_duration_sec=2.0,
        )  # fmt: skip

    def _work(self) -> None:
        if self.fresh() is None:
            return
        now = self.get_clock().now().nanoseconds
        if now - self._published_ns >= 0.99e9 / max(self.given["publish_frequency"], 1e-3) or now < self._published_ns:
            self._published_ns = now
            self._publish()

    def _publish(self) -> None:
        assert self.latest is not None
        if self._grid_out.get_subscription_count():
            self._grid_out.publish(self._as_grid(self.latest))
        if self._raw_out.get_subscription_count():
            self._raw_out.publish(self._as_costmap(self.latest))
        if self._robot_out.get_subscription_count():
            self._robot_out.publish(self._outline())

    def _as_grid(self, costs: Costmap) -> OccupancyGrid:
        msg = OccupancyGrid()
        msg.header.frame_id, msg.header.stamp = self.frame, self.get_clock().now().to_msg()
        msg.info.resolution = costs.resolution
        msg.info.height, msg.info.width = costs.cells.shape
        msg.info.origin.position.x, msg.info.origin.position.y = costs.x, costs.y
        msg.data = array.array("b", occupancy(costs.cells).tobytes())
        return msg

    def _as_costmap(self, costs: Costmap) -> CostmapMessage:
        msg = CostmapMessage()
        msg.header.frame_id, msg.header.stamp = self.frame, self.get_clock().now().to_msg()
        meta = msg.metadata
        meta.layer, meta.resolution = "master", costs.resolution
        meta.size_y, meta.size_x = costs.cells.shape
        meta.origin.position.x, meta.origin.position.y, meta.origin.orientation.w = costs.x, costs.y, 1.0
        meta.map_load_time = meta.update_time = msg.header.stamp
        msg.data = array.array("B", costs.cells.tobytes())
        return msg

    def _outline(self) -> PolygonStamped:
        msg = PolygonStamped()
        msg.header.frame_id, msg.header.stamp = self.frame, self.get_clock().now().to_msg()
        msg.polygon.points = [Point32(x=float(x), y=float(y)) for x, y in self.robot.at(*self.pose())]
        return msg

    # -- services

    def clear(self) -> None:
        """Clear what scans have marked."""
        for layer, _ in self.layers.obstacles:
            layer.forget()
        for foreign in self.layers.foreign:
            foreign.reset()

    def _clear(
        self, _request: ClearEntireCostmap.Request, response: ClearEntireCostmap.Response
    ) -> ClearEntireCostmap.Response:
        self.get_logger().info(f"Received request to clear entirely the {self.get_name()}")
        self.clear()
        return response

    def _clear_around(
        self, request: ClearCostmapAroundRobot.Request, response: ClearCostmapAroundRobot.Response
    ) -> ClearCostmapAroundRobot.Response:
        self._clear_square(request.reset_distance, outside=False)
        return response

    def _clear_except(
        self, request: ClearCostmapExceptRegion.Request, response: ClearCostmapExceptRegion.Response
    ) -> ClearCostmapExceptRegion.Response:
        self._clear_square(request.reset_distance, outside=True)
        return response

    def _clear_square(self, side: float, *, outside: bool) -> None:
        try:
            here = self.pose()
        except TransformException as fault:
            self.get_logger().error(f"Cannot clear map because robot pose cannot be retrieved: {fault}")
            return
        for layer, _ in self.layers.obstacles:
            layer.forget_square(here.x, here.y, side, outside=outside)

    def _get(self, _request: GetCostmap.Request, response: GetCostmap.Response) -> GetCostmap.Response:
        if self.latest is not None:
            response.map = self._as_costmap(self.latest)
        return response
