"""The choice of topics to record."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rosidl_runtime_py.utilities import get_message

from coursekit.rcl.names import is_hidden

if TYPE_CHECKING:
    from rclpy.node import Node


class TopicFilter:
    """Decides for each topic in the graph whether it is recorded; warns once of a topic that cannot be recorded."""

    def __init__(self, options: Any, topics: list[str], node: Node) -> None:
        self._options = options
        self._topics = topics
        self._node = node
        self._warned: set[str] = set()
        self._wanted, self._unwanted = _expression(options.regex, "--regex"), _expression(options.exclude, "--exclude")

    def select(self) -> dict[str, str]:
        """The topics to record and their types, among those in the graph now."""
        topics = self._node.get_topic_names_and_types()
        return {name: types[0] for name, types in topics if types and self._takes(name, types)}

    def _takes(self, name: str, types: list[str]) -> bool:
        if not self._is_meant(name):
            return False
        if len(types) > 1:
            return self._refuse(
                name, f"Topic '{name}' has several types associated. Only topics with one type are supported"
            )
        return self._is_known(name, types[0])

    def _is_meant(self, name: str) -> bool:
        options = self._options
        named = name in self._topics
        if not (named or options.all or (self._wanted is not None and self._wanted(name))):
            return False
        if self._unwanted is not None and self._unwanted(name):
            return False
        published, heard = self._node.count_publishers(name), self._node.count_subscribers(name)
        if not published and not options.include_unpublished_topics:
            return False
        if options.ignore_leaf_topics and not (published and heard):
            return False
        if is_hidden(name) and not options.include_hidden_topics:
            text = "Hidden topics are not recorded. Enable them with --include-hidden-topics"
            return self._refuse("hidden", text)
        return True

    def _is_known(self, name: str, kind: str) -> bool:
        try:
            get_message(kind)
        except Exception as error:  # a definition may be invalid in many ways
            text = f"Topic '{name}' has unknown type '{kind}' associated. Only topics with known type are supported. "
            return self._refuse(name, f"{text}Reason: '{error}'")
        return True

    def _refuse(self, key: str, text: str) -> bool:
        if key not in self._warned:
            self._warned.add(key)
            self._node.get_logger().warning(text)
        return False


def _expression(text: str, flag: str) -> Callable[[str], Any] | None:
    if not text:
        return None
    try:
        return re.compile(text).search
    except re.error as error:
        raise RuntimeError(f"{flag} '{text}' is no regular expression: {error}") from None
