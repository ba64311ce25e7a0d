"""`ros2 run nav2_controller controller_server`: follows paths, avoiding obstacles in the local costmap."""

from __future__ import annotations

from typing import Any

import numpy as np
from geometry_msgs.msg import Twist
from nav2_msgs.action import FollowPath
from nav2_msgs.msg import SpeedLimit
from nav_msgs.msg import Odometry, Path
from rclpy.lifecycle import LifecycleState, TransitionCallbackReturn
from tf2_ros import TransformException

from coursekit.geometry.plane import Pose2D, wrap
from coursekit.nav.checkers import GoalChecker
from coursekit.nav.controller import ControlError, Controller
from coursekit.nav.planner import length
from coursekit.nodes.nav2.controller_parameters import SERVER, controller, fit, goal_checkers, progress_checker
from coursekit.nodes.nav2.costmap_node import CostmapNode
from coursekit.nodes.nav2.parameters import Obedience, declare
from coursekit.nodes.nav2.running import Beat, Server, run
from coursekit.nodes.scanning.planar import plane


class ControllerServer(Server):
    """Provides the action follow_path; publishes cmd_vel."""

    def __init__(self) -> None:
        super().__init__("controller_server")
        declare(self, SERVER)
        self.costmap = CostmapNode("local_costmap", self)

    # -- states

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Configure the costmap, create the plugins; FAILURE for invalid parameters."""
        self.get_logger().info("Configuring controller interface")
        if self.costmap.trigger_configure() != TransitionCallbackReturn.SUCCESS:
            return TransitionCallbackReturn.FAILURE
        try:
            self._make_plugins()
        except ValueError as fault:
            self.get_logger().error(str(fault))
            self.costmap.trigger_cleanup()
            return TransitionCallbackReturn.FAILURE
        self.get_logger().info(f"Controller frequency set to {1 / self._period:.4f}Hz")
        self.get_logger().info(f"Controller Server has {' '.join(self._controllers)} controllers available.")
        self._make_topics()
        self._obedience = Obedience(self, self._make_plugins)
        self.serve(FollowPath, "follow_path", self._follow)
        return super().on_configure(state)

    def _make_plugins(self) -> None:
        """Read the parameters. ValueError for invalid ones."""
        given = declare(self, SERVER)
        frequency = given["controller_frequency"]
        if not frequency > 0:
            raise ValueError(f"controller_frequency is {frequency}: give Hz, for example 20.0")
        self._period, self._patience = 1.0 / frequency, given["failure_tolerance"]
        self._progress = progress_checker(self, given["progress_checker_plugin"])
        self._goals = goal_checkers(self, given["goal_checker_plugins"])
        self._controllers = {
            name: controller(self, name, self.costmap, self._period) for name in given["controller_plugins"]
        }

    def _make_topics(self) -> None:
        self._speeds, self._limit, self._limit_share = (0.0, 0.0), 0.0, 0.0
        self._cmd_out = self.create_lifecycle_publisher(Twist, "cmd_vel", 1)
        self._plan_out = self.create_lifecycle_publisher(Path, "received_global_plan", 1)
        self._heard = [
            self.create_subscription(Odometry, self.text("odom_topic"), self._take_odometry, 10),
            self.create_subscription(SpeedLimit, self.text("speed_limit_topic"), self._take_limit, 10),
        ]

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Activate the costmap and accept goals."""
        if self.costmap.trigger_activate() is not TransitionCallbackReturn.SUCCESS:
            return TransitionCallbackReturn.FAILURE
        return super().on_activate(state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Stop the robot and deactivate the costmap."""
        self._stop()
        self.costmap.trigger_deactivate()
        return super().on_deactivate(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Destroy the plugins and the costmap."""
        self._obedience.end()
        self.costmap.trigger_cleanup()
        for heard in self._heard:
            self.destroy_subscription(heard)
        for publisher in (self._cmd_out, self._plan_out):
            self.destroy_lifecycle_publisher(publisher)
        return super().on_cleanup(state)

    # -- inputs

    def _take_odometry(self, msg: Odometry) -> None:
        self._speeds = msg.twist.twist.linear.x, msg.twist.twist.angular.z

    def _take_limit(self, msg: SpeedLimit) -> None:
        """Handle a limit in m/s, or in percent of the maximum speed; 0 means no limit."""
        self._limit, self._limit_share = (0.0, msg.speed_limit / 100) if msg.percentage else (msg.speed_limit, 0.0)

    def _top(self, one: Controller) -> float:
        return self._limit or self._limit_share * one.limits.max_speed

    # -- path following

    async def _follow(self, handle: Any) -> Any:
        """Drive until the goal is reached, fails, or is cancelled."""
        result, request = FollowPath.Result(), handle.request
        fault = self._unknown(request)
        if fault:
            self.get_logger().error(fault)
            handle.abort()
            self._stop()
            return result
        fresh = self.actions[0].fresh
        self.get_logger().info(
            "Received a goal, begin computing control effort." if fresh else "Passing new path to controller."
        )
        self._plan_out.publish(request.path)
        drive = _Drive(self, handle, self._controllers[request.controller_id or next(iter(self._controllers))])
        beat = Beat(self, self._period)
        try:
            while not drive.step():
                await beat.next()
        finally:
            beat.stop()
        return result

    def _unknown(self, request: Any) -> str:
        """Return what is wrong with a goal, or ''."""
        if request.controller_id and request.controller_id not in self._controllers:
            known = ", ".join(self._controllers)
            return f"FollowPath called with controller name {request.controller_id}, which does not exist. Known: {known}"
        if request.goal_checker_id and request.goal_checker_id not in self._goals:
            known = ", ".join(self._goals)
            return (
                f"FollowPath called with goal_checker name {request.goal_checker_id}, which does not exist. Known: {known}"
            )
        return "" if request.path.poses else "Invalid path, Path is empty."

    def goal_checker(self, name: str) -> GoalChecker:
        """Return a goal checker by name, or the first one."""
        return self._goals[name or next(iter(self._goals))]

    def drive(self, speeds: tuple[float, float]) -> None:
        """Publish the velocity command."""
        msg = Twist()
        msg.linear.x, msg.angular.z = speeds
        self._cmd_out.publish(msg)

    def _stop(self) -> None:
        self.drive((0.0, 0.0))


class _Drive:
    """One goal of follow_path, executed step by step."""

    def __init__(self, server: ControllerServer, handle: Any, one: Controller) -> None:
        self.server, self.handle, self.controller = server, handle, one
        self.path = handle.request.path
        self.frame = self.path.header.frame_id or server.costmap.frame
        poses = [plane(pose.pose.position, pose.pose.orientation) for pose in self.path.poses]
        self.poses = np.array(poses, dtype=float)
        self.checker = server.goal_checker(handle.request.goal_checker_id)
        self.checker.reset()
        fit(one, server.costmap)
        one.begin()
        if server.actions[0].fresh:
            server._progress.reset()
        self.since_ns: int | None = None

    def step(self) -> bool:
        """Publish one command. Returns whether it was the last."""
        server, handle = self.server, self.handle
        if server.actions[0].replaced(handle):
            handle.abort()
            if not server.actions[0].active:
                server._stop()
            return True
        if handle.is_cancel_requested:
            server.get_logger().info("Goal was canceled. Stopping the robot.")
            server._stop()
            handle.canceled()
            return True
        try:
            return self._drive_on()
        except (ControlError, TransformException) as fault:
            return self._failed(str(fault))

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
        if self.checker.reached(here, goal, server._speeds):
            return self._arrived()
        now = server.get_clock().now().nanoseconds * 1e-9
        if not server._progress.gets_on(here.x, here.y, now, here.theta):
            server.get_logger().error("Failed to make progress")
            return self._end()
        server.drive(self._speeds(costs, here, goal, points))
        self.since_ns = None
        self._feed_back(here, points)
        return False

    def _speeds(self, costs: Any, here: Pose2D, goal: Pose2D, points: np.ndarray) -> tuple[float, float]:
        now = self.server._speeds
        if self.checker.near(here, goal):
            if not self.controller.blocked(costs, here):
                return self.controller.turn(costs, here, now, wrap(goal.theta - here.theta))
            self.checker.reset()  # something is approaching: avoid it first, then return to the goal
        return self.controller.command(costs, here, now, points, self.server._top(self.controller))

    def _arrived(self) -> bool:
        self.server.get_logger().info("Reached the goal!")
        self.server._stop()
        self.handle.succeed()
        return True

    def _failed(self, why: str) -> bool:
        """Stop the robot; abort if the failure lasts too long."""
        server = self.server
        now = server.get_clock().now().nanoseconds
        server._stop()
        server.get_logger().warning(why, throttle_duration_sec=2.0)
        self.since_ns = now if self.since_ns is None else self.since_ns
        if 0 <= server._patience < (now - self.since_ns) * 1e-9 or server._patience == 0:
            server.get_logger().error("Controller patience exceeded")
            return self._end()
        return False

    def _end(self) -> bool:
        self.server._stop()
        self.handle.abort()
        return True

    def _feed_back(self, here: Pose2D, points: np.ndarray) -> None:
        feedback = FollowPath.Feedback()
        nearest = int(np.hypot(points[:, 0] - here.x, points[:, 1] - here.y).argmin())
        feedback.distance_to_goal = length(points[nearest:])
        feedback.speed = float(np.hypot(*self.server._speeds[:1], 0.0))
        self.handle.publish_feedback(feedback)


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(ControllerServer, args)
