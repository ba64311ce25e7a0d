"""`ros2 run joy joy_node`: publishes a gamepad on /joy. Without one, it waits until one is plugged in."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from rclpy.qos import QoSProfile
from sensor_msgs.msg import Joy, JoyFeedback

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.joy.device import Device, devices, name_of
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.running import run

FULL = 32767
LOOK_SECONDS = 1.0
"""How often to look for a gamepad while there is none."""
POLL_SECONDS = 0.005
_DEFAULTS: dict[str, Any] = {
    "device_id": 0, "device_name": "", "deadzone": 0.05, "autorepeat_rate": 20.0, "sticky_buttons": False,
    "coalesce_interval_ms": 1,
}  # fmt: skip


class GamepadNode(CppNode):
    """Publishes a gamepad on changes, and `autorepeat_rate` times a second; `given` has its parameters."""

    def __init__(self, name: str, defaults: dict[str, Any]) -> None:
        super().__init__(name)
        self._given = declare(self, defaults)
        self._deadzone, self._rate, coalesce = self.settings()
        self._device: Device | None = None
        self._toggled: list[int] = []
        self._said_ns = 0
        self._out = self.create_publisher(Joy, "joy", QoSProfile(depth=10))
        self._poll = self.create_timer(max(POLL_SECONDS, coalesce), self._work)
        self._poll.cancel()
        self._look()
        self.create_timer(LOOK_SECONDS, self._look)

    def settings(self) -> tuple[float, float, float]:
        """Return the dead zone, the rate of repetition and the seconds between two readings."""
        raise NotImplementedError

    def wanted(self) -> Path | None:
        """Return the selected gamepad, if it is there."""
        raise NotImplementedError

    def opened(self, device: Device) -> None:
        """Say that the gamepad is open."""
        raise NotImplementedError

    def missing(self, fault: OSError | None) -> None:
        """Say, if it shall be said, that there is no gamepad, or none that can be opened."""
        raise NotImplementedError

    def _look(self) -> None:
        """Open the selected gamepad, if it is there."""
        if self._device is not None:
            return
        path = self.wanted()
        if path is None:
            return self.missing(None)
        try:
            self._device = Device(path)
        except OSError as fault:
            return self.missing(fault)
        self._toggled.clear()
        self.opened(self._device)
        self._poll.reset()

    def _work(self) -> None:
        if self._device is None:
            return
        try:
            moved = self._device.read()
        except OSError as fault:
            self.get_logger().info(f"Lost joystick: {fault}")
            self._device.close()
            self._device = None
            self._poll.cancel()
            return
        rate, now = self._rate, self.get_clock().now().nanoseconds
        if moved or (rate > 0 and now - self._said_ns >= 1e9 / rate):
            self._said_ns = now
            self._publish(self._device)

    def _publish(self, device: Device) -> None:
        msg = Joy()
        msg.header.frame_id, msg.header.stamp = "joy", self.get_clock().now().to_msg()
        msg.axes = [scaled(value, self._deadzone) for value in device.axes]
        msg.buttons = self._sticky(device) if self._given["sticky_buttons"] else list(device.buttons)
        self._out.publish(msg)

    def _sticky(self, device: Device) -> list[int]:
        """Return the state of sticky buttons: on until pressed again."""
        self._toggled.extend([0] * (len(device.buttons) - len(self._toggled)))
        for number in device.pressed:
            self._toggled[number] = 1 - self._toggled[number]
        device.pressed.clear()
        return list(self._toggled)


class JoyNode(GamepadNode):
    """joy's node: gamepads by number or name. ValueError for invalid parameters."""

    def __init__(self) -> None:
        super().__init__("joy_node", _DEFAULTS)
        self.create_subscription(JoyFeedback, "joy/set_feedback", lambda msg: None, 10)

    def settings(self) -> tuple[float, float, float]:
        """Refuse what Humble's refuses."""
        given = self._given
        if not 0.0 <= given["deadzone"] <= 1.0:
            raise ValueError("Deadzone must be between 0.0 and 1.0")
        if given["autorepeat_rate"] < 0.0:
            raise ValueError("Autorepeat rate must be >= 0.0")
        if given["autorepeat_rate"] > 1000.0:
            raise ValueError("Autorepeat rate must be <= 1000.0")
        if given["coalesce_interval_ms"] < 0:
            raise ValueError("coalesce_interval_ms must be positive")
        return given["deadzone"], given["autorepeat_rate"], given["coalesce_interval_ms"] * 1e-3

    def wanted(self) -> Path | None:
        """Look for the name, or take the gamepad of that number."""
        name, number = self._given["device_name"], self._given["device_id"]
        paths = devices()
        chosen = [path for path in paths if name_of(path) == name][:1] if name else paths[number : number + 1]
        return chosen[0] if number >= 0 and chosen else None

    def opened(self, device: Device) -> None:
        """Say it as Humble does."""
        log = self.get_logger()
        log.info("No haptic (rumble) available, skipping initialization")
        log.info(f"Opened joystick: {device.name}.  deadzone: {self._deadzone:f}")

    def missing(self, fault: OSError | None) -> None:
        """Wait quietly, but tell what cannot be opened."""
        if fault is not None:
            number = self._given["device_id"]
            self.get_logger().warning(f"Unable to open joystick {number}: {fault}", throttle_duration_sec=10.0)


def scaled(value: int, deadzone: float) -> float:
    """Convert an axis to -1 … 1, forward and left positive; 0 within the dead zone, continuous at its edge.

    >>> [scaled(value, 0.5) for value in (0, 16000, 32767, -32768)]
    [0.0, 0.0, -1.0, 1.0]
    """
    dead = FULL * deadzone
    size = max(abs(max(value, -FULL)) - dead, 0.0)
    if not size:
        return 0.0
    return (-1.0 if value > 0 else 1.0) * size / (FULL - dead)


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(JoyNode, args, refuses=(ValueError,))


def enumerate_devices(args: list[str] | None = None) -> int:
    """List the connected gamepads."""
    print("Joystick Device ID : Joystick Device Name")
    print("-" * 41)
    for number, path in enumerate(devices()):
        print(f"{number:18} : {name_of(path)}")
    return 0
