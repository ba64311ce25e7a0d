"""Keeps two graphs in step: sends local changes to the other side, and creates ghosts for remote nodes and endpoints."""

from __future__ import annotations

import itertools
import threading
from collections.abc import Callable, Iterator
from dataclasses import astuple
from typing import Any

from coursekit.core.graph import Graph
from coursekit.core.graph_node import GraphNode
from coursekit.core.qos import Qos
from coursekit.core.service import Client, RequestId, Server
from coursekit.core.topic import Endpoint, Publisher, Subscription
from coursekit.interfaces import cdr

from .ghosts import KINDS, GhostClient, GhostNode, GhostPublisher, Named

MOST = 20_000
"""Maximum number of the other side's nodes and endpoints."""


class Mirror:
    """One side's view: `collect` returns the events for the other side, `apply` processes the other side's events.

    `on_news()` is called, from any thread, when there are events to collect.
    """

    def __init__(self, graph: Graph, on_news: Callable[[], None] = lambda: None) -> None:
        self.graph = graph
        self._on_news = on_news
        self._lock = threading.RLock()
        """Protects this object's tables only. Never held during changes of the graph: their caller may hold its lock."""
        self._events: list[list[Any]] = []
        self._bodies: list[bytes] = []
        self._numbers: dict[Any, int] = {}
        """The numbers of the local nodes and endpoints that the other side knows."""
        self._ours: dict[int, Any] = {}
        self._theirs: dict[int, Any] = {}
        self._count = itertools.count(1)
        self._stale = True
        graph.watch(self._note_change)

    def post(self, event: list[Any], body: bytes = b"") -> None:
        """Send an event with the next exchange."""
        with self._lock:
            self._events.append(event)
            self._bodies.append(body)
        self._on_news()

    def collect(self) -> tuple[list[list[Any]], bytes]:
        """Return the changes that the other side does not know yet."""
        with self._lock:
            if self._stale:
                self._stale = False
                self._tell_changes()
            events, body = self._events, b"".join(self._bodies)
            self._events, self._bodies = [], []
        return events, body

    def end(self) -> None:
        """Remove the other side's nodes and endpoints from this graph, because it is gone."""
        self.graph.unwatch(self._note_change)
        for ghost in list(self._theirs.values()):
            ghost.close()
        self._theirs.clear()

    def apply(self, events: list[list[Any]], body: bytes) -> list[list[Any]]:
        """Apply the other side's events; return those that do not concern the graph.

        Raises:
            LookupError, TypeError, ValueError: for malformed events.
        """
        rest, at = [], 0
        for event in events:
            kind, *facts = event
            if kind in ("message", "request", "response"):
                size = int(facts.pop())
                if size < 0 or at + size > len(body):
                    raise ValueError("a message is longer than what was sent")
                getattr(self, f"_on_{kind}")(*facts, body[at : at + size])
                at += size
            elif kind in ("node", "endpoint", "gone"):
                getattr(self, f"_on_{kind}")(*facts)
            else:
                rest.append(event)
        return rest

    # -- local changes

    def _note_change(self) -> None:
        self._stale = True
        self._on_news()

    def _number_of(self, thing: Any) -> int:
        """Return the number of a local node or endpoint; one that is new to the other side is announced first."""
        with self._lock:
            number = self._numbers.get(thing)
            if number is None:
                self._stale = True  # it may have left the graph since: checked at the next exchange
                number = self._numbers[thing] = next(self._count)
                self._ours[number] = thing
                self.post(self._told(thing, number))
        return number

    def _told(self, thing: Any, number: int) -> list[Any]:
        if isinstance(thing, GraphNode):
            return ["node", number, thing.name, thing.namespace]
        node = self._number_of(thing.node)
        return ["endpoint", number, _kind_of(thing), node, thing.name, thing.type_name, list(astuple(thing.qos))]

    def _tell_changes(self) -> None:
        there = dict.fromkeys(self._local())
        for endpoint in there:
            self._number_of(endpoint)
        for gone in [gone for gone in self._numbers if gone not in there]:
            number = self._numbers.pop(gone)
            del self._ours[number]
            self.post(["gone", number])

    def _local(self) -> Iterator[Any]:
        for node in list(self.graph.nodes):
            if not isinstance(node, GhostNode) and not node.remote:  # the other side can join the network itself
                yield node
                yield from (*node.publishers, *node.subscriptions, *node.servers, *node.clients)

    # -- remote changes

    def _on_node(self, number: int, name: str, namespace: str) -> None:
        if len(self._theirs) >= MOST or number in self._theirs:
            raise ValueError("more nodes than there can be")
        self._theirs[number] = self.graph.enter(GhostNode(self.graph, str(name), str(namespace)))

    def _on_endpoint(self, number: int, kind: str, node: int, name: str, type_name: str, qos: list[int]) -> None:
        owner = self._theirs[node]
        if len(self._theirs) >= MOST or number in self._theirs or not isinstance(owner, GhostNode):
            raise ValueError("more ends of topics than there can be")
        profile = Qos(*(int(value) for value in qos))
        ghost: Any = KINDS[kind](self.graph, owner, str(name), Named(str(type_name)), profile)
        if kind != "publisher":
            ghost.number, ghost.tell = number, self.post
        if kind in ("subscription", "server"):
            ghost.number_of = self._number_of
        self._theirs[number] = ghost
        getattr(self.graph, f"add_{kind}")(ghost)

    def _on_gone(self, number: int) -> None:
        ghost = self._theirs.pop(number)
        ghost.close()

    def _on_message(self, publisher: int, subscription: int, stamp: int, data: bytes) -> None:
        ghost, target = self._theirs.get(publisher), self._ours.get(subscription)
        if isinstance(ghost, GhostPublisher) and isinstance(target, Subscription) and _same_topic(ghost, target):
            ghost.deliver(target, data, int(stamp))

    def _on_request(self, client: int, server: int, number: int, data: bytes) -> None:
        ghost, target = self._theirs.get(client), self._ours.get(server)
        if isinstance(ghost, GhostClient) and isinstance(target, Server) and _same_topic(ghost, target):
            request = cdr.deserialize(data, target.msg_type.Request)
            target.push(request, RequestId(ghost, int(number)))

    def _on_response(self, client: int, number: int, data: bytes) -> None:
        target = self._ours.get(client)
        if isinstance(target, Client):
            target.push(int(number), cdr.deserialize(data, target.msg_type.Response))


def _kind_of(end: Endpoint) -> str:
    kinds = {Publisher: "publisher", Subscription: "subscription", Server: "server", Client: "client"}
    return next(name for kind, name in kinds.items() if isinstance(end, kind))


def _same_topic(one: Endpoint, other: Endpoint) -> bool:
    return (one.name, one.type_name) == (other.name, other.type_name)
