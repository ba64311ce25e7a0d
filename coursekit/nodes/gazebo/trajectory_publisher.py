"""Simulated gz::sim::systems::JointTrajectoryController: joints follow the points of a trajectory."""

from __future__ import annotations

import math

from std_msgs.msg import Float32
from trajectory_msgs.msg import JointTrajectory

from .devices import TrajectoryDevice
from .sensor_publishers import SensorPublisher


class TrajectoryPublisher(SensorPublisher):
    """Commands each joint to the next point in time, as Gazebo does; `TOPIC_progress` has the completed fraction."""

    device: TrajectoryDevice

    def open(self) -> None:
        self._way: JointTrajectory | None = None
        self._next, self._start_ns = 0, 0
        self._heard = self.node.create_subscription(JointTrajectory, self.device.topic, self._hear, 10)
        self._out = self.publisher(Float32, f"{self.device.topic}_progress", 10)

    def restart(self, begin_ns: int) -> None:
        super().restart(begin_ns)
        self._way = None

    def _hear(self, msg: JointTrajectory) -> None:
        if fault := fault_of(msg, self.device.joints):
            self.node.get_logger().warning(f"JointTrajectoryController of {self.robot.name}: {fault}; nothing is moved")
            return
        stamp = msg.header.stamp
        self._start_ns = self.simulation.now_ns
        if self.device.from_header:
            self._start_ns = stamp.sec * 1_000_000_000 + stamp.nanosec
        self._way, self._next = msg, 0
        self._command(msg)

    def _command(self, way: JointTrajectory) -> None:
        point = way.points[self._next]
        mode, goals = ("position", point.positions) if point.positions else ("velocity", point.velocities)
        for joint, goal in zip(way.joint_names, goals, strict=True):
            self.robot.motors.command(joint, mode, float(goal))

    def publish(self, time_ns: int) -> None:
        way = self._way
        while way is not None and time_ns - self._start_ns >= self._time_ns(way):
            self._next += 1
            self._out.publish(Float32(data=self._next / len(way.points)))
            if self._next == len(way.points):
                self._stop(way)
                way = self._way = None
            else:
                self._command(way)

    def _time_ns(self, way: JointTrajectory) -> int:
        time = way.points[self._next].time_from_start
        return int(time.sec * 1_000_000_000 + time.nanosec)

    def _stop(self, way: JointTrajectory) -> None:
        """Stop joints that were only given a velocity."""
        if not way.points[-1].positions:
            for joint in way.joint_names:
                self.robot.motors.command(joint, "velocity", 0.0)

    def close(self) -> None:
        super().close()
        self.node.destroy_subscription(self._heard)


def fault_of(msg: JointTrajectory, joints: tuple[str, ...]) -> str:
    """Return what is wrong with a trajectory, or '' if it can be followed.

    >>> fault_of(JointTrajectory(joint_names=["elbow"]), ("arm",))
    "joint 'elbow' is none of its joints (arm)"
    """
    for name in msg.joint_names:
        if name not in joints:
            return f"joint '{name}' is none of its joints ({', '.join(joints) or 'none'})"
    if not msg.joint_names or not msg.points:
        return "the trajectory has no joints or no points"
    last = -1
    for number, point in enumerate(msg.points):
        goals = point.positions or point.velocities
        if len(goals) != len(msg.joint_names) or not all(map(math.isfinite, goals)):
            return f"point {number} does not have a finite number for each of the {len(msg.joint_names)} joints"
        time = point.time_from_start.sec * 1_000_000_000 + point.time_from_start.nanosec
        if time <= last:
            return f"point {number} is not later than the one before it"
        last = time
    return ""


__all__ = ["TrajectoryPublisher", "fault_of"]
