"""A robot of few lines: it drives through the office and tells its scans and its odometry, on the session's clock."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import rclpy
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import LaserScan
from tf2_ros import Buffer, StaticTransformBroadcaster, TransformBroadcaster, TransformListener

from coursekit.geometry.plane import Pose2D
from coursekit.nodes.nav2.map_message import MAP_QOS, from_message
from coursekit.nodes.scanning.planar import of_transform, put
from coursekit.slam.scan import Laser
from tests.slam.building import Wheels, drive, look, office

BEAMS, PERIOD = 180, 0.1
WALLS = office(3)
LASER = Laser(-math.pi, math.radians(2), range_max=10.0)


class Robot:
    """Publishes /scan and tf odom → base_footprint, hears /map and tf, and asks services."""

    def __init__(self, session: Any, seat: Pose2D | None = None, flipped: bool = False, odometry: bool = True) -> None:
        self.session = session
        self.context = rclpy.context.Context()
        rclpy.init(context=self.context)
        self.node = rclpy.create_node("robot", context=self.context)
        self.executor = rclpy.executors.SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)
        self._scans = self.node.create_publisher(LaserScan, "scan", rclpy.qos.qos_profile_sensor_data)
        self._moving, self._fixed = TransformBroadcaster(self.node), StaticTransformBroadcaster(self.node)
        self.buffer = Buffer()
        TransformListener(self.buffer, self.node)
        self.maps: list[OccupancyGrid] = []
        self.node.create_subscription(OccupancyGrid, "map", self.maps.append, MAP_QOS)
        self._seat, self._flipped, self._odometry = seat or Pose2D(), flipped, odometry
        self._rng = np.random.default_rng(5)
        self.wheels = Wheels(np.random.default_rng(6))
        self._mount()

    def close(self) -> None:
        """Leave the session."""
        rclpy.shutdown(context=self.context)

    def _mount(self) -> None:
        msg = self._transform("base_footprint", "laser", self._seat)
        if self._flipped:  # half a turn about the x axis comes last
            q = msg.transform.rotation
            q.x, q.y, q.z, q.w = q.w, q.z, 0.0, 0.0
        self._fixed.sendTransform(msg)

    def _transform(self, parent: str, child: str, pose: Pose2D) -> TransformStamped:
        msg = TransformStamped()
        msg.header.frame_id, msg.child_frame_id = parent, child
        msg.header.stamp = self.node.get_clock().now().to_msg()
        put(pose, msg.transform.translation, msg.transform.rotation)
        return msg

    def scan(self, truth: Pose2D) -> LaserScan:
        """What is seen from a place now."""
        laser = Laser(LASER.angle_min, LASER.angle_increment, 0.0, LASER.range_max, self._seat, self._flipped)
        msg = LaserScan(angle_min=laser.angle_min, angle_increment=laser.angle_increment, range_max=laser.range_max)
        msg.angle_max = msg.angle_min + (BEAMS - 1) * msg.angle_increment
        msg.header.frame_id, msg.header.stamp = "laser", self.node.get_clock().now().to_msg()
        msg.ranges = look(WALLS, truth, laser, BEAMS, self._rng).tolist()
        return msg

    def tell(self, truth: Pose2D, scan: LaserScan | None = None) -> None:
        """Publish odometry and a scan from a place, and let a period pass."""
        if self._odometry:
            self._moving.sendTransform(self._transform("odom", "base_footprint", self.wheels.roll(truth)))
        self._scans.publish(scan or self.scan(truth))
        self.spin(PERIOD)

    def go(self, corners: list[tuple[float, float]]) -> Pose2D:
        """Drive from corner to corner; the last pose."""
        pose = Pose2D()
        for pose in drive(corners, step=0.15, turn=0.3):
            self.tell(pose)
        return pose

    def spin(self, seconds: float) -> None:
        """Let time pass."""
        until = self.session.clock.steady() + round(seconds * 1e9)
        while self.session.clock.steady() < until:
            self.executor.spin_once(timeout_sec=(until - self.session.clock.steady()) * 1e-9)

    def ask(self, kind: Any, service: str, **request: Any) -> Any:
        """Ask a service."""
        client = self.node.create_client(kind, service)
        assert client.wait_for_service(5.0)
        future = client.call_async(kind.Request(**request))
        self.executor.spin_until_future_complete(future, 10.0)
        return future.result()

    def where(self) -> Pose2D:
        """The robot in the map, by tf."""
        odom = of_transform(self.buffer.lookup_transform("map", "odom", rclpy.time.Time()))
        return odom @ self.wheels.pose

    def where_is(self, truth: Pose2D) -> float:
        """How far from there tf says that it is [m], a radian as a metre."""
        here = self.where().to(truth)
        return math.hypot(here.x, here.y) + abs(here.theta)


def wall_gaps(msg: OccupancyGrid, start: Pose2D) -> np.ndarray:
    """Metres from each occupied cell of a map, begun at `start`, to the nearest true wall."""
    grid = from_message(msg)
    rows, columns = np.nonzero(grid.cells == 100)
    points = start.transform((np.stack([columns, rows], axis=1) + 0.5) * grid.resolution + np.array(grid.origin[:2]))
    a, b = WALLS[:, None, :2], WALLS[:, None, 2:]
    along = np.clip(((points - a) * (b - a)).sum(axis=2) / np.maximum(((b - a) ** 2).sum(axis=2), 1e-12), 0, 1)
    gaps: np.ndarray = np.linalg.norm(points - a - along[..., None] * (b - a), axis=2).min(axis=0)
    return gaps
