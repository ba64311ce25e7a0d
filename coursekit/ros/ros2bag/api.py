"""Arguments of `ros2 bag`, and the QoS profiles in its files."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy.duration import Duration
from rclpy.qos import QoSProfile

from coursekit.cli import bag_arguments

if TYPE_CHECKING:
    from argparse import ArgumentParser


def print_error(string: str) -> str:
    """The text of an error as `ros2 bag` prints it.

    >>> print_error("no bag")
    '[ERROR] [ros2bag]: no bag'
    """
    return f"[ERROR] [ros2bag]: {string}"


def dict_to_duration(time_dict: dict[str, int] | None) -> Duration:
    """The duration of {sec: ..., nsec: ...}; raises ValueError if a key is missing or the duration is negative.

    >>> dict_to_duration({"sec": 1, "nsec": 5}).nanoseconds
    1000000005
    """
    return bag_arguments.duration_of(time_dict)


def interpret_dict_as_qos_profile(qos_profile_dict: dict[str, Any]) -> QoSProfile:
    """The profile of a dictionary of policies; raises ValueError for an unknown policy."""
    return bag_arguments.profile_of(qos_profile_dict)


def convert_yaml_to_qos_profile(qos_profile_dict: dict[str, dict[str, Any]]) -> dict[str, QoSProfile]:
    """The profiles of several topics."""
    return {topic: bag_arguments.profile_of(values) for topic, values in qos_profile_dict.items()}


def check_path_exists(value: str) -> str:
    """A path that exists, for argparse."""
    return bag_arguments.existing_path(value)


def check_positive_float(value: str) -> float:
    """A number above 0, for argparse."""
    return bag_arguments.positive_float(value)


def check_not_negative_int(value: str) -> int:
    """A whole number of 0 or more, for argparse."""
    return bag_arguments.not_negative_int(value)


def add_standard_reader_args(parser: ArgumentParser) -> None:
    """Add the arguments for the bag's path and its storage."""
    bag_arguments.add_reader(parser)
