"""`ros2 run ros_gz_image image_bridge TOPIC ...`: brings camera images from the newer Gazebo to ROS."""

from __future__ import annotations

import sys
from typing import Any

from rclpy.utilities import remove_ros_args

from .bridge import run
from .bridge_config import Bridged


def main(args: list[str] | None = None) -> Any:
    """Bridge the topics given on the command line, each lazily. Returns 255 if there is none."""
    topics = remove_ros_args(list(args if args is not None else sys.argv))[1:]
    if not topics:
        print("Usage: image_bridge <topic> ..: their pictures of Gazebo, under the same names in ROS", file=sys.stderr)
        return 255
    kinds = "sensor_msgs/msg/Image", "gz.msgs.Image"
    return run([Bridged(topic, kinds[0], topic, kinds[1], "GZ_TO_ROS", lazy=True) for topic in topics], args)
