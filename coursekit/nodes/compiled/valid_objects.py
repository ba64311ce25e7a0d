"""Access to valid nodes and contexts: rclcpp refuses to make objects before init() and after shutdown()."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy.exceptions import NotInitializedException

from coursekit.nodes.compiled.frames import Unpacker

if TYPE_CHECKING:
    from rclpy.context import Context
    from rclpy.node import Node

    from coursekit.nodes.compiled.host import Host


class RCLError(Exception):
    """rclcpp's exception of that name."""


class InvalidNodeError(Exception):
    """rclcpp's exception of that name."""


def check_node_of_client(node: Node) -> None:
    """Raise InvalidNodeError if a client's node, whose graph would tell of servers, has been destroyed."""
    if not node.handle.valid:
        raise InvalidNodeError("node is invalid")


def living_node(host: Host, frame: Unpacker, what: str) -> Any:
    """Return the node of a request for making an entity; RCLError if its context has ended."""
    node = host.things[frame.integer()]
    if not node.context.ok():
        raise RCLError(f"could not create {what}: rcl node's context is invalid, at ./src/rcl/node.c:428")
    return node


def check_context_of_timer(node: Node) -> None:
    """Raise RCLError if the context of a timer's node has ended."""
    if not node.context.ok():
        raise RCLError(
            "Couldn't initialize rcl timer handle: the given context is not valid, "
            "either rcl_init() was not called or rcl_shutdown() was called., at ./src/rcl/guard_condition.c:67"
        )


def living_context(host: Host, frame: Unpacker) -> Context:
    """Return the context of a request for making an executor; NotInitializedException if it is not valid."""
    context = host.context_called(frame.integer())
    if not context.ok():
        raise NotInitializedException("cannot create executor")
    return context
