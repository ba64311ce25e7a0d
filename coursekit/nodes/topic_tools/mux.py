"""`ros2 run topic_tools mux OUTTOPIC INTOPIC1 [INTOPIC2...]`: republishes one of several topics, selected by a service."""

from __future__ import annotations

from typing import Any

from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String
from topic_tools_interfaces.srv import MuxAdd, MuxDelete, MuxList, MuxSelect

from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.topic_tools.tool import DISCOVERY_SECONDS, run_tool, source_of

NONE = "__none"


class Mux(Node):
    """Subscribes to the selected topic; ~/select, ~/add, ~/delete and ~/list change and show the topics."""

    def __init__(self, words: list[str]) -> None:
        super().__init__("mux")
        topics = [""] if len(words) < 2 else words[1:]
        given = declare(self, {"output_topic": words[0] if words else "~/selected_topic", "input_topics": topics})
        self.topics = [self.resolve_topic_name(topic) for topic in given["input_topics"] if topic]
        if not self.topics:
            raise ValueError("mux needs topics: ros2 run topic_tools mux OUTTOPIC INTOPIC1 [INTOPIC2...]")
        first = declare(self, {"initial_topic": "", "lazy": False})["initial_topic"]
        self.output_topic = given["output_topic"]
        self._mouth: Any = None
        self._ear: Any = None
        kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self._told: Any = self.create_publisher(String, "~/selected", kept)
        self._offer()
        self._choose(NONE if first == NONE else self.resolve_topic_name(first) if first else self.topics[0])
        self.create_timer(DISCOVERY_SECONDS, self._look)

    def _offer(self) -> None:
        self.create_service(MuxSelect, "~/select", self._select)
        self.create_service(MuxAdd, "~/add", self._add)
        self.create_service(MuxDelete, "~/delete", self._delete)
        self.create_service(MuxList, "~/list", self._list)

    def _choose(self, topic: str) -> None:
        """Select another topic."""
        self.selected = topic
        if self._ear is not None:
            self.destroy_subscription(self._ear)
            self._ear = None
        self._told.publish(String(data=topic))
        self._look()

    def _look(self) -> None:
        """Subscribe to the selected topic once it has a publisher."""
        if self._ear is not None or self.selected == NONE:
            return
        source = source_of(self, self.selected)
        if source is not None:
            kind, qos = source
            if self._mouth is None:
                self._mouth = self.create_publisher(kind, self.output_topic, 10)
            self._ear = self.create_subscription(kind, self.selected, self._mouth.publish, qos, raw=True)

    # -- services

    def _select(self, request: Any, response: Any) -> Any:
        wanted = NONE if request.topic == NONE else self.resolve_topic_name(request.topic)
        response.prev_topic, response.success = self.selected, wanted == NONE or wanted in self.topics
        if response.success:
            self._choose(wanted)
        else:
            self.get_logger().warning(f"Failed to switch to non-existing topic {wanted} in mux.")
        return response

    def _add(self, request: Any, response: Any) -> Any:
        wanted = self.resolve_topic_name(request.topic)
        response.success = request.topic != NONE and wanted not in self.topics
        if response.success:
            self.topics.append(wanted)
        else:
            self.get_logger().warning(f"Tried to add a topic that mux was already listening to: [{wanted}], or {NONE}.")
        return response

    def _delete(self, request: Any, response: Any) -> Any:
        wanted = self.resolve_topic_name(request.topic)
        response.success = wanted in self.topics and wanted != self.selected
        if response.success:
            self.topics.remove(wanted)
        else:
            self.get_logger().warning(f"Tried to delete the selected topic, or one that is not there: {wanted}.")
        return response

    def _list(self, _request: Any, response: Any) -> Any:
        response.topics = list(self.topics)
        return response


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run_tool(Mux, args)
