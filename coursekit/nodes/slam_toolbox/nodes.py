"""slam_toolbox's executables, which differ in their use of scans."""

from __future__ import annotations

from collections.abc import Callable

import rclpy
from geometry_msgs.msg import PoseWithCovarianceStamped
from rclpy.executors import ExternalShutdownException
from std_srvs.srv import Empty, SetBool

from coursekit.geometry.plane import Pose2D
from coursekit.nodes.scanning.planar import plane
from coursekit.nodes.slam_toolbox.engines import Localizing
from coursekit.nodes.slam_toolbox.parameters import declare_lifelong
from coursekit.nodes.slam_toolbox.services import Services
from coursekit.nodes.slam_toolbox.toolbox import SlamToolbox


def start_pose(node: SlamToolbox) -> tuple[Pose2D | None, bool]:
    """The start pose in a loaded map (None: its first pose), and whether the parameters specify it."""
    given = node.get_parameter("map_start_pose").value
    if given is not None and len(given):
        if len(given) == 3:
            return Pose2D.of(given), True
        node.get_logger().error(
            "LocalizationSlamToolbox: Incorrect number of arguments for map starting pose. Must be in format: "
            "[x, y, theta]. Starting at the origin"
        )
        return Pose2D(), True
    return None, bool(node.get_parameter("map_start_at_dock").value)


def load_by_parameters(node: SlamToolbox, services: Services, *, localize: bool) -> None:
    """Load map_file_name, if one is given."""
    name = str(node.get_parameter("map_file_name").value or "")
    if not name:
        if localize:
            node.get_logger().warning(
                "map_file_name is empty: mapping until slam_toolbox/deserialize_map loads a pose graph or a map's .yaml"
            )
        return
    pose, said = start_pose(node)
    if not said:
        node.get_logger().error(
            "LocalizationSlamToolbox: Map starting pose not specified. Set either map_start_pose or map_start_at_dock."
        )
    services.load(name, pose, localize=localize, anywhere=localize and not said)


def make_async() -> SlamToolbox:
    """Create a node that skips scans rather than lag behind."""
    node = SlamToolbox()
    load_by_parameters(node, Services(node), localize=False)
    return node


def make_sync() -> SlamToolbox:
    """Create a node that uses every scan, even if processing takes longer than the drive."""
    node = SlamToolbox(keep_all=True)
    load_by_parameters(node, Services(node, queue=True), localize=False)
    return node


def make_lifelong() -> SlamToolbox:
    """Create a node that continues a saved map indefinitely; unlike in ROS 2, it keeps scans that newer ones cover."""
    node = SlamToolbox()
    declare_lifelong(node)
    node.get_logger().warning("LifelongSlamToolbox: all scans are kept, so that lifelong_* parameters have no effect")
    load_by_parameters(node, Services(node), localize=False)
    return node


def make_localization() -> SlamToolbox:
    """Create a node that localises in the map of map_file_name; /initialpose sets the robot's pose."""
    node = SlamToolbox()
    services = Services(node, localize=True)
    _listen_for_poses(node)
    node.create_service(Empty, "slam_toolbox/clear_localization_buffer", lambda _request, response: response)
    load_by_parameters(node, services, localize=True)
    return node


def make_map_and_localization() -> SlamToolbox:
    """Create a node that maps, or localises if slam_toolbox/set_localization_mode is on."""
    node = SlamToolbox()
    services = Services(node)
    _listen_for_poses(node)

    def switch(request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
        response.message = services.set_localization(request.data)
        response.success = not response.message
        mode = "localization" if isinstance(node.engine, Localizing) else "mapping"
        node.get_logger().info(f"{'Now in' if response.success else 'Still in'} {mode} mode")
        return response

    node.create_service(SetBool, "slam_toolbox/set_localization_mode", switch)
    load_by_parameters(node, services, localize=False)
    return node


def _listen_for_poses(node: SlamToolbox) -> None:
    """Set the robot's pose in a map on /initialpose."""

    def move(msg: PoseWithCovarianceStamped) -> None:
        if msg.header.frame_id not in ("", node.map_frame):
            node.get_logger().error(
                f"/initialpose came in frame '{msg.header.frame_id}', it must be '{node.map_frame}': left aside"
            )
        elif not isinstance(node.engine, Localizing):
            node.get_logger().error("LocalizePoseCallback: Cannot process localization command if not in localization mode.")
        else:
            pose = plane(msg.pose.pose.position, msg.pose.pose.orientation)
            where = f"({pose.x:.2f} {pose.y:.2f}), theta={pose.theta:.2f}"
            node.get_logger().info(f"LocalizePoseCallback: Localizing to: {where}")
            node.engine.look_near(pose)

    node.create_subscription(PoseWithCovarianceStamped, "initialpose", move, 1)


def _run(make: Callable[[], SlamToolbox], args: list[str] | None) -> int:
    """Run a node until Ctrl-C."""
    rclpy.init(args=args)
    node = None
    try:
        node = make()
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        if node is not None:
            node.destroy_node()
        rclpy.try_shutdown()
    return 0


def main_async(args: list[str] | None = None) -> int:
    """Run async_slam_toolbox_node."""
    return _run(make_async, args)


def main_sync(args: list[str] | None = None) -> int:
    """Run sync_slam_toolbox_node."""
    return _run(make_sync, args)


def main_lifelong(args: list[str] | None = None) -> int:
    """Run lifelong_slam_toolbox_node."""
    return _run(make_lifelong, args)


def main_localization(args: list[str] | None = None) -> int:
    """Run localization_slam_toolbox_node."""
    return _run(make_localization, args)


def main_map_and_localization(args: list[str] | None = None) -> int:
    """Run map_and_localization_slam_toolbox_node."""
    return _run(make_map_and_localization, args)
