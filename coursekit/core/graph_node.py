"""A node of the graph: what it publishes, subscribes, serves and calls."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .interface import Interface
from .qos import Qos
from .service import Client, Server
from .topic import Publisher, Subscription

if TYPE_CHECKING:
    from .graph import Graph


class GraphNode:
    """A node in the graph."""

    def __init__(
        self, graph: Graph, name: str, namespace: str, process: object = None, participant: object = None
    ) -> None:
        self.graph = graph
        self.name = name
        self.namespace = namespace
        self.process: Any = process
        self.deaf_to_itself = False
        """Whether it ignores its own messages: a bridge in both directions would otherwise send them in circles."""
        self.participant = participant
        """The DDS participant that it shares with other nodes: each topic has one type per participant. None: not shared."""
        self.remote = ""
        """The network address if the node runs on another computer or in another notebook."""
        self.publishers: list[Publisher] = []
        self.subscriptions: list[Subscription] = []
        self.servers: list[Server] = []
        self.clients: list[Client] = []

    @property
    def full_name(self) -> str:
        """For example '/robot1/camera'."""
        return f"{self.namespace.rstrip('/')}/{self.name}"

    @property
    def logger_name(self) -> str:
        """For example 'robot1.camera'."""
        return self.full_name.strip("/").replace("/", ".")

    def publisher(self, name: str, msg_type: Interface, qos: Qos) -> Publisher:
        """Create a publisher and match it with the existing subscriptions."""
        return self.graph.add_publisher(Publisher(self.graph, self, name, msg_type, qos))

    def subscription(self, name: str, msg_type: Interface, qos: Qos) -> Subscription:
        """Create a subscription and match it with the existing publishers."""
        return self.graph.add_subscription(Subscription(self.graph, self, name, msg_type, qos))

    def server(self, name: str, srv_type: Interface, qos: Qos) -> Server:
        """Create a service server."""
        return self.graph.add_server(Server(self.graph, self, name, srv_type, qos))

    def client(self, name: str, srv_type: Interface, qos: Qos) -> Client:
        """Create a service client."""
        return self.graph.add_client(Client(self.graph, self, name, srv_type, qos))

    def close(self) -> None:
        """Leave the graph, with all endpoints of the node."""
        for endpoint in [*self.publishers, *self.subscriptions, *self.servers, *self.clients]:
            endpoint.close()  # type: ignore[attr-defined]
        self.graph.remove_node(self)
