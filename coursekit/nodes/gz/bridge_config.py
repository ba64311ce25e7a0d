"""Which topics to bridge: command-line arguments, or a YAML file."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import yaml

from coursekit.files import read_text

SIGNS = {"]": "ROS_TO_GZ", "[": "GZ_TO_ROS", "@": "BIDIRECTIONAL"}
DIRECTIONS = ("BIDIRECTIONAL", "GZ_TO_ROS", "ROS_TO_GZ")


@dataclass(frozen=True)
class Bridged:
    """One topic on both sides, or a service if the type contains `/srv/`."""

    ros_topic: str
    ros_type: str
    gz_topic: str
    gz_type: str
    direction: str = "BIDIRECTIONAL"
    lazy: bool = False
    publisher_queue: int = 10
    subscriber_queue: int = 10

    @property
    def is_service(self) -> bool:
        """Whether it is a service."""
        return "/srv/" in self.ros_type


def of_word(word: str, lazy: bool = False) -> Bridged:
    """Parse `TOPIC@ROS_TYPE@GZ_TYPE`; in place of the second @, `[` is Gazebo to ROS only, `]` ROS to Gazebo only.

    Raises ValueError.

    >>> of_word("/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan").direction
    'GZ_TO_ROS'
    """
    topic, _, rest = word.partition("@")
    sign = next((mark for mark in SIGNS if mark in rest), "@")
    (ros_type, _, gz_type), direction = rest.partition(sign), SIGNS[sign]
    if "/srv/" in ros_type:
        if direction != "BIDIRECTIONAL":
            raise ValueError(f"'{word}': a service has no direction; write SERVICE@ROS_TYPE")
        return Bridged(topic, ros_type, topic, gz_type)
    gz_type, _, gz_topic = gz_type.partition("@")
    if not (topic and ros_type and gz_type) or "@" in gz_topic:
        raise ValueError(f"'{word}' is no bridge; write TOPIC@ROS_TYPE@GZ_TYPE, or [ or ] in place of the second @")
    return Bridged(topic, ros_type, gz_topic or topic, gz_type, direction, lazy)


def of_file(name: str) -> tuple[list[Bridged], list[str]]:
    """Return the bridges in a YAML file, and the errors in the invalid ones."""
    try:
        text = read_text(name)
    except (OSError, UnicodeDecodeError) as error:
        return [], [f"Could not parse config: failed to open file [{name}] ({error})"]
    if not text.strip():
        return [], [f"Could not parse config: file empty [{name}]"]
    try:
        rows = yaml.safe_load(text)
    except (yaml.YAMLError, RecursionError, ValueError) as error:
        return [], [f"Could not parse config: {error}"]
    if not isinstance(rows, list):
        return [], ["Could not parse config: top level must be a YAML sequence"]
    bridges, faults = [], []
    for row in rows:
        try:
            bridges.append(_of_row(row))
        except ValueError as error:
            faults.append(f"Could not parse entry: {error}")
    return bridges, faults


def _of_row(row: Any) -> Bridged:
    if not isinstance(row, dict):
        raise ValueError("entry must be a YAML map")
    if row.get("service_name"):
        name, kind = str(row["service_name"]), str(row.get("ros_type_name") or "")
        if "/srv/" not in kind:
            raise ValueError("service_name needs a ros_type_name with /srv/")
        return Bridged(name, kind, name, "")
    names = ("topic_name", "ros_topic_name", "gz_topic_name", "ros_type_name", "gz_type_name", "direction")
    both, ros, gz, ros_type, gz_type, direction = (str(row.get(name) or "") for name in names)
    for other, name in ((ros, names[1]), (gz, names[2])):
        if both and other:
            raise ValueError(f"topic_name and {name} are mutually exclusive")
    if not (ros_type and gz_type):
        raise ValueError("both ros_type_name and gz_type_name must be set")
    if direction and direction not in DIRECTIONS:
        raise ValueError(f"invalid direction [{direction}]; there are {', '.join(DIRECTIONS)}")
    if not (both or ros or gz):
        raise ValueError("one of topic_name, ros_topic_name and gz_topic_name must be set")
    try:
        queues = int(row.get("publisher_queue", 10)), int(row.get("subscriber_queue", 10))
    except (TypeError, ValueError):
        raise ValueError("publisher_queue and subscriber_queue are whole numbers") from None
    way, lazy = direction or "BIDIRECTIONAL", bool(row.get("lazy", False))
    return Bridged(ros or both or gz, ros_type, gz or both or ros, gz_type, way, lazy, *queues)


__all__ = ["DIRECTIONS", "Bridged", "of_file", "of_word"]
