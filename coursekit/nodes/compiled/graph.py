"""A compiled program's requests about the graph: its nodes, endpoints and changes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy.expand_topic_name import expand_topic_name
from rclpy.validate_full_topic_name import validate_full_topic_name
from rclpy.validate_namespace import validate_namespace
from rclpy.validate_node_name import validate_node_name
from rclpy.validate_topic_name import validate_topic_name

from coursekit.nodes.compiled import qos
from coursekit.nodes.compiled.frames import Unpacker, packed

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host


def do_resolve_topic(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return a topic's full name as used by a node, optionally without remapping."""
    return packed(host.things[frame.integer()].resolve_topic_name(frame.text(), only_expand=bool(frame.integer())))


def do_resolve_service(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return a service's full name as used by a node, optionally without remapping."""
    return packed(host.things[frame.integer()].resolve_service_name(frame.text(), only_expand=bool(frame.integer())))


def do_expand_name(_host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the full name of a topic or service in a node of that name and namespace."""
    name, node, space, is_service = frame.text(), frame.text(), frame.text(), bool(frame.integer())
    validate_node_name(node)
    validate_namespace(space)
    validate_topic_name(name, is_service=is_service)
    full = expand_topic_name(name, node, space)
    validate_full_topic_name(full, is_service=is_service)
    return packed(full)


def do_node_names(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Full names of all nodes."""
    nodes = host.things[frame.integer()].get_node_names_and_namespaces()
    names = [f"{space.rstrip('/')}/{name}" for name, space in nodes]
    return packed(len(names), *names)


def do_topics(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """All topics with their types."""
    return _names_and_types(host.things[frame.integer()].get_topic_names_and_types())


def do_services(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """All services with their types."""
    return _names_and_types(host.things[frame.integer()].get_service_names_and_types())


def do_ends_of(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return a node's endpoints with their types; a word such as "service" selects the kind."""
    node, which, name, namespace = host.things[frame.integer()], frame.text(), frame.text(), frame.text()
    return _names_and_types(getattr(node, f"get_{which}_names_and_types_by_node")(name, namespace or "/"))


def _names_and_types(pairs: list[tuple[str, list[str]]]) -> bytes:
    return packed(len(pairs), *(word for name, types in pairs for word in (name, len(types), *types)))


def do_count_publishers(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the number of publishers of a topic."""
    return packed(host.things[frame.integer()].count_publishers(frame.text()))


def do_count_subscribers(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the number of subscriptions to a topic."""
    return packed(host.things[frame.integer()].count_subscribers(frame.text()))


def do_publishers_info(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """The publishers of a topic."""
    return _endpoints(host.things[frame.integer()].get_publishers_info_by_topic(frame.text(), bool(frame.integer())))


def do_subscriptions_info(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """The subscriptions to a topic."""
    return _endpoints(host.things[frame.integer()].get_subscriptions_info_by_topic(frame.text(), bool(frame.integer())))


def _endpoints(infos: list[Any]) -> bytes:
    parts = [packed(len(infos))]
    for info in infos:
        who = (info.node_name, info.node_namespace, info.topic_type, int(info.endpoint_type), bytes(info.endpoint_gid))
        parts.append(packed(*who) + qos.packed_profile(info.qos_profile))
    return b"".join(parts)


def do_graph_changes(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return a counter of changes of nodes, topics or services."""
    return packed(host.things[frame.integer()]._rclpy_graph.version)


def do_wait_for_graph(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Wait until that counter has grown, with a timeout (negative: none). Returns the counter."""
    graph, seen, nanoseconds = host.things[frame.integer()]._rclpy_graph, frame.integer(), frame.integer()
    end = None if nanoseconds < 0 else host.clock.steady() + nanoseconds
    waiter = host.clock.new_waiter()
    graph.watch(waiter.notify)
    try:
        while graph.version == seen and not host.stopping and (end is None or host.clock.steady() < end):
            waiter.wait(end)
    finally:
        graph.unwatch(waiter.notify)
    return packed(graph.version)
