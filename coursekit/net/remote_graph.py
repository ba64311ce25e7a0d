"""Adds the announcements of peers to this graph, and receives the messages for local subscriptions."""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator
from typing import Any

from coursekit.core.graph_node import GraphNode
from coursekit.core.topic import Subscription
from coursekit.processes.current_process import outside

from .announcements import INSIDE, local_nodes
from .calls import Questions
from .link_context import LinkContext
from .receiving import Receiver
from .remote import RemoteClient, RemotePublisher, RemoteServer, RemoteSubscription, is_latched
from .wire.attachment import Attachment
from .wire.token import NODE, PUBLISHER, SERVER, SUBSCRIPTION, Token, gid_of, read_token

MOST = 20_000
"""Maximum number of announcements."""


class RemoteGraph:
    """Remote nodes and endpoints; all calls come from one thread, in the order in which announcements arrive."""

    def __init__(self, place: LinkContext, *, listen_only: bool) -> None:
        self._place = place
        self._listen_only = listen_only
        self._things: dict[str, Any] = {}
        self._nodes: dict[tuple[str, str], GraphNode] = {}
        self._ends_of_node: dict[tuple[str, str], int] = {}
        self._receivers: dict[tuple[str, str], Receiver] = {}
        self._questions: dict[str, Questions] = {}
        self._same_names: set[str] = set()
        self._arrival = threading.Condition()
        self.sessions: dict[str, list[Token]] = {}
        """The announcements of each peer."""

    @property
    def publishers(self) -> list[RemotePublisher]:
        """The remote publishers."""
        return [thing for thing in list(self._things.values()) if isinstance(thing, RemotePublisher)]

    @property
    def same_names(self) -> list[str]:
        """Names of nodes that exist on both sides."""
        here = {node.full_name for node in local_nodes(self._place.graph)}
        return sorted({visitor.full_name for visitor in list(self._nodes.values())} & here)

    def came(self, text: str) -> None:
        """Add a peer's announcement; invalid, known and own tokens are ignored."""
        try:
            token = read_token(text)
        except ValueError:
            return
        if not self.wants(token) or text in self._things or len(self._things) >= MOST:
            return
        node = self._node_of(token)
        self._things[text] = node if token.kind == NODE else self._enter(text, token, node)
        self.sessions.setdefault(token.session, []).append(token)
        with self._arrival:
            self._arrival.notify_all()

    def wants(self, token: Token) -> bool:
        """Whether the token belongs in this graph: it is a peer's, of the same domain."""
        theirs = token.session != self._place.id and token.domain_id == self._place.domain_id
        return theirs and token.name not in INSIDE

    def wait_for(self, texts: set[str], seconds: float) -> None:
        """Wait until these have arrived, at most so many seconds; one that has just left never arrives."""
        with self._arrival:
            self._arrival.wait_for(lambda: texts <= self._things.keys(), seconds)

    def left(self, text: str) -> None:
        """Remove an announcement that a peer withdrew, or a peer that is gone."""
        thing = self._things.pop(text, None)
        if thing is None:
            return
        token = read_token(text)
        self._forget(token)
        if token.kind != NODE:
            thing.close()
        key = (token.session, token.node)
        self._ends_of_node[key] -= 1
        if not self._ends_of_node[key]:
            del self._ends_of_node[key]
            self._nodes.pop(key).close()

    def listen(self) -> None:
        """Receive the topics of local subscriptions; called before they are announced, since peers may send at once."""
        wanted: dict[tuple[str, str], bool] = {}
        for subscription in self._subscriptions():
            key = (subscription.name, subscription.type_name)
            wanted[key] = wanted.get(key, False) or is_latched(subscription)
        for key, latched in wanted.items():
            known = self._receivers.get(key)
            if known is None or (latched and not known.latched):
                self._receivers[key] = Receiver(self._place.session, self._place.key(*key), latched=latched)
                if known is not None:
                    known.close()
        for key in [key for key in self._receivers if key not in wanted]:
            self._receivers.pop(key).close()

    def take(self, name: str, type_name: str, data: bytes, came_with: Attachment) -> None:
        """Take a message that arrived over a direct line."""
        receiver = self._receivers.get((name, type_name))
        if receiver is not None:
            receiver.take(data, came_with)

    def compare(self) -> None:
        """Update the receivers' publishers, and warn the user of nodes with the same names."""
        publishers: dict[tuple[str, str], list[RemotePublisher]] = {}
        for publisher in self.publishers:
            publishers.setdefault((publisher.name, publisher.type_name), []).append(publisher)
        for key, receiver in self._receivers.items():
            receiver.set_publishers(publishers.get(key, []))
        self._tell_same_names()

    def _subscriptions(self) -> Iterator[Subscription]:
        for node in local_nodes(self._place.graph):
            yield from (subscription for subscription in list(node.subscriptions) if subscription.name not in INSIDE)

    def close(self) -> None:
        """Remove all of them from the graph."""
        parts: list[Any] = [*self._receivers.values(), *self._questions.values()]
        for part in parts:
            part.close()
        self._receivers.clear()
        self._questions.clear()
        for text in list(self._things):
            self.left(text)

    def _node_of(self, token: Token) -> GraphNode:
        key = (token.session, token.node)
        node = self._nodes.get(key)
        if node is None:
            node = GraphNode(self._place.graph, token.node_name, token.namespace)
            node.remote = self._place.address
            self._nodes[key] = self._place.graph.enter(node)
        self._ends_of_node[key] = self._ends_of_node.get(key, 0) + 1
        return node

    def _enter(self, text: str, token: Token, node: GraphNode) -> Any:
        graph = self._place.graph
        if token.kind == PUBLISHER:
            publisher = RemotePublisher(graph, node, token, self._place.tell)
            publisher.gid = gid_of(text) + bytes(8)
            return graph.add_publisher(publisher)
        if token.kind == SUBSCRIPTION:
            return graph.add_subscription(RemoteSubscription(graph, node, token, hears=not self._listen_only))
        if token.kind == SERVER:
            return graph.add_server(RemoteServer(graph, node, token, self._ask))
        return graph.add_client(RemoteClient(graph, node, token))

    def _ask(self, server: RemoteServer, data: bytes, request_id: Any) -> None:
        if self._listen_only:
            again = f"To send: %network {self._place.address}"
            self._place.tell(f"You only listen: the request to {server.name} is not sent. {again}")
            return
        key = self._place.key(server.name, server.type_name, server.type_hash)
        questions = self._questions.get(key)
        if questions is None:
            questions = self._questions.setdefault(key, Questions(self._place.session, key, os.urandom(16)))
        outside(questions.ask, server, data, request_id)  # its thread lasts until the response, which may never come

    def _forget(self, token: Token) -> None:
        others = self.sessions.get(token.session, [])
        if token in others:
            others.remove(token)
        if not others:
            self.sessions.pop(token.session, None)

    def _tell_same_names(self) -> None:
        for name in self.same_names:
            if name not in self._same_names and "/_" not in name:
                self._same_names.add(name)
                self._place.tell(
                    f"Two nodes are called {name}: one here, one in another session. Commands reach either of them. "
                    f"Rename yours: --ros-args -r __node:={name.rpartition('/')[2]}_2, or take a ROS_DOMAIN_ID of your own."
                )


__all__ = ["RemoteGraph"]
