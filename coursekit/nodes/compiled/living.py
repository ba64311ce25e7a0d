"""Nodes and contexts that live: rclcpp refuses to make anything before init() and after shutdown()."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy.exceptions import NotInitializedException

from coursekit.nodes.compiled.frames import Unpacker

if TYPE_CHECKING:
    from rclpy.context import Context

    from coursekit.nodes.compiled.host import Host


class RCLError(Exception):
    """What rclcpp throws under that name."""


def living_node(host: Host, frame: Unpacker, what: str) -> Any:
    """The node that a question names, to make something on it; RCLError where its context has ended."""
    node = host.things[frame.integer()]
    if not node.context.ok():
        raise RCLError(f"could not create {what}: rcl node's context is invalid, at ./src/rcl/node.c:428")
    return node


def living_context(host: Host, frame: Unpacker) -> Context:
    """The context that a question names, to make an executor in it; NotInitializedException where it does not live."""
    context = host.context_called(frame.integer())
    if not context.ok():
        raise NotInitializedException("cannot create executor")
    return context
