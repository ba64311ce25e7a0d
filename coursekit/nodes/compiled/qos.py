"""QoS of a compiled program's publishers and subscriptions: profiles, events, and policies overridden by parameters."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import astuple
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import SetParametersResult
from rclpy.duration import Duration
from rclpy.qos import QoSHistoryPolicy, QoSPolicyKind, QoSProfile
from rclpy.qos_event import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.qos_overriding_options import QoSOverridingOptions

from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.nodes.compiled.valid_objects import RCLError

if TYPE_CHECKING:
    from coursekit.nodes.compiled.host import Host


_MANUAL_BY_NODE = 2
"""A liveliness that rmw deprecates, rclpy does not name and Fast DDS does not have."""
_PLACES = {
    "publisher": "./src/publisher.cpp:226, at ./src/rcl/publisher.c:116",
    "subscription": "./src/rcl/subscription.c:108",
}
"""Where rmw and rcl refuse the QoS of an end."""


def profile(frame: Unpacker, end: str = "") -> QoSProfile:
    """Read a profile from a frame; RCLError if it is that of an end ("publisher", "subscription") that cannot have it."""
    history, depth, reliability, durability, deadline, lifespan, liveliness, lease = (frame.integer() for _ in range(8))
    if end and liveliness == _MANUAL_BY_NODE:
        raise RCLError(f"could not create {end}: create_{end}() failed setting topic QoS, at {_PLACES[end]}")
    if history == QoSHistoryPolicy.KEEP_LAST and not depth:
        history = QoSHistoryPolicy.SYSTEM_DEFAULT  # as rmw takes it; rclpy would warn of what C++ does not write
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


def packed_profile(qos: QoSProfile) -> bytes:
    """Pack a profile for the C++ function QoS::unpack."""
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


def publisher_events(host: Host, frame: Unpacker) -> PublisherEventCallbacks:
    """Read the callbacks of a publisher's events; rclcpp's own warnings are among the program's callbacks."""
    deadline, liveliness, incompatible = (_telling(host, frame.integer()) for _ in range(3))
    return PublisherEventCallbacks(
        deadline=deadline, liveliness=liveliness, incompatible_qos=incompatible, use_default_callbacks=False
    )


def subscription_events(host: Host, frame: Unpacker) -> SubscriptionEventCallbacks:
    """Read the callbacks of a subscription's events."""
    deadline, liveliness, incompatible, lost = (_telling(host, frame.integer()) for _ in range(4))
    return SubscriptionEventCallbacks(
        deadline=deadline,
        liveliness=liveliness,
        incompatible_qos=incompatible,
        message_lost=lost,
        use_default_callbacks=False,
    )


def _telling(host: Host, handler: int) -> Callable[[Any], None] | None:
    def tell(info: Any) -> None:
        host.call(handler, packed_event(info))

    return tell if handler else None


def packed_event(info: Any) -> bytes:
    """Pack an event's data for the program's event handlers."""
    return packed(*map(int, astuple(info)))


def overriding(host: Host, frame: Unpacker) -> QoSOverridingOptions | None:
    """Read which policies parameters may override, and the validating callback; None for no policies."""
    name, kinds = frame.text(), [QoSPolicyKind(frame.integer()) for _ in range(frame.integer())]
    judge = frame.integer()

    def verdict(qos: QoSProfile) -> SetParametersResult:
        answer = host.call(judge, packed_profile(qos))
        return SetParametersResult(successful=bool(answer.integer()), reason=answer.text())

    return QoSOverridingOptions(kinds, callback=verdict if judge else None, entity_id=name or None) if kinds else None
