"""The part of Node that queries the graph."""

from __future__ import annotations

from typing import Any

from coursekit.core.graph import names_and_types
from coursekit.core.qos import INFINITE, Qos
from rclpy._rclpy_pybind11 import NodeNameNonExistentError
from rclpy.duration import Duration, Infinite
from rclpy.expand_topic_name import expand_topic_name
from rclpy.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSProfile,
    ReliabilityPolicy,
)
from rclpy.topic_endpoint_info import TopicEndpointInfo, TopicEndpointTypeEnum
from rclpy.validate_full_topic_name import validate_full_topic_name

NamesAndTypes = list[tuple[str, list[str]]]


class NodeGraph:
    """A node's queries of the graph."""

    _rclpy_graph_node: Any

    @property
    def _rclpy_graph(self) -> Any:
        self.handle.check()  # type: ignore[attr-defined]
        return self._rclpy_graph_node.graph

    def _rclpy_endpoints_of(self, kind: str, node_name: str, node_namespace: str) -> list[Any]:
        nodes = self._rclpy_graph.find_nodes(node_name, node_namespace)
        if not nodes:
            raise NodeNameNonExistentError(
                f"Cannot get {kind} names and types for nonexistent node: cannot get them for node, it does not exist: "
                f"{node_namespace.rstrip('/')}/{node_name}"
            )
        return [endpoint for node in nodes for endpoint in getattr(node, kind)]

    def get_publisher_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> NamesAndTypes:
        """Topics that a node publishes.

        >>> [name for name, types in node.get_publisher_names_and_types_by_node("robot", "/")]
        ['/parameter_events', '/rosout']
        """
        return names_and_types(self._rclpy_endpoints_of("publishers", node_name, node_namespace))

    def get_subscriber_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> NamesAndTypes:
        """Topics that a node subscribes to."""
        return names_and_types(self._rclpy_endpoints_of("subscriptions", node_name, node_namespace))

    def get_service_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Services that a node serves."""
        return names_and_types(self._rclpy_endpoints_of("servers", node_name, node_namespace))

    def get_client_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        """Services that a node calls."""
        return names_and_types(self._rclpy_endpoints_of("clients", node_name, node_namespace))

    def get_topic_names_and_types(self, no_demangle: bool = False) -> NamesAndTypes:
        """All topics.

        >>> dict(node.get_topic_names_and_types())["/rosout"]
        ['rcl_interfaces/msg/Log']
        """
        return self._rclpy_graph.topics()

    def get_service_names_and_types(self) -> NamesAndTypes:
        """All services.

        >>> from std_srvs.srv import Trigger
        >>> service = node.create_service(Trigger, "stop", lambda request, response: response)
        >>> dict(node.get_service_names_and_types())["/stop"]
        ['std_srvs/srv/Trigger']
        """
        return self._rclpy_graph.services()

    def get_node_names(self) -> list[str]:
        """Names of all nodes.

        >>> node.get_node_names()
        ['robot']
        """
        return [node.name for node in list(self._rclpy_graph.nodes)]

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        """(name, namespace) of all nodes."""
        return [(node.name, node.namespace) for node in list(self._rclpy_graph.nodes)]

    def get_node_names_and_namespaces_with_enclaves(self) -> list[tuple[str, str, str]]:
        """(name, namespace, enclave) of all nodes."""
        return [(name, namespace, "/") for name, namespace in self.get_node_names_and_namespaces()]

    def _rclpy_resolved(self, name: str, kind: str) -> str:
        full = expand_topic_name(name, self.get_name(), self.get_namespace())  # type: ignore[attr-defined]
        validate_full_topic_name(full, is_service=kind == "service")
        return self.handle.resolve(full, kind)  # type: ignore[attr-defined]

    def count_publishers(self, topic_name: str) -> int:
        """The number of publishers on a topic."""
        return len(self._rclpy_graph.publishers.get(self._rclpy_resolved(topic_name, "topic"), ()))

    def count_subscribers(self, topic_name: str) -> int:
        """The number of subscriptions to a topic.

        >>> from std_msgs.msg import String
        >>> subscription = node.create_subscription(String, "chatter", print, 10)
        >>> node.count_subscribers("/chatter"), node.count_publishers("/chatter")
        (1, 0)
        """
        return len(self._rclpy_graph.subscriptions.get(self._rclpy_resolved(topic_name, "topic"), ()))

    def count_services(self, service_name: str) -> int:
        """The number of servers of a service."""
        return len(self._rclpy_graph.servers.get(self._rclpy_resolved(service_name, "service"), ()))

    def count_clients(self, service_name: str) -> int:
        """The number of clients of a service."""
        return len(self._rclpy_graph.clients.get(self._rclpy_resolved(service_name, "service"), ()))

    def get_publishers_info_by_topic(
        self, topic_name: str, no_mangle: bool = False
    ) -> list[TopicEndpointInfo]:
        """The publishers of a topic.

        >>> from std_msgs.msg import String
        >>> publisher = node.create_publisher(String, "chatter", 10)
        >>> [(info.node_name, info.topic_type) for info in node.get_publishers_info_by_topic("/chatter")]
        [('robot', 'std_msgs/msg/String')]
        """
        name = topic_name if no_mangle else self._rclpy_resolved(topic_name, "topic")
        kind = TopicEndpointTypeEnum.PUBLISHER
        return [_info(endpoint, kind) for endpoint in list(self._rclpy_graph.publishers.get(name, ()))]

    def get_subscriptions_info_by_topic(
        self, topic_name: str, no_mangle: bool = False
    ) -> list[TopicEndpointInfo]:
        """The subscriptions to a topic."""
        name = topic_name if no_mangle else self._rclpy_resolved(topic_name, "topic")
        kind = TopicEndpointTypeEnum.SUBSCRIPTION
        return [_info(endpoint, kind) for endpoint in list(self._rclpy_graph.subscriptions.get(name, ()))]


def _info(endpoint: Any, kind: TopicEndpointTypeEnum) -> TopicEndpointInfo:
    return TopicEndpointInfo(
        node_name=endpoint.node.name,
        node_namespace=endpoint.node.namespace,
        topic_type=endpoint.type_name,
        endpoint_type=kind,
        endpoint_gid=list(endpoint.gid),
        qos_profile=profile_of(endpoint.qos),
    )


def _duration(nanoseconds: int) -> Duration:
    return Infinite if nanoseconds in (0, INFINITE) else Duration(nanoseconds=nanoseconds)


def profile_of(qos: Qos) -> QoSProfile:
    """The profile of an endpoint in the graph."""
    return QoSProfile(
        history=HistoryPolicy(qos.history),
        depth=qos.depth,
        reliability=ReliabilityPolicy(qos.reliability),
        durability=DurabilityPolicy(qos.durability),
        lifespan=_duration(qos.lifespan),
        deadline=_duration(qos.deadline),
        liveliness=LivelinessPolicy(qos.liveliness),
        liveliness_lease_duration=_duration(qos.lease),
    )


def core_qos(profile: QoSProfile) -> Qos:
    """A profile in the core's format."""
    return Qos(
        history=int(profile.history),
        depth=profile.depth,
        reliability=int(profile.reliability),
        durability=int(profile.durability),
        lifespan=profile.lifespan.nanoseconds,
        deadline=profile.deadline.nanoseconds,
        liveliness=int(profile.liveliness),
        lease=profile.liveliness_lease_duration.nanoseconds,
    )
