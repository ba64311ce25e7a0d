"""The node behind `async_slam_toolbox_node`, `sync_slam_toolbox_node` and the others."""

from __future__ import annotations

import numpy as np
from geometry_msgs.msg import PoseWithCovarianceStamped, TransformStamped
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from rclpy.time import Time
from sensor_msgs.msg import LaserScan
from tf2_ros import TransformBroadcaster, TransformException, TransformListener
from visualization_msgs.msg import MarkerArray

from coursekit.geometry.plane import Pose2D
from coursekit.nodes.scanning.lasers import Lasers
from coursekit.nodes.scanning.planar import of_transform, put
from coursekit.nodes.scanning.scan_filter import ScanFilter, WakingBuffer, lookup
from coursekit.nodes.slam_toolbox.engines import Engine, Mapping
from coursekit.nodes.slam_toolbox.map_topic import MapTopic
from coursekit.nodes.slam_toolbox.parameters import declare, number, slam_parameters
from coursekit.slam.precompile import warm
from coursekit.slam.scan import Scan
from coursekit.slam.slam import Result, Slam

EVERY_SCAN = 1000
"""The number of scans that a synchronous node queues while it is busy."""


class SlamToolbox(Node):
    """Scans and odometry in; /map, /pose and map → odom out.

    With `keep_all` it processes every scan, however late; otherwise it skips scans that arrive while it is busy.
    """

    def __init__(self, *, keep_all: bool = False) -> None:
        super().__init__("slam_toolbox")
        declare(self)
        self.slam_params = slam_parameters(self)
        self._read_parameters()
        self.engine: Engine = Mapping(Slam(self.slam_params))
        self.last: Result | None = None
        self._stamp = Time()
        self._map_to_odom = Pose2D()
        self._count = 0
        self.odometry: Pose2D | None = None
        warm()
        self._make_topics(keep_all)
        self.get_logger().info("Using solver plugin " + str(self.get_parameter("solver_plugin").value))

    def _read_parameters(self) -> None:
        """Read the parameters that are used at the start only."""
        self.map_frame, self.odom_frame, self.base_frame = (
            str(self.get_parameter(f"{name}_frame").value) for name in ("map", "odom", "base")
        )
        self._scales = [number(self, f"{name}_covariance_scale") for name in ("position", "yaw")]
        self._ahead = Duration(seconds=number(self, "transform_timeout", least=0.0))
        throttle = self.get_parameter("throttle_scans").value
        if not isinstance(throttle, int) or throttle < 1:
            default = "this isn't allowed so it will be set to default value 1."
            self.get_logger().warning(f"You've set throttle_scans to be {throttle!r}, {default}")
            throttle = 1
        self._throttle = throttle

    def _make_topics(self, keep_all: bool) -> None:
        """Create the topics, the transforms and the two timers."""
        self.buffer = WakingBuffer(Duration(seconds=number(self, "tf_buffer_duration", least=0.1)), self)
        self._listener = TransformListener(self.buffer, self)
        self._broadcaster = TransformBroadcaster(self)
        self.lasers = Lasers(self, self.buffer, self.base_frame, number(self, "max_laser_range", least=0.01))
        self.map_topic = MapTopic(self, str(self.get_parameter("map_name").value), self.map_frame)
        self._pose_publisher = self.create_publisher(PoseWithCovarianceStamped, "pose", 10)
        self._graph_publisher = self.create_publisher(MarkerArray, "slam_toolbox/graph_visualization", 1)
        self._scan_publisher = self.create_publisher(LaserScan, "slam_toolbox/scan_visualization", 10)
        size = EVERY_SCAN if keep_all else int(number(self, "scan_queue_size", least=1))
        self._filter = ScanFilter(self, self.buffer, self.odom_frame, size, self._take)
        qos = QoSProfile(depth=EVERY_SCAN if keep_all else 1, reliability=ReliabilityPolicy.BEST_EFFORT)
        self.create_subscription(LaserScan, str(self.get_parameter("scan_topic").value), self._filter.add, qos)
        period = number(self, "transform_publish_period", least=0.0)
        if period > 0:
            self.create_timer(period, self._publish_transform)
        self.create_timer(max(number(self, "map_update_interval", least=0.0), 0.05), self.publish_map)

    # -- scans

    @property
    def paused(self) -> bool:
        """Whether new scans are ignored."""
        return bool(self.get_parameter("paused_new_measurements").value)

    def use(self, engine: Engine) -> None:
        """Switch to another engine."""
        self.engine, self.last = engine, None

    def forget_waiting(self) -> bool:
        """Discard the scans that wait for their transform. Return whether there were any."""
        return self._filter.clear()

    def _take(self, msg: LaserScan) -> None:
        """Process a scan whose transform is known."""
        self._count += 1
        if self.paused or self._count % self._throttle:
            return
        laser = self.lasers.of(msg)
        odometry = self._odometry_at(msg)
        if laser is None or odometry is None:
            return
        stamp = Time.from_msg(msg.header.stamp)
        scan = Scan.from_ranges(np.asarray(msg.ranges), laser, self.slam_params, stamp.nanoseconds * 1e-9)
        self._settle(self.engine.add(scan, odometry), odometry, stamp)
        if self.get_parameter("enable_interactive_mode").value:
            self._scan_publisher.publish(msg)

    def _odometry_at(self, msg: LaserScan) -> Pose2D | None:
        """The robot's pose from odometry at the time of the scan."""
        try:
            return of_transform(lookup(self.buffer, self.odom_frame, self.base_frame, msg.header.stamp))
        except TransformException as fault:
            self.get_logger().warning("Failed to compute odom pose", throttle_duration_sec=5.0)
            text = f"base_frame is '{self.base_frame}': {fault}"
            self.get_logger().warning(text, throttle_duration_sec=5.0)
            return None

    def _settle(self, result: Result, odometry: Pose2D, stamp: Time) -> None:
        """Store and publish the result of a scan."""
        self.last, self._stamp, self.odometry = result, stamp, odometry
        self._map_to_odom = result.pose @ odometry.inverse()
        if not result.accepted:
            why = f"This scan does not fit the map (match {100 * result.score:.0f} %): going by odometry alone"
            self.get_logger().warning(why, throttle_duration_sec=5.0)
        self._publish_pose(result, stamp)

    # -- publishing

    def _publish_pose(self, result: Result, stamp: Time) -> None:
        msg = PoseWithCovarianceStamped()
        msg.header.frame_id, msg.header.stamp = self.map_frame, stamp.to_msg()
        put(result.pose, msg.pose.pose.position, msg.pose.pose.orientation)
        c, s = np.cos(result.pose.theta), np.sin(result.pose.theta)
        turn = np.array([[c, -s], [s, c]])
        spread = turn @ result.covariance[:2, :2] @ turn.T * self._scales[0]
        covariance = np.zeros((6, 6))
        covariance[:2, :2], covariance[5, 5] = spread, result.covariance[2, 2] * self._scales[1]
        msg.pose.covariance = covariance.ravel()
        self._pose_publisher.publish(msg)

    def _publish_transform(self) -> None:
        """Publish map → odom, valid a little into the future."""
        if self.last is None:
            return
        restamp = self.get_parameter("restamp_tf").value
        msg = TransformStamped()
        msg.header.frame_id, msg.child_frame_id = self.map_frame, self.odom_frame
        begin = self.get_clock().now() if restamp else self._stamp
        msg.header.stamp = (begin + self._ahead).to_msg()
        put(self._map_to_odom, msg.transform.translation, msg.transform.rotation)
        self._broadcaster.sendTransform(msg)

    def publish_map(self) -> None:
        """Publish the current map and markers."""
        grid = self.engine.grid()
        if grid is not None:
            self.map_topic.publish(grid, self._stamp.to_msg())
        if self._graph_publisher.get_subscription_count():
            marks = self.engine.markers(self.last, self.map_frame, self._stamp.to_msg())
            self._graph_publisher.publish(marks)
