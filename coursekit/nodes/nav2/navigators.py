"""bt_navigator's two actions: each keeps its tree and its blackboard from goal to goal, as nav2's navigators do."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from ament_index_python.packages import get_package_share_directory
from geometry_msgs.msg import PoseStamped
from nav2_msgs.action import NavigateThroughPoses, NavigateToPose
from rclpy.duration import Duration

from coursekit.nav.behavior_tree import Kinds, TreeNode
from coursekit.nav.path_change import remaining
from coursekit.nav.planner import length
from coursekit.nodes.nav2.running import Server
from coursekit.nodes.nav2.transform_lookup import stamped
from coursekit.nodes.nav2.tree_context import TreeContext
from coursekit.nodes.nav2.tree_run import PREEMPTED, TreeRun, board_of, load_tree, text_of
from coursekit.nodes.scanning.planar import points_of

if TYPE_CHECKING:
    from rclpy.action.server import ServerGoalHandle
    from rclpy.time import Time

    from coursekit.nodes.nav2.tree_log import TreeLog

_OTHER_TREE = (
    "Preemption request was rejected since the requested BT XML file is not the same as the one that the current goal "
    "is executing. Preemption with a new BT is invalid since it would require cancellation of the previous goal instead "
    "of true preemption.\nCancel the current goal and send a new action request if you want to use a different BT XML file. "
    "For now, continuing to track the last goal until completion."
)
"""nav2's words."""


