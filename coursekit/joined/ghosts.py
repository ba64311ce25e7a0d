"""Stand-ins for what is in the other interpreter: they match like the real thing and pass on what they are given.

A ghost needs no class of its interface, only its name: messages cross as CDR and are read where the real end is. Ghosts of
publishers do not repeat deadlines and leases: those are watched where the publisher is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from coursekit.core.graph import Graph, GraphNode
from coursekit.core.qos import Qos
from coursekit.core.service import Client, RequestId, Server
from coursekit.core.topic import Publisher, Subscription
from coursekit.interfaces import cdr

Tell = Callable[[list[Any], bytes], None]
"""Takes an event for the other side, and the bytes that belong to it."""
NumberOf = Callable[[Any], int]
"""Gives the number by which the other side knows one of ours."""


@dataclass(frozen=True)
class Named:
    """An interface of which only the name is known."""

    _TYPE_NAME: str


class GhostNode(GraphNode):
    """A node of the other interpreter."""


class GhostPublisher(Publisher):
    """Delivers what the real one published to subscriptions on this side."""

    def _watch_deadline(self) -> None:
        """The real one is watched where it is."""

    def deliver(self, target: Subscription, data: bytes, stamp: int) -> None:
        """Give one subscription the message in CDR bytes."""
        msg = cdr.deserialize(data, target.msg_type)
        target.push((msg if target.reduce is None else target.reduce(msg), stamp, self))


class GhostSubscription(Subscription):
    """Passes on what is published on this side."""

    number: int
    number_of: NumberOf
    tell: Tell

    def __init__(self, graph: Graph, node: GraphNode, name: str, msg_type: Any, qos: Qos) -> None:
        super().__init__(graph, node, name, msg_type, qos)
        self.reduce = cdr.serialize

    def push(self, entry: tuple[Any, int, Publisher]) -> None:
        """Send the message to the real subscription."""
        data, stamp, publisher = entry
        self.tell(["message", self.number_of(publisher), self.number, stamp, len(data)], data)

    def _check_deadline(self) -> None:
        """The real one is watched where it is."""


class GhostServer(Server):
    """Passes on the requests of clients on this side."""

    number: int
    number_of: NumberOf
    tell: Tell

    def push(self, request: Any, request_id: RequestId) -> None:
        """Send the request to the real server."""
        data = cdr.serialize(request)
        event = ["request", self.number_of(request_id.client), self.number, request_id.sequence_number, len(data)]
        self.tell(event, data)


class GhostClient(Client):
    """Passes on the responses of servers on this side."""

    number: int
    tell: Tell

    def push(self, sequence_number: int, response: Any) -> None:
        """Send the response to the real client."""
        data = cdr.serialize(response)
        self.tell(["response", self.number, sequence_number, len(data)], data)


KINDS: dict[str, type[Any]] = {
    "publisher": GhostPublisher,
    "subscription": GhostSubscription,
    "server": GhostServer,
    "client": GhostClient,
}
