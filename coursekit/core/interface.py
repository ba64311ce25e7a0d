"""What the graph needs of messages and of the types of topics and services, whoever made their classes."""

from __future__ import annotations

from typing import Protocol


class Interface(Protocol):
    """The type of a topic or service: in most cases the class of its messages.

    >>> from std_msgs.msg import String
    >>> kind: Interface = String
    >>> kind._TYPE_NAME
    'std_msgs/msg/String'
    """

    @property
    def _TYPE_NAME(self) -> str: ...


class Message(Protocol):
    """A message, a request or a response: it is copied on its way, so that no two nodes share it."""

    def _clone(self) -> Message: ...
