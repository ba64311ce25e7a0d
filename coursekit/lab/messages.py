"""Receiving a topic in a notebook: its type, a compatible quality of service, its messages as text."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from coursekit.cli.api import full_name
from coursekit.core.graph import Graph
from coursekit.core.interface import Message
from coursekit.suggestions import did_you_mean

from .errors import NotThere
from .panel_node import HiddenNode, appears

TRUNCATE = 128


def known_type(graph: Graph, topic: str) -> str:
    """Return the type of a topic in the graph; LookupError with similar names if it is missing or has several types."""
    appears(lambda: topic in dict(graph.topics()))
    types = dict(graph.topics()).get(topic)
    if not types:
        names = [name for name, _ in graph.topics()]
        hint = did_you_mean(topic, names, f"Topics are: {', '.join(names) or 'none'}.")
        raise NotThere(f"There is no topic {topic} in the graph: no node publishes or subscribes to it. {hint}")
    if len(types) > 1:
        raise NotThere(f"Topic {topic} is used with several types ({', '.join(types)}); let all nodes use one.")
    return types[0]


def listen(hidden: HiddenNode, topic: str, callback: Callable[[Any], None]) -> Any:
    """Subscribe with a quality of service compatible with the publishers. Returns the subscription."""
    from rclpy.qos import qos_profile_sensor_data
    from rosidl_runtime_py.utilities import get_message

    from coursekit.cli.topic_qos import fitting

    kind = get_message(known_type(hidden.graph, topic))
    publishers = hidden.node.get_publishers_info_by_topic(topic)
    profile = fitting(publishers)[0] if publishers else qos_profile_sensor_data
    return hidden.node.create_subscription(kind, topic, callback, profile)


def as_yaml(msg: Message) -> str:
    """Format a message as `ros2 topic echo` prints it; long arrays and texts are truncated.

    >>> from geometry_msgs.msg import Vector3
    >>> print(as_yaml(Vector3(x=1.0)), end="")
    x: 1.0
    y: 0.0
    z: 0.0
    """
    from rosidl_runtime_py import message_to_yaml

    return str(message_to_yaml(msg, truncate_length=TRUNCATE)).rstrip("\n")


def echo(topic: str, n: int = 1, timeout_sec: float = 10.0) -> None:
    """Print the next `n` messages of a topic, as `ros2 topic echo` does; TimeoutError when they do not arrive in time.

    >>> %ros2 run demo_nodes_py talker &
    [talker: running]
    >>> echo("/chatter")
    data: 'Hello World: 0'
    ---
    """
    hidden = HiddenNode("echo")
    heard: list[Message] = []
    enough = hidden.session.clock.new_event()

    def collect(msg: Message) -> None:
        heard.append(msg)
        if len(heard) >= n:
            enough.set()

    try:
        listen(hidden, full_name(topic), collect)
        enough.wait(timeout_sec)
    finally:
        hidden.close()
    for msg in heard[:n]:
        print(f"{as_yaml(msg)}\n---")
    if len(heard) < n:
        raise TimeoutError(
            f"{len(heard)} of {n} messages came on {topic} within {timeout_sec:g} s. "
            f"`graph()` shows its publishers, `%ros2 topic info -v {topic}` their quality of service."
        )


__all__ = ["as_yaml", "echo", "known_type", "listen"]
