"""A controller manager for a simulated robot: its hardware consists of the robot's joints."""

from __future__ import annotations

import math
from typing import Any

from geometry_msgs.msg import Twist, TwistStamped
from rclpy.node import Node

from coursekit.nodes.control.controller import Controller, Interfaces
from coursekit.nodes.control.description import HardwareInfo
from coursekit.nodes.control.diff_drive import DEFAULTS
from coursekit.nodes.control.hardware import Hardware
from coursekit.nodes.control.manager import Manager
from coursekit.nodes.control.manager_services import ManagerServices
from coursekit.nodes.control.types import DRIVE, TYPES
from coursekit.sim.robot import GRAVITY, Drive, Robot
from coursekit.sim.simulation import Simulation

from .devices import ControlDevice, OdometryDevice
from .odometry_publishers import OdometryPublisher
from .sensor_publishers import SensorPublisher, heading


class SimulatedHardware(Hardware):
    """gazebo_ros2_control/GazeboSystem and gz_ros2_control/GazeboSimSystem: positions and speeds go to the joints' motors.

    Wheels of a drive move the robot; their efforts push it. An effort moves other joints against viscous friction;
    gravity is ignored.
    """

    def __init__(self, info: HardwareInfo, robot: Robot, simulation: Simulation) -> None:
        super().__init__(info)
        self.robot, self.simulation = robot, simulation
        drive = robot.model.drive
        self._wheels = set(drive.left + drive.right) if drive is not None else set()
        self._driven = {name.partition("/")[0] for name in self.commands} & self._wheels
        robot.motors.mimics.update(info.mimics)
        self.begin()

    def begin(self) -> None:
        """Set the joints to the initial positions of the description."""
        for name, interface in self.info.interfaces("states").items():
            joint, _, kind = name.partition("/")
            if kind == "position" and not math.isnan(interface.initial):
                self.robot.motors.put(joint, interface.initial)

    def read(self, dt: float) -> None:
        """Update positions and speeds of joints, and sensor values."""
        speeds = self._speeds()
        for name in self.states:
            joint, _, kind = name.partition("/")
            if kind == "position":
                self.states[name] = self.robot.angles.get(joint, 0.0)
            elif kind == "velocity":
                self.states[name] = speeds.get(joint, 0.0)
            elif kind == "effort":
                told = self.commands.get(name, 0.0)
                self.states[name] = 0.0 if math.isnan(told) else told
            elif kind == "acceleration":
                self.states[name] = 0.0
            else:
                self.states[name] = self._felt(kind)

    def _speeds(self) -> dict[str, float]:
        drive, (ahead, _, turn) = self.robot.model.drive, self.robot.wheels
        if drive is None:
            return self.robot.motors.speeds
        half = turn * drive.separation / 2
        left, right = (ahead - half) / drive.radius, (ahead + half) / drive.radius
        return self.robot.motors.speeds | dict.fromkeys(drive.left, left) | dict.fromkeys(drive.right, right)

    def _felt(self, kind: str) -> float:
        turned = heading(self.robot.place.theta)
        felt = {"orientation.z": turned.z, "orientation.w": turned.w, "angular_velocity.z": self.robot.velocity[2]}
        return felt.get(kind, GRAVITY if kind == "linear_acceleration.z" else 0.0)

    def write(self, dt: float) -> None:
        """Apply the commands."""
        told = set()
        for name, value in self.commands.items():
            joint, _, kind = name.partition("/")
            if math.isnan(value):
                continue
            if joint in self._driven and (kind == "velocity" or value):
                told.add(kind)
            if joint not in self._wheels and kind in ("position", "velocity", "effort"):
                self.robot.motors.command(joint, kind, value)
        drive = self.robot.model.drive
        if drive is not None and told & {"velocity", "effort"}:
            ahead, turn = self._rolled(drive) if "velocity" in told else self._pushed(drive, dt)
            self.robot.command(ahead, turn, now_ns=self.simulation.now_ns)

    def _rolled(self, drive: Drive) -> tuple[float, float]:
        """Return linear and angular velocity for wheels at these speeds."""
        left, right = (self._sum(joints, "velocity") / len(joints) * drive.radius for joints in (drive.left, drive.right))
        return (left + right) / 2, (right - left) / drive.separation

    def _pushed(self, drive: Drive, dt: float) -> tuple[float, float]:
        """Return linear and angular velocity after efforts have acted for a time."""
        left, right = (self._sum(joints, "effort") / drive.radius for joints in (drive.left, drive.right))
        ahead, _, turn = self.robot.wheels
        mass, moment = self.robot.model.mass, self.robot.body.moment
        return ahead + (left + right) / mass * dt, turn + (right - left) * drive.separation / 2 / moment * dt

    def _sum(self, joints: tuple[str, ...], kind: str) -> float:
        values = [self.commands.get(f"{joint}/{kind}", 0.0) for joint in joints]
        return sum(0.0 if math.isnan(value) else value for value in values)


