"""The topics of the graph: types, counts, and, for watched topics, the rate and the last message."""

from __future__ import annotations

from collections import deque
from typing import Any

from coursekit.cli.api import full_name
from coursekit.core.interface import Message
from coursekit.view.graph_facts import nodes_at, take, types_of

from .messages import as_yaml, listen
from .panel import Panel, static

WINDOW = 50
"""The number of messages over which the rate is averaged."""
SILENT_SECONDS = 2.0
"""A topic silent for this long [s], and for three times its period, has a rate of 0."""


class Watch:
    """One watched topic: the arrival times of its last messages, and the last message."""

    def __init__(self, panel: TopicPanel, topic: str) -> None:
        self._panel = panel
        self._times: deque[int] = deque(maxlen=WINDOW)
        self.count = 0
        self.last: Message | None = None
        self.subscription = listen(panel.hidden, topic, self._hear)

    def _hear(self, msg: Message) -> None:
        self._times.append(self._panel.session.clock.steady())
        self.count += 1
        self.last = msg
        self._panel.changed()

    def rate(self) -> float:
        """Return the messages per second; 0 when there are none."""
        times = list(self._times)
        if len(times) < 2 or times[-1] == times[0]:
            return 0.0
        period = (times[-1] - times[0]) * 1e-9 / (len(times) - 1)
        silent = (self._panel.session.clock.steady() - times[-1]) * 1e-9
        return 0.0 if silent > max(SILENT_SECONDS, 3 * period) else 1.0 / period


class TopicPanel(Panel):
    """See `topic_panel`."""

    _esm = static("topics.js")
    _css = static("topics.css")

    def __init__(self, *topics: str) -> None:
        super().__init__("topic_panel")
        self._watched: dict[str, Watch] = {}
        self.hidden.graph.watch(self.changed)
        try:
            for topic in topics:
                self.watch(topic)
        except LookupError:
            self.close()
            raise

    def watch(self, topic: str) -> None:
        """Measure the rate of a topic and keep its last message; LookupError when there is no such topic."""
        name = full_name(topic)
        if name not in self._watched:
            self._watched[name] = Watch(self, name)
            self.changed()

    def unwatch(self, topic: str) -> None:
        """Stop watching a topic."""
        watched = self._watched.pop(full_name(topic), None)
        if watched is not None:
            self.hidden.node.destroy_subscription(watched.subscription)
            self.changed()

    def rate(self, topic: str) -> float:
        """Return the rate of a watched topic in Hz; 0 while it is silent."""
        return self._watched[full_name(topic)].rate()

    def last(self, topic: str) -> Message | None:
        """Return the last message of a watched topic; None before the first."""
        return self._watched[full_name(topic)].last

    # -- what is shown

    def _rows(self) -> list[dict[str, Any]]:
        facts = take(self.hidden.graph)
        return [
            {
                "name": name,
                "type": ", ".join(types_of(name, facts.publishers, facts.subscriptions)),
                "publishers": len(nodes_at(name, facts.publishers)),
                "subscribers": len(nodes_at(name, facts.subscriptions)),
                **self._heard(name),
            }
            for name in facts.topics
        ]

    def _heard(self, name: str) -> dict[str, Any]:
        watched = self._watched.get(name)
        if watched is None:
            return {"watched": False}
        last = as_yaml(watched.last) if watched.last is not None else ""
        return {"watched": True, "rate": watched.rate(), "count": watched.count, "last": last}

    def shown(self) -> dict[str, Any]:
        """Return the rows of the table."""
        rows = self._rows()
        if any(row.get("rate") for row in rows):
            self.look_again(1.5)  # a rate must fall to zero when the topic falls silent
        return {"rows": rows}

    def text(self) -> str:
        """Return a line for each topic; for watched topics with rate and last message."""
        rows = self._rows()
        lines = [f"topics: {len(rows)}"]
        for row in rows:
            ends = f"{row['publishers']} -> {row['subscribers']}"
            rate = f"  {row['rate']:.2f} Hz" if row["watched"] else ""
            lines.append(f"{row['name']} [{row['type']}] {ends}{rate}")
            if row["watched"]:
                lines += [f"    {line}" for line in row["last"].splitlines()]
        return "\n".join(lines)

    def on_watch(self, message: dict[str, Any]) -> None:
        """Handle a watch checkbox."""
        name = str(message.get("name", ""))
        try:
            self.watch(name) if message.get("on") else self.unwatch(name)
        except LookupError as error:
            self.tell(type="error", text=str(error))

    def leave(self) -> None:
        """Stop watching the graph."""
        self.hidden.graph.unwatch(self.changed)


def topic_panel(*topics: str) -> TopicPanel:
    """Show the topics with their types and counts; the named topics are watched: rate and last message.

    >>> %ros2 run demo_nodes_py talker &
    [talker: running]
    >>> table = topic_panel("/chatter")
    >>> wait(3)
    >>> table
    topics: 1
    /chatter [std_msgs/msg/String] 1 -> 0  1.00 Hz
        data: 'Hello World: 2'

    In ROS 2: `ros2 topic list -t`, `ros2 topic hz`, `ros2 topic echo`, or the topic monitor of rqt.
    """
    return TopicPanel(*topics)


__all__ = ["TopicPanel", "topic_panel"]
