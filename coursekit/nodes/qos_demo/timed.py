"""Deadline, lifespan and liveliness: durations on the command line in milliseconds."""

import argparse
import sys

import rclpy
from rclpy.duration import Duration
from rclpy.logging import get_logger
from rclpy.qos import QoSDurabilityPolicy, QoSLivelinessPolicy, QoSProfile, QoSReliabilityPolicy
from rclpy.qos_event import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.utilities import remove_ros_args

from .common import Listener, Talker, spin

POLICIES = {
    "AUTOMATIC": QoSLivelinessPolicy.AUTOMATIC,
    "MANUAL_BY_TOPIC": QoSLivelinessPolicy.MANUAL_BY_TOPIC,
}


def _arguments(name: str, what: str, *options: tuple[str, int, str]) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser()
    parser.add_argument(name, type=int, help=what)
    for flag, default, text in options:
        parser.add_argument(flag, type=int, default=default, help=text)
    return parser


def _parsed(parser: argparse.ArgumentParser) -> argparse.Namespace:
    return parser.parse_args(remove_ros_args(sys.argv)[1:])


def deadline(args: list[str] | None = None) -> int:
    """A talker that pauses misses its deadline; both ends get an event."""
    options = _parsed(
        _arguments(
            "deadline",
            "Deadline [ms]",
            ("--publish-for", 5000, "How long to publish until the talker pauses [ms]"),
            ("--pause-for", 1000, "How long the talker pauses [ms]"),
        )
    )
    rclpy.init(args=args)
    qos = QoSProfile(depth=10, deadline=Duration(seconds=options.deadline / 1000))
    heard = SubscriptionEventCallbacks(deadline=lambda event: get_logger("Listener").info(str(event)))
    told = PublisherEventCallbacks(deadline=lambda event: get_logger("Talker").info(str(event)))
    listener = Listener("qos_deadline_chatter", qos, events=heard)
    talker = Talker("qos_deadline_chatter", qos, events=told)
    talker.create_timer(options.publish_for / 1000, lambda: talker.pause_for(options.pause_for / 1000))
    return spin(listener, talker)


def lifespan(args: list[str] | None = None) -> int:
    """A late listener receives the messages whose lifespan has not expired."""
    options = _parsed(
        _arguments(
            "lifespan",
            "Lifespan [ms]",
            ("--history", 10, "How many messages the talker keeps"),
            ("--publish-count", 10, "How many messages to publish"),
            ("--subscribe-after", 2500, "When the listener subscribes [ms]"),
        )
    )
    rclpy.init(args=args)
    qos = QoSProfile(
        depth=options.history,
        reliability=QoSReliabilityPolicy.RELIABLE,
        durability=QoSDurabilityPolicy.TRANSIENT_LOCAL,
        lifespan=Duration(seconds=options.lifespan / 1000),
    )
    listener = Listener("qos_lifespan_chatter", qos, later=True)
    talker = Talker("qos_lifespan_chatter", qos, publish_count=options.publish_count)
    listener.create_timer(options.subscribe_after / 1000, listener.start_listening)
    return spin(listener, talker)


def liveliness(args: list[str] | None = None) -> int:
    """A talker ends, or no longer asserts its liveliness; events report this."""
    parser = _arguments(
        "liveliness_lease_duration",
        "Lease of the liveliness [ms]",
        ("--topic-assert-period", 0, "How often the talker asserts that it lives [ms]; 0: never"),
        ("--kill-publisher-after", 3000, "When the talker ends [ms]; 0: never"),
    )
    parser.add_argument("--policy", choices=list(POLICIES), default="AUTOMATIC", help="Policy")
    options = _parsed(parser)
    rclpy.init(args=args)
    policy = POLICIES[options.policy]
    lease = Duration(seconds=options.liveliness_lease_duration / 1000)
    qos = QoSProfile(depth=10, liveliness=policy, liveliness_lease_duration=lease)
    heard = SubscriptionEventCallbacks(liveliness=lambda event: get_logger("Listener").info(str(event)))
    told = PublisherEventCallbacks(liveliness=lambda event: get_logger("Talker").info(str(event)))
    listener = Listener("qos_liveliness_chatter", qos, events=heard)
    period = options.topic_assert_period / 1000
    talker = Talker("qos_liveliness_chatter", qos, events=told, assert_period=period)

    def end() -> None:
        killer.cancel()
        talker.stop()
        if policy == QoSLivelinessPolicy.AUTOMATIC:
            talker.destroy_node()

    if options.kill_publisher_after:
        killer = listener.create_timer(options.kill_publisher_after / 1000, end)
    return spin(listener, talker)
