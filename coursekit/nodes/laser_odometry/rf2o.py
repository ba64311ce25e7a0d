"""`ros2 run rf2o_laser_odometry rf2o_laser_odometry_node`: publishes odometry from a laser's scans.

It has rf2o's names and parameters. Scans are matched with the walls seen just before, where rf2o solves for range flow.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from rclpy.qos import qos_profile_sensor_data
from rclpy.time import Time
from sensor_msgs.msg import LaserScan
from tf2_ros import Buffer, TransformBroadcaster, TransformListener

from coursekit.geometry.plane import Pose2D
from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.running import run
from coursekit.nodes.scanning.lasers import Lasers
from coursekit.nodes.scanning.planar import plane, put
from coursekit.slam.laser_odometry import LaserOdometry
from coursekit.slam.scan import Scan

_DEFAULTS: dict[str, Any] = {
    "laser_scan_topic": "/scan", "odom_topic": "/odom_rf2o", "base_frame_id": "base_link", "odom_frame_id": "odom",
    "publish_tf": True, "init_pose_from_topic": "/base_pose_ground_truth", "freq": 10.0,
}  # fmt: skip


class Rf2o(CppNode):
    """Takes the newest scan `freq` times a second; begins at the pose on `init_pose_from_topic`, if that is named."""

    def __init__(self) -> None:
        super().__init__("CLaserOdometry2DNode")
        self._given = given = declare(self, _DEFAULTS)
        if not given["freq"] > 0:
            raise ValueError(f"freq is {given['freq']}: give scans a second, for example 10.0")
        self._buffer = Buffer(node=self)
        self._listener = TransformListener(self._buffer, self)
        self._broadcaster = TransformBroadcaster(self)
        self._lasers = Lasers(self, self._buffer, given["base_frame_id"], math.inf)
        self._odometry = None if given["init_pose_from_topic"] else LaserOdometry()
        self._scan: LaserScan | None = None
        self._last_ns = 0
        self._out = self.create_publisher(Odometry, given["odom_topic"], 5)
        self.create_subscription(LaserScan, given["laser_scan_topic"], self._hear, qos_profile_sensor_data)
        if given["init_pose_from_topic"]:
            self.create_subscription(Odometry, given["init_pose_from_topic"], self._begin, qos_profile_sensor_data)
        self.create_timer(1.0 / given["freq"], self._work)
        self.get_logger().info(f"Listening laser scan from topic: {given['laser_scan_topic']}")

    def _begin(self, msg: Odometry) -> None:
        if self._odometry is None:
            self._odometry = LaserOdometry(plane(msg.pose.pose.position, msg.pose.pose.orientation))

    def _hear(self, msg: LaserScan) -> None:
        if self._odometry is not None:
            self._scan = msg

    def _work(self) -> None:
        msg, self._scan = self._scan, None
        if msg is None or self._odometry is None:
            self.get_logger().warning("Waiting for laser_scans....", throttle_duration_sec=5.0)
            return
        laser, stamp = self._lasers.of(msg), Time.from_msg(msg.header.stamp).nanoseconds
        if laser is None:
            return
        if not self._odometry.add(Scan.from_ranges(np.asarray(msg.ranges), laser, self._odometry.params, stamp * 1e-9)):
            self.get_logger().warning(
                "This scan fits none before it: the robot counts as standing", throttle_duration_sec=5.0
            )
        seconds, self._last_ns = (stamp - self._last_ns) * 1e-9 if self._last_ns else 0.0, stamp
        self._publish(msg, self._odometry.pose, self._odometry.motion, seconds)

    def _publish(self, scan: LaserScan, pose: Pose2D, motion: Pose2D, seconds: float) -> None:
        msg = Odometry(child_frame_id=self._given["base_frame_id"])
        msg.header.stamp, msg.header.frame_id = scan.header.stamp, self._given["odom_frame_id"]
        put(pose, msg.pose.pose.position, msg.pose.pose.orientation)
        if seconds > 0:
            msg.twist.twist.linear.x, msg.twist.twist.angular.z = motion.x / seconds, motion.theta / seconds
        self._out.publish(msg)
        if self._given["publish_tf"]:
            moved = TransformStamped(header=msg.header, child_frame_id=msg.child_frame_id)
            put(pose, moved.transform.translation, moved.transform.rotation)
            self._broadcaster.sendTransform(moved)


def main(args: list[str] | None = None) -> int:
    """Publish until Ctrl-C."""
    return run(Rf2o, args, refuses=(ValueError,))
