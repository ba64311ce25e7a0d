"""`ros2 run twist_mux joystick_relay.py`: joy_vel_in as joy_vel_out, in steps of speed, while the gamepad has priority."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from geometry_msgs.msg import Twist
from rclpy.action import ActionServer
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import Bool
from twist_mux_msgs.action import JoyPriority, JoyTurbo
from visualization_msgs.msg import Marker

from coursekit.nodes.running import run

_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


@dataclass
class Range:
    """The speeds of full deflection, from the first step to the last.

    >>> Range(0.2, 0.8, 4).at(1), Range(0.2, 0.8, 4).at(3), Range(0.2, 0.8, 1).at(1)
    (0.2, 0.6000000000000001, 0.2)
    """

    least: float
    most: float
    steps: int

    def at(self, step: int) -> float:
        """The speed of a step, from 1."""
        return self.least + (self.most - self.least) / max(self.steps - 1, 1) * (step - 1)


class Turbo:
    """The steps of speed, for driving and for turning. ValueError for speeds or steps that are not positive."""

    def __init__(self, node: Node) -> None:
        self._node = node
        self._steps = int(self._given("steps", 1))
        self._forward = self._range("linear_forward")
        self._backward = self._range("linear_backward", self._forward)
        self._lateral, self._angular = self._range("linear_lateral"), self._range("angular")
        middle = (self._steps + 1) // 2
        self._first = int(self._given("init_step", middle))
        if not 1 <= self._first <= self._steps:
            node.get_logger().warning(
                f"Initial step {self._first} outside range [1, {self._steps}]! Falling back to default {middle}"
            )
            self._first = middle
        self._step = self._angular_step = self._first

    def _given(self, name: str, default: float) -> float:
        value = self._node.declare_parameter(f"turbo.{name}", default).value
        if not value > 0 and name != "init_step":
            raise ValueError(f"turbo.{name} is {value}: give a number above 0")
        return float(value)

    def _range(self, name: str, default: Range | None = None) -> Range:
        usual = default or Range(1.0, 1.0, 1)
        return Range(self._given(f"{name}_min", usual.least), self._given(f"{name}_max", usual.most), self._steps)

    def scaled(self, asked: Twist) -> Twist:
        """The velocity for a gamepad's deflections of -1 to 1; zero where they are none."""
        velocity, reason = Twist(), _fault(asked)
        if reason:
            self._node.get_logger().error(reason)
            return velocity
        along = self._forward if asked.linear.x >= 0 else self._backward
        velocity.linear.x = asked.linear.x * along.at(self._step)
        velocity.linear.y = asked.linear.y * self._lateral.at(self._step)
        velocity.angular.z = asked.angular.z * self._angular.at(self._angular_step)
        return velocity

    def change(self, by: int) -> None:
        """Go up or down a step, driving and turning."""
        self._step = min(max(self._step + by, 1), self._steps)
        self.change_angular(by)

    def change_angular(self, by: int) -> None:
        """Go up or down a step, turning alone."""
        self._angular_step = min(max(self._angular_step + by, 1), self._steps)

    def reset(self) -> None:
        """Go back to the first step."""
        self._step = self._angular_step = self._first


def _fault(asked: Twist) -> str:
    """What is wrong with a gamepad's deflections."""
    if asked.linear.z or asked.angular.x or asked.angular.y:
        return "Joystick provided invalid values, only linear.x, linear.y and angular.z may be non-zero."
    deflections = (asked.linear.x, asked.linear.y, asked.angular.z)
    if max(map(abs, deflections)) > 1.0:
        return "Joystick provided invalid values ({:g}, {:g}, {:g}), not in [-1, 1] range.".format(*deflections)
    return ""


class JoystickRelay(Node):
    """Tells twist_mux on joy_priority whether the gamepad has it; actions toggle that, and change the steps."""

    def __init__(self) -> None:
        super().__init__("joystick_relay")
        self._priority = bool(self.declare_parameter("priority", True).value)
        self._turbo = turbo = Turbo(self)
        self._out = self.create_publisher(Twist, "joy_vel_out", 1)
        self._told = self.create_publisher(Bool, "joy_priority", _KEPT)
        self._shown = self.create_publisher(Marker, "text_marker", _KEPT)
        self.create_subscription(Twist, "joy_vel_in", self._pass, 1)
        self.create_timer(1.0, self._show)
        self._serve("joy_priority_action", JoyPriority, self._toggle)
        self._serve("joy_turbo_increase", JoyTurbo, lambda: turbo.change(1))
        self._serve("joy_turbo_decrease", JoyTurbo, lambda: turbo.change(-1))
        self._serve("joy_turbo_angular_increase", JoyTurbo, lambda: turbo.change_angular(1))
        self._serve("joy_turbo_angular_decrease", JoyTurbo, lambda: turbo.change_angular(-1))
        self._serve("joy_turbo_reset", JoyTurbo, turbo.reset)
        self._told.publish(Bool(data=self._priority))
        self._show()

    def _serve(self, name: str, kind: Any, act: Callable[[], None]) -> None:
        """An action that acts and has succeeded."""

        def carry_out(goal: Any) -> Any:
            act()
            goal.succeed()
            return kind.Result()

        ActionServer(self, kind, name, carry_out)

    def _pass(self, msg: Twist) -> None:
        if self._priority:
            self._out.publish(self._turbo.scaled(msg))
        self._show()

    def _toggle(self) -> None:
        self._priority = not self._priority
        self.get_logger().info(f"Toggled joy_priority, current status is: {self._priority}")
        self._told.publish(Bool(data=self._priority))
        self._show()
        if self._priority:
            self._out.publish(Twist())

    def _show(self) -> None:
        text = Marker(type=Marker.TEXT_VIEW_FACING, text="Manual" if self._priority else "Autonomous")
        text.header.frame_id, text.pose.position.z, text.scale.z = "base_footprint", 2.0, 0.5
        text.color.r = text.color.g = text.color.b = text.color.a = 1.0
        self._shown.publish(text)


def main(args: list[str] | None = None) -> int:
    """Relay until Ctrl-C."""
    return run(JoystickRelay, args, refuses=(ValueError,))
