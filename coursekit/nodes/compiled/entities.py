"""What a compiled program asks of nodes, topics, timers and services."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import Parameter as ParameterMessage
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.clock import Clock, ClockType
from rclpy.duration import Duration
from rclpy.parameter import Parameter
from rclpy.qos import QoSProfile
from tf2_ros import TransformListener

from coursekit.interfaces.cdr import deserialize, serialize
from coursekit.interfaces.registry import load
from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.nodes.cpp_node import CppNode

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host

_FOREVER = 2**63 - 1
_SYSTEM_TIME, _STEADY_TIME = 2, 3


def do_drop(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """The program has destroyed something."""
    thing = host.things.pop(frame.integer(), None)
    if isinstance(thing, CppNode):
        thing.destroy_node()
    elif isinstance(thing, tuple):  # (node, how to destroy it, it)
        node, how, entity = thing
        getattr(node, how)(entity)
    elif isinstance(thing, (ActionClient, ActionServer)):
        thing.destroy()
    elif isinstance(thing, TransformListener):
        thing.executor.shutdown(0)


def do_node(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make a node."""
    name, namespace, _lifecycle = frame.text(), frame.text(), frame.integer()
    use_global, allow, automatic, rosout, services = (bool(frame.integer()) for _ in range(5))
    arguments = [frame.text() for _ in range(frame.integer())]
    overrides = [Parameter.from_parameter_msg(frame.message(ParameterMessage)) for _ in range(frame.integer())]
    node = CppNode(
        name,
        namespace=namespace,
        cli_args=arguments,
        use_global_arguments=use_global,
        enable_rosout=rosout,
        start_parameter_services=services,
        parameter_overrides=overrides,
        allow_undeclared_parameters=allow,
        automatically_declare_parameters_from_overrides=automatic,
    )
    full_name = node.get_fully_qualified_name()
    group = host.keep(node.default_callback_group)
    return packed(host.keep(node), node.get_name(), node.get_namespace(), full_name, node.get_logger().name, group)


