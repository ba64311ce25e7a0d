"""The behaviour tree nodes that call actions, with nav2's names and ports."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from action_msgs.msg import GoalStatus
from geometry_msgs.msg import Point
from nav2_msgs.action import (
    AssistedTeleop,
    BackUp,
    ComputePathThroughPoses,
    ComputePathToPose,
    DriveOnHeading,
    FollowPath,
    NavigateThroughPoses,
    NavigateToPose,
    SmoothPath,
    Spin,
    Wait,
)
from nav2_msgs.srv import IsPathValid
from rclpy.action import ActionClient
from rclpy.duration import Duration

from coursekit.nav.behavior_tree import FAILURE, RUNNING, SUCCESS, TreeNode
from coursekit.nav.path_change import remaining, worth_it
from coursekit.nodes.nav2.tree_context import context_of
from coursekit.nodes.scanning.planar import points_of


def _time(node: TreeNode, port: str, default: float) -> Any:
    return Duration(seconds=node.number(port, default)).to_msg()


class ActionNode(TreeNode):
    """A node that calls an action: `kind`, the server's name, `goal(node)`, and `done(node, result)` for success."""

    kind: Any
    server = ""
    recovers = False
    again: Callable[[TreeNode], bool] = staticmethod(lambda node: False)

    def goal(self) -> Any:
        """The goal to send now."""
        raise NotImplementedError(self.server)

    def done(self, result: Any) -> None:
        """Store the result on the blackboard."""

    def prepare(self) -> None:
        """Create the client."""
        tree_context = context_of(self)
        self.client: ActionClient = tree_context.client(self.kind, self.ports.get("server_name") or self.server)
        self._sent: Any = None

    def step(self) -> str:
        """Send the goal, then poll for its end on each tick."""
        if self.status != RUNNING or self.again(self):
            if not self.client.server_is_ready():
                name = self.ports.get("server_name") or self.server
                context_of(self).error(f'"{name}" action server not available: is its node running and active?')
                return FAILURE
            if self.recovers and self.status != RUNNING:
                self.board["number_recoveries"] = self.board.get("number_recoveries", 0) + 1
            self._sent, self._result = self.client.send_goal_async(self.goal()), None
            return RUNNING
        if self._result is None:
            if self._sent.done():
                if not self._sent.result().accepted:
                    context_of(self).error(f'Goal was rejected by the action server "{self.server}"')
                    return FAILURE
                self._result = self._sent.result().get_result_async()
            return RUNNING
        if not self._result.done():
            return RUNNING
        answer = self._result.result()
        if answer.status != GoalStatus.STATUS_SUCCEEDED:
            return FAILURE
        self.done(answer.result)
        return SUCCESS

    def stop(self) -> None:
        """Cancel the goal as soon as it is accepted."""
        self._sent.add_done_callback(lambda sent: sent.result().accepted and sent.result().cancel_goal_async())


class PlanToPose(ActionNode):
    """ComputePathToPose. A different path that is hardly shorter replaces the driven path only if that is blocked."""

    kind: Any
    kind, server = ComputePathToPose, "compute_path_to_pose"

    def prepare(self) -> None:
        """Create the clients."""
        super().prepare()
        self._is_valid = context_of(self).service(IsPathValid, "is_path_valid")
        self._asked: Any = None
        self._aim: Any = None
        self._taken_for: Any = None

    def step(self) -> str:
        """Plan; then, if necessary, check whether the rest of the driven path is still free."""
        if self._asked is None:
            status = super().step()
            ahead = self._other_way() if status == SUCCESS else None
            if ahead is None:
                return status if status != SUCCESS else self._take()
            self._asked = self._is_valid.call_async(IsPathValid.Request(path=ahead))
        if not self._asked.done():
            return RUNNING
        answer, self._asked = self._asked.result(), None
        return SUCCESS if answer is not None and answer.is_valid else self._take()

    def stop(self) -> None:
        """Cancel the planning or the check."""
        self._asked = None
        super().stop()

    def _other_way(self) -> Any:
        """The rest of the driven path, if another way to the same goal is planned that is hardly shorter; else None."""
        old = self.get("path")
        same = old is not None and context_of(self).driven is old and self._taken_for == self._aim
        here = context_of(self).pose() if same else None
        if here is None or not self._is_valid.service_is_ready():
            return None
        ahead = remaining(points_of(old), here.x, here.y)
        if not len(ahead) or not self._new.poses or worth_it(points_of(self._new), ahead):
            return None
        return type(old)(header=old.header, poses=old.poses[-len(ahead) :])

    def _take(self) -> str:
        self._taken_for = self._aim
        self.put("path", self._new)
        return SUCCESS

    def goal(self) -> Any:
        """Plan to the pose `goal`, from `start` if it is given."""
        self._aim = self.get("goal")
        asked = ComputePathToPose.Goal(goal=self._aim, planner_id=self.get("planner_id", ""))
        if self.get("start") is not None:
            asked.start, asked.use_start = self.get("start"), True
        return asked

    def done(self, result: ComputePathToPose.Result | ComputePathThroughPoses.Result) -> None:
        """Keep the path as a candidate."""
        self._new = result.path


