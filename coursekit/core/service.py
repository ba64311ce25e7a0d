"""Services: a request goes to every server of the service; the first response counts."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from .interface import Interface, Message
from .qos import Qos
from .topic import Endpoint

if TYPE_CHECKING:
    from .graph import Graph
    from .graph_node import GraphNode


@dataclass(frozen=True)
class RequestId:
    """The client of a request and the request's sequence number."""

    client: Client
    sequence_number: int


class Server(Endpoint):
    """The serving end: a queue of (request, RequestId).

    >>> from std_srvs.srv import SetBool
    >>> from coursekit.core.graph import Graph
    >>> from coursekit.core.virtual_clock import VirtualClock
    >>> node = Graph(VirtualClock()).add_node("gripper", "/")
    >>> server, client = node.server("/grip", SetBool, Qos()), node.client("/grip", SetBool, Qos())
    >>> number = client.send(SetBool.Request(data=True))
    >>> request, asked = server.take()
    >>> server.respond(asked, SetBool.Response(success=request.data, message="closed"))
    >>> client.take() == (number, SetBool.Response(success=True, message="closed"))
    True
    """

    __slots__ = ("queue",)

    def __init__(self, graph: Graph, node: GraphNode, name: str, srv_type: Interface, qos: Qos) -> None:
        super().__init__(graph, node, name, srv_type, qos)
        self.queue: deque[tuple[Any, RequestId]] = deque()

    def has_work(self) -> bool:
        """Whether a request is waiting."""
        return bool(self.queue)

    def take(self) -> tuple[Any, RequestId] | None:
        """Return the oldest request, or None."""
        try:
            return self.queue.popleft()
        except IndexError:
            return None

    def push(self, request: Message, request_id: RequestId) -> None:
        """Queue a request."""
        self.queue.append((request, request_id))
        self.signal()
        if self.listener is not None:
            self.listener(request)

    def respond(self, request_id: RequestId, response: Message) -> None:
        """Send a copy of `response` to the client of the request.

        A client of the same executor receives it after the messages published by the callback: topics come before responses.
        """
        request_id.client.yields = request_id.client.sink is self.sink
        request_id.client.push(request_id.sequence_number, response._clone())

    def close(self) -> None:
        """Leave the graph."""
        self.alive = False
        self.graph.remove_server(self)


class Client(Endpoint):
    """The calling end: a queue of (sequence number, response)."""

    __slots__ = ("_next_number", "queue")

    def __init__(self, graph: Graph, node: GraphNode, name: str, srv_type: Interface, qos: Qos) -> None:
        super().__init__(graph, node, name, srv_type, qos)
        self.queue: deque[tuple[int, Any]] = deque()
        self._next_number = 1

    def has_work(self) -> bool:
        """Whether a response is waiting."""
        return bool(self.queue)

    def take(self) -> tuple[int, Any] | None:
        """Return the oldest response, or None."""
        try:
            return self.queue.popleft()
        except IndexError:
            return None

    def push(self, sequence_number: int, response: Message) -> None:
        """Queue a response; a closed client drops it."""
        if self.alive:
            self.queue.append((sequence_number, response))
            self.signal()
            if self.listener is not None:
                self.listener(response)

    def send(self, request: Message) -> int:
        """Send copies of `request` to every server and return the request's number."""
        number = self._next_number
        self._next_number += 1
        for server in self.graph.servers_of(self):
            server.push(request._clone(), RequestId(self, number))
        return number

    def peek_number(self) -> int:
        """Return the sequence number of the next request."""
        return self._next_number

    def server_is_ready(self) -> bool:
        """Whether a server of this name and type exists."""
        return bool(self.graph.servers_of(self))

    def close(self) -> None:
        """Leave the graph."""
        self.alive = False
        self.graph.remove_client(self)
