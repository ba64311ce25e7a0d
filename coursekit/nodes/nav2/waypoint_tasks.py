"""What the waypoint follower does at each waypoint: nav2's plugins WaitAtWaypoint, InputAtWaypoint and PhotoAtWaypoint."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from geometry_msgs.msg import PoseStamped
from rclpy.duration import Duration
from rclpy.qos import qos_profile_system_default
from sensor_msgs.msg import Image
from std_msgs.msg import Empty

from coursekit.nodes.nav2.cpp_behavior import CppTask
from coursekit.nodes.nav2.cpp_plugins import CppPlugins
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.nav2.running import pause

if TYPE_CHECKING:
    from rclpy.node import Node

LOOK_SECONDS = 1 / 50
Stop = Callable[[], bool]


class Task(Protocol):
    """Something to do at a waypoint."""

    subscription: Any

    async def process(self, pose: PoseStamped, number: int, stop: Stop) -> bool:
        """Do it at the waypoint of this number; return whether it was done. It ends early when `stop()` is true."""


class WaitAtWaypoint:
    """Stands still for `waypoint_pause_duration` milliseconds."""

    DEFAULTS: dict[str, Any] = {"enabled": True, "waypoint_pause_duration": 0}

    def __init__(self, node: Node, given: dict[str, Any]) -> None:
        self._node, self.subscription = node, None
        self._seconds = given["waypoint_pause_duration"] * 1e-3 if given["enabled"] else 0.0

    async def process(self, pose: PoseStamped, number: int, stop: Stop) -> bool:
        """Wait."""
        if self._seconds > 0:
            await pause(self._node, self._seconds)
        return True


class InputAtWaypoint:
    """Waits for a message on `input_topic`, at most `timeout` seconds."""

    DEFAULTS: dict[str, Any] = {"enabled": True, "timeout": 10.0, "input_topic": "input_at_waypoint/input"}

    def __init__(self, node: Node, given: dict[str, Any]) -> None:
        self._node, self._given, self._heard = node, given, False
        node.get_logger().info(f"InputAtWaypoint: Subscribing to input topic {given['input_topic']}.")
        self.subscription = node.create_subscription(Empty, given["input_topic"], self._hear, 1)

    def _hear(self, msg: Empty) -> None:
        self._heard = True

    async def process(self, pose: PoseStamped, number: int, stop: Stop) -> bool:
        """Wait for the message; False if none has come."""
        if not self._given["enabled"]:
            return True
        self._heard, clock = False, self._node.get_clock()
        start, most = clock.now(), Duration(seconds=self._given["timeout"])
        while clock.now() - start < most and not stop():
            if self._heard:
                return True
            await pause(self._node, LOOK_SECONDS)
        self._node.get_logger().warning(f"Unable to get external input at wp {number}. Moving on.")
        return False


class PhotoAtWaypoint:
    """Saves the last picture of `image_topic` into the folder `save_dir`."""

    DEFAULTS: dict[str, Any] = {
        "enabled": True, "image_topic": "/camera/color/image_raw", "save_dir": "/tmp/waypoint_images", "image_format": "png",
    }  # fmt: skip

    def __init__(self, node: Node, given: dict[str, Any]) -> None:
        self._node, self._given, self._picture, self.subscription = node, given, Image(), None
        self._folder = Path(given["save_dir"])
        self._enabled = given["enabled"] and self._make_folder()
        if not self._enabled:
            node.get_logger().info("Photo at waypoint plugin is disabled.")
            return
        topic = given["image_topic"]
        node.get_logger().info(f"Initializing photo at waypoint plugin, subscribing to camera topic named; {topic}")
        self.subscription = node.create_subscription(Image, topic, self._see, qos_profile_system_default)

    def _make_folder(self) -> bool:
        try:
            self._folder.mkdir(exist_ok=True)
        except OSError as fault:
            self._node.get_logger().error(
                f"Exception ({fault}) thrown while attempting to create image capture directory."
                " This task executor is being disabled as it cannot save images."
            )
            return False
        return True

    def _see(self, msg: Image) -> None:
        self._picture = msg

    async def process(self, pose: PoseStamped, number: int, stop: Stop) -> bool:
        """Save the picture; False if there is none."""
        log = self._node.get_logger()
        if not self._enabled:
            log.warning("Photo at waypoint plugin is disabled. Not performing anything")
            return True
        try:
            self._save(self._folder / f"{number}_{pose.header.stamp.sec}.{self._given['image_format']}")
        except Exception as fault:
            log.error(
                f"Couldn't take photo at waypoint {number}! Caught exception: {fault} \n"
                f"Make sure that the image topic named: {self._given['image_topic']} is valid and active!"
            )
            return False
        log.info(f"Photo has been taken sucessfully at waypoint {number}")  # nav2's spelling
        return True

    def _save(self, path: Path) -> None:
        import cv2
        from cv_bridge import CvBridge

        colors = "bgr8" if self._picture.encoding == "rgb8" else "passthrough"
        if not cv2.imwrite(str(path), CvBridge().imgmsg_to_cv2(self._picture, colors)):
            raise OSError(f"{path} cannot be written")


KINDS: dict[str, Any] = {
    f"nav2_waypoint_follower::{kind.__name__}": kind for kind in (WaitAtWaypoint, InputAtWaypoint, PhotoAtWaypoint)
}


def task_of(node: Node, name: str, foreign: CppPlugins) -> Task:
    """Return the task that the parameters under `name.` describe. Raises NoPlugin, CppFault."""
    plugin = declare(node, {"plugin": "nav2_waypoint_follower::WaitAtWaypoint"}, name)["plugin"]
    if plugin not in KINDS:
        return foreign.get(CppTask, name, plugin, KINDS)
    kind = KINDS[plugin]
    task: Task = kind(node, declare(node, kind.DEFAULTS, name))
    return task