class Navigator:
    """An action whose goals a behaviour tree works on. A new goal takes the running tree over, if it names the same file."""

    kind: Any
    name = ""
    parameter = ""
    """The parameter with the default tree's file; empty for `default`, one of nav2_bt_navigator's files."""
    default = ""
    field = ""
    """The goal's field that says where to go."""
    key = ""
    """The parameter with the key of the blackboard for it."""

    def __init__(
        self, node: Server, context: TreeContext, kinds: Kinds, frame: str, log: TreeLog, others: list[Navigator]
    ) -> None:  # fmt: skip
        self._node, self._context, self._kinds, self._frame = node, context, kinds, frame
        self._log, self._others = log, others
        self.board = board_of(context)
        self._tree: TreeNode | None = None
        self._file, self._text = "", ""
        self._handle: ServerGoalHandle | None = None
        self._action = node.serve(self.kind, self.name, self._navigate)

    def poses(self, request: Any) -> list[PoseStamped]:
        """The poses of a goal."""
        value = getattr(request, self.field)
        return value if isinstance(value, list) else [value]

    def default_file(self) -> str:
        """The file of the tree for goals that name none."""
        share = Path(get_package_share_directory("nav2_bt_navigator"))
        return self._node.text(self.parameter) or str(share / "behavior_trees" / self.default)

    def load(self, file: str) -> None:
        """Load the tree of a file, unless it is the one that is there. Raises TreeError (a ValueError)."""
        text = text_of(file)
        if (file, text) == (self._file, self._text):
            return
        if file == self._file:
            self._node.get_logger().warning(f"{file} has changed and is read again; on a robot, restart bt_navigator for it")
        tree = load_tree(file, text, self.board, self._kinds)
        self.close()
        self._tree, self._file, self._text = tree, file, text

    def close(self) -> None:
        """Let go of the tree."""
        if self._tree is not None:
            self._tree.retire()
        self._tree, self._file, self._text = None, "", ""

    async def _navigate(self, handle: ServerGoalHandle) -> Any:
        """Work on a goal until it ends, or until another one takes its tree over."""
        if not self._accepts(handle.request):
            self._action.current = self._handle
            handle.abort()
            return self.kind.Result()
        self._handle = handle
        begin = self._begin(handle.request)
        assert self._tree is not None

        def ended() -> str:
            if self._handle is not handle:
                return PREEMPTED
            return "canceled" if handle.is_cancel_requested else "" if self._action.active else "deactivated"

        def tell() -> None:
            handle.publish_feedback(self._feedback(begin))

        period = max(self._node.number("bt_loop_duration"), 1) * 1e-3
        try:
            end = await TreeRun(self._tree, self._context, ended, tell, period, self._log).run()
        finally:
            if self._handle is handle:
                self._handle = None
        self._finish(handle, end)
        return self.kind.Result()

    def _accepts(self, request: Any) -> bool:
        """Whether a goal may begin; its tree is loaded then."""
        log, poses, file = self._node.get_logger(), self.poses(request), request.behavior_tree or self.default_file()
        if any(other._handle is not None for other in self._others if other is not self):
            log.error(f"Requested navigation from {self.name} while another navigator is processing, rejecting request.")
        elif not poses or self._context.pose() is None:
            log.error("There are no poses to go to" if not poses else "Initial robot pose is not available.")
        elif self._handle is not None:
            return self._preempts(file)
        else:
            return self._loads(file)
        return False

    def _preempts(self, file: str) -> bool:
        self._node.get_logger().info("Received goal preemption request")
        if file != self._file:
            self._node.get_logger().warning(_OTHER_TREE)
        return file == self._file

    def _loads(self, file: str) -> bool:
        try:
            self.load(file)
        except ValueError as fault:
            self._node.get_logger().error(f"{fault}. Navigation canceled.")
            return False
        return True

    def _begin(self, request: Any) -> Time:
        """Put a goal on the blackboard. Returns the time."""
        here, to = self._context.pose(), self.poses(request)[-1].pose.position
        begins = f"({here.x:.2f}, {here.y:.2f})" if here is not None else ""
        way = f"through {len(request.poses)} poses" if self.kind is NavigateThroughPoses else begins
        self._node.get_logger().info(f"Begin navigating from current location {way} to ({to.x:.2f}, {to.y:.2f})")
        self.board["number_recoveries"] = 0
        self.board[self._node.text(self.key)] = getattr(request, self.field)
        return self._node.get_clock().now()

    def _finish(self, handle: ServerGoalHandle, end: str) -> None:
        """Set and log how a goal ended."""
        log = self._node.get_logger()
        if end == "canceled":
            log.info("Goal canceled")
            handle.canceled()
        elif end == "succeeded":
            log.info("Goal succeeded")
            handle.succeed()
        else:
            if end != PREEMPTED:
                log.error("Goal failed" if end == "failed" else "Deactivated: the goal is given up")
            handle.abort()

    def _feedback(self, begin: Time) -> Any:
        feedback, here, now = self.kind.Feedback(), self._context.pose(), self._node.get_clock().now()
        if here is not None:
            feedback.current_pose = stamped(here, self._frame, now.to_msg())
        feedback.navigation_time = (now - begin).to_msg()
        feedback.distance_remaining = distance = self._distance()
        speed = self._context.speed()
        if speed > 0.01 and distance > 0.1:
            feedback.estimated_time_remaining = Duration(seconds=distance / speed).to_msg()
        feedback.number_of_recoveries = int(self.board["number_recoveries"])
        return feedback

    def _distance(self) -> float:
        """The remaining length of the path [m]."""
        here, path = self._context.pose(), self.board.get(self._node.text("path_blackboard_id"))
        if here is None or path is None or not path.poses:
            return 0.0
        return length(remaining(points_of(path), here.x, here.y))


class NavigateToPoseNavigator(Navigator):
    """The action navigate_to_pose."""

    kind = NavigateToPose
    name = "navigate_to_pose"
    parameter, field, key = "default_nav_to_pose_bt_xml", "pose", "goal_blackboard_id"
    default = "navigate_to_pose_w_replanning_and_recovery.xml"


class NavigateThroughPosesNavigator(Navigator):
    """The action navigate_through_poses."""

    kind = NavigateThroughPoses
    name = "navigate_through_poses"
    parameter, field, key = "default_nav_through_poses_bt_xml", "poses", "goals_blackboard_id"
    default = "navigate_through_poses_w_replanning_and_recovery.xml"

    def _feedback(self, begin: Time) -> NavigateThroughPoses.Feedback:
        feedback: NavigateThroughPoses.Feedback = super()._feedback(begin)
        feedback.number_of_poses_remaining = len(self.board.get(self._node.text(self.key), []))
        return feedback
