"""A talker that offers less than the listener requests: no message arrives, and both get an event with the reason."""

import argparse
import sys
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import rclpy
from rclpy.duration import Duration
from rclpy.logging import get_logger
from rclpy.qos import QoSDurabilityPolicy, QoSLivelinessPolicy, QoSProfile, QoSReliabilityPolicy
from rclpy.qos_event import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.utilities import remove_ros_args

from .common import Listener, Talker, spin

TOPIC, COUNT = "incompatible_qos_chatter", 5


@dataclass(frozen=True)
class Pair:
    """Offers of a talker and requests of a listener that do not match, and how the demo reports them."""

    name: str
    condition: str
    setting: str
    told: tuple[str, str]
    offered: dict[str, Any]
    asked: dict[str, Any]

    def __str__(self) -> str:
        return (
            f"{self.name} incompatibility selected.\nIncompatibility condition: {self.condition}.\n"
            f"Setting publisher {self.setting} to: {self.told[0]}\nSetting subscription {self.setting} to: {self.told[1]}\n"
        )


_SECONDS = ("2 seconds", "1 second")
POLICIES = {
    "durability": Pair(
        "Durability", "publisher durability kind < subscription durability kind", "durability",
        ("VOLATILE", "TRANSIENT_LOCAL"),
        {"durability": QoSDurabilityPolicy.VOLATILE}, {"durability": QoSDurabilityPolicy.TRANSIENT_LOCAL},
    ),
    "deadline": Pair(
        "Deadline", "publisher deadline > subscription deadline", "deadline", _SECONDS,
        {"deadline": Duration(seconds=2)}, {"deadline": Duration(seconds=1)},
    ),
    "liveliness_policy": Pair(
        "Liveliness Policy", "publisher liveliness policy < subscription liveliness policy", "liveliness policy",
        ("AUTOMATIC", "MANUAL_BY_TOPIC"),
        {"liveliness": QoSLivelinessPolicy.AUTOMATIC}, {"liveliness": QoSLivelinessPolicy.MANUAL_BY_TOPIC},
    ),
    "liveliness_lease_duration": Pair(
        "Liveliness lease duration", "publisher liveliness lease duration > subscription liveliness lease duration",
        "liveliness lease duration", _SECONDS,
        {"liveliness_lease_duration": Duration(seconds=2)}, {"liveliness_lease_duration": Duration(seconds=1)},
    ),
    "reliability": Pair(
        "Reliability", "publisher reliability < subscription reliability", "reliability", ("BEST_EFFORT", "RELIABLE"),
        {"reliability": QoSReliabilityPolicy.BEST_EFFORT}, {"reliability": QoSReliabilityPolicy.RELIABLE},
    ),
}  # fmt: skip


def told_of(name: str, what: str) -> Callable[[Any], None]:
    """A callback that logs an event of QoS that do not match."""

    def tell(event: Any) -> None:
        get_logger(name).info(
            f"{what} incompatible qos - total {event.total_count} delta {event.total_count_change} "
            f"last_policy_kind: {event.last_policy_kind}"
        )

    return tell


def main(args: list[str] | None = None) -> int:
    """Publish five messages that the listener does not receive."""
    parser = argparse.ArgumentParser()
    parser.add_argument("incompatible_qos_policy_name", choices=list(POLICIES), help="The policy that shall not match")
    pair = POLICIES[parser.parse_args(remove_ros_args(sys.argv)[1:]).incompatible_qos_policy_name]
    print(pair)
    rclpy.init(args=args)
    told = PublisherEventCallbacks(incompatible_qos=told_of("talker", "Offered"))
    heard = SubscriptionEventCallbacks(incompatible_qos=told_of("listener", "Requested"))
    talker = Talker(TOPIC, QoSProfile(depth=10, **pair.offered), events=told, publish_count=COUNT)
    listener = Listener(TOPIC, QoSProfile(depth=10, **pair.asked), events=heard)
    return spin(listener, talker, lambda _: talker.published < COUNT)
