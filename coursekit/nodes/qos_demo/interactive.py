"""A publisher and a subscriber of the C++ demos that keys steer: durations on their command lines are in seconds."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Mapping
from typing import Any

import rclpy
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException
from rclpy.logging import get_logger
from rclpy.node import Node
from rclpy.qos import QoSProfile
from rclpy.qos_event import PublisherEventCallbacks, SubscriptionEventCallbacks

from coursekit.nodes.turtlesim.teleop import keys
from coursekit.processes.process import current_process

from .cpp import CppListener, CppTalker, option
from .timed import POLICIES

TOPIC = "qos_chatter"
INFINITE = 2**63 * 1e-9
"""What a middleware gives for a duration that is not set [s]."""
_SHARED = {
    "--deadline": "deadline [s]",
    "--liveliness": "AUTOMATIC or MANUAL_BY_TOPIC",
    "--lease": "lease of the liveliness [s]",
}
Commands = Mapping[str, Callable[[], Any]]


def _told(options: Mapping[str, str], commands: Mapping[str, str]) -> bool:
    """Print the usage if --help is among the arguments. Returns whether it is."""
    if "--help" not in sys.argv:
        return False
    print(f"{sys.argv[0]} [OPTIONS]\n\nOptions:")
    print("\n".join(f"{name:<14}{text}" for name, text in {"--help": "print this text", **options}.items()))
    print("\nKeys while it runs:")
    print("\n".join(f"{key:<14}{text}" for key, text in {**commands, "q": "print its QoS", "x": "end"}.items()))
    return True


def _asked_qos() -> QoSProfile | None:
    """The QoS that the command line asks for; None, and a message, for a liveliness that there is not."""
    qos = QoSProfile(depth=10)
    kind = option("--liveliness", "AUTOMATIC")
    if kind not in POLICIES:
        print(f"error: invalid liveliness kind specified\nmust be one of: {', '.join(POLICIES)}")
        return None
    if "--liveliness" in sys.argv:
        qos.liveliness = POLICIES[kind]
    qos.deadline = Duration(seconds=float(option("--deadline", "0")))
    qos.liveliness_lease_duration = Duration(seconds=float(option("--lease", "0")))
    return qos


def print_qos(qos: QoSProfile) -> None:
    """Print a profile, policy by policy."""

    def word(policy: Any) -> str:
        return str(policy.name).lower().replace("_", " ")

    def lasting(duration: Duration) -> str:
        return f"{duration.nanoseconds * 1e-9 or INFINITE:g}"

    liveliness = "automatic" if word(qos.liveliness) == "system default" else word(qos.liveliness)
    print(f"HISTORY POLICY: {word(qos.history)} (depth: {qos.depth})")
    print(f"RELIABILITY POLICY: {word(qos.reliability)}\nDURABILITY POLICY: {word(qos.durability)}")
    print(f"DEADLINE: {lasting(qos.deadline)}\nLIFESPAN: {lasting(qos.lifespan)}")
    print(f"LIVELINESS POLICY: {liveliness} (lease duration: {lasting(qos.liveliness_lease_duration)})", flush=True)


def _spin(node: Node) -> None:
    try:
        rclpy.spin(node)
    except ExternalShutdownException:
        pass


def _steer(node: Node, qos: QoSProfile, commands: Commands) -> int:
    """Spin a node, and carry out the commands of keys until x, Ctrl-C or the end of the input."""
    print_qos(qos)
    threading.Thread(target=_spin, args=(node,), daemon=True).start()
    if process := current_process():
        process.want_keys()
    every: Commands = {**commands, "q": lambda: print_qos(qos)}
    try:
        for key in keys(sys.stdin):
            if key == "x":
                print("exiting the demo...", flush=True)
                break
            every.get(key, lambda: None)()
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()
    return 0


def _missed(name: str, what: str) -> Callable[[Any], Any]:
    return lambda event: get_logger(name).info(f"{what} - total {event.total_count} (delta {event.total_count_change})")


def publisher(args: list[str] | None = None) -> int:
    """Publish; s stops and starts, p asserts that the publisher lives."""
    if _told({"--delay": "between two messages [s]", **_SHARED}, {"p": "assert liveliness", "s": "stop or start"}):
        return 0
    if (qos := _asked_qos()) is None:
        return 255
    rclpy.init(args=args)
    events = PublisherEventCallbacks(
        deadline=_missed("talker", "Deadline missed"), liveliness=_missed("talker", "Liveliness lost")
    )
    talker = CppTalker(TOPIC, qos, events=events, period=float(option("--delay", "0.5")))
    return _steer(talker, qos, {"p": talker.assert_liveliness, "s": talker.toggle})


def _changed(event: Any) -> None:
    alive = f"alive {event.alive_count} (delta {event.alive_count_change})"
    dead = f"not alive {event.not_alive_count} (delta {event.not_alive_count_change})"
    get_logger("listener").info(f"Liveliness changed - {alive}, {dead}")


def subscriber(args: list[str] | None = None) -> int:
    """Listen."""
    if _told(_SHARED, {}):
        return 0
    if (qos := _asked_qos()) is None:
        return 255
    rclpy.init(args=args)
    events = SubscriptionEventCallbacks(deadline=_missed("listener", "Deadline missed"), liveliness=_changed)
    return _steer(CppListener(TOPIC, qos, events=events), qos, {})
