"""`ros2 run teleop_twist_keyboard teleop_twist_keyboard`: converts keys on its standard input to velocities."""

from __future__ import annotations

import sys
from typing import Any

import rclpy
from geometry_msgs.msg import Twist, TwistStamped
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from coursekit.processes.process import current_process

USAGE = """
Keys typed here become Twist messages; a US keyboard has them where they belong.
---------------------------
Moving around:
   u    i    o
   j    k    l
   m    ,    .

For Holonomic mode (strafing), hold down the shift key:
---------------------------
   U    I    O
   J    K    L
   M    <    >

t : up (+z)
b : down (-z)

anything else : stop

q/z : increase/decrease max speeds by 10%
w/x : increase/decrease only linear speed by 10%
e/c : increase/decrease only angular speed by 10%

CTRL-C to quit
"""
MOVES: dict[str, tuple[int, int, int, int]] = {
    "i": (1, 0, 0, 0), "o": (1, 0, 0, -1), "j": (0, 0, 0, 1), "l": (0, 0, 0, -1), "u": (1, 0, 0, 1),
    ",": (-1, 0, 0, 0), ".": (-1, 0, 0, 1), "m": (-1, 0, 0, -1),
    "O": (1, -1, 0, 0), "I": (1, 0, 0, 0), "J": (0, 1, 0, 0), "L": (0, -1, 0, 0), "U": (1, 1, 0, 0),
    "<": (-1, 0, 0, 0), ">": (-1, -1, 0, 0), "M": (-1, 1, 0, 0), "t": (0, 0, 1, 0), "b": (0, 0, -1, 0),
}  # fmt: skip
"""The direction of each key: forward, left, up, rotation to the left."""
SPEEDS = {"q": (1.1, 1.1), "z": (0.9, 0.9), "w": (1.1, 1.0), "x": (0.9, 1.0), "e": (1.0, 1.1), "c": (1.0, 0.9)}
"""The factors of each key for the linear and the angular speed."""
REMIND = 15
"""The number of speed changes after which the keys are shown again."""


class TeleopTwistKeyboard(Node):
    """Converts keys to Twist, or to TwistStamped if the parameter `stamped` is set."""

    def __init__(self) -> None:
        super().__init__("teleop_twist_keyboard")
        fixed = ParameterDescriptor(read_only=True)
        self._stamped = bool(self.declare_parameter("stamped", False, fixed).value)
        self._frame = str(self.declare_parameter("frame_id", "", fixed).value)
        if not self._stamped and self._frame:
            raise ValueError("'frame_id' can only be set when 'stamped' is True")
        self.speed = float(self.declare_parameter("speed", 0.5).value)
        self.turn = float(self.declare_parameter("turn", 1.0).value)
        self._out = self.create_publisher(TwistStamped if self._stamped else Twist, "cmd_vel", 10)
        self._changes = 0

    def told(self) -> str:
        """The line that shows the speeds."""
        return f"currently:\tspeed {self.speed}\tturn {self.turn} "

    def press(self, key: str, direction: tuple[int, int, int, int]) -> tuple[int, int, int, int]:
        """Execute a key, given the direction so far. Return the new direction."""
        if key in MOVES:
            direction = MOVES[key]
        elif key in SPEEDS:
            self._scale(*SPEEDS[key])
        else:
            direction = (0, 0, 0, 0)
        self.publish(direction)
        return direction

    def _scale(self, linear: float, angular: float) -> None:
        self.speed, self.turn = self.speed * linear, self.turn * angular
        print(self.told(), flush=True)
        if self._changes == REMIND - 1:
            print(USAGE, flush=True)
        self._changes = (self._changes + 1) % REMIND

    def publish(self, direction: tuple[int, int, int, int]) -> None:
        """Publish the velocity for a direction."""
        message: Any = TwistStamped() if self._stamped else Twist()
        twist = message
        if self._stamped:
            message.header.stamp, message.header.frame_id = self.get_clock().now().to_msg(), self._frame
            twist = message.twist
        x, y, z, turning = direction
        twist.linear.x, twist.linear.y, twist.linear.z = x * self.speed, y * self.speed, z * self.speed
        twist.angular.z = turning * self.turn
        self._out.publish(message)


def main(args: list[str] | None = None) -> None:
    """Read keys until Ctrl-C or the end of the input; then stop the robot."""
    rclpy.init(args=args)
    node = TeleopTwistKeyboard()
    process = current_process()
    if process is not None:
        process.want_keys()
    direction = (0, 0, 0, 0)
    print(USAGE)
    print(node.told(), flush=True)
    try:
        while (key := sys.stdin.read(1)) not in ("", "\x03"):
            if key != "\n":
                direction = node.press(key, direction)
    except KeyboardInterrupt:
        pass
    finally:
        if rclpy.ok():
            node.publish((0, 0, 0, 0))
        rclpy.try_shutdown()
