"""`ros2 run nav2_amcl amcl`: a lifecycle node that localises a robot in /map with a particle filter."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from geometry_msgs.msg import PoseWithCovarianceStamped, TransformStamped
from nav2_msgs.msg import ParticleCloud
from nav_msgs.msg import OccupancyGrid
from rclpy.duration import Duration
from rclpy.lifecycle import LifecycleNode, LifecycleState, TransitionCallbackReturn
from rclpy.qos import qos_profile_sensor_data
from rclpy.time import Time
from sensor_msgs.msg import LaserScan
from std_srvs.srv import Empty
from tf2_ros import TransformBroadcaster, TransformException, TransformListener

from coursekit.geometry.plane import Pose2D
from coursekit.nav.particle_filter import Estimate, ParticleFilter
from coursekit.nav.particle_map import ParticleMap
from coursekit.nodes.nav2.amcl_messages import POSE_QOS, beam_ends, cloud_message, pose_message, pose_of
from coursekit.nodes.nav2.amcl_parameters import declare, filter_parameters, given, number
from coursekit.nodes.nav2.map_message import MAP_QOS, from_message
from coursekit.nodes.nav2.parameters import Obedience
from coursekit.nodes.running import run
from coursekit.nodes.scanning.lasers import Lasers
from coursekit.nodes.scanning.planar import of_transform, put
from coursekit.nodes.scanning.scan_filter import ScanFilter, WakingBuffer, lookup

if TYPE_CHECKING:
    from builtin_interfaces.msg import Time as TimeMsg

_USUAL = np.diag([0.25, 0.25, 0.06853891945200942])
"""Default covariance of an initial pose: half a metre, 15 degrees."""
_QUIET = 2.0
_NO_POSE = "AMCL cannot publish a pose or update the transform. Please set the initial pose..."


class Amcl(LifecycleNode):
    """Moves particles with the odometry, weights them with scans, publishes /amcl_pose and map → odom."""

    def __init__(self) -> None:
        super().__init__("amcl")
        self.get_logger().info("Creating")
        declare(self)
        self._filter: ParticleFilter | None = None
        self._start: tuple[Pose2D, np.ndarray] | None = None
        self._active = self._known = self._forced = self._anywhere = False
        self._before: Pose2D | None = None
        self._estimate: Estimate | None = None
        self._map_to_odom = Pose2D()

    # -- states

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Read parameters, create topics and services; FAILURE for invalid parameters."""
        self.get_logger().info("Configuring")
        try:
            self._params = filter_parameters(self)
            self._read_parameters()
        except ValueError as fault:
            self.get_logger().error(str(fault))
            return TransitionCallbackReturn.FAILURE
        self._obedience = Obedience(self, self._read_again)
        self._make_transforms()
        self._make_topics()
        return super().on_configure(state)

    def _read_again(self) -> None:
        params = filter_parameters(self)
        self._read_parameters()
        self._params = params
        if self._filter is not None:
            self._filter.params = params

    def _read_parameters(self) -> None:
        """Read the node's own parameters. ValueError for invalid ones."""
        self._map_frame, self._odom_frame, self._base_frame = (
            str(given(self, f"{name}_frame_id")) for name in ("global", "odom", "base")
        )
        self._least = number(self, "update_min_d"), number(self, "update_min_a")
        self._beams, self._ahead = int(number(self, "max_beams")), Duration(seconds=number(self, "transform_tolerance"))
        farthest, self._nearest = number(self, "laser_max_range"), number(self, "laser_min_range")
        self._farthest = farthest if farthest > 0 else math.inf
        self._far_wall = number(self, "laser_likelihood_max_dist")
        if self._filter is None and given(self, "set_initial_pose"):
            start = Pose2D.of([number(self, f"initial_pose.{axis}") for axis in ("x", "y", "yaw")])
            self._start = (start, _USUAL)

    def _make_transforms(self) -> None:
        self.get_logger().info("initTransforms")
        self._buffer = WakingBuffer(node=self)
        self._listener = TransformListener(self._buffer, self)
        self._broadcaster = TransformBroadcaster(self)
        self._lasers = Lasers(self, self._buffer, self._base_frame, self._farthest)
        self._waiting = ScanFilter(self, self._buffer, self._odom_frame, 10, self._take)

    def _make_topics(self) -> None:
        self.get_logger().info("initPubSub")
        self._pose_publisher = self.create_lifecycle_publisher(PoseWithCovarianceStamped, "amcl_pose", POSE_QOS)
        self._cloud_publisher = self.create_lifecycle_publisher(ParticleCloud, "particle_cloud", qos_profile_sensor_data)
        scan, grid = (str(self.get_parameter(f"{name}_topic").value) for name in ("scan", "map"))
        self._subscriptions_made = [
            self.create_subscription(PoseWithCovarianceStamped, "initialpose", self._initial_pose, qos_profile_sensor_data),
            self.create_subscription(OccupancyGrid, grid, self._take_map, MAP_QOS),
            self.create_subscription(LaserScan, scan, self._hear, qos_profile_sensor_data),
        ]
        self.get_logger().info("Subscribed to map topic.")
        self._services_made = [
            self.create_service(Empty, "reinitialize_global_localization", self._look_everywhere),
            self.create_service(Empty, "request_nomotion_update", self._force),
        ]

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Start processing scans."""
        self.get_logger().info("Activating")
        self._active = True
        answer = super().on_activate(state)
        self._begin()
        return answer

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Stop processing scans."""
        self.get_logger().info("Deactivating")
        self._active = False
        return super().on_deactivate(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Discard the map and the particles."""
        self.get_logger().info("Cleaning up")
        answer = super().on_cleanup(state)
        self._obedience.end()
        for subscription in self._subscriptions_made:
            self.destroy_subscription(subscription)
        for service in self._services_made:
            self.destroy_service(service)
        self._listener.unregister()
        self.destroy_lifecycle_publisher(self._pose_publisher)
        self.destroy_lifecycle_publisher(self._cloud_publisher)
        self._filter, self._estimate, self._known = None, None, False
        return answer

    # -- inputs

    def _take_map(self, msg: OccupancyGrid) -> None:
        """Handle a map; the particles are initialised again."""
        info = msg.info
        if self._filter is not None and self.get_parameter("first_map_only").value:
            return
        self.get_logger().info(f"Received a {info.width} X {info.height} map @ {info.resolution:.3f} m/pix")
        if msg.header.frame_id != self._map_frame:
            self.get_logger().warning(
                f"Frame_id of map received:'{msg.header.frame_id}' doesn't match global_frame_id:'{self._map_frame}'. "
                "This could cause issues with reading published topics"
            )
        try:
            self._filter = ParticleFilter(ParticleMap(from_message(msg), self._far_wall), self._params)
        except ValueError as fault:
            self.get_logger().error(f"The map cannot be used: {fault}")
            return
        if self._start is None and self._estimate is not None:
            self._start = (Pose2D.of(self._estimate.pose), self._estimate.covariance)
        self._begin()

    def _begin(self) -> None:
        """Initialise the particles at the given pose, once there is a map."""
        if not self._active or self._filter is None:
            return
        if self._anywhere:
            self._filter.start_anywhere()
        elif self._start is not None:
            pose, covariance = self._start
            now = self.get_clock().now().nanoseconds * 1e-9
            self.get_logger().info(f"Setting pose ({now:.6f}): {pose.x:.3f} {pose.y:.3f} {pose.theta:.3f}")
            self._filter.start(np.array(pose), covariance)
        else:
            return
        self._known, self._before, self._start, self._anywhere = True, None, None, False

    def _initial_pose(self, msg: PoseWithCovarianceStamped) -> None:
        self.get_logger().info("initialPoseReceived")
        frame = msg.header.frame_id
        if frame == "":
            self.get_logger().warning(
                "Received initial pose with empty frame_id. You should always supply a frame_id."
            )
        elif frame != self._map_frame:
            self.get_logger().warning(
                f'Ignoring initial pose in frame "{frame}"; initial poses must be in the global frame, "{self._map_frame}"'
            )
            return
        try:
            self._start = pose_of(msg)
        except ValueError as fault:
            self.get_logger().error(str(fault))
            return
        if not self._active:
            self.get_logger().warning("Received initial pose request, but AMCL is not yet in the active state")
        self._begin()

    def _look_everywhere(self, _request: Empty.Request, response: Empty.Response) -> Empty.Response:
        self.get_logger().info("Initializing with uniform distribution")
        self._anywhere = True
        self._begin()
        self.get_logger().info("Global initialisation done!")
        return response

    def _force(self, _request: Empty.Request, response: Empty.Response) -> Empty.Response:
        self.get_logger().info("Requesting no-motion update")
        self._forced = True
        return response

    def _hear(self, msg: LaserScan) -> None:
        if self._active:
            self._waiting.add(msg)

    # -- scans

    def _take(self, msg: LaserScan) -> None:
        """Process a scan whose transform is known."""
        particles = self._filter
        if not self._active or particles is None:
            self.get_logger().warning("Waiting for map....", throttle_duration_sec=_QUIET)
            return
        if not self._known:
            self.get_logger().warning(_NO_POSE, throttle_duration_sec=_QUIET)
            return
        laser = self._lasers.of(msg)
        if laser is None:
            return
        try:
            odometry = of_transform(lookup(self._buffer, self._odom_frame, self._base_frame, msg.header.stamp))
        except TransformException as fault:
            self.get_logger().error(f"Couldn't determine robot's pose associated with laser scan: {fault}")
            return
        if self._due(odometry):
            ends = beam_ends(msg, laser, self._beams)
            self._update(particles, ends, odometry, min(laser.range_max, self._farthest), msg.header.stamp)
        self._publish_transform(msg.header.stamp)

    def _due(self, odometry: Pose2D) -> bool:
        """Whether the robot has moved enough, was just given a pose, or an update was requested."""
        if self._before is None or self._forced:
            return True
        motion = self._before.to(odometry)
        distance, turn = self._least
        return abs(motion.x) > distance or abs(motion.y) > distance or abs(motion.theta) > turn

    def _update(
        self, particles: ParticleFilter, ends: np.ndarray, odometry: Pose2D, farthest: float, stamp: TimeMsg
    ) -> None:
        """Move and weight the particles, and publish the result."""
        if self._before is not None:
            particles.move(np.array(self._before), np.array(odometry))
        self._before, self._forced = odometry, False
        if self._nearest > 0:
            ends = ends[np.hypot(ends[:, 0], ends[:, 1]) > self._nearest]
        if len(ends):
            particles.update(ends, farthest)
        self._estimate = particles.estimate()
        self._map_to_odom = Pose2D.of(self._estimate.pose) @ odometry.inverse()
        self._pose_publisher.publish(pose_message(self._estimate, self._map_frame, stamp))
        if self._cloud_publisher.get_subscription_count():
            self._cloud_publisher.publish(cloud_message(particles, self._map_frame, stamp))

    def _publish_transform(self, stamp: TimeMsg) -> None:
        """Publish map → odom, valid slightly into the future."""
        if not self.get_parameter("tf_broadcast").value:
            return
        msg = TransformStamped()
        msg.header.frame_id, msg.child_frame_id = self._map_frame, self._odom_frame
        msg.header.stamp = (Time.from_msg(stamp) + self._ahead).to_msg()
        put(self._map_to_odom, msg.transform.translation, msg.transform.rotation)
        self._broadcaster.sendTransform(msg)


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(Amcl, args)
