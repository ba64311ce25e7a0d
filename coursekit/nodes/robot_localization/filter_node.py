"""`ros2 run robot_localization ekf_node` and `ukf_node`: sensors in; odometry/filtered and its transform out."""

from __future__ import annotations

import numpy as np
from geometry_msgs.msg import AccelWithCovarianceStamped, PoseWithCovarianceStamped, Twist, TwistStamped
from nav_msgs.msg import Odometry
from rclpy.node import Node
from rclpy.time import Time
from robot_localization.srv import SetPose, ToggleFilterProcessing
from std_srvs.srv import Empty
from tf2_ros import TransformBroadcaster, TransformException

from coursekit.geometry.pose import compose
from coursekit.geometry.rotation import rpy_of
from coursekit.nav.fusion.estimator import Estimator
from coursekit.nav.fusion.kalman import Ekf, Estimate
from coursekit.nav.fusion.state import ANGLES, POSE, POSITION, SIZE, wrapped
from coursekit.nav.fusion.unscented import Ukf
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.robot_localization import messages, parameters
from coursekit.nodes.robot_localization.diagnostics import FilterDiagnostics
from coursekit.nodes.robot_localization.filter_subscriptions import FilterSubscriptions
from coursekit.nodes.robot_localization.frames import Frames
from coursekit.nodes.robot_localization.geometry import pose_of, square, turned, turning, vector
from coursekit.nodes.robot_localization.measurement_conversion import MeasurementConverter
from coursekit.nodes.robot_localization.sources import sources
from coursekit.nodes.running import run


