"""`ros2 run nav2_velocity_smoother velocity_smoother`: cmd_vel in, cmd_vel_smoothed out, with limited accelerations."""

from __future__ import annotations

import math
from typing import Any

from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from rclpy.lifecycle import LifecycleState, TransitionCallbackReturn

from coursekit.nav.acceleration_limiter import AccelerationLimiter
from coursekit.nodes.nav2.parameters import Obedience, declare
from coursekit.nodes.nav2.running import Server, run

_SERVER: dict[str, Any] = {
    "smoothing_frequency": 20.0,
    "feedback": "OPEN_LOOP",
    "scale_velocities": False,
    "max_velocity": [0.50, 0.0, 2.5],
    "min_velocity": [-0.50, 0.0, -2.5],
    "max_accel": [2.5, 0.0, 3.2],
    "max_decel": [-2.5, 0.0, -3.2],
    "odom_topic": "odom",
    "odom_duration": 0.1,
    "deadband_velocity": [0.0, 0.0, 0.0],
    "velocity_timeout": 1.0,
}
_STILL = [0.0, 0.0, 0.0]


class VelocitySmoother(Server):
    """Republishes `cmd_vel` with limited accelerations; stops when no message arrives for `velocity_timeout`."""

    def __init__(self) -> None:
        super().__init__("velocity_smoother")
        declare(self, _SERVER)

    def _read(self) -> None:
        """Read the parameters; raises ValueError if they are invalid."""
        given = declare(self, _SERVER)
        axes = ("max_velocity", "min_velocity", "max_accel", "max_decel", "deadband_velocity")
        if any(len(given[name]) != 3 for name in axes):
            raise ValueError(f"Invalid size of kinematic limits: {', '.join(axes)} have three numbers each, x, y and yaw")
        if any(limit > 0 for limit in given["max_decel"]):
            raise ValueError("Positive values set of deceleration! These should be negative to slow down!")
        if any(limit < 0 for limit in given["max_accel"]):
            raise ValueError("Negative values set of acceleration! These should be positive to speed up!")
        if given["feedback"] not in ("OPEN_LOOP", "CLOSED_LOOP"):
            raise ValueError("Invalid feedback_type. Options are OPEN_LOOP and CLOSED_LOOP.")
        if not given["smoothing_frequency"] > 0:
            raise ValueError(f"smoothing_frequency is {given['smoothing_frequency']}: give Hz, for example 20.0")
        self._given = given
        self._limiter = AccelerationLimiter(*(tuple(given[name]) for name in axes[:4]), together=given["scale_velocities"])  # type: ignore[misc, arg-type]

    # -- states

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Subscribe; return FAILURE for an invalid parameter."""
        self.get_logger().info("Configuring velocity smoother")
        try:
            self._read()
        except ValueError as fault:
            self.get_logger().error(str(fault))
            return TransitionCallbackReturn.FAILURE
        self._wish, self._now, self._odometry, self._heard_ns, self._resting = _STILL, _STILL, _STILL, 0, True
        self._out = self.create_lifecycle_publisher(Twist, "cmd_vel_smoothed", 1)
        self._heard = [
            self.create_subscription(Twist, "cmd_vel", self._hear, 1),
            self.create_subscription(Odometry, self._given["odom_topic"], self._take_odometry, 10),
        ]
        self._obedience = Obedience(self, self._read)
        return super().on_configure(state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Start publishing."""
        self._timer = self.create_timer(1.0 / self._given["smoothing_frequency"], self._work)
        return super().on_activate(state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Stop publishing."""
        self.destroy_timer(self._timer)
        return super().on_deactivate(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Destroy the subscriptions and the publisher."""
        self._obedience.end()
        for heard in self._heard:
            self.destroy_subscription(heard)
        self.destroy_lifecycle_publisher(self._out)
        return super().on_cleanup(state)

    # -- speeds

    def _hear(self, msg: Twist) -> None:
        wish = [msg.linear.x, msg.linear.y, msg.angular.z]
        if not all(map(math.isfinite, wish)):
            self.get_logger().error("Velocity message contains NaNs or Infs! Ignoring as invalid!")
            return
        self._wish, self._heard_ns, self._resting = wish, self.get_clock().now().nanoseconds, False

    def _take_odometry(self, msg: Odometry) -> None:
        twist = msg.twist.twist
        self._odometry = [twist.linear.x, twist.linear.y, twist.angular.z]

    def _work(self) -> None:
        if self._resting:
            return
        silent = (self.get_clock().now().nanoseconds - self._heard_ns) * 1e-9
        if silent > self._given["velocity_timeout"]:
            if not any(self._now) and not any(self._wish):
                self._resting = True
                return
            self._wish = _STILL
        now = self._now if self._given["feedback"] == "OPEN_LOOP" else self._odometry
        self._now = self._limiter.toward(now, self._wish, 1.0 / self._given["smoothing_frequency"])
        dead = self._given["deadband_velocity"]
        self._say([0.0 if abs(speed) < dead[k] else speed for k, speed in enumerate(self._now)])

    def _say(self, speeds: list[float]) -> None:
        msg = Twist()
        msg.linear.x, msg.linear.y, msg.angular.z = speeds
        self._out.publish(msg)


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(VelocitySmoother, args)
