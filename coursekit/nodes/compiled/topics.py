"""A compiled program's requests about its publishers and subscriptions."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, Any

from rclpy._rclpy_info import as_bytes
from rclpy.qos import qos_check_compatible

from coursekit.interfaces.cdr import deserialize
from coursekit.interfaces.registry import load
from coursekit.nodes.compiled import qos
from coursekit.nodes.compiled.content_filter import Test, compile_filter
from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.nodes.compiled.statistics import TopicStatistics
from coursekit.nodes.compiled.valid_objects import living_node

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host


class Hearing:
    """The processing of a subscription's messages: its filter, its statistics, the program's callback."""

    def __init__(self, host: Host, kind: type[Any], handler: int, ignored: Collection[bytes]) -> None:
        self._host, self._kind, self._handler, self._ignored = host, kind, handler, ignored
        self.filter: Test | None = None
        self.statistics: TopicStatistics | None = None
        self.stays = False
        """Whether messages of the program's own publishers may stay in it."""

    def wants(self, data: bytes, gid: bytes) -> bool:
        """Whether a message passes: it is neither filtered out nor from an ignored publisher of this program."""
        if gid in self._ignored:
            return False
        return self.filter is None or self.filter(deserialize(data, self._kind))

    def heard(self, data: bytes, info: dict[str, Any]) -> None:
        """Pass a message to the program."""
        if not self.wants(data, info["publisher_gid"]):
            return
        if self.statistics is not None:
            self.statistics.hear(deserialize(data, self._kind))
        self._host.call(
            self._handler, packed_info(info["source_timestamp"], info["received_timestamp"], info["publisher_gid"]) + data
        )


def packed_info(sent: int, received: int, gid: bytes) -> bytes:
    """Pack the content of the C++ class MessageInfo."""
    return packed(sent, received, bytes(gid))


def do_publisher(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make a publisher."""
    node, kind, topic = living_node(host, frame, "publisher"), load(frame.text()), frame.text()
    group = host.things.get(frame.integer())
    publisher = node.create_publisher(
        kind,
        topic,
        qos.profile(frame, "publisher"),
        callback_group=group,
        event_callbacks=qos.publisher_events(host, frame),
        qos_overriding_options=qos.overriding(host, frame),
    )
    host.own_gids.add(publisher._core.gid)
    number = host.keep((node, "destroy_publisher", publisher))
    return (
        packed(number, publisher.topic_name) + qos.packed_profile(publisher.qos_profile) + packed(bytes(publisher._core.gid))
    )


def do_publish(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Publish a serialized message."""
    publisher = host.things[frame.integer()][2]
    if publisher._context_ok():
        publisher.publish(frame.rest())


def do_subscription_count(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the number of subscriptions of a publisher."""
    return packed(host.things[frame.integer()][2].get_subscription_count())


def do_assert_liveliness(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Assert a publisher's liveliness."""
    host.things[frame.integer()][2].assert_liveliness()


def do_type(_host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Check that a message type of that name exists; raises an error otherwise."""
    load(frame.text())


def do_subscription(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make a subscription."""
    node, kind, topic = living_node(host, frame, "subscription"), load(frame.text()), frame.text()
    handler, group = frame.integer(), host.things.get(frame.integer())
    wanted = qos.profile(frame, "subscription")
    events = qos.subscription_events(host, frame)
    hearing = Hearing(host, kind, handler, host.own_gids if frame.integer() else ())
    subscription = node.create_subscription(
        kind,
        topic,
        hearing.heard,
        wanted,
        callback_group=group,
        event_callbacks=events,
        qos_overriding_options=qos.overriding(host, frame),
        raw=True,
    )
    subscription.hearing = hearing
    counted, statistics_topic, period = frame.integer(), frame.text(), frame.integer()
    if counted:
        hearing.statistics = TopicStatistics(node, host.clock, statistics_topic, period / 1e9)
    number = host.keep((node, "destroy_subscription", subscription))
    return packed(number, subscription.topic_name) + qos.packed_profile(subscription.qos_profile)


def do_content_filter(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Restrict a subscription to messages that satisfy an expression; an empty one passes all."""
    subscription, expression = host.things[frame.integer()][2], frame.text()
    parameters = [frame.text() for _ in range(frame.integer())]
    subscription.hearing.filter = compile_filter(expression, parameters) if expression else None


def do_take(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Take the next queued message without its callback, 0 if there is none."""
    subscription = host.things[frame.integer()][2]
    while (entry := subscription._core.take()) is not None:
        data, gid = as_bytes(entry[0]), entry[2].gid
        if subscription.hearing.wants(data, gid):
            return packed(1) + packed_info(entry[1], entry[1], gid) + data
    return packed(0)


def do_publisher_count(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the number of publishers of a subscription."""
    return packed(host.things[frame.integer()][2].get_publisher_count())


def do_qos_check(_host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return whether two profiles are compatible, and why not."""
    verdict, reason = qos_check_compatible(qos.profile(frame), qos.profile(frame))
    return packed(int(verdict), reason)
