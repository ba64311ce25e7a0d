"""Proxies for nodes and endpoints in the other interpreter: they match like real ones and forward their messages.

A ghost needs only the name of its interface, not its class: messages cross as CDR and are deserialized at the real
endpoint. Ghosts of publishers do not check deadlines and leases: the publisher's own side does.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from coursekit.core.graph import Graph
from coursekit.core.graph_node import GraphNode
from coursekit.core.qos import Qos
from coursekit.core.service import Client, RequestId, Server
from coursekit.core.topic import Publisher, Subscription
from coursekit.interfaces import cdr

Tell = Callable[[list[Any], bytes], None]
"""Callback for an event to the other side, with its bytes."""
NumberOf = Callable[[Any], int]
"""Returns the number by which the other side knows a local node or endpoint."""


@dataclass(frozen=True)
class Named:
    """An interface known only by its name."""

    _TYPE_NAME: str


class GhostNode(GraphNode):
    """A node of the other interpreter."""


class GhostPublisher(Publisher):
    """Delivers the messages of the remote publisher to local subscriptions."""

    def _watch_deadline(self) -> None:
        """Do nothing: the deadline is checked on the publisher's own side."""

    def deliver(self, target: Subscription, data: bytes, stamp: int) -> None:
        """Deliver a message in CDR bytes to one subscription."""
        msg = cdr.deserialize(data, target.msg_type)
        target.push((msg if target.reduce is None else target.reduce(msg), stamp, self))


class GhostSubscription(Subscription):
    """Forwards local messages to the remote subscription."""

    number: int
    number_of: NumberOf
    tell: Tell

    def __init__(self, graph: Graph, node: GraphNode, name: str, msg_type: Any, qos: Qos) -> None:
        super().__init__(graph, node, name, msg_type, qos)
        self.reduce = cdr.serialize

    def push(self, entry: tuple[Any, int, Publisher]) -> None:
        """Forward a message to the remote subscription."""
        data, stamp, publisher = entry
        self.tell(["message", self.number_of(publisher), self.number, stamp, len(data)], data)

    def _check_deadline(self) -> None:
        """Do nothing: the deadline is checked on the subscription's own side."""


class GhostServer(Server):
    """Forwards the requests of local clients to the remote server."""

    number: int
    number_of: NumberOf
    tell: Tell

    def push(self, request: Any, request_id: RequestId) -> None:
        """Forward a request to the remote server."""
        data = cdr.serialize(request)
        event = ["request", self.number_of(request_id.client), self.number, request_id.sequence_number, len(data)]
        self.tell(event, data)


class GhostClient(Client):
    """Forwards the responses of local servers to the remote client."""

    number: int
    tell: Tell

    def push(self, sequence_number: int, response: Any) -> None:
        """Forward a response to the remote client."""
        data = cdr.serialize(response)
        self.tell(["response", self.number, sequence_number, len(data)], data)


KINDS: dict[str, type[Any]] = {
    "publisher": GhostPublisher,
    "subscription": GhostSubscription,
    "server": GhostServer,
    "client": GhostClient,
}
