"""The lasers of a robot, by the frame of their scans."""

from __future__ import annotations

from rclpy.node import Node
from rclpy.time import Time
from sensor_msgs.msg import LaserScan
from tf2_ros import Buffer, TransformException

from coursekit.nodes.scanning.planar import expected_beams, fault_of, laser_of
from coursekit.slam.scan import Laser


class Lasers:
    """The mounting of each laser, looked up once; logs errors about inconsistent scans."""

    def __init__(self, node: Node, buffer: Buffer, base: str, farthest: float) -> None:
        self._node, self._buffer, self._base, self._farthest = node, buffer, base, farthest
        self._known: dict[tuple[object, ...], Laser] = {}
        self._frames: set[str] = set()
        self._complained: set[str] = set()

    def of(self, scan: LaserScan) -> Laser | None:
        """The laser of a scan; None, with an error in the log, if the scan cannot be used."""
        fault = fault_of(scan)
        if fault:
            self._complain(f"A scan in frame '{scan.header.frame_id}' cannot be used: {fault}")
            return None
        beams = expected_beams(scan)
        if beams and abs(beams - len(scan.ranges)) > 1:
            expected = f"LaserRangeScan contains {len(scan.ranges)} range readings, expected {beams}"
            self._complain(f"{expected}; they are taken from angle_min on")
        key = (scan.header.frame_id, scan.angle_min, scan.angle_increment, scan.range_min, scan.range_max)
        if key not in self._known:
            laser = self._make(scan)
            if laser is None:
                return None
            self._known[key] = laser
        return self._known[key]

    def _make(self, scan: LaserScan) -> Laser | None:
        """Create a laser from its scan and the transform base → laser."""
        try:
            seat = self._buffer.lookup_transform_core(self._base, scan.header.frame_id, Time())
        except TransformException as fault:
            self._node.get_logger().error(
                f"Failed to compute laser pose, aborting initialization ({fault})", throttle_duration_sec=5.0
            )
            return None
        self._greet(scan)
        return laser_of(scan, seat, self._farthest)

    def _greet(self, scan: LaserScan) -> None:
        """Log the registration of a new laser."""
        if scan.header.frame_id in self._frames:
            return
        self._frames.add(scan.header.frame_id)
        log = self._node.get_logger()
        if 0 < scan.range_max < self._farthest:
            log.warning(
                f"maximum laser range setting ({self._farthest:.1f} m) exceeds the capabilities of the used Lidar "
                f"({scan.range_max:.1f} m)"
            )
        log.info("Registering sensor: [Custom Described Lidar]")

    def _complain(self, text: str) -> None:
        """Log an error once."""
        if text not in self._complained and len(self._complained) < 100:
            self._complained.add(text)
            self._node.get_logger().error(text)
