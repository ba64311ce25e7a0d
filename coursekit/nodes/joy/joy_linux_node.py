"""`ros2 run joy_linux joy_linux_node`: publishes the gamepad at a path on /joy."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sensor_msgs.msg import JoyFeedbackArray

from coursekit.nodes.joy.device import Device, devices, name_of
from coursekit.nodes.joy.joy_node import FULL, GamepadNode
from coursekit.nodes.running import run

MOST = 0.9
_DEFAULTS: dict[str, Any] = {
    "dev": "/dev/input/js0", "dev_name": "", "dev_ff": "/dev/input/event0", "deadzone": 0.05, "autorepeat_rate": 20.0,
    "coalesce_interval": 0.001, "default_trig_val": False, "sticky_buttons": False,
}  # fmt: skip


class JoyLinuxNode(GamepadNode):
    """joy_linux's node: values out of range are corrected, not refused."""

    def __init__(self) -> None:
        self._said = False
        super().__init__("joy_node", _DEFAULTS)
        self.create_subscription(JoyFeedbackArray, "joy/set_feedback", lambda msg: None, 10)

    def settings(self) -> tuple[float, float, float]:
        """Correct the parameters, and tell it."""
        log, given = self.get_logger(), self._given
        deadzone, rate, coalesce = given["deadzone"], given["autorepeat_rate"], given["coalesce_interval"]
        if deadzone >= 1:
            log.warning(
                "joy_linux_node: deadzone greater than 1 was requested. It is divided by 32767; give it from 0 to 1."
            )
            deadzone /= FULL
        if not 0.0 <= deadzone <= MOST:
            log.warning(f"joy_node: deadzone ({deadzone:f}) is not between 0 and {MOST}, setting it to the nearest of them.")
        for name, value in (("autorepeat_rate", rate), ("coalesce_interval", coalesce)):
            if value < 0:
                log.warning(f"joy_node: {name} ({value:f}) less than 0, setting to 0.")
        return min(max(deadzone, 0.0), MOST), max(rate, 0.0), max(coalesce, 0.0)

    def wanted(self) -> Path | None:
        """Take the path, or the first gamepad whose name holds `dev_name`."""
        name = self._given["dev_name"]
        if name:
            return next((path for path in devices() if name in name_of(path)), None)
        path = Path(self._given["dev"])
        return path if path.exists() else None

    def opened(self, device: Device) -> None:
        """Say it as Humble does."""
        self._said = False
        self.get_logger().info(f"Opened joystick: {device.path}. deadzone_: {self._deadzone:f}.")

    def missing(self, fault: OSError | None) -> None:
        """Say it once."""
        if self._said:
            return
        self._said, name = True, self._given["dev_name"]
        what = f"find a joystick with name containing {name}" if name else f"open joystick {self._given['dev']}"
        self.get_logger().error(f"Couldn't {what}. Will retry every second.")


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(JoyLinuxNode, args)
