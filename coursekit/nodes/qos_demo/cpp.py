"""The same demos with the names, options and words of the C++ package: a word that is no option is passed over."""

from __future__ import annotations

import re
import sys
from typing import Any

import rclpy
from rclpy.duration import Duration
from rclpy.logging import get_logger
from rclpy.qos import QoSDurabilityPolicy, QoSProfile, QoSReliabilityPolicy
from rclpy.qos_event import PublisherEventCallbacks, SubscriptionEventCallbacks

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import terminate

from .common import Listener, Talker, spin
from .incompatible import POLICIES as PAIRS
from .incompatible import told_of
from .timed import POLICIES


class NotANumber(ValueError):
    """A word that std::stoul refuses."""


class CppTalker(Talker, CppNode):
    """The talker of the C++ demos."""

    NAME, TOLD = "talker", "Publishing: '{}'"

    def assert_liveliness(self) -> None:
        """Say that the publisher lives, and print it."""
        print("asserting publisher liveliness", flush=True)
        super().assert_liveliness()

    def toggle(self) -> None:
        """Stop publishing, or start again."""
        stopped = self._timer.is_canceled()
        print(f"{'start' if stopped else 'stop'} sending messages", flush=True)
        if stopped:
            self._timer.reset()
        else:
            self._timer.cancel()


class CppListener(Listener, CppNode):
    """The listener of the C++ demos."""

    NAME, TOLD = "listener", "Listener heard: [{}]"

    def __init__(self, *args: Any, **options: Any) -> None:
        get_logger(self.NAME).info("Listener starting up")
        super().__init__(*args, **options)

    def _subscribed(self) -> None:
        """The C++ demos do not tell it."""


def option(name: str, default: str) -> str:
    """The word after an option on the command line."""
    words = sys.argv
    at = words.index(name) + 1 if name in words else len(words)
    return words[at] if at < len(words) else default


def seconds(word: str) -> float:
    """The seconds of a number of milliseconds, which is read as far as there are digits.

    >>> seconds("1500ms")
    1.5
    """
    digits = re.match(r"\s*\+?(\d+)", word)
    if digits is None:
        raise NotANumber("stoul")
    return int(digits[1]) / 1000


def _usage(name: str, required: str, *options: str) -> bool:
    """Print how a program is started, where it is started without arguments or with -h. Returns whether it was."""
    if len(sys.argv) > 1 and "-h" not in sys.argv:
        return False
    _tell_usage(name, required, *options)
    return True


def _tell_usage(name: str, required: str, *options: str) -> None:
    print(f"Usage for {name}:\n{name} {required} {' '.join(f'[{word}]' for word in (*options, '-h'))}")
    if any(word.startswith("--") for word in options):
        print("Durations are in milliseconds.")


def deadline(args: list[str] | None = None) -> int:
    """A talker that pauses misses its deadline; both ends get an event."""
    if _usage("deadline", "deadline_duration", "--publish-for 5000", "--pause-for 1000"):
        return 0
    try:
        period, lasting = seconds(sys.argv[1]), seconds(option("--pause-for", "1000"))
        running = seconds(option("--publish-for", "5000"))
    except NotANumber as fault:
        return terminate(str(fault), "std::invalid_argument")
    rclpy.init(args=args)
    qos = QoSProfile(depth=10, deadline=Duration(seconds=period))

    def tell(name: str, what: str) -> Any:
        text = f"{what} deadline missed - total {{0.total_count}} delta {{0.total_count_change}}"
        return lambda event: get_logger(name).info(text.format(event))

    talker = CppTalker("qos_deadline_chatter", qos, events=PublisherEventCallbacks(deadline=tell("talker", "Offered")))
    heard = SubscriptionEventCallbacks(deadline=tell("listener", "Requested"))
    listener = CppListener("qos_deadline_chatter", qos, events=heard)
    talker.create_timer(running, lambda: talker.pause_for(lasting))
    return spin(talker, listener)


def lifespan(args: list[str] | None = None) -> int:
    """A late listener receives the messages whose lifespan has not expired."""
    if _usage("lifespan", "lifespan_duration", "--history 10", "--publish-count 5", "--subscribe-after 5000"):
        return 0
    try:
        lasting, after = seconds(sys.argv[1]), seconds(option("--subscribe-after", "5000"))
        depth, count = (round(seconds(option(*pair)) * 1000) for pair in (("--history", "10"), ("--publish-count", "5")))
    except NotANumber as fault:
        return terminate(str(fault), "std::invalid_argument")
    rclpy.init(args=args)
    qos = QoSProfile(
        depth=depth,
        reliability=QoSReliabilityPolicy.RELIABLE,
        durability=QoSDurabilityPolicy.TRANSIENT_LOCAL,
        lifespan=Duration(seconds=lasting),
    )
    talker = CppTalker("qos_lifespan_chatter", qos, publish_count=count)
    listener = CppListener("qos_lifespan_chatter", qos, later=True)
    listener.create_timer(after, listener.start_listening)
    return spin(talker, listener)


def _alive(event: Any) -> None:
    log = get_logger("listener")
    log.info("Liveliness changed event:")
    for name in ("alive_count", "not_alive_count", "alive_count_change", "not_alive_count_change"):
        log.info(f"  {name}: {getattr(event, name)}")


def liveliness(args: list[str] | None = None) -> int:
    """A talker ends, or no longer asserts its liveliness; events report this."""
    usage = ("liveliness", "lease_duration", "--policy AUTOMATIC", "--topic-assert-period 0", "--kill-publisher-after 3000")
    if _usage(*usage):
        return 0
    policy = option("--policy", "AUTOMATIC")
    try:
        lease, asserting = seconds(sys.argv[1]), seconds(option("--topic-assert-period", "0"))
        after = seconds(option("--kill-publisher-after", "3000"))
    except NotANumber as fault:
        return terminate(str(fault), "std::invalid_argument")
    if policy not in POLICIES:
        print(f"Unknown liveliness policy: {policy}")
        _tell_usage(*usage)
        return 1
    rclpy.init(args=args)
    qos = QoSProfile(depth=10, liveliness=POLICIES[policy], liveliness_lease_duration=Duration(seconds=lease))
    talker = CppTalker("qos_liveliness_chatter", qos, assert_period=asserting)
    listener = CppListener("qos_liveliness_chatter", qos, events=SubscriptionEventCallbacks(liveliness=_alive))

    def end() -> None:
        killer.cancel()
        talker.stop()
        if policy == "AUTOMATIC":
            talker.destroy_node()

    killer = listener.create_timer(after, end)
    return spin(talker, listener)


def incompatible(args: list[str] | None = None) -> int:
    """Publish five messages that the listener does not receive; both ends get an event with the reason."""
    usage = ("incompatible_qos", "|".join(PAIRS))
    if _usage(*usage):
        return 0
    if sys.argv[1] not in PAIRS:
        print(f"{sys.argv[1]} is not a valid qos policy name")
        _tell_usage(*usage)
        return 0
    pair, count = PAIRS[sys.argv[1]], 5
    print(pair)
    rclpy.init(args=args)
    told = PublisherEventCallbacks(incompatible_qos=told_of("talker", "Offered"))
    heard = SubscriptionEventCallbacks(incompatible_qos=told_of("listener", "Requested"))
    topic = "qos_incompatible_qos_chatter"
    talker = CppTalker(topic, QoSProfile(depth=10, **pair.offered), events=told, publish_count=count)
    listener = CppListener(topic, QoSProfile(depth=10, **pair.asked), events=heard)
    return spin(talker, listener, lambda _: talker.published < count)
