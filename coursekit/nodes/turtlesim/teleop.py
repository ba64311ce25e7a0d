"""The node `teleop_turtle`: drives turtle1 with keys from its standard input."""

from __future__ import annotations

import sys
import threading
from collections.abc import Iterator
from typing import Any, TextIO

import rclpy
from geometry_msgs.msg import Twist
from rclpy.action import ActionClient
from rclpy.executors import ExternalShutdownException
from turtlesim.action import RotateAbsolute

from coursekit.nodes.cpp_node import CppNode
from coursekit.processes.process import current_process

ARROWS = {"up": (1.0, 0.0), "down": (-1.0, 0.0), "right": (0.0, -1.0), "left": (0.0, 1.0)}
"""Arrow keys: (linear, angular)."""
_SEQUENCES = {"A": "up", "B": "down", "C": "right", "D": "left"}
"""The last letter of an arrow key's escape sequence."""
HEADINGS = {
    "g": 0.0,
    "t": 0.7854,
    "r": 1.5708,
    "e": 2.3562,
    "d": 3.1416,
    "c": -2.3562,
    "v": -1.5708,
    "b": -0.7854,
}
"""The keys around F on a keyboard, as the directions of a compass [rad]."""
USAGE = """\
Reading from keyboard
---------------------------
Use arrow keys to move the turtle.
Use G|B|V|C|D|E|R|T keys to rotate to absolute orientations. 'F' to cancel a rotation.
'Q' to quit."""


def keys(stream: TextIO) -> Iterator[str]:
    """Yield the typed keys: 'up', 'down', 'right', 'left' or a lower-case letter.

    >>> import io
    >>> list(keys(io.StringIO(chr(27) + "[AgQ" + chr(27) + "OD")))
    ['up', 'g', 'q', 'left']
    """
    while key := stream.read(1):
        if key == "\x1b":
            opening, letter = stream.read(1), stream.read(1)
            if opening in ("[", "O") and letter in _SEQUENCES:
                yield _SEQUENCES[letter]
        elif key.isalpha():
            yield key.lower()


class TeleopTurtle(CppNode):
    """Converts keys to velocities and rotation goals."""

    def __init__(self) -> None:
        super().__init__("teleop_turtle")
        self.declare_parameter("scale_angular", 2.0)
        self.declare_parameter("scale_linear", 2.0)
        self._publisher = self.create_publisher(Twist, "turtle1/cmd_vel", 1)
        self._rotate = ActionClient(self, RotateAbsolute, "turtle1/rotate_absolute")
        self._goal: Any = None

    def press(self, key: str) -> bool:
        """Execute a key. Return False for the key that quits."""
        if key in ARROWS:
            self._move(*ARROWS[key])
        elif key in HEADINGS:
            self._turn_to(HEADINGS[key])
        elif key == "f" and self._goal is not None:
            self._goal.cancel_goal_async()
        return key != "q"

    def _move(self, linear: float, angular: float) -> None:
        twist = Twist()
        twist.linear.x = linear * self.get_parameter("scale_linear").value
        twist.angular.z = angular * self.get_parameter("scale_angular").value
        self._publisher.publish(twist)

    def _turn_to(self, theta: float) -> None:
        asked = self._rotate.send_goal_async(RotateAbsolute.Goal(theta=theta))
        asked.add_done_callback(self._take_goal)

    def _take_goal(self, asked: Any) -> None:
        self._goal = asked.result()


def _spin(node: CppNode) -> None:
    try:
        rclpy.spin(node)
    except ExternalShutdownException:
        pass


def main(args: list[str] | None = None) -> None:
    """Read keys until Q, the end of the input or Ctrl-C."""
    rclpy.init(args=args)
    node = TeleopTurtle()
    threading.Thread(target=_spin, args=(node,), daemon=True).start()
    print(USAGE, flush=True)
    process = current_process()
    if process is not None:
        process.want_keys()
    try:
        for key in keys(sys.stdin):
            if not node.press(key):
                break
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()
