"""The turtles' frames under the names of turtle_tf2_cpp: the same nodes, with what rclcpp gives to each node."""

from __future__ import annotations

import sys

from rclpy.logging import get_logger

from coursekit.nodes.cpp_node import as_cpp
from coursekit.nodes.running import run

from .broadcasters import DynamicFrameBroadcaster, FixedFrameBroadcaster, FramePublisher, StaticFramePublisher
from .drawer import PoseDrawer
from .listener import FrameListener

_WORDS = "child_frame_name x y z roll pitch yaw"


def turtle(args: list[str] | None = None) -> int:
    """Run turtle_tf2_broadcaster."""
    return run(as_cpp(FramePublisher), args)


def fixed(args: list[str] | None = None) -> int:
    """Run fixed_frame_tf2_broadcaster."""
    return run(as_cpp(FixedFrameBroadcaster), args)


def dynamic(args: list[str] | None = None) -> int:
    """Run dynamic_frame_tf2_broadcaster."""
    return run(as_cpp(DynamicFrameBroadcaster), args)


def listener(args: list[str] | None = None) -> int:
    """Run turtle_tf2_listener."""
    return run(as_cpp(FrameListener), args)


def drawer(args: list[str] | None = None) -> int:
    """Run turtle_tf2_message_filter."""
    return run(as_cpp(PoseDrawer), args)


def static(args: list[str] | None = None) -> int:
    """Run static_turtle_tf2_broadcaster, whose refusals the C++ program logs."""
    refused = ""
    if len(sys.argv) != 8:
        usage = f"ros2 run turtle_tf2_cpp static_turtle_tf2_broadcaster {_WORDS}"
        refused = f"Invalid number of parameters\nusage: {usage}"
    elif sys.argv[1] == "world":
        refused = "Your static turtle name cannot be 'world'"
    if refused:
        get_logger("logger").info(refused)
        return 1
    return run(lambda: as_cpp(StaticFramePublisher)(sys.argv[1], [float(word) for word in sys.argv[2:]]), args)
