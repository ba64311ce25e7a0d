"""A talker that offers less than the listener asks for: nothing is heard, and both are told why."""

import argparse
import sys
from collections.abc import Callable
from typing import Any

import rclpy
from rclpy.duration import Duration
from rclpy.logging import get_logger
from rclpy.qos import QoSDurabilityPolicy, QoSLivelinessPolicy, QoSProfile, QoSReliabilityPolicy
from rclpy.qos_event import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.utilities import remove_ros_args

from .common import Listener, Talker, spin

TOPIC, COUNT = "incompatible_qos_chatter", 5

POLICIES: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "durability": (
        {"durability": QoSDurabilityPolicy.VOLATILE},
        {"durability": QoSDurabilityPolicy.TRANSIENT_LOCAL},
    ),
    "deadline": ({"deadline": Duration(seconds=2)}, {"deadline": Duration(seconds=1)}),
    "liveliness_policy": (
        {"liveliness": QoSLivelinessPolicy.AUTOMATIC},
        {"liveliness": QoSLivelinessPolicy.MANUAL_BY_TOPIC},
    ),
    "liveliness_lease_duration": (
        {"liveliness_lease_duration": Duration(seconds=2)},
        {"liveliness_lease_duration": Duration(seconds=1)},
    ),
    "reliability": (
        {"reliability": QoSReliabilityPolicy.BEST_EFFORT},
        {"reliability": QoSReliabilityPolicy.RELIABLE},
    ),
}


def _tell(name: str, what: str) -> Callable[[Any], None]:
    def tell(event: Any) -> None:
        get_logger(name).info(
            f"{what} incompatible qos - total {event.total_count} delta {event.total_count_change} "
            f"last_policy_kind: {event.last_policy_kind}"
        )

    return tell


def _named(value: Any) -> str:
    return f"{value.nanoseconds // 10**9} s" if isinstance(value, Duration) else str(value.name)


def main(args: list[str] | None = None) -> int:
    """Publish five messages that the listener does not get."""
    parser = argparse.ArgumentParser()
    parser.add_argument("incompatible_qos_policy_name", choices=list(POLICIES), help="The policy that shall not match")
    policy = parser.parse_args(remove_ros_args(sys.argv)[1:]).incompatible_qos_policy_name
    offered, asked = POLICIES[policy]
    for who, profile in (("publisher", offered), ("subscription", asked)):
        print(f"Setting {who} {policy} to: {_named(*profile.values())}")
    rclpy.init(args=args)
    told = PublisherEventCallbacks(incompatible_qos=_tell("talker", "Offered"))
    heard = SubscriptionEventCallbacks(incompatible_qos=_tell("listener", "Requested"))
    talker = Talker(TOPIC, QoSProfile(depth=10, **offered), events=told, publish_count=COUNT)
    listener = Listener(TOPIC, QoSProfile(depth=10, **asked), events=heard)
    return spin(listener, talker, lambda _: talker.published < COUNT)
