"""`ros2 run twist_stamper twist_stamper` and `twist_unstamper`: conversion between stamped and unstamped velocities."""

from __future__ import annotations

from geometry_msgs.msg import Twist, TwistStamped
from rclpy.node import Node

from coursekit.nodes.running import run


class TwistStamper(Node):
    """Converts Twist on cmd_vel_in to TwistStamped on cmd_vel_out, stamped now in the frame `frame_id`."""

    def __init__(self) -> None:
        super().__init__("twist_stamper")
        self._frame = str(self.declare_parameter("frame_id", "").value)
        self._out = self.create_publisher(TwistStamped, "cmd_vel_out", 10)
        self.create_subscription(Twist, "cmd_vel_in", self._hear, 10)

    def _hear(self, msg: Twist) -> None:
        stamped = TwistStamped(twist=msg)
        stamped.header.stamp, stamped.header.frame_id = self.get_clock().now().to_msg(), self._frame
        self._out.publish(stamped)


class TwistUnstamper(Node):
    """Converts TwistStamped on cmd_vel_in to Twist on cmd_vel_out."""

    def __init__(self) -> None:
        super().__init__("twist_unstamper")
        self._out = self.create_publisher(Twist, "cmd_vel_out", 10)
        self.create_subscription(TwistStamped, "cmd_vel_in", lambda msg: self._out.publish(msg.twist), 10)


def stamper(args: list[str] | None = None) -> int:
    """Run the stamper until Ctrl-C."""
    return run(TwistStamper, args)


def unstamper(args: list[str] | None = None) -> int:
    """Run the unstamper until Ctrl-C."""
    return run(TwistUnstamper, args)
