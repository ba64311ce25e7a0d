"""Announces the local graph on the network, and carries the messages and responses that peers request."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any

from coursekit.core.graph import Graph
from coursekit.core.graph_node import GraphNode
from coursekit.core.service import Client, Server
from coursekit.core.topic import Endpoint, Publisher, Subscription
from coursekit.joined.ghosts import GhostNode

from .calls import Answers
from .direct import DirectLines
from .link_context import LinkContext
from .quality import wire_quality
from .remote import RemoteSubscription
from .sending import Sender
from .wire.names import NO_HASH
from .wire.token import CLIENT, NODE, PUBLISHER, SERVER, SUBSCRIPTION, Token, gid_of

INSIDE = ("/clock",)
"""Topics that never leave the session and are not accepted from outside: each simulation has its own time."""
KINDS = {Publisher: PUBLISHER, Subscription: SUBSCRIPTION, Server: SERVER, Client: CLIENT}


class Announced:
    """A local node or endpoint that is announced to peers, with the objects that serve it."""

    def __init__(self, token: Any, sender: Sender | None = None, answers: Answers | None = None) -> None:
        self.sender = sender
        self._parts = [part for part in (sender, answers) if part is not None]
        self._token = token

    def close(self) -> None:
        """Withdraw the announcement."""
        for part in self._parts:
            part.close()
        self._token.undeclare()


class Announcer:
    """Keeps the announcements in step with the graph: one thread calls `compare` after each change."""

    def __init__(self, place: LinkContext, direct: DirectLines | None, *, listen_only: bool) -> None:
        self._place = place
        self._direct = direct
        self._listen_only = listen_only
        self._numbers = itertools.count(1)
        self._node_numbers: dict[GraphNode, int] = {}
        self.known: dict[Any, Announced] = {}

    @property
    def senders(self) -> list[Sender]:
        """The senders of announced publishers."""
        return [known.sender for known in list(self.known.values()) if known.sender is not None]

    def compare(self) -> None:
        """Announce new nodes and endpoints, withdraw removed ones, and send the topics that have listeners."""
        there = dict.fromkeys(self._ours())
        for gone in [endpoint for endpoint in self.known if endpoint not in there]:
            self.known.pop(gone).close()
            self._node_numbers.pop(gone, None)
        for endpoint in there:
            if endpoint not in self.known:
                self.known[endpoint] = self._announce(endpoint)
        for sender in self.senders:
            listeners = [target for target in sender.publisher.targets if isinstance(target, RemoteSubscription)]
            lines = self._direct.to(listener.session for listener in listeners) if self._direct else ()
            sender.want({listener.type_hash for listener in listeners}, lines)

    def close(self) -> None:
        """Withdraw all announcements."""
        for known in self.known.values():
            known.close()
        self.known.clear()

    def _ours(self) -> Iterator[Any]:
        for node in local_nodes(self._place.graph):
            yield node
            ends: list[Endpoint] = [*node.subscriptions]
            if not self._listen_only:
                ends += [*node.publishers, *node.servers, *node.clients]
            yield from (end for end in ends if end.name not in INSIDE)

    def _announce(self, thing: Any) -> Announced:
        token = self._token(thing)
        text = token.text()
        sender = answers = None
        if token.kind == PUBLISHER:
            sender = Sender(self._place.session, thing, gid_of(text), self._keys_of(thing))
        if token.kind == SERVER:
            key = self._place.key(thing.name, thing.type_name)
            answers = Answers(self._place.session, thing, key, self._place.tell)
        # The token comes last: peers may send requests as soon as they see it.
        return Announced(self._place.session.liveliness().declare_token(text), sender, answers)

    def _keys_of(self, endpoint: Endpoint) -> Any:
        return lambda type_hash: self._place.key(endpoint.name, endpoint.type_name, type_hash)

    def _token(self, thing: Any) -> Token:
        node = thing if isinstance(thing, GraphNode) else thing.node
        number = self._node_numbers.setdefault(node, next(self._numbers))
        head = Token(self._place.domain_id, self._place.id, str(number), str(number), NODE, node.namespace, node.name)
        if thing is node:
            return head
        kind = next(kind for cls, kind in KINDS.items() if isinstance(thing, cls))
        return head._replace(
            entity=str(next(self._numbers)),
            kind=kind,
            name=thing.name,
            type_name=thing.type_name,
            type_hash=NO_HASH,
            quality=wire_quality(thing.qos),
        )


def local_nodes(graph: Graph) -> list[GraphNode]:
    """Return the nodes of this session, except remote nodes and neighbours' nodes, which may join the network themselves."""
    return [node for node in list(graph.nodes) if not node.remote and not isinstance(node, GhostNode)]
