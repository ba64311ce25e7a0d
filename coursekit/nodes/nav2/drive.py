"""One goal of follow_path."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from geometry_msgs.msg import Twist
from nav2_msgs.action import FollowPath
from tf2_ros import TransformException

from coursekit.geometry.plane import Pose2D, wrap
from coursekit.nav.controller import ControlError
from coursekit.nav.planner import length
from coursekit.nodes.compiled.classes import CppFault
from coursekit.nodes.nav2.controller_parameters import fit
from coursekit.nodes.nav2.transform_lookup import stamped
from coursekit.nodes.scanning.planar import plane

if TYPE_CHECKING:
    from rclpy.action.goal_handle import ServerGoalHandle

    from coursekit.nav.costmap import Costmap
    from coursekit.nodes.nav2.controller_server import ControllerServer

_PLANNER_EXCEPTION = "nav2_core::PlannerException"


class Drive:
    """One goal of follow_path, executed step by step."""

    def __init__(self, server: ControllerServer, handle: ServerGoalHandle, one: Any) -> None:
        self.server, self.handle, self.controller = server, handle, one
        self.path = handle.request.path
        self.frame = self.path.header.frame_id or server.costmap.frame
        poses = [plane(pose.pose.position, pose.pose.orientation) for pose in self.path.poses]
        self.poses = np.array(poses, dtype=float)
        self.checker = server.goal_checker(handle.request.goal_checker_id)
        self.since_ns: int | None = None
        self._fresh, self._begun = server.actions[0].fresh, False

    def _start(self) -> None:
        self._begun = True
        self.checker.reset()
        if self._fresh:
            self.server.progress.reset()
        self._begin()

    def _begin(self) -> None:
        """Prepare the controller."""
        fit(self.controller, self.server.costmap)
        self.controller.begin()

    def step(self) -> bool:
        """Publish one command. Returns whether it was the last."""
        server, handle = self.server, self.handle
        if server.actions[0].replaced(handle):
            handle.abort()
            if not server.actions[0].active:
                server.stop()
            return True
        if handle.is_cancel_requested:
            server.get_logger().info("Goal was canceled. Stopping the robot.")
            server.stop()
            handle.canceled()
            return True
        try:
            if not self._begun:
                self._start()
            return self._drive_on()
        except (ControlError, TransformException) as fault:
            return self._failed(str(fault))
        except CppFault as fault:
            server.get_logger().error(str(fault))
            return self._end()

    def _drive_on(self) -> bool:
        server = self.server
        costs = server.costmap.latest or server.costmap.fresh()
        if costs is None:
            raise ControlError("The local costmap does not know where the robot is")
        frame = server.costmap.frame
        here = server.costmap.pose()
        shift = server.costmap.where.between(frame, self.frame)
        points = shift.transform(self.poses[:, :2])
        goal = shift @ Pose2D.of(self.poses[-1])
        if self.checker.reached(here, goal, server.speeds):
            return self._arrived()
        now = server.get_clock().now().nanoseconds * 1e-9
        if not server.progress.gets_on(here.x, here.y, now, here.theta):
            server.get_logger().error("Failed to make progress")
            return self._end()
        server.drive(self._command(costs, here, goal, points))
        self.since_ns = None
        self._feed_back(here, points)
        return False

    def _command(self, costs: Costmap, here: Pose2D, goal: Pose2D, points: np.ndarray) -> Twist:
        velocity, speeds = Twist(), self._speeds(costs, here, goal, points)
        velocity.linear.x, velocity.angular.z = speeds
        turn = wrap(goal.theta - self.poses[-1, 2])
        self.server.local_plan.tell(here, speeds, self.controller.horizon, points, lambda: self.poses[:, 2] + turn)
        return velocity

    def _speeds(self, costs: Costmap, here: Pose2D, goal: Pose2D, points: np.ndarray) -> tuple[float, float]:
        now = self.server.speeds
        if self.checker.near(here, goal):
            if not self.controller.blocked(costs, here):
                return self.controller.turn(costs, here, now, wrap(goal.theta - here.theta))
            self.checker.reset()  # something is approaching: avoid it first, then return to the goal
        return self.controller.command(costs, here, now, points, self.server.top(self.controller))

    def _arrived(self) -> bool:
        self.server.get_logger().info("Reached the goal!")
        self.server.stop()
        self.handle.succeed()
        return True

    def _failed(self, why: str) -> bool:
        """Stop the robot; abort if the failure lasts too long, at once without a failure_tolerance."""
        server = self.server
        now = server.get_clock().now().nanoseconds
        server.stop()
        if server.patience == 0:
            server.get_logger().error(why)
            return self._end()
        server.get_logger().warning(why, throttle_duration_sec=2.0)
        self.since_ns = now if self.since_ns is None else self.since_ns
        if 0 <= server.patience < (now - self.since_ns) * 1e-9:
            server.get_logger().error("Controller patience exceeded")
            return self._end()
        return False

    def _end(self) -> bool:
        self.server.stop()
        self.handle.abort()
        return True

    def _feed_back(self, here: Pose2D, points: np.ndarray) -> None:
        feedback = FollowPath.Feedback()
        nearest = int(np.hypot(points[:, 0] - here.x, points[:, 1] - here.y).argmin())
        feedback.distance_to_goal = length(points[nearest:])
        feedback.speed = float(np.hypot(*self.server.speeds[:1], 0.0))
        self.handle.publish_feedback(feedback)


class CppDrive(Drive):
    """A goal for a controller that is a C++ class: a PlannerException is a failure that may pass."""

    def _begin(self) -> None:
        self.controller.follow(self.path)

    def _command(self, costs: Costmap, here: Pose2D, goal: Pose2D, points: np.ndarray) -> Twist:
        server = self.server
        at = stamped(here, server.costmap.frame, server.get_clock().now().to_msg())
        try:
            velocity: Twist = self.controller.command(at, self._measured(), self.checker)
        except CppFault as fault:
            if fault.kind == _PLANNER_EXCEPTION:
                raise ControlError(str(fault)) from None
            raise
        return velocity

    def _measured(self) -> Twist:
        """Return the robot's velocity, without what is below the thresholds."""
        server, measured = self.server, Twist()
        (forward, left), turn = (server.velocity.linear.x, server.velocity.linear.y), server.velocity.angular.z
        measured.linear.x = forward if abs(forward) > server.number("min_x_velocity_threshold") else 0.0
        measured.linear.y = left if abs(left) > server.number("min_y_velocity_threshold") else 0.0
        measured.angular.z = turn if abs(turn) > server.number("min_theta_velocity_threshold") else 0.0
        return measured
