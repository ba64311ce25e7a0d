"""`ros2 run rqt_image_view rqt_image_view [TOPIC]`: shows an image topic in a window."""

from __future__ import annotations

import sys
from typing import Any

import cv2
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from rclpy.utilities import remove_ros_args

from coursekit.nodes.images.transport import TRANSPORTS, to_bgr

_BY_NAME = {type_._TYPE_NAME: type_ for type_ in TRANSPORTS.values()}
_OWN = "rqt_image_view"


class ImageViewer(Node):
    """Shows the given topic, or the first image topic that somebody publishes."""

    def __init__(self, topic: str | None) -> None:
        super().__init__(_OWN)
        self._wanted = None if topic is None else self.resolve_topic_name(topic)
        self._topic = ""
        self._search = self.create_timer(0.2, self._look)

    def _look(self) -> None:
        for name, types in self.get_topic_names_and_types():
            kind = next((_BY_NAME[type_name] for type_name in types if type_name in _BY_NAME), None)
            if kind is None or self._wanted not in (None, name) or not self.count_publishers(name):
                continue
            self._search.cancel()
            self._topic = name
            self.create_subscription(kind, name, self._show, qos_profile_sensor_data)
            return

    def _show(self, msg: Any) -> None:
        cv2.imshow(self._topic, to_bgr(msg))

    def close(self) -> None:
        """Close the window."""
        if self._topic and cv2.getWindowProperty(self._topic, cv2.WND_PROP_VISIBLE) > 0:
            cv2.destroyWindow(self._topic)


def main(args: list[str] | None = None) -> None:
    """Show until Ctrl-C."""
    words = remove_ros_args(sys.argv if args is None else args)[1:]
    rclpy.init(args=args)
    node = ImageViewer(words[0] if words else None)
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.close()
        node.destroy_node()
        rclpy.try_shutdown()
