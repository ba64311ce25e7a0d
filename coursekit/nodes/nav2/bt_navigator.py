"""`ros2 run nav2_bt_navigator bt_navigator`: drives the robot to a pose, using planner, controller and behaviours."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from ament_index_python.packages import get_package_share_directory
from geometry_msgs.msg import PoseStamped
from nav2_msgs.action import NavigateThroughPoses, NavigateToPose
from nav_msgs.msg import Odometry
from rclpy.action import ActionClient
from rclpy.duration import Duration
from rclpy.lifecycle import LifecycleState, TransitionCallbackReturn
from rclpy.time import Time
from tf2_ros import TransformException

from coursekit.geometry.plane import Pose2D
from coursekit.nodes.compiled.classes import CppFault
from coursekit.nodes.nav2.crew import Crew
from coursekit.nodes.nav2.foreign_tree import ForeignNodes, load
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.nav2.running import Server, SingleGoal, run
from coursekit.nodes.nav2.tree_libraries import LIBRARIES
from coursekit.nodes.nav2.tree_log import TreeLog
from coursekit.nodes.nav2.trip import KINDS, Trip, load_tree
from coursekit.nodes.nav2.whereabouts import Whereabouts, stamped

if TYPE_CHECKING:
    from rclpy.action.goal_handle import ServerGoalHandle

    from coursekit.nav.behavior_tree import Kinds

_SERVER: dict[str, Any] = {
    "global_frame": "map",
    "robot_base_frame": "base_link",
    "odom_topic": "odom",
    "transform_tolerance": 0.1,
    "bt_loop_duration": 10,
    "default_server_timeout": 20,
    "default_nav_to_pose_bt_xml": "",
    "default_nav_through_poses_bt_xml": "",
    "plugin_lib_names": [f"nav2_{name}" for name in LIBRARIES],
}
_TREES = {NavigateToPose: "default_nav_to_pose_bt_xml", NavigateThroughPoses: "default_nav_through_poses_bt_xml"}
"""Parameters for the file of a behaviour tree."""
_OWN = {
    NavigateToPose: "navigate_to_pose_w_replanning_and_recovery.xml",
    NavigateThroughPoses: "navigate_through_poses_w_replanning_and_recovery.xml",
}
"""The default files from nav2_bt_navigator."""


class BtNavigator(Server):
    """The actions navigate_to_pose and navigate_through_poses, and the topic goal_pose."""

    def __init__(self) -> None:
        super().__init__("bt_navigator")
        declare(self, _SERVER)
        self._driver: Any = None
        """The goal that currently drives the robot; a goal that cannot start does not replace it."""

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Create the actions; FAILURE for invalid parameters."""
        self.get_logger().info("Configuring")
        try:
            given = declare(self, _SERVER)
        except ValueError as fault:
            self.get_logger().error(str(fault))
            return TransitionCallbackReturn.FAILURE
        self._frame, self._speed = given["global_frame"], 0.0
        self.where = Whereabouts(self, given["robot_base_frame"])
        self._crew = Crew(
            self, self._pose, lambda goal: self.where.pose_in(self._frame, goal),
            lambda target, source: self.where.buffer.can_transform(target, source, Time()),
        )  # fmt: skip
        self._foreign = self._load(given["plugin_lib_names"])
        self._log = TreeLog(self)
        self._period = max(given["bt_loop_duration"], 1) * 1e-3
        self._to_pose = self.serve(NavigateToPose, "navigate_to_pose", self._go_to)
        self._through = self.serve(NavigateThroughPoses, "navigate_through_poses", self._go_through)
        self._self_client = ActionClient(self, NavigateToPose, "navigate_to_pose")
        self._heard = [
            self.create_subscription(PoseStamped, "goal_pose", self._clicked, 10),
            self.create_subscription(Odometry, given["odom_topic"], self._take_odometry, 10),
        ]
        return super().on_configure(state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Accept goals; FAILURE if a default tree cannot be loaded."""
        for name in _TREES:
            try:
                load_tree(self._file(name), self._crew, [], self._kinds).retire()
            except ValueError as fault:
                self.get_logger().error(str(fault))
                return TransitionCallbackReturn.FAILURE
        return super().on_activate(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Destroy the actions and subscriptions."""
        for heard in self._heard:
            self.destroy_subscription(heard)
        self._self_client.destroy()
        self._crew.destroy()
        self._log.destroy()
        if self._foreign is not None:
            self._foreign.close()
        self.where.close()
        return super().on_cleanup(state)

    def _load(self, names: list[str]) -> ForeignNodes | None:
        """Load the workspaces' libraries of nodes. Raises CppFault."""
        self._kinds: Kinds = KINDS
        try:
            foreign = load(names, self)
            if foreign is not None:
                foreign.configure()
                self._kinds = {**KINDS, **foreign.kinds()}
        except CppFault:
            self.where.close()
            raise
        return foreign

    def _take_odometry(self, msg: Odometry) -> None:
        self._speed = msg.twist.twist.linear.x

    def _clicked(self, msg: PoseStamped) -> None:
        """Handle a goal from a click."""
        self._self_client.send_goal_async(NavigateToPose.Goal(pose=msg))

    def _pose(self) -> Pose2D | None:
        try:
            return self.where.robot(self._frame)
        except TransformException:
            return None

    async def _go_to(self, handle: ServerGoalHandle) -> Any:
        return await self._go(handle, NavigateToPose, [handle.request.pose], self._to_pose)

    async def _go_through(self, handle: ServerGoalHandle) -> Any:
        return await self._go(handle, NavigateThroughPoses, list(handle.request.poses), self._through)

    async def _go(self, handle: ServerGoalHandle, kind: type[Any], goals: list[PoseStamped], action: SingleGoal) -> Any:
        """Execute a goal of either action."""
        log, here = self.get_logger(), self._pose()
        if not goals or here is None:
            log.error("There are no poses to go to" if not goals else "Initial robot pose is not available.")
            handle.abort()
            return kind.Result()
        other = self._through if action is self._to_pose else self._to_pose
        other.current = None  # a goal of one kind replaces one of the other
        to = goals[-1].pose.position
        through = f" through {len(goals)} poses" if kind is NavigateThroughPoses else f" ({here.x:.2f}, {here.y:.2f})"
        log.info(f"Begin navigating from current location{through} to ({to.x:.2f}, {to.y:.2f})")
        begin = self.get_clock().now()

        def tell(trip: Trip) -> None:
            handle.publish_feedback(self._feedback(kind.Feedback(), trip, begin))

        def stop() -> bool:
            return bool(handle.is_cancel_requested or action.replaced(handle))

        def goes_on() -> bool:
            return self._driver not in (handle, None)

        try:
            tree = load_tree(handle.request.behavior_tree or self._file(kind), self._crew, goals, self._kinds)
        except ValueError as fault:
            log.error(f"{fault}. Navigation canceled.")
            handle.abort()
            return kind.Result()
        self._driver = handle
        end = await Trip(tree, self._crew, stop, goes_on, tell, self._period, self._log).run()
        self._driver = None if self._driver is handle else self._driver
        self._finish(handle, action, end)
        return kind.Result()

    def _file(self, kind: type[Any]) -> str:
        """Return the tree file of an action: the parameter's, or nav2's default."""
        share = Path(get_package_share_directory("nav2_bt_navigator"))
        return self.text(_TREES[kind]) or str(share / "behavior_trees" / _OWN[kind])

    def _finish(self, handle: ServerGoalHandle, action: SingleGoal, end: str) -> None:
        """Set and log how a goal ended."""
        log = self.get_logger()
        if end == "stopped" and handle.is_cancel_requested:
            log.info("Goal canceled")
            handle.canceled()
        elif end == "stopped":
            log.info("Goal preempted by a newer one" if action.active else "Deactivated: the goal is given up")
            handle.abort()
        elif end == "succeeded":
            log.info("Goal succeeded")
            handle.succeed()
        else:
            log.error("Goal failed")
            handle.abort()

    def _feedback(self, feedback: NavigateToPose.Feedback | NavigateThroughPoses.Feedback, trip: Trip, begin: Time) -> Any:
        here, now = self._pose(), self.get_clock().now()
        if here is not None:
            feedback.current_pose = stamped(here, self._frame, now.to_msg())
        feedback.navigation_time = (now - begin).to_msg()
        feedback.distance_remaining = trip.distance
        speed = abs(self._speed)
        if speed > 0.01:
            feedback.estimated_time_remaining = Duration(seconds=trip.distance / speed).to_msg()
        feedback.number_of_recoveries = trip.recoveries
        if hasattr(feedback, "number_of_poses_remaining"):
            feedback.number_of_poses_remaining = len(trip.goals)
        return feedback


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(BtNavigator, args)
