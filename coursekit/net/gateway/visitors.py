"""The announcements of peers, represented in ROS: each remote node is a node here, under its own name."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rclpy.node import Node

from ..wire.token import CLIENT, NODE, PUBLISHER, SERVER, SUBSCRIPTION, Token, gid_of, read_token
from .announced import INSIDE, PREFIX
from .calls import Passed
from .topic import Topic
from .types import class_of, is_latched, profile_of

MOST = 5000
"""Maximum number of announcements."""


class Visitors:
    """Remote nodes and endpoints; all calls come from one thread."""

    def __init__(self, gateway: Any) -> None:
        self._gateway = gateway
        self._undo: dict[str, Callable[[], None]] = {}
        self._nodes: dict[tuple[str, str], Any] = {}
        self._counts: dict[tuple[str, str], int] = {}
        self._topics: dict[tuple[str, str], Topic] = {}

    def is_own(self, name: str, namespace: str) -> bool:
        """Whether a ROS node was created here for a remote one."""
        return any((node.get_name(), node.get_namespace()) == (name, namespace) for node in self._nodes.values())

    def compare(self) -> None:
        """Match the subscription of each topic to the QoS that ROS publishers offer now."""
        for (name, type_name), topic in self._topics.items():
            infos = self._gateway.node.get_publishers_info_by_topic(name)
            topic.compare([
                info.qos_profile for info in infos
                if info.topic_type == type_name and not info.node_name.startswith(PREFIX)
                and not self.is_own(info.node_name, info.node_namespace)
            ])  # fmt: skip

    def came(self, text: str) -> None:
        """Create the announced node or endpoint."""
        try:
            token = read_token(text)
        except ValueError:
            return
        theirs = token.session != self._gateway.id and token.domain_id == self._gateway.domain_id
        inside = token.name in INSIDE or token.node_name.startswith(PREFIX)
        if not theirs or inside or text in self._undo or len(self._undo) >= MOST:
            return
        node = self._node_of(token)
        self._undo[text] = lambda: None
        if token.kind != NODE:
            try:
                self._undo[text] = self._make(node, token, text)
            except Exception as error:  # a type that is not installed, or names that this rmw rejects
                what = f"{token.name} ({token.type_name}) of {token.full_node_name}"
                self._gateway.tell(f"{what} cannot be made here: {error!r}")

    def left(self, text: str) -> None:
        """Remove the announced node or endpoint."""
        undo = self._undo.pop(text, None)
        if undo is None:
            return
        undo()
        token = read_token(text)
        key = (token.session, token.node)
        self._counts[key] -= 1
        if not self._counts[key]:
            node = self._nodes.pop(key)
            self._gateway.executor.remove_node(node)
            node.destroy_node()

    def _node_of(self, token: Token) -> Any:
        key = (token.session, token.node)
        self._counts[key] = self._counts.get(key, 0) + 1
        if key not in self._nodes:
            node = Node(
                token.node_name, namespace=token.namespace, start_parameter_services=False, enable_rosout=False,
                use_global_arguments=False,
            )  # fmt: skip
            self._nodes[key] = node
            self._gateway.executor.add_node(node)
        return self._nodes[key]

    def _make(self, node: Node, token: Token, text: str) -> Callable[[], None]:
        kind, profile = class_of(token.type_name), profile_of(token.quality)
        makers = {PUBLISHER: self._publisher, SUBSCRIPTION: self._subscription, SERVER: self._server, CLIENT: self._client}
        return makers[token.kind](node, token, text, kind, profile)

    def _topic(self, token: Token, kind: Any) -> Topic:
        key = (token.name, token.type_name)
        if key not in self._topics:
            self._topics[key] = Topic(self._gateway, token.name, token.type_name, kind)
        return self._topics[key]

    def _publisher(self, node: Node, token: Token, text: str, kind: Any, profile: Any) -> Callable[[], None]:
        publisher, topic, gid = node.create_publisher(kind, token.name, profile), self._topic(token, kind), gid_of(text)
        topic.add_speaker(gid, publisher, latched=is_latched(profile))

        def undo() -> None:
            topic.remove_speaker(gid)
            node.destroy_publisher(publisher)

        return undo

    def _subscription(self, node: Node, token: Token, text: str, kind: Any, profile: Any) -> Callable[[], None]:
        shown = node.create_subscription(kind, token.name, lambda _data: None, profile, raw=True)
        topic = self._topic(token, kind)
        topic.add_listener(text, token.type_hash, token.quality)

        def undo() -> None:
            topic.remove_listener(text)
            node.destroy_subscription(shown)

        return undo

    def _server(self, node: Node, token: Token, _text: str, kind: Any, profile: Any) -> Callable[[], None]:
        return Passed(self._gateway, node, token.name, token.type_name, token.type_hash, kind, profile).close

    def _client(self, node: Node, token: Token, _text: str, kind: Any, _profile: Any) -> Callable[[], None]:
        client = node.create_client(kind, token.name)

        def undo() -> None:
            node.destroy_client(client)

        return undo
