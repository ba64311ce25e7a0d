"""`ros2 run teleop_twist_joy teleop_node`: while a button is held, a gamepad's sticks drive the robot."""

from __future__ import annotations

from typing import Any

from geometry_msgs.msg import Twist, TwistStamped
from rclpy.logging import get_logger
from sensor_msgs.msg import Joy

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.nav2.parameters import Obedience, declare
from coursekit.nodes.running import run

_LINEAR, _ANGULAR = ("x", "y", "z"), ("yaw", "pitch", "roll")
_FIELDS = {"x": "x", "y": "y", "z": "z", "roll": "x", "pitch": "y", "yaw": "z"}


def _defaults() -> dict[str, Any]:
    defaults: dict[str, Any] = {"require_enable_button": True, "enable_button": 5, "enable_turbo_button": -1}
    for kind, fields, axis in (("linear", _LINEAR, 5), ("angular", _ANGULAR, 2)):
        for k, field in enumerate(fields):
            defaults[f"axis_{kind}.{field}"] = -1 if k else axis
            defaults[f"scale_{kind}.{field}"] = 0.0 if k else 0.5
            defaults[f"scale_{kind}_turbo.{field}"] = 0.0 if k else 1.0
    return defaults


class TeleopTwistJoy(CppNode):
    """Joy in, Twist (TwistStamped if `publish_stamped_twist` is set) out; one stop when the button is released."""

    def __init__(self) -> None:
        super().__init__("teleop_twist_joy_node")
        self._stopped = False
        fixed = declare(self, {"publish_stamped_twist": False, "frame": "teleop_twist_joy"})
        self._stamped, self._frame = fixed["publish_stamped_twist"], fixed["frame"]
        self._out = self.create_publisher(TwistStamped if self._stamped else Twist, "cmd_vel", 10)
        self.create_subscription(Joy, "joy", self._hear, 10)
        self._read()
        self._obedience = Obedience(self, self._read)
        self._tell()

    def _read(self) -> None:
        self._given = declare(self, _defaults())

    def _tell(self) -> None:
        """Log the buttons, and the number and scale of each axis."""
        log, given = get_logger("TeleopTwistJoy"), self._given
        if given["require_enable_button"]:
            log.info(f"Teleop enable button {given['enable_button']}.")
        turbo = given["enable_turbo_button"]
        if turbo >= 0:
            log.info(f"Turbo on button {turbo}.")
        for kind, fields in (("linear", sorted(_LINEAR)), ("angular", sorted(_ANGULAR))):
            for field in fields:
                axis = given[f"axis_{kind}.{field}"]
                if axis == -1:
                    continue
                log.info(f"{kind.title()} axis {field} on {axis} at scale {given[f'scale_{kind}.{field}']:f}.")
                if turbo >= 0:
                    log.info(f"Turbo for {kind} axis {field} is scale {given[f'scale_{kind}_turbo.{field}']:f}.")

    def _hear(self, msg: Joy) -> None:
        given = self._given
        if _down(msg, given["enable_turbo_button"]):
            self._send(self._twist(msg, "_turbo"))
        elif not given["require_enable_button"] or _down(msg, given["enable_button"]):
            self._send(self._twist(msg, ""))
        elif not self._stopped:
            self._send(Twist())
            self._stopped = True

    def _twist(self, msg: Joy, speed: str) -> Twist:
        self._stopped = False
        twist = Twist()
        for kind, fields in (("linear", _LINEAR), ("angular", _ANGULAR)):
            for field in fields:
                axis = self._given[f"axis_{kind}.{field}"]
                if 0 <= axis < len(msg.axes):
                    value = msg.axes[axis] * self._given[f"scale_{kind}{speed}.{field}"]
                    setattr(getattr(twist, kind), _FIELDS[field], value)
        return twist

    def _send(self, twist: Twist) -> None:
        if not self._stamped:
            self._out.publish(twist)
            return
        stamped = TwistStamped(twist=twist)
        stamped.header.stamp, stamped.header.frame_id = self.get_clock().now().to_msg(), self._frame
        self._out.publish(stamped)


def _down(msg: Joy, button: int) -> bool:
    return 0 <= button < len(msg.buttons) and bool(msg.buttons[button])


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(TeleopTwistJoy, args)
