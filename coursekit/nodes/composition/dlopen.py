"""`ros2 run composition dlopen_composition LIBRARY...`: one process with the nodes of libraries, given or linked."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import rclpy
from rclpy.logging import get_logger
from rclpy.node import Node
from rclpy.utilities import remove_ros_args

from coursekit.nodes.composition.nodes import Client, Server
from coursekit.nodes.cpp_node import as_cpp
from coursekit.nodes.demo_nodes.listener import Listener
from coursekit.nodes.demo_nodes.talker import Talker
from coursekit.nodes.running import spin_to_the_end, terminate

_LIBRARY = re.compile(r"(?:lib)?(\w+)_component\.(?:so|dylib|dll)")
_CLASSES: dict[str, tuple[str, Callable[[], Node]]] = {
    "talker": ("composition::Talker", lambda: as_cpp(Talker)(1, "'")),
    "listener": ("composition::Listener", as_cpp(Listener)),
    "node_like_listener": ("composition::NodeLikeListener", as_cpp(Listener)),
    "server": ("composition::Server", Server),
    "client": ("composition::Client", Client),
}
"""The Python class for each of the demo's libraries, so no library is opened."""
_LINKED = ("client", "listener", "server", "talker")


def component_of(library: str) -> tuple[str, Callable[[], Node]] | None:
    """Return the component class of a demo library by its file name, and its constructor; None for others.

    >>> component_of("/opt/ros/humble/lib/libserver_component.so")
    ('composition::Server', <class 'coursekit.nodes.composition.nodes.Server'>)
    """
    match = _LIBRARY.fullmatch(Path(library).name)
    return _CLASSES.get(match[1]) if match else None


def main(args: list[str] | None = None) -> int:
    """Load the libraries and run their nodes until Ctrl-C."""
    libraries = remove_ros_args(sys.argv if args is None else args)[1:]
    if not libraries:
        print("Requires at least one argument to be passed with the library to load", file=sys.stderr)
        return 1
    rclpy.init(args=args)
    log, nodes = get_logger("dlopen_composition"), []
    for library in libraries:
        log.info(f"Load library {library}")
        component = component_of(library)
        if component is None:
            return terminate(_unknown(library), "class_loader::LibraryLoadException")
        nodes.append(_instance(log, *component))
    return spin_to_the_end(*nodes)


def linked(args: list[str] | None = None) -> int:
    """Run the nodes of the libraries that linktime_composition is linked with: those are under an empty name."""
    rclpy.init(args=args)
    log = get_logger("linktime_composition")
    log.info("Load library ")
    return spin_to_the_end(*(_instance(log, *_CLASSES[name]) for name in _LINKED))


def _instance(log: Any, name: str, make: Callable[[], Node]) -> Node:
    log.info(f"Instantiate class rclcpp_components::NodeFactoryTemplate<{name}>")
    return make()


def _unknown(library: str) -> str:
    known = ", ".join(f"lib{name}_component.so" for name in _CLASSES)
    return f"Could not load library {library}: no C++ library can be opened here; programs stand for {known}"
