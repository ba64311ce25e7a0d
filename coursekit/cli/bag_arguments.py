"""The common parts of the verbs of `ros2 bag`: arguments, their validation, and error messages."""

from __future__ import annotations

import argparse
import functools
import math
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from coursekit.bag.errors import BagError
from coursekit.bag.metadata_file import load_settings
from coursekit.bag.storage import SUFFIXES
from coursekit.files import read_bytes

from . import api

if TYPE_CHECKING:
    from argparse import Namespace

_DURATIONS = ("deadline", "lifespan", "liveliness_lease_duration")
_VALUES = ("depth", "avoid_ros_namespace_conventions")


def refuse(text: str) -> api.Unhappy:
    """Return an error that ends the command, in Humble's words."""
    return api.Unhappy(f"[ERROR] [ros2bag]: {text}")


def refusing(main: Callable[[Any], int]) -> Callable[[Any], int]:
    """Make a verb report errors of a bag without a traceback."""

    @functools.wraps(main)
    def run(args: Namespace) -> int:
        try:
            return main(args)
        except BagError as error:
            raise refuse(str(error)) from None

    return run


def add_reader(parser: argparse.ArgumentParser) -> None:
    """Add the arguments `bag_path` and `-s`."""
    parser.add_argument("bag_path", type=existing_path, help="Bag to open")
    parser.add_argument(
        "-s",
        "--storage",
        default="",
        choices=sorted(SUFFIXES),
        help="Storage implementation of bag. By default attempts to detect automatically - use this argument to override.",
    )


def existing_path(value: str) -> str:
    """Validate a path that must exist."""
    try:
        exists = Path(value).exists()
    except (OSError, ValueError):
        exists = False
    if not exists:
        raise argparse.ArgumentTypeError(f"Bag path '{value}' does not exist!")
    return value


def readable_file(value: str) -> str:
    """Validate a file that must be readable, in the words of Humble's argparse.FileType."""
    try:
        read_bytes(value)
    except OSError as error:
        raise argparse.ArgumentTypeError(f"can't open '{value}': {error}") from None
    return value


def positive_float(value: str) -> float:
    """Parse a number above 0."""
    number = _number(value)
    if not number > 0.0 or math.isinf(number):
        raise argparse.ArgumentTypeError(f"{value} is not in the valid range (> 0.0)")
    return number


def not_negative_float(value: str) -> float:
    """Parse a number of at least 0."""
    number = _number(value)
    if not number >= 0.0 or math.isinf(number):
        raise argparse.ArgumentTypeError(f"Value {value} is less than zero.")
    return number


def _number(value: str) -> float:
    try:
        return float(value)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{value} is not the valid type (float)") from None


def not_negative_int(value: str) -> int:
    """Parse a whole number of at least 0."""
    try:
        number = int(value)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{value} is not the valid type (int)") from None
    if number < 0:
        raise argparse.ArgumentTypeError(f"Value {value} is less than zero.")
    return number


def qos_overrides(path: str | None) -> dict[str, Any]:
    """Read QoS profiles by topic from a YAML file; Unhappy in Humble's words."""
    from rclpy.qos import InvalidQoSProfileException

    if not path:
        return {}
    try:
        loaded = load_settings(Path(path)) or {}
        if not isinstance(loaded, dict) or not all(isinstance(profile, dict) for profile in loaded.values()):
            raise ValueError(f"{path} should have topics with their policies, for example: /chatter: {{depth: 5}}")
        return {str(topic): profile_of(values) for topic, values in loaded.items()}
    except (InvalidQoSProfileException, ValueError, AssertionError, BagError) as error:
        raise refuse(str(error)) from None


def profile_of(values: dict[str, Any]) -> Any:
    """Make a QoS profile from a dictionary of policies; ValueError for an unknown one.

    >>> profile_of({"reliability": "best_effort", "depth": 5}).reliability.name
    'BEST_EFFORT'
    """
    from rclpy import qos

    policies: dict[str, Any] = {}
    for key, value in values.items():
        if key in _DURATIONS:
            policies[key] = duration_of(value)
        elif key in ("history", "reliability", "durability", "liveliness"):
            kind = getattr(qos, f"{key.capitalize()}Policy")
            if str(value) not in kind.short_keys():
                raise ValueError(f"`{key}` is {value!r}; it can be {', '.join(kind.short_keys())}")
            policies[key] = kind[value.upper()]
        elif key in _VALUES:
            if not isinstance(value, int) or value < 0:
                raise ValueError(f"`{key}` may not be a negative value.")
            policies[key] = value
        else:
            raise ValueError(f"Unexpected key `{key}` for QoS profile.")
    return qos.QoSProfile(**policies)


def duration_of(value: Any) -> Any:
    """Make a duration from {sec: ..., nsec: ...}; ValueError when a key is missing or the duration is negative.

    >>> duration_of({"sec": 1, "nsec": 500_000_000}).nanoseconds
    1500000000
    """
    from rclpy.duration import Duration

    if not value:
        return Duration()
    if not isinstance(value, dict) or not {"sec", "nsec"} <= set(value):
        raise ValueError("Time overrides must include both seconds (sec) and nanoseconds (nsec).")
    if not all(isinstance(value[key], int) for key in ("sec", "nsec")):
        raise ValueError("Time overrides must be whole numbers.")
    nanoseconds = value["sec"] * 10**9 + value["nsec"]
    if nanoseconds < 0:
        raise ValueError("Time duration may not be a negative value.")
    return Duration(nanoseconds=min(nanoseconds, 2**63 - 1))