def do_callback_group(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make a callback group."""
    frame.integer()
    return packed(host.keep(ReentrantCallbackGroup() if frame.integer() else MutuallyExclusiveCallbackGroup()))


def do_ros_now(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """The time of a node that follows /clock."""
    return packed(host.things[frame.integer()].get_clock().now().nanoseconds)


def do_ros_time_active(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Whether a node follows /clock."""
    return packed(int(host.things[frame.integer()].get_clock().ros_time_is_active))


def do_node_names(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Full names of all nodes."""
    found = host.things[frame.integer()].get_node_names_and_namespaces()
    names = [f"{space.rstrip('/')}/{name}" for name, space in found]
    return packed(len(names), *names)


def do_topics(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """All topics with their types."""
    return _names_and_types(host.things[frame.integer()].get_topic_names_and_types())


def do_services(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """All services with their types."""
    return _names_and_types(host.things[frame.integer()].get_service_names_and_types())


def _names_and_types(found: list[tuple[str, list[str]]]) -> bytes:
    return packed(len(found), *(word for name, types in found for word in (name, len(types), *types)))


def do_count_publishers(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """How many publish on a topic."""
    return packed(host.things[frame.integer()].count_publishers(frame.text()))


def do_count_subscribers(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """How many listen to a topic."""
    return packed(host.things[frame.integer()].count_subscribers(frame.text()))


# -- topics


def _qos(frame: Unpacker) -> QoSProfile:
    history, depth, reliability, durability, deadline, lifespan, liveliness, lease = (frame.integer() for _ in range(8))
    return QoSProfile(
        history=history,
        depth=depth,
        reliability=reliability,
        durability=durability,
        liveliness=liveliness,
        deadline=Duration(nanoseconds=deadline),
        lifespan=Duration(nanoseconds=lifespan),
        liveliness_lease_duration=Duration(nanoseconds=lease),
    )


def _packed_qos(qos: QoSProfile) -> bytes:
    return packed(
        int(qos.history),
        qos.depth,
        int(qos.reliability),
        int(qos.durability),
        qos.deadline.nanoseconds,
        qos.lifespan.nanoseconds,
        int(qos.liveliness),
        qos.liveliness_lease_duration.nanoseconds,
    )


def do_publisher(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make a publisher."""
    node, kind, topic = host.things[frame.integer()], load(frame.text()), frame.text()
    group = host.things.get(frame.integer())
    publisher = node.create_publisher(kind, topic, _qos(frame), callback_group=group)
    number = host.keep((node, "destroy_publisher", publisher))
    return packed(number, publisher.topic_name) + _packed_qos(publisher.qos_profile)


def do_publish(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Publish a message's bytes."""
    publisher = host.things[frame.integer()][2]
    if publisher._context_ok():
        publisher.publish(frame.rest())


def do_subscription_count(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """How many hear a publisher."""
    return packed(host.things[frame.integer()][2].get_subscription_count())


def do_assert_liveliness(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Say that a publisher lives."""
    host.things[frame.integer()][2].assert_liveliness()


def do_subscription(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make a subscription."""
    node, kind, topic = host.things[frame.integer()], load(frame.text()), frame.text()
    handler, group = frame.integer(), host.things.get(frame.integer())
    heard = partial(_heard, host, handler)
    qos = _qos(frame)
    subscription = node.create_subscription(kind, topic, heard, qos, callback_group=group, raw=True)
    number = host.keep((node, "destroy_subscription", subscription))
    return packed(number, subscription.topic_name) + _packed_qos(qos)


def _heard(host: Host, handler: int, data: bytes, info: Any) -> None:
    host.call(handler, packed(info["source_timestamp"], info["received_timestamp"]) + data)


def do_publisher_count(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """How many a subscription hears."""
    return packed(host.things[frame.integer()][2].get_publisher_count())


# -- timers


def do_timer(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make a timer."""
    node, period, kind, handler = host.things[frame.integer()], frame.integer(), frame.integer(), frame.integer()
    group = host.things.get(frame.integer())
    clocks = {_STEADY_TIME: ClockType.STEADY_TIME, _SYSTEM_TIME: ClockType.SYSTEM_TIME}
    clock = Clock(clock_type=clocks[kind]) if kind in clocks else None

    def ring() -> None:
        host.call(handler)

    return packed(host.keep((node, "destroy_timer", node.create_timer(period / 1e9, ring, group, clock))))


def do_timer_cancel(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Stop a timer."""
    host.things[frame.integer()][2].cancel()


def do_timer_reset(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Have a timer begin anew."""
    host.things[frame.integer()][2].reset()


def do_timer_canceled(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Whether a timer is stopped."""
    return packed(int(host.things[frame.integer()][2].is_canceled()))


def do_timer_ready(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Whether a timer is due."""
    return packed(int(host.things[frame.integer()][2].is_ready()))


def do_timer_left(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Nanoseconds until a timer is due."""
    left = host.things[frame.integer()][2].time_until_next_call()
    return packed(_FOREVER if left is None else left)


# -- services


def do_service(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make a service; its callback answers at once."""
    node, kind, name = host.things[frame.integer()], load(frame.text()), frame.text()
    handler, group = frame.integer(), host.things.get(frame.integer())

    def answer(request: Any, _response: Any) -> Any:
        result = host.call(handler, packed(0) + serialize(request))
        result.integer()
        return result.message(kind.Response)

    service = node.create_service(kind, name, answer, qos_profile=_qos(frame), callback_group=group)
    return packed(host.keep((node, "destroy_service", service)), service.service_name)


def do_client(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make a client."""
    node, kind, name = host.things[frame.integer()], load(frame.text()), frame.text()
    handler, group = frame.integer(), host.things.get(frame.integer())
    client = node.create_client(kind, name, qos_profile=_qos(frame), callback_group=group)
    client.handler = handler
    return packed(host.keep((node, "destroy_client", client)), client.service_name)


def do_send_request(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Send a request; its answer goes to the client's handler."""
    client, number = host.things[frame.integer()][2], frame.integer()
    future = client.call_async(deserialize(frame.rest(), client.srv_type.Request))
    future.add_done_callback(lambda done: host.call(client.handler, packed(number) + serialize(done.result())) and None)


def do_service_ready(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Whether a client's service is there."""
    return packed(int(host.things[frame.integer()][2].service_is_ready()))


def do_wait_for_service(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Wait for a client's service."""
    client, nanoseconds = host.things[frame.integer()][2], frame.integer()
    return packed(int(client.wait_for_service(None if nanoseconds < 0 else nanoseconds / 1e9)))
