"""`ros2 run twist_mux twist_mux`: several topics of velocities in; the one of highest priority out on cmd_vel_out."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from diagnostic_msgs.msg import DiagnosticStatus
from diagnostic_updater import DiagnosticStatusWrapper, Updater
from geometry_msgs.msg import Twist, TwistStamped
from rclpy.node import Node
from std_msgs.msg import Bool

from coursekit.nodes.running import run

DEPTH = 10


class Input:
    """A topic with a priority; it is ignored when it has been silent for `timeout` seconds (0: never)."""

    def __init__(self, node: Node, name: str, kind: Any, given: dict[str, Any], heard: Callable[[Any], None]) -> None:
        missing = [key for key in ("topic", "timeout", "priority") if key not in given]
        if missing:
            raise ValueError(f"{name} has no {' and no '.join(missing)}")
        self.name, self.topic, self._clock = name, str(given["topic"]), node.get_clock()
        self.timeout, self.priority = float(given["timeout"]), int(given["priority"])
        self._heard, self._stamp_ns, self.last = heard, 0, None
        node.create_subscription(kind, self.topic, self._hear, DEPTH)
        node.get_logger().info(
            f"Topic handler '{name}' subscribed to topic '{self.topic}': timeout = "
            f"{f'{self.timeout:f}s' if self.timeout > 0 else 'None'}, priority = {self.priority}."
        )

    def _hear(self, msg: Any) -> None:
        self.last, self._stamp_ns = msg, self._clock.now().nanoseconds
        self._heard(msg)

    @property
    def silent(self) -> bool:
        """Whether no message has arrived within the timeout."""
        return self.timeout > 0 and self._clock.now().nanoseconds - self._stamp_ns > self.timeout * 1e9

    @property
    def locked(self) -> bool:
        """Whether a lock is set, or silent, because then its publisher may have died."""
        return self.silent or bool(self.last is not None and self.last.data)


class TwistMux(Node):
    """Passes on velocities from the active topic of highest priority; locks mask all topics of lower priority."""

    def __init__(self) -> None:
        super().__init__(
            "twist_mux", allow_undeclared_parameters=True, automatically_declare_parameters_from_overrides=True
        )
        stamped = self.has_parameter("use_stamped") and bool(self.get_parameter("use_stamped").value)
        self._kind = TwistStamped if stamped else Twist
        self._out = self.create_publisher(self._kind, "cmd_vel_out", 1)
        self.inputs: list[Input] = []
        self.locks: list[Input] = []
        try:
            self._listen()
        except (ValueError, TypeError) as fault:
            self.get_logger().fatal(f"Error parsing params: {fault}; each one has topic, timeout and priority")
        self._updater = Updater(self)
        self._updater.setHardwareID("none")
        self._updater.add("Twist mux status", self._tell)

    def _listen(self) -> None:
        for name, given in self._groups("topics").items():
            self.inputs.append(Input(self, name, self._kind, given, partial(self._hear, name)))
        for name, given in self._groups("locks").items():
            self.locks.append(Input(self, name, Bool, given, lambda msg: None))

    def _groups(self, prefix: str) -> dict[str, dict[str, Any]]:
        """Parameters below a prefix, such as topics.joystick.priority, grouped by the name after the prefix."""
        groups: dict[str, dict[str, Any]] = {}
        for key, parameter in self.get_parameters_by_prefix(prefix).items():
            name, _, field = key.rpartition(".")
            groups.setdefault(name, {})[field] = parameter.value
        return groups

    def lock_priority(self) -> int:
        """The priority below which inputs are masked."""
        return max((lock.priority for lock in self.locks if lock.locked), default=0)

    def leader(self) -> str:
        """The name of the active input of highest priority; empty if there is none."""
        least = self.lock_priority()
        able = [entry for entry in self.inputs if not entry.silent and entry.priority >= least and entry.priority > 0]
        return max(able, key=lambda entry: entry.priority).name if able else ""

    def _hear(self, name: str, msg: Any) -> None:
        if self.leader() == name:
            self._out.publish(msg)

    def _tell(self, status: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        status.summary(DiagnosticStatus.OK, "ok")
        least = self.lock_priority()
        for entry in self.inputs:
            self._tell_input(status, "velocity", entry, "masked" if entry.silent or entry.priority < least else "unmasked")
        for lock in self.locks:
            self._tell_input(status, "lock", lock, "locked" if lock.locked else "free")
        status.add("current priority", least)
        return status

    @staticmethod
    def _tell_input(status: DiagnosticStatusWrapper, kind: str, source: Input, word: str) -> None:
        about = f"(listening to {source.topic} @ {source.timeout:f}s with priority #{source.priority})"
        status.add(f"{kind} {source.name}", f" {word} {about}")


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(TwistMux, args)
