"""`ros2 run coursekit_robots practice_base`: the driver of a robot with wheels and a LiDAR.

Its world is simulated; everything else is as on a real robot. It stamps messages with its computer's clock, limits
velocities, and stops when no command arrives.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path

from geometry_msgs.msg import Twist
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor
from rclpy.node import Node

from coursekit.nodes.gazebo.devices import OdometryDevice
from coursekit.nodes.gazebo.model_conversion import ModelConversion, assemble
from coursekit.nodes.gazebo.odometry_publishers import OdometryPublisher
from coursekit.nodes.gazebo.precompile import warm_up
from coursekit.nodes.gazebo.sensor_publishers import PUBLISHERS, SensorPublisher
from coursekit.nodes.gazebo.urdf_model import blueprint_of
from coursekit.nodes.gazebo.world_lookup import open_world
from coursekit.nodes.running import run
from coursekit.sim import Simulation, WorldError
from coursekit.urdf import load

DESCRIPTION = Path(__file__).parents[2] / "share" / "coursekit_robots" / "urdf" / "robot_lidar.urdf"
KINDS: dict[type, type[SensorPublisher]] = {**PUBLISHERS, OdometryDevice: OdometryPublisher}
TICK_SECONDS = 0.01
JUMP_NS = 500_000_000
"""A difference above this [ns] means that the clock was set, not that time passed."""


class PracticeBase(Node):
    """Drives on /cmd_vel; publishes /scan, /odom, /joint_states and the frame odom -> base_footprint.

    Parameters that can be set while it runs: max_speed [m/s], max_turn [rad/s], command_timeout [s], and clock_error [s],
    the error of its computer's clock.
    """

    def __init__(self) -> None:
        super().__init__("base")
        self._limit("max_speed", 0.3, 0.0, 1.0, "no command is carried out faster [m/s]")
        self._limit("max_turn", 1.0, 0.0, 3.0, "no command turns faster [rad/s]")
        self._limit("command_timeout", 0.5, 0.1, 5.0, "without a command it stops after this time [s]")
        self._limit("clock_error", 0.0, -3600.0, 3600.0, "by which this computer's clock is wrong [s]")
        warm_up()
        self._simulation = Simulation(open_world(str(self.declare_parameter("world", "robot_world").value)).world)
        self._simulation.now_ns = self._now()
        model = assemble(blueprint_of(load(DESCRIPTION)))
        assert model.robot is not None
        self._robot = self._simulation.spawn(model.robot, model.name)
        self._sensors = list(self._equip(model))
        self._commanded_ns: int | None = None
        self.create_subscription(Twist, "cmd_vel", self._hear, 10)
        self.create_timer(TICK_SECONDS, self._tick)
        self.get_logger().info("Wheels and laser are ready")

    def _limit(self, name: str, value: float, low: float, high: float, text: str) -> None:
        between = [FloatingPointRange(from_value=low, to_value=high)]
        self.declare_parameter(name, value, ParameterDescriptor(description=text, floating_point_range=between))

    def _told(self, name: str) -> float:
        value: float = self.get_parameter(name).value
        return value

    def _equip(self, model: ModelConversion) -> Iterator[SensorPublisher]:
        for number, device in enumerate(model.devices):
            kind = KINDS[type(device)]
            yield kind(self, self._simulation, self._robot, device, number, self._simulation.now_ns)

    # -- time

    def _now(self) -> int:
        """This computer's clock [ns]."""
        return int(self.get_clock().now().nanoseconds) + round(self._told("clock_error") * 1e9)

    def _tick(self) -> None:
        now = self._now()
        if abs(now - self._simulation.now_ns) > JUMP_NS:
            self._simulation.now_ns = now
            for sensor in self._sensors:
                sensor.restart(now)
        self._stop_if_silent()
        self._simulation.advance_to(now)
        for sensor in self._sensors:
            self._work(sensor, now)

    @staticmethod
    def _work(sensor: SensorPublisher, now: int) -> None:
        while sensor.due_ns <= now:
            sensor.work()

    # -- driving

    def _hear(self, msg: Twist) -> None:
        forward, turn = msg.linear.x, msg.angular.z
        if not (math.isfinite(forward) and math.isfinite(turn)):
            return
        speed, spin = self._told("max_speed"), self._told("max_turn")
        if abs(forward) > speed or abs(turn) > spin:
            asked = f"{forward:.2f} m/s, {turn:.2f} rad/s"
            self.get_logger().warning(f"Too fast: {asked}. It is cut to the limits", throttle_duration_sec=5.0)
        self._robot.command(max(-speed, min(speed, forward)), max(-spin, min(spin, turn)))
        self._commanded_ns = self.get_clock().now().nanoseconds if forward or turn else None

    def _stop_if_silent(self) -> None:
        """Stop the robot if no command has arrived for `command_timeout`."""
        timeout = self._told("command_timeout")
        if self._commanded_ns is not None and self.get_clock().now().nanoseconds - self._commanded_ns > timeout * 1e9:
            self._commanded_ns = None
            self._robot.command(0.0)
            self.get_logger().warning(f"No command for {timeout:g} s: stopped")


def main(args: list[str] | None = None) -> int:
    """Drive until Ctrl-C."""
    return run(PracticeBase, args, refuses=(WorldError,))