class FilterNode(Node):
    """Estimates the robot's pose, `frequency` times a second, from the sensors in its parameters."""

    def __init__(self, kind: type[Ekf] = Ekf, name: str = "ekf_filter_node") -> None:
        super().__init__(name)
        self._given = given = parameters.read(self)
        self._sources = sources(self)
        self._frames = Frames(self)
        self._begin(kind)
        flat, gravity = given["two_d_mode"], given["gravitational_acceleration"]
        base = given["base_link_frame"]
        preparing = MeasurementConverter(self._frames, given["world_frame"], base, flat=flat, gravity=gravity)
        self._health = FilterDiagnostics(self, given["frequency"]) if given["print_diagnostics"] else None
        self._ears = FilterSubscriptions(self, preparing, self._estimator, self._sources, self._health)
        self._enabled, self._on, self._published_ns, self._last_ns = not given["disabled_at_startup"], True, -1, 0
        self._make_topics()

    def _begin(self, kind: type[Ekf]) -> None:
        """Create the filter from the parameters."""
        given = self._given
        self._control = parameters.control(self, given, self._sources)
        more = declare(self, {"alpha": 0.001, "kappa": 0.0, "beta": 2.0}) if kind is Ukf else {}
        noise, scaled = parameters.covariance(self, "process_noise_covariance"), given["dynamic_process_noise_covariance"]
        history = round(abs(given["history_length"]) * 1e9) if given["smooth_lagged_data"] else 0
        kalman_filter = kind(noise, control=self._control, scaled=scaled, **more)
        timeout, up_to_now = round(given["sensor_timeout"] * 1e9), given["predict_to_current_time"]
        self._estimator = Estimator(kalman_filter, timeout, history, up_to_now=up_to_now)
        self._reset()

    def _reset(self) -> None:
        """Reset the estimate to the initial values in the parameters."""
        first = Estimate()
        covariance = parameters.covariance(self, "initial_estimate_covariance")
        if covariance is not None:
            first.covariance = covariance.copy()
        state = parameters.optional(self, "initial_state")
        if state is not None and len(state) == SIZE:
            first.state = np.array(state)
        self._estimator.filter.now = first

    def _make_topics(self) -> None:
        """Create the topics, the services, the transform and the timer."""
        self._broadcaster = TransformBroadcaster(self)
        self._out = self.create_publisher(Odometry, "odometry/filtered", 10)
        if self._given["publish_acceleration"]:
            self._accelerations = self.create_publisher(AccelWithCovarianceStamped, "accel/filtered", 10)
        self.create_subscription(PoseWithCovarianceStamped, "set_pose", self._set_pose, 1)
        self.create_service(SetPose, "set_pose", self._serve_pose)
        self.create_service(Empty, "enable", self._enable)
        self.create_service(ToggleFilterProcessing, "toggle", self._toggle)
        if self._control is not None:
            kind = TwistStamped if self._given["stamped_control"] else Twist
            self.create_subscription(kind, "cmd_vel", self._command, 1)
        self.create_timer(1.0 / self._given["frequency"], self._work)

    # -- work

    def _work(self) -> None:
        now_ns = self.get_clock().now().nanoseconds
        if not self._enabled:
            name = self.resolve_service_name("enable")
            self.get_logger().info(f"Filter is disabled. To enable it call the {name} service", once=True)
            return
        if now_ns < self._last_ns and self._given["reset_on_time_jump"]:
            self._start_again()
        self._last_ns = now_ns
        estimate = self._advance(now_ns)
        if not estimate.begun:
            return
        if not np.isfinite(estimate.state).all():
            self.get_logger().error(
                "Critical Error, NaNs were detected in the output state of the filter. This was likely due to poorly "
                "coniditioned process, noise, or sensor covariances.", throttle_duration_sec=5.0,
            )  # fmt: skip
            return
        if estimate.time_ns > self._published_ns or self._given["permit_corrected_publication"]:
            self._publish(estimate)
        self._published_ns = estimate.time_ns

    def _advance(self, now_ns: int) -> Estimate:
        if self._on:
            self._estimator.advance(now_ns)
        else:
            self._estimator.forget()
            self._estimator.filter.now.time_ns = now_ns
        return self._estimator.filter.now

    def _start_again(self) -> None:
        """Reset after time went back, as when a bag or a simulation restarts."""
        self.get_logger().warning("Detected jump back in time. Resetting the filter.")
        self._ears.forget()
        self._ears.deaf_until_ns, self._published_ns = 0, -1
        self._reset()

    def _publish(self, estimate: Estimate) -> None:
        given = self._given
        if given["publish_tf"]:
            self._send_transform(estimate)
        if self._health is not None:
            self._health.tick()
        self._out.publish(messages.odometry(estimate, given["world_frame"], given["base_link_frame_output"]))
        if given["publish_acceleration"]:
            self._accelerations.publish(messages.acceleration(estimate, given["base_link_frame_output"]))

    def _send_transform(self, estimate: Estimate) -> None:
        """Publish odom → base_link; or, if another node publishes that, map → odom."""
        given, pose = self._given, messages.pose_of(estimate)
        stamp = estimate.time_ns + round(given["transform_time_offset"] * 1e9)
        child = given["base_link_frame_output"]
        if given["world_frame"] != given["odom_frame"]:
            try:
                pose = compose(pose, self._frames.pose(given["base_link_frame"], given["odom_frame"], 0))
            except TransformException as fault:
                self.get_logger().error(f"Could not obtain transform from odom: {fault}", throttle_duration_sec=5.0)
                return
            child = given["odom_frame"]
        self._broadcaster.sendTransform(messages.transform(pose, stamp, given["world_frame"], child))

    # -- requests

    def _set_pose(self, msg: PoseWithCovarianceStamped) -> None:
        """Set the pose, with zero velocity."""
        stamp, world = Time.from_msg(msg.header.stamp).nanoseconds, self._given["world_frame"]
        try:
            seat = self._frames.pose(world, msg.header.frame_id or world, stamp)
        except TransformException as fault:
            self.get_logger().error(f"set_pose cannot be used: {fault}")
            return
        self._ears.forget()
        self._ears.deaf_until_ns = stamp
        pose = compose(seat, pose_of(msg.pose.pose.position, msg.pose.pose.orientation))
        state, covariance = np.zeros(SIZE), np.eye(SIZE) * 1e-6
        state[POSITION], state[ANGLES] = pose[:3], rpy_of(pose[3:])
        covariance[POSE, POSE] = turned(square(msg.pose.covariance), turning(seat))
        before = self._estimator.filter.now
        now_ns = self.get_clock().now().nanoseconds
        self._estimator.filter.now = Estimate(wrapped(state), covariance, now_ns, before.begun)

    def _serve_pose(self, request: SetPose.Request, response: SetPose.Response) -> SetPose.Response:
        self._set_pose(request.pose)
        return response

    def _enable(self, _request: Empty.Request, response: Empty.Response) -> Empty.Response:
        log, name = self.get_logger(), self.get_name()
        if self._enabled:
            already = "the filter was already enabled! Use param disabled_at_startup."
            log.warning(f"[{name}:] Asking for enabling filter service, but {already}")
        else:
            log.info(f"[{name}:] Enabling filter...")
            self._enabled = True
        return response

    def _toggle(
        self, request: ToggleFilterProcessing.Request, response: ToggleFilterProcessing.Response
    ) -> ToggleFilterProcessing.Response:
        if request.on == self._on:
            self.get_logger().warning("Service was called to toggle filter processing but state was already as requested.")
            response.status = False
            return response
        self.get_logger().info(f"Toggling filter measurement filtering to {'On' if request.on else 'Off'}.")
        self._on, response.status = bool(request.on), True
        return response

    def _command(self, msg: Twist | TwistStamped) -> None:
        now = self.get_clock().now().to_msg()
        twist, stamp = (msg.twist, msg.header.stamp) if isinstance(msg, TwistStamped) else (msg, now)
        time_ns = Time.from_msg(stamp).nanoseconds
        if self._control is not None:
            self._control.command(np.concatenate([vector(twist.linear), vector(twist.angular)]), time_ns)


def ekf(args: list[str] | None = None) -> int:
    """Run an extended Kalman filter until Ctrl-C."""
    return run(lambda: FilterNode(Ekf, "ekf_filter_node"), args, refuses=(ValueError,))


def ukf(args: list[str] | None = None) -> int:
    """Run an unscented Kalman filter until Ctrl-C."""
    return run(lambda: FilterNode(Ukf, "ukf_filter_node"), args, refuses=(ValueError,))