class PlanThroughPoses(PlanToPose):
    """ComputePathThroughPoses."""

    kind, server = ComputePathThroughPoses, "compute_path_through_poses"

    def goal(self) -> Any:
        """Plan through the poses in `goals`."""
        self._aim = self.get("goals")
        return ComputePathThroughPoses.Goal(goals=self._aim, planner_id=self.get("planner_id", ""))


class Follow(ActionNode):
    """FollowPath: a new path replaces the driven one."""

    kind, server = FollowPath, "follow_path"
    again = staticmethod(lambda node: node.get("path") is not node.path)

    def goal(self) -> Any:
        """Follow the path, and record it as the driven path."""
        self.path = context_of(self).driven = self.get("path")
        names = {name: self.get(name, "") for name in ("controller_id", "goal_checker_id")}
        return FollowPath.Goal(path=self.path, **names)

    def done(self, result: FollowPath.Result) -> None:
        """Record that no path is driven any more."""
        context_of(self).driven = None

    def stop(self) -> None:
        """Cancel the goal."""
        context_of(self).driven = None
        super().stop()


class Smooth(ActionNode):
    """SmoothPath."""

    kind, server = SmoothPath, "smooth_path"

    def goal(self) -> Any:
        """Smooth the path `unsmoothed_path`."""
        return SmoothPath.Goal(
            path=self.get("unsmoothed_path"), smoother_id=self.get("smoother_id", ""),
            max_smoothing_duration=_time(self, "max_smoothing_duration", 3.0),
            check_for_collisions=str(self.get("check_for_collisions", "")).lower() in ("true", "1"),
        )  # fmt: skip

    def done(self, result: SmoothPath.Result) -> None:
        """Store the smoothed path."""
        self.put("smoothed_path", result.path)
        self.put("was_completed", result.was_completed)


def _ordered(name: str, action: type[Any], by: str, make: Callable[[TreeNode], Any]) -> type[ActionNode]:
    """A recovery that sends one goal to an action."""
    return type(name, (ActionNode,), {"kind": action, "server": by, "recovers": True, "goal": make})


ACTIONS: dict[str, type[TreeNode]] = {
    "ComputePathToPose": PlanToPose, "ComputePathThroughPoses": PlanThroughPoses, "FollowPath": Follow, "SmoothPath": Smooth,
    "NavigateToPose": _ordered("go", NavigateToPose, "navigate_to_pose", lambda n: NavigateToPose.Goal(
        pose=n.get("goal"), behavior_tree=n.get("behavior_tree", ""))),
    "NavigateThroughPoses": _ordered("go_through", NavigateThroughPoses, "navigate_through_poses",
        lambda n: NavigateThroughPoses.Goal(poses=n.get("goals"), behavior_tree=n.get("behavior_tree", ""))),
    "Spin": _ordered("spin", Spin, "spin", lambda n: Spin.Goal(
        target_yaw=n.number("spin_dist", 1.57), time_allowance=_time(n, "time_allowance", 10.0))),
    "BackUp": _ordered("backup", BackUp, "backup", lambda n: BackUp.Goal(
        target=Point(x=n.number("backup_dist", 0.15)), speed=n.number("backup_speed", 0.025),
        time_allowance=_time(n, "time_allowance", 10.0))),
    "DriveOnHeading": _ordered("drive", DriveOnHeading, "drive_on_heading", lambda n: DriveOnHeading.Goal(
        target=Point(x=n.number("dist_to_travel", 0.15)), speed=n.number("speed", 0.025),
        time_allowance=_time(n, "time_allowance", 10.0))),
    "AssistedTeleop": _ordered("teleop", AssistedTeleop, "assisted_teleop", lambda n: AssistedTeleop.Goal(
        time_allowance=_time(n, "time_allowance", 10.0))),
    "Wait": _ordered("wait", Wait, "wait", lambda n: Wait.Goal(time=_time(n, "wait_duration", 1.0))),
}  # fmt: skip
"""The nodes by their names in XML."""
