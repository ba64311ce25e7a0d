"""`ros2 run ros_gz_bridge parameter_bridge TOPIC@ROS_TYPE@GZ_TYPE ...`: bridges Gazebo topics to ROS and back."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

import rclpy
from rclpy.clock import Clock, ClockType
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.expand_topic_name import expand_topic_name
from rclpy.node import Node
from rclpy.qos import QoSPolicyKind
from rclpy.qos_overriding_options import QoSOverridingOptions
from rclpy.utilities import remove_ros_args
from rosidl_runtime_py.utilities import get_message, get_service

from coursekit.processes.session import current

from .bridge_config import Bridged, of_file, of_word
from .bridge_types import SERVICES, carried_by, conversion, full_name
from .transport import gz_context

USAGE = """Bridge a collection of ROS2 and Gazebo Transport topics and services.

  parameter_bridge <topic@ROS2_type@gz_type> ..  <service@ROS2_srv_type> ..

In place of the second @: [ bridges from Gazebo to ROS only, ] from ROS to Gazebo only. For example:
    parameter_bridge /clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock
    parameter_bridge /cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist
"""


POLICIES = (QoSPolicyKind.DEPTH, QoSPolicyKind.DURABILITY, QoSPolicyKind.HISTORY, QoSPolicyKind.RELIABILITY)
"""The QoS policies of a ROS topic that parameters such as `qos_overrides./tf_static.publisher.durability` can set."""


class Way:
    """One direction of a topic. `open` subscribes (if lazy, once `wanted` on the other side); `mend` edits messages."""

    def __init__(
        self, source: Node, target: Node, here: tuple[str, str], there: tuple[str, str], one: Bridged,
        mend: Callable[[Any], Any] | None = None,
    ) -> None:  # fmt: skip
        self.source, self.here, self.queue = source, here, one.subscriber_queue
        kind, name = there
        change = conversion(here[0], kind)
        if change is None:
            raise LookupError(f"{here[0]} cannot be made {kind} in this direction")
        self.change: Callable[[Any], Any] = change if mend is None else lambda msg: mend(change(msg))
        options = None if mend is None else QoSOverridingOptions(POLICIES)
        self.out = target.create_publisher(get_message(kind), name, one.publisher_queue, qos_overriding_options=options)
        self.heard: Any = None
        if not one.lazy:
            self.open()

    def open(self) -> None:
        """Subscribe."""
        kind, name = self.here
        self.heard = self.source.create_subscription(
            get_message(kind), name, lambda msg: self.out.publish(self.change(msg)), self.queue
        )

    def follow(self) -> None:
        """Subscribe while somebody is listening on the other side (lazy mode)."""
        wanted = self.out.get_subscription_count() > 0
        if wanted and self.heard is None:
            self.open()
        elif not wanted and self.heard is not None:
            self.source.destroy_subscription(self.heard)
            self.heard = None


class RosGzBridge(Node):
    """The bridge: this node is in ROS, `gz` is in Gazebo's graph."""

    def __init__(self, words: list[Bridged]) -> None:
        super().__init__("ros_gz_bridge")
        self.gz_context = gz_context()
        self.gz = rclpy.create_node("ros_gz_bridge", context=self.gz_context)
        self._rclpy_graph_node.deaf_to_itself = self.gz._rclpy_graph_node.deaf_to_itself = True
        beat = int(self.declare_parameter("subscription_heartbeat", 1000).value)
        file = str(self.declare_parameter("config_file", "").value)
        self._expand = bool(self.declare_parameter("expand_gz_topic_names", False).value)
        self._lazy = bool(self.declare_parameter("lazy", False).value)
        self._wall = bool(self.declare_parameter("override_timestamps_with_wall_time", False).value)
        self._frame = str(self.declare_parameter("override_frame_id", "").value)
        self._lazy_ways: list[Way] = []
        self.create_timer(beat * 1e-3, self._follow)
        bridges, faults = of_file(file) if file else ([], [])
        for fault in faults:
            self.get_logger().error(fault)
        for word in [*words, *bridges]:
            self.add(word)

    def _follow(self) -> None:
        for way in self._lazy_ways:
            way.follow()

    def add(self, one: Bridged) -> None:
        """Bridge a topic or service; log an error for types that cannot be paired."""
        try:
            if one.is_service:
                self._add_service(one)
                return
            carrier, ros_type = carried_by(one.ros_type, one.gz_type), full_name(one.ros_type)
            lazy = one.lazy or self._lazy
            gz_end, ros_end = (carrier, self._gz_topic(one.gz_topic)), (ros_type, one.ros_topic)
            if one.direction != "ROS_TO_GZ":
                self._say("GZ->ROS", (one.gz_topic, one.gz_type), (one.ros_topic, one.ros_type), lazy)
                self._keep(Way(self.gz, self, gz_end, ros_end, one, self._mend), lazy)
            if one.direction != "GZ_TO_ROS":
                self._say("ROS->GZ", (one.ros_topic, one.ros_type), (one.gz_topic, one.gz_type), lazy)
                self._keep(Way(self, self.gz, ros_end, gz_end, one), lazy)
        except (LookupError, ValueError, ModuleNotFoundError, AttributeError) as error:
            self.get_logger().warning(
                f"Failed to create a bridge for topic [{one.ros_topic}] with ROS2 type [{one.ros_type}] to topic "
                f"[{one.gz_topic}] with Gazebo Transport type [{one.gz_type}]: {error}"
            )

    def _mend(self, msg: Any) -> Any:
        """Set the frame and the time that the parameters specify on a message going into ROS."""
        header = getattr(msg, "header", None)
        if header is not None and self._frame:
            header.frame_id = self._frame
        if header is not None and self._wall:
            header.stamp = Clock(clock_type=ClockType.SYSTEM_TIME).now().to_msg()
        return msg

    def _gz_topic(self, name: str) -> str:
        if self._expand:
            return str(expand_topic_name(name, self.get_name(), self.get_namespace()))
        return "/" + name.lstrip("/")

    def _say(self, way: str, source: tuple[str, str], target: tuple[str, str], lazy: bool) -> None:
        self.get_logger().info(
            f"Creating {way} Bridge: [{source[0]} ({source[1]}) -> {target[0]} ({target[1]})] (Lazy {int(lazy)})"
        )

    def _keep(self, way: Way, lazy: bool) -> None:
        if lazy:
            self._lazy_ways.append(way)

    def _add_service(self, bridged: Bridged) -> None:
        name = bridged.ros_type.rpartition("/")[2]
        if not any(each.endswith(f"/{name}") for each in SERVICES):
            raise LookupError(f"{bridged.ros_type} is no service of Gazebo's; there are {', '.join(SERVICES)}")
        kind = get_service(bridged.ros_type)
        client = self.gz.create_client(kind, bridged.gz_topic)

        async def pass_on(request: Any, answer: Any) -> Any:
            return await client.call_async(request) if client.service_is_ready() else answer

        self.create_service(kind, bridged.ros_topic, pass_on)
        self.get_logger().info(f"Creating service bridge: [{bridged.ros_topic} ({bridged.ros_type})]")


def spin(node: RosGzBridge) -> None:
    """Spin both sides until shutdown: Gazebo's in a thread, ROS's here."""
    beside = SingleThreadedExecutor(context=node.gz_context)
    beside.add_node(node.gz)

    def gazebo_side() -> None:
        try:
            beside.spin()
        except ExternalShutdownException:
            pass

    current().spawn(gazebo_side)
    try:
        rclpy.spin(node)
    finally:
        node.gz_context.try_shutdown()


def run(words: list[Bridged], args: list[str] | None) -> int:
    """Bridge until Ctrl-C. Returns the exit code."""
    rclpy.init(args=args)
    node = RosGzBridge(words)
    try:
        spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()
    return 0


def main(args: list[str] | None = None) -> Any:
    """Bridge what the command line and the parameter `config_file` name. Returns 255 if that cannot be read."""
    told = list(args if args is not None else sys.argv)
    words = remove_ros_args(told)[1:]
    if len(told) < 2 or any(word in ("-h", "--help") for word in words):
        print(USAGE)
        return 255
    try:
        bridged = [of_word(word) for word in words]
    except ValueError as error:
        print(USAGE)
        print(error, file=sys.stderr)
        return 255
    return run(bridged, args)
