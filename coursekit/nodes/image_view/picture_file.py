"""Pictures written to files, named by a pattern such as left%04i.%s."""

from __future__ import annotations

from typing import Any

import cv2
from rclpy.node import Node

from coursekit.processes.current_process import program_folder


def name_of(pattern: str, count: int) -> str:
    """Return the name of a picture: a pattern may ask for its number and for the ending, or for neither.

    >>> name_of("left%04i.%s", 7), name_of("frame%i.png", 7), name_of("last.jpg", 7)
    ('left0007.jpg', 'frame7.png', 'last.jpg')
    """
    for given in ((count, "jpg"), (count,), ()):
        try:
            return pattern % given
        except (TypeError, ValueError):
            continue
    return pattern


def save(node: Node, name: str, image: Any) -> bool:
    """Write a picture and log it. Returns whether that succeeded."""
    try:
        saved = cv2.imwrite(str(program_folder() / name), image)
    except cv2.error:  # an ending that is none
        saved = False
    if saved:
        node.get_logger().info(f"Saved image {name}")
    else:
        node.get_logger().error(f"Failed to save image to path {name}")
    return saved
