"""Publishing messages: with a form made from the topic's type, or from code."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from coursekit.cli.api import full_name
from coursekit.core.interface import Message
from coursekit.view.graph_facts import take

from .errors import BadArgument
from .form import filled, schema
from .messages import as_yaml, known_type
from .panel import Panel, static

DEPTH = 10
"""The depth of the publishers' queues."""


class MessagePublisher(Panel):
    """See `message_publisher`."""

    _esm = static("publisher.js", "form.js")
    _css = static("publisher.css", "form.css")

    def __init__(self, topic: str = "", type_name: str = "") -> None:
        super().__init__("message_publisher")
        self._chosen = full_name(topic) if topic else ""
        self._types = {self._chosen: type_name} if type_name else {}
        """The types of topics that are in the list though no node may have them: those asked for, and those published on."""
        self._publishers: dict[str, Any] = {}
        self._timer: Any = None
        self._last: Message | None = None
        self.count = 0
        """How many messages have been published."""
        self.hidden.graph.watch(self.changed)

    # -- from code

    def publish(self, topic: str = "", /, **fields: Any) -> None:
        """Publish a message on a topic, the chosen one by default; a nested field is given as a dict.

        Fields not given keep their defaults. LookupError: there is no such topic; ValueError: a field does not fit.
        """
        self._choose(topic)
        self._publish(self._chosen, self._message(fields))

    def repeat(self, rate: float, topic: str = "", /, **fields: Any) -> None:
        """Publish a message `rate` times a second until `stop`."""
        self._choose(topic)
        name, message = self._chosen, self._message(fields)
        if not 0.0 < rate <= 1000.0:
            raise BadArgument(f"The rate is more than 0 and at most 1000 Hz, not {rate}")
        self.stop()
        self._timer = self.hidden.node.create_timer(1.0 / rate, lambda: self._publish(name, message))
        self.changed()

    def stop(self) -> None:
        """End what `repeat` began."""
        if self._timer is not None:
            self.hidden.node.destroy_timer(self._timer)
            self._timer = None
            self.changed()

    def _choose(self, topic: str) -> None:
        self._chosen = full_name(topic) if topic else self._chosen

    def _message(self, fields: dict[str, Any]) -> Message:
        return filled(self._kind(self._chosen)(), fields)

    def _kind(self, topic: str) -> Any:
        from rosidl_runtime_py.utilities import get_message

        return get_message(self._types.get(topic) or known_type(self.hidden.graph, topic))

    def _publish(self, topic: str, message: Any) -> None:
        if topic not in self._publishers:
            self._publishers[topic] = self.hidden.node.create_publisher(type(message), topic, DEPTH)
            self._types[topic] = type(message)._TYPE_NAME
        self._publishers[topic].publish(message)
        self._last = message
        self.count += 1
        self.changed()

    # -- what is shown

    def _names(self) -> list[str]:
        return sorted({*take(self.hidden.graph).topics, *self._types})

    def text(self) -> str:
        """Return the topic, and the last message."""
        lines = [f"publishes on: {self._chosen or '(no topic)'}", f"published: {self.count}"]
        if self._last is not None:
            lines += [f"    {line}" for line in as_yaml(self._last).splitlines()]
        return "\n".join(lines)

    def shown(self) -> dict[str, Any]:
        """Return the topics, and the form of the chosen one."""
        names = self._names()
        if self._chosen not in names:
            self._chosen = names[0] if names else ""
        content: dict[str, Any] = {"topics": names, "chosen": self._chosen, "kind": "", "fields": []}
        content |= {"repeats": self._timer is not None, "count": self.count}
        try:
            kind = self._kind(self._chosen) if self._chosen else None
        except LookupError as error:
            return content | {"kind": str(error)}
        return content | ({"kind": kind._TYPE_NAME, "fields": schema(kind)} if kind else {})

    def on_choose(self, message: dict[str, Any]) -> None:
        """Select another topic."""
        self.stop()
        self._chosen = str(message.get("name", ""))
        self._push()

    def on_publish(self, message: dict[str, Any]) -> None:
        """Handle the button that publishes once."""
        self._tried(lambda fields: self.publish(**fields), message)

    def on_repeat(self, message: dict[str, Any]) -> None:
        """Handle the button that publishes again and again."""

        def repeat(fields: dict[str, Any]) -> None:
            self.repeat(float(message.get("rate") or 0.0), **fields)

        self._tried(repeat, message)

    def on_stop(self, message: dict[str, Any]) -> None:
        """Handle the button that ends it."""
        self.stop()

    def _tried(self, action: Callable[[dict[str, Any]], None], message: dict[str, Any]) -> None:
        try:
            action(dict(message.get("fields") or {}))
        except Exception as error:  # any input is possible; the panel shows its error
            self.tell(type="refused", text=str(error))

    def leave(self) -> None:
        """Stop publishing, and watching the graph."""
        self.stop()
        self.hidden.graph.unwatch(self.changed)


def message_publisher(topic: str = "", type_name: str = "") -> MessagePublisher:
    """Show a form to publish messages on a topic, once or again and again; `.publish(**fields)` from code.

    `type_name` is needed for a topic that no node has yet, such as `message_publisher("/speed", "std_msgs/msg/Float64")`.

    >>> %ros2 run turtlesim turtlesim_node &
    [turtlesim_node: running]
    >>> form = message_publisher("/turtle1/cmd_vel")
    >>> form.publish(linear={"x": 1.0})
    >>> form.count
    1

    In ROS 2: `ros2 topic pub`, or rqt's message publisher.
    """
    return MessagePublisher(topic, type_name)


__all__ = ["MessagePublisher", "message_publisher"]
