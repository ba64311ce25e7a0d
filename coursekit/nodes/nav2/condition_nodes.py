"""Behaviour tree nodes that check the clock, the robot and its goals, with nav2's names and ports."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from coursekit.nav.behavior_tree import FAILURE, IDLE, RUNNING, SUCCESS, TreeNode
from coursekit.nav.tree_blackboard import SECONDS
from coursekit.nodes.nav2.crew import crew_of

if TYPE_CHECKING:
    from geometry_msgs.msg import PoseStamped


class Paced(TreeNode):
    """RateController: ticks its child `hz` times a second, and whenever the child is running."""

    arity = (1, 1)
    begun = -math.inf

    def step(self) -> str:
        """Tick the child when it is due."""
        now, child = self.board[SECONDS](), self.children[0]
        if self.status == IDLE:
            self.begun = -math.inf
        if child.status != RUNNING and not self.due(now):
            return RUNNING
        status = child.tick()
        if status == SUCCESS:
            self.began(now)
        return status

    def due(self, now: float) -> bool:
        """Whether the child is due."""
        return now - self.begun >= 1.0 / max(self.number("hz", 10.0), 1e-3)

    def began(self, now: float) -> None:
        """Start the interval now."""
        self.begun = now


class PacedBySpeed(Paced):
    """SpeedController, always at its maximum rate."""

    def due(self, now: float) -> bool:
        """Whether the child is due."""
        return now - self.begun >= 1.0 / max(self.number("max_rate", 1.0), 1e-3)


class PacedByWay(Paced):
    """DistanceController: ticks its child each time the robot has travelled `distance` [m]."""

    place: Any = None

    def due(self, now: float) -> bool:
        """Whether the robot has travelled that far."""
        here = crew_of(self).pose()
        return self.begun == -math.inf or here is None or here.distance(self.place) >= self.number("distance", 1.0)

    def began(self, now: float) -> None:
        """Measure from here."""
        self.begun, self.place = now, crew_of(self).pose()


class TakeGoal(TreeNode):
    """GoalUpdater: replaces the goal with the latest pose on the topic `goal_update`, if there is one."""

    arity = (1, 1)

    def prepare(self) -> None:
        """Subscribe."""
        self.heard = crew_of(self).listen("goal_update")

    def step(self) -> str:
        """Pass the goal on."""
        self.put("output_goal", self.heard[-1] if self.heard else self.get("input_goal"))
        return self.children[0].tick()


class ConditionNode(TreeNode):
    """A condition that is evaluated immediately: `answer(node)`."""

    answer: Callable[[TreeNode], bool] = staticmethod(lambda node: False)

    def step(self) -> str:
        """Evaluate the condition."""
        return SUCCESS if self.answer(self) else FAILURE


def _condition(name: str, answer: Callable[[TreeNode], bool]) -> type[ConditionNode]:
    return type(name, (ConditionNode,), {"answer": staticmethod(answer)})


def _near(node: TreeNode) -> bool:
    return bool(crew_of(node).gap(node.get("goal")) <= 0.25)


def _drop_passed(node: TreeNode) -> bool:
    """RemovePassedGoals: removes goals, except the last, that are within `radius` [m]."""
    goals = list(node.get("input_goals"))
    while len(goals) > 1 and crew_of(node).gap(goals[0]) < node.number("radius", 0.5):
        goals.pop(0)
    node.put("output_goals", goals)
    return True


def _place(pose: PoseStamped) -> tuple[float, float]:
    return pose.pose.position.x, pose.pose.position.y


def _truncate(node: TreeNode) -> bool:
    """TruncatePath: removes the last `distance` metres."""
    path, left = node.get("input_path"), node.number("distance", 1.0)
    poses = list(path.poses)
    end = _place(poses[-1]) if poses else (0.0, 0.0)
    while len(poses) > 1 and math.dist(_place(poses[-1]), end) < left:
        poses.pop()
    node.put("output_path", type(path)(header=path.header, poses=poses))
    return True


def _truncate_to_surroundings(node: TreeNode) -> bool:
    """TruncatePathLocal: keeps `distance_backward` and `distance_forward` metres of the path around the robot."""
    path, here = node.get("input_path"), crew_of(node).pose()
    if here is None:
        return False
    places = [_place(pose) for pose in path.poses]
    nearest = min(range(len(places)), key=lambda k: math.dist(places[k], (here.x, here.y)), default=0)
    begin, end, back, ahead = nearest, nearest, node.number("distance_backward", 4.0), node.number("distance_forward", 8.0)
    while begin > 0 and (back := back - math.dist(places[begin], places[begin - 1])) >= 0:
        begin -= 1
    while end + 1 < len(places) and (ahead := ahead - math.dist(places[end], places[end + 1])) >= 0:
        end += 1
    node.put("output_path", type(path)(header=path.header, poses=path.poses[begin : end + 1]))
    return True


def _expired(node: TreeNode) -> bool:
    now = crew_of(node).seconds()
    begun = node.__dict__.setdefault("begun", now)
    if now - begun >= node.number("seconds", 1.0):
        node.__dict__["begun"] = now
        return True
    return False


def _travelled(node: TreeNode) -> bool:
    here = crew_of(node).pose()
    begun = node.__dict__.setdefault("begun", here)
    if here is not None and begun is not None and here.distance(begun) >= node.number("distance", 1.0):
        node.__dict__["begun"] = here
        return True
    return False


def _chooses(what: str) -> type[ConditionNode]:
    """Return a selector: it outputs the latest name on its topic, or the default one."""

    def answer(node: TreeNode) -> bool:
        heard = crew_of(node).listen_to_text(node.get("topic_name", f"{what}_selector"))
        node.put(f"selected_{what}", heard[-1] if heard else node.get(f"default_{what}", ""))
        return True

    return _condition(f"{what}_selector", answer)


CONDITIONS: dict[str, type[TreeNode]] = {
    "RateController": Paced, "DistanceController": PacedByWay, "SpeedController": PacedBySpeed, "GoalUpdater": TakeGoal,
    "GoalReached": _condition("GoalReached", _near), "TimeExpired": _condition("TimeExpired", _expired),
    "DistanceTraveled": _condition("DistanceTraveled", _travelled),
    "GoalUpdated": ConditionNode, "IsStuck": ConditionNode,
    "InitialPoseReceived": _condition("InitialPoseReceived", lambda node: crew_of(node).pose() is not None),
    "RemovePassedGoals": _condition("RemovePassedGoals", _drop_passed),
    "TruncatePath": _condition("TruncatePath", _truncate),
    "TruncatePathLocal": _condition("TruncatePathLocal", _truncate_to_surroundings),
    "TransformAvailable": _condition("TransformAvailable", lambda node: crew_of(node).knows(
        node.get("child", ""), node.get("parent", ""))),
    **{f"{name}Selector": _chooses(what) for name, what in (
        ("Planner", "planner"), ("Controller", "controller"), ("Smoother", "smoother"), ("GoalChecker", "goal_checker"))},
}  # fmt: skip
"""Node types by XML name. A new goal restarts the tree, so GoalUpdated never succeeds."""
