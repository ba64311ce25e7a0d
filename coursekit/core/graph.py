"""The graph of one ROS domain: which nodes exist, what they publish, subscribe, serve and call."""

from __future__ import annotations

import itertools
import threading
from collections.abc import Callable, Iterable, Iterator
from typing import TypeVar

from .clock import Clock
from .graph_node import GraphNode
from .service import Client, Server
from .status import LIVELINESS, MATCHED
from .topic import Endpoint, Publisher, Subscription, match

E = TypeVar("E", bound=Endpoint)


class Graph:
    """Nodes, topics and services of one domain; safe to use from any thread.

    >>> from coursekit.core.virtual_clock import VirtualClock
    >>> graph = Graph(VirtualClock())
    >>> graph.add_node("talker", "/").full_name
    '/talker'
    """

    def __init__(self, clock: Clock, numbers: Iterator[int] | None = None) -> None:
        self.clock = clock
        self._numbers = itertools.count(1) if numbers is None else numbers
        self.nodes: list[GraphNode] = []
        self.publishers: dict[str, list[Publisher]] = {}
        self.subscriptions: dict[str, list[Subscription]] = {}
        self.servers: dict[str, list[Server]] = {}
        self.clients: dict[str, list[Client]] = {}
        self.gone: dict[str, str] = {}
        """By topic that still has subscriptions: the node of its last publisher, which has left."""
        self.version = 0
        self._lock = threading.RLock()
        self._watchers: list[Callable[[], None]] = []

    # -- change

    def new_number(self) -> int:
        """Return a number for an endpoint; the graphs of a session share the numbering."""
        return next(self._numbers)

    def add_node(self, name: str, namespace: str, process: object = None, participant: object = None) -> GraphNode:
        """Add a new node; two may have the same name, as in ROS."""
        return self.enter(GraphNode(self, name, namespace, process, participant))

    def enter(self, node: GraphNode) -> GraphNode:
        """Add an existing node."""
        with self._lock:
            self.nodes.append(node)
        self.changed()
        return node

    def remove_node(self, node: GraphNode) -> None:
        """Remove a node; harmless when it is already removed."""
        with self._lock:
            if node in self.nodes:
                self.nodes.remove(node)
        self.changed()

    def add_publisher(self, publisher: Publisher) -> Publisher:
        """Add and match a publisher."""
        with self._lock:
            _enter(self.publishers, publisher.node.publishers, publisher)
            self.gone.pop(publisher.name, None)
            for subscription in self.subscriptions.get(publisher.name, ()):
                match(publisher, subscription)
        self.changed()
        return publisher

    def remove_publisher(self, publisher: Publisher) -> None:
        """Remove a publisher; messages in transit still arrive."""
        with self._lock:
            _leave(self.publishers, publisher.node.publishers, publisher)
            for target in publisher.targets:
                target.status(MATCHED).add(-1)
                if target.lost_publisher(publisher):
                    target.status(LIVELINESS).add(0, -1)
                elif publisher.is_live():
                    target.status(LIVELINESS).add(-1)
            publisher.targets = ()
            if publisher.name not in self.publishers and publisher.name in self.subscriptions:
                self.gone[publisher.name] = publisher.node.full_name
        self.changed()

    def add_subscription(self, subscription: Subscription) -> Subscription:
        """Add and match a subscription."""
        with self._lock:
            _enter(self.subscriptions, subscription.node.subscriptions, subscription)
            for publisher in self.publishers.get(subscription.name, ()):
                match(publisher, subscription)
        self.changed()
        return subscription

    def remove_subscription(self, subscription: Subscription) -> None:
        """Remove a subscription."""
        with self._lock:
            _leave(self.subscriptions, subscription.node.subscriptions, subscription)
            for publisher in self.publishers.get(subscription.name, ()):
                if subscription in publisher.targets:
                    publisher.targets = tuple(target for target in publisher.targets if target is not subscription)
                    publisher.status(MATCHED).add(-1)
            if subscription.name not in self.subscriptions:
                self.gone.pop(subscription.name, None)
        self.changed()

    def add_server(self, server: Server) -> Server:
        """Add a service server."""
        with self._lock:
            _enter(self.servers, server.node.servers, server)
        self.changed()
        return server

    def remove_server(self, server: Server) -> None:
        """Remove a service server."""
        with self._lock:
            _leave(self.servers, server.node.servers, server)
        self.changed()

    def add_client(self, client: Client) -> Client:
        """Add a service client."""
        with self._lock:
            _enter(self.clients, client.node.clients, client)
        self.changed()
        return client

    def remove_client(self, client: Client) -> None:
        """Remove a service client."""
        with self._lock:
            _leave(self.clients, client.node.clients, client)
        self.changed()

    def servers_of(self, client: Client) -> list[Server]:
        """The servers that answer `client`."""
        return [server for server in self.servers.get(client.name, ()) if server.type_name == client.type_name]

    def clear(self) -> None:
        """Remove everything."""
        for node in list(self.nodes):
            node.close()

    def abandon(self) -> None:
        """Empty the graph without notifications and locks: for a forked child, whose parent still owns the contents."""
        for ends in (self.publishers, self.subscriptions, self.servers, self.clients):
            ends.clear()  # type: ignore[attr-defined]
        self.nodes.clear()
        self._watchers.clear()

    # -- watch

    def watch(self, callback: Callable[[], None]) -> None:
        """Call `callback()` after every change; it must not block.

        >>> from coursekit.core.virtual_clock import VirtualClock
        >>> graph = Graph(VirtualClock())
        >>> graph.watch(lambda: print([node.full_name for node in graph.nodes]))
        >>> robot = graph.add_node("camera", "/robot1")
        ['/robot1/camera']
        >>> robot.close()
        []
        """
        self._watchers.append(callback)

    def unwatch(self, callback: Callable[[], None]) -> None:
        """Remove a callback."""
        if callback in self._watchers:
            self._watchers.remove(callback)

    def changed(self) -> None:
        """Count a change and notify the watchers."""
        self.version += 1
        for callback in list(self._watchers):
            callback()

    # -- look

    def find_nodes(self, name: str, namespace: str) -> list[GraphNode]:
        """Return the nodes with this name and namespace: none, one, or several, as ROS warns of but allows.

        >>> from coursekit.core.virtual_clock import VirtualClock
        >>> graph = Graph(VirtualClock())
        >>> twins = [graph.add_node("talker", "/"), graph.add_node("talker", "/")]
        >>> graph.find_nodes("talker", "/") == twins, graph.find_nodes("talker", "/robot1")
        (True, [])
        """
        return [node for node in list(self.nodes) if node.name == name and node.namespace == namespace]

    def topics(self) -> list[tuple[str, list[str]]]:
        """(name, types) of every topic with a publisher or subscription, by name.

        >>> from std_msgs.msg import String
        >>> from coursekit.core.qos import Qos
        >>> from coursekit.core.virtual_clock import VirtualClock
        >>> graph = Graph(VirtualClock())
        >>> _ = graph.add_node("talker", "/").publisher("/chatter", String, Qos())
        >>> graph.topics()
        [('/chatter', ['std_msgs/msg/String'])]
        """
        return names_and_types([*_all(self.publishers), *_all(self.subscriptions)])

    def services(self) -> list[tuple[str, list[str]]]:
        """(name, types) of every service with a server or client, by name.

        >>> from std_srvs.srv import Empty
        >>> from coursekit.core.qos import Qos
        >>> from coursekit.core.virtual_clock import VirtualClock
        >>> graph = Graph(VirtualClock())
        >>> _ = graph.add_node("turtlesim", "/").server("/clear", Empty, Qos())
        >>> graph.services()
        [('/clear', ['std_srvs/srv/Empty'])]
        """
        return names_and_types([*_all(self.servers), *_all(self.clients)])


