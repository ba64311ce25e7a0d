"""The robot's graph, announced to peers; it is polled twice a second, since rclpy does not report changes."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any, NamedTuple

from ..wire.names import NO_HASH
from ..wire.quality import Quality
from ..wire.token import CLIENT, NODE, PUBLISHER, SERVER, SUBSCRIPTION, Token, gid_of
from .calls import Offered
from .types import class_of, quality_of

INSIDE = ("/clock",)
PREFIX = "_coursekit_gateway_"


class Thing(NamedTuple):
    """A ROS node, or one of its endpoints."""

    kind: str
    namespace: str
    node: str
    name: str = ""
    type_name: str = ""


class Announced:
    """Keeps the announcements in step with the ROS graph; `compare` is called by one thread."""

    def __init__(self, gateway: Any) -> None:
        self._gateway = gateway
        self._numbers = itertools.count(1)
        self._node_numbers: dict[tuple[str, str], int] = {}
        self._said: dict[Thing, list[Any]] = {}
        self._tokens: dict[Thing, str] = {}
        self._speakers: dict[tuple[str, str], bytes] = {}

    def gid_of_publisher(self, name: str, type_name: str) -> bytes:
        """Return the gid of one of the ROS publishers of a topic, used for all messages on that topic."""
        return self._speakers.get((name, type_name), bytes(16))

    def compare(self) -> None:
        """Announce new nodes and endpoints, withdraw removed ones."""
        there = dict.fromkeys(self._present())
        for gone in [token for token in self._said if token not in there]:
            for part in self._said.pop(gone):
                part.undeclare() if hasattr(part, "undeclare") else part.close()
            del self._tokens[gone]
        for new in [token for token in there if token not in self._said]:
            self._announce(new)
        speakers = [(thing, text) for thing, text in self._tokens.items() if thing.kind == PUBLISHER]
        self._speakers = {(thing.name, thing.type_name): gid_of(text) for thing, text in speakers}

    def _present(self) -> Iterator[Thing]:
        node = self._gateway.node
        for name, namespace in node.get_node_names_and_namespaces():
            if name.startswith(PREFIX) or self._gateway.visitors.is_own(name, namespace):
                continue
            ends = {
                PUBLISHER: node.get_publisher_names_and_types_by_node,
                SUBSCRIPTION: node.get_subscriber_names_and_types_by_node,
                SERVER: node.get_service_names_and_types_by_node,
                CLIENT: node.get_client_names_and_types_by_node,
            }
            try:
                groups = [(kind, ask(name, namespace)) for kind, ask in ends.items()]
            except Exception:
                continue  # the node has just left
            yield Thing(NODE, namespace, name)
            for kind, group in groups:
                yield from (Thing(kind, namespace, name, topic, types[0]) for topic, types in group if topic not in INSIDE)

    def _announce(self, new: Thing) -> None:
        parts: list[Any] = []
        if new.kind == SERVER:
            try:
                parts.append(Offered(self._gateway, new.name, new.type_name, class_of(new.type_name)))
            except (ImportError, AttributeError):
                self._gateway.tell(f"{new.name} is not offered: this Python has no {new.type_name}. Source its workspace.")
        text = self._token(new).text()
        self._tokens[new] = text
        self._said[new] = [*parts, self._gateway.session.liveliness().declare_token(text)]

    def _token(self, new: Thing) -> Token:
        key = (new.namespace, new.node)
        number = str(self._node_numbers.setdefault(key, next(self._numbers)))
        entity = number if new.kind == NODE else str(next(self._numbers))
        head = Token(self._gateway.domain_id, self._gateway.id, number, entity, new.kind, new.namespace, new.node)
        if new.kind == NODE:
            return head
        return head._replace(name=new.name, type_name=new.type_name, type_hash=NO_HASH, quality=self._quality(new))

    def _quality(self, new: Thing) -> Quality:
        if new.kind in (SERVER, CLIENT):
            return Quality(depth=10)
        node = self._gateway.node
        ask = node.get_publishers_info_by_topic if new.kind == PUBLISHER else node.get_subscriptions_info_by_topic
        for info in ask(new.name):
            if (info.node_namespace, info.node_name) == (new.namespace, new.node):
                return quality_of(info.qos_profile)
        return Quality(depth=10)
