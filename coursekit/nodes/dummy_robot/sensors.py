"""`ros2 run dummy_sensors dummy_laser` and `dummy_joint_states`: oscillating values."""

from __future__ import annotations

import math

from sensor_msgs.msg import JointState, LaserScan

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run

STEP = 0.1  # radians of the oscillation per message
SCAN_TIME = 0.04  # seconds per rotation of the mirror, of which a beam takes a quarter of a degree
BEAMS = 1081  # 270 degrees, four beams a degree, both ends


class DummyLaser(CppNode):
    """Publishes /scan thirty times a second: a circle that shrinks and grows."""

    def __init__(self) -> None:
        super().__init__("dummy_laser")
        self._publisher = self.create_publisher(LaserScan, "scan", 10)
        self._phase = 0.0
        self._msg = LaserScan(
            angle_min=math.radians(-135.0), angle_max=math.radians(135.0), angle_increment=math.radians(0.25),
            time_increment=SCAN_TIME * 0.25 / 360, scan_time=SCAN_TIME, range_min=0.0, range_max=10.0,
        )  # fmt: skip
        self._msg.header.frame_id = "single_rrbot_hokuyo_link"
        log = self.get_logger()
        log.info(f"angle inc:\t{self._msg.angle_increment:f}")
        log.info(f"scan size:\t{BEAMS}")
        log.info(f"scan time increment: \t{self._msg.time_increment:f}")
        self._publish()
        self.create_timer(1 / 30, self._publish)

    def _publish(self) -> None:
        self._phase += STEP
        self._msg.ranges = [abs(math.sin(self._phase))] * BEAMS
        self._msg.header.stamp = self.get_clock().now().to_msg()
        self._publisher.publish(self._msg)


class DummyJointStates(CppNode):
    """Publishes /joint_states fifty times a second: both joints oscillate together."""

    def __init__(self) -> None:
        super().__init__("dummy_joint_states")
        self._publisher = self.create_publisher(JointState, "joint_states", 10)
        self._phase = 0.0
        self._msg = JointState(name=["single_rrbot_joint1", "single_rrbot_joint2"])
        self._publish()
        self.create_timer(1 / 50, self._publish)

    def _publish(self) -> None:
        self._phase += STEP
        self._msg.position = [math.sin(self._phase)] * 2
        self._msg.header.stamp = self.get_clock().now().to_msg()
        self._publisher.publish(self._msg)


def laser(args: list[str] | None = None) -> int:
    """Publish scans until Ctrl-C."""
    return run(DummyLaser, args)


def joint_states(args: list[str] | None = None) -> int:
    """Publish joint states until Ctrl-C."""
    return run(DummyJointStates, args)
