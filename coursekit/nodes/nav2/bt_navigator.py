"""`ros2 run nav2_bt_navigator bt_navigator`: drives the robot to a pose, using planner, controller and behaviours."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import PoseStamped
from nav2_msgs.action import NavigateToPose
from rclpy.action import ActionClient
from rclpy.lifecycle import LifecycleState, TransitionCallbackReturn
from rclpy.time import Time
from tf2_ros import TransformException

from coursekit.geometry.plane import Pose2D
from coursekit.nodes.compiled.classes import CppFault
from coursekit.nodes.nav2.cpp_tree_nodes import CppTreeNodes, load
from coursekit.nodes.nav2.navigators import NavigateThroughPosesNavigator, NavigateToPoseNavigator, Navigator
from coursekit.nodes.nav2.odom_smoother import OdomSmoother
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.nav2.running import Server, run
from coursekit.nodes.nav2.transform_lookup import TransformLookup
from coursekit.nodes.nav2.tree_context import TreeContext
from coursekit.nodes.nav2.tree_libraries import LIBRARIES
from coursekit.nodes.nav2.tree_log import TreeLog
from coursekit.nodes.nav2.tree_run import KINDS

if TYPE_CHECKING:
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
    "goal_blackboard_id": "goal",
    "goals_blackboard_id": "goals",
    "path_blackboard_id": "path",
    "plugin_lib_names": [f"nav2_{name}" for name in LIBRARIES],
}


class BtNavigator(Server):
    """The actions navigate_to_pose and navigate_through_poses, and the topic goal_pose."""

    def __init__(self) -> None:
        super().__init__("bt_navigator")
        declare(self, _SERVER)

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Create the actions; FAILURE for invalid parameters."""
        self.get_logger().info("Configuring")
        try:
            given = declare(self, _SERVER)
        except ValueError as fault:
            self.get_logger().error(str(fault))
            return TransitionCallbackReturn.FAILURE
        self._frame = given["global_frame"]
        self.where = TransformLookup(self, given["robot_base_frame"])
        self._odometry = OdomSmoother(self, given["odom_topic"])
        self._tree_context = TreeContext(
            self, self._pose, lambda goal: self.where.pose_in(self._frame, goal),
            lambda target, source: self.where.buffer.can_transform(target, source, Time()), self._odometry.speed,
        )  # fmt: skip
        self._foreign = self._load(given["plugin_lib_names"])
        self._log = TreeLog(self)
        self._navigators: list[Navigator] = []
        shared = (self, self._tree_context, self._kinds, self._frame, self._log, self._navigators)
        self._navigators += [NavigateToPoseNavigator(*shared), NavigateThroughPosesNavigator(*shared)]
        self._self_client = ActionClient(self, NavigateToPose, "navigate_to_pose")
        self._heard = self.create_subscription(PoseStamped, "goal_pose", self._clicked, 10)
        return super().on_configure(state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Accept goals; FAILURE if a default tree cannot be loaded."""
        for navigator in self._navigators:
            try:
                navigator.load(navigator.default_file())
            except ValueError as fault:
                self.get_logger().error(str(fault))
                return TransitionCallbackReturn.FAILURE
        return super().on_activate(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Destroy the actions and subscriptions."""
        for navigator in self._navigators:
            navigator.close()
        self.destroy_subscription(self._heard)
        self._odometry.destroy()
        self._self_client.destroy()
        self._tree_context.destroy()
        self._log.destroy()
        if self._foreign is not None:
            self._foreign.close()
        self.where.close()
        return super().on_cleanup(state)

    def _load(self, names: list[str]) -> CppTreeNodes | None:
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

    def _clicked(self, msg: PoseStamped) -> None:
        """Handle a goal from a click."""
        self._self_client.send_goal_async(NavigateToPose.Goal(pose=msg))

    def _pose(self) -> Pose2D | None:
        try:
            return self.where.robot(self._frame)
        except TransformException:
            return None


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(BtNavigator, args)