class SimulatedDrive(Controller):
    """diff_drive_controller in the simulator: it drives the robot itself, with the odometry errors of wheels."""

    def __init__(
        self, node: Node, interfaces: Interfaces, rate: float, sensor: ControlPublisher, device: OdometryDevice
    ) -> None:
        super().__init__(node, interfaces, rate)
        self._sensor, self._device = sensor, device
        self._odometry: OdometryPublisher | None = None
        self._active = False

    def configure(self) -> None:
        """Subscribe to commands; declare the parameters with which the robot's drive was made."""
        for name, usual in DEFAULTS.items():
            self.parameter(name, usual)
        kind = TwistStamped if self._device.stamped else Twist
        self.node.create_subscription(kind, self._device.command_topic, self._hear, 10)

    def command_names(self) -> list[str]:
        """Return the velocity commands of its wheels."""
        drive = self._sensor.robot.model.drive
        assert drive is not None
        wanted = [f"{joint}/velocity" for joint in (*drive.left, *drive.right)]
        return [name for name in wanted if name in self.interfaces.commands()]

    def activate(self) -> None:
        """Publish odometry from now on."""
        sensor = self._sensor
        if self._odometry is None:
            self._odometry = OdometryPublisher(
                self.node, sensor.simulation, sensor.robot, self._device, 0, sensor.due_ns
            )
        self._odometry.restart(sensor.due_ns)
        self._active = True

    def deactivate(self) -> None:
        """Stop."""
        self._active = False
        self._sensor.robot.command(0.0, 0.0, now_ns=self._sensor.simulation.now_ns)

    def _hear(self, msg: Twist | TwistStamped) -> None:
        if self._active:
            twist = msg.twist if isinstance(msg, TwistStamped) else msg
            self._sensor.robot.command(twist.linear.x, twist.angular.z, now_ns=self._sensor.simulation.now_ns)

    def update(self, now_ns: int, dt: float) -> None:
        """Publish odometry whenever it is due."""
        while self._odometry is not None and self._odometry.due_ns <= now_ns:
            self._odometry.work()


class ControlPublisher(SensorPublisher):
    """The controller manager of a simulated robot; the simulator makes `node` in ROS."""

    device: ControlDevice

    def open(self) -> None:
        device = self.device
        makers: dict[str, Any] = dict(TYPES)
        if device.odometry:
            makers[DRIVE] = self._drive_of
        self.manager = Manager(self.node, self.node.executor, device.arguments(), makers)
        self.services = ManagerServices(self.manager)
        self.hardware = [SimulatedHardware(info, self.robot, self.simulation) for info in device.hardware]
        for hardware in self.hardware:
            self.manager.add(hardware)
        if not self.hardware:
            self.manager.log.error("The robot description has no <ros2_control>: there are no joints to control.")

    def _drive_of(self, node: Node, interfaces: Interfaces, rate: float) -> Controller:
        told = dict(self.device.odometry)
        return SimulatedDrive(node, interfaces, rate, self, told.get(node.get_name()) or next(iter(told.values())))

    def publish(self, time_ns: int) -> None:
        self.manager.update(time_ns, 1.0 / self.device.rate)

    def restart(self, begin_ns: int) -> None:
        """Restart at a time; trajectories end."""
        super().restart(begin_ns)
        if begin_ns < self.manager.now_ns:
            for hardware in self.hardware:
                hardware.begin()
                hardware.read(0.0)
            self.manager.restart(begin_ns)

    def close(self) -> None:
        """Close the manager together with its robot."""
        self.manager.close()


__all__ = ["ControlPublisher", "SimulatedHardware"]