def names_and_types(endpoints: Iterable[Endpoint]) -> list[tuple[str, list[str]]]:
    """(name, sorted types) of these endpoints, by name.

    >>> from std_msgs.msg import String
    >>> from coursekit.core.qos import Qos
    >>> from coursekit.core.virtual_clock import VirtualClock
    >>> node = Graph(VirtualClock()).add_node("talker", "/")
    >>> names_and_types([node.publisher("/chatter", String, Qos())])
    [('/chatter', ['std_msgs/msg/String'])]
    """
    types_by_name: dict[str, dict[str, None]] = {}
    for endpoint in endpoints:
        types_by_name.setdefault(endpoint.name, {})[endpoint.type_name] = None
    return [(name, sorted(types)) for name, types in sorted(types_by_name.items())]


def _all(endpoints: dict[str, list[E]]) -> list[E]:
    return [endpoint for group in list(endpoints.values()) for endpoint in list(group)]


def _enter(by_name: dict[str, list[E]], of_node: list[E], endpoint: E) -> None:
    by_name.setdefault(endpoint.name, []).append(endpoint)
    of_node.append(endpoint)


def _leave(by_name: dict[str, list[E]], of_node: list[E], endpoint: E) -> None:
    group = by_name.get(endpoint.name, [])
    if endpoint in group:
        group.remove(endpoint)
        if not group:
            del by_name[endpoint.name]
    if endpoint in of_node:
        of_node.remove(endpoint)
