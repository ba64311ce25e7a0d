"""Behaviour tree nodes that check the clock, the robot and its goals, with nav2's names and ports."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rclpy.time import Time

from coursekit.nav.behavior_tree import FAILURE, IDLE, RUNNING, SUCCESS, TreeError, TreeNode
from coursekit.nav.tree_blackboard import SECONDS, Board
from coursekit.nodes.nav2.tree_context import context_of

if TYPE_CHECKING:
    from geometry_msgs.msg import PoseStamped


class RateController(TreeNode):
    """Ticks its child at first, `hz` times a second from then on, and whenever the child is running."""

    arity = (1, 1)
    begun = 0.0
    first = True

    def step(self) -> str:
        """Tick the child when it is due."""
        if self.status == IDLE:
            self.first = True
            self.begin()
        if not self.is_turn():
            return RUNNING
        status = self.children[0].tick()
        if status == SUCCESS:
            self.begin()
        return status

    def is_turn(self) -> bool:
        """Whether to tick the child now."""
        first, self.first = self.first, False
        return first or self.children[0].status == RUNNING or self.due()

    def due(self) -> bool:
        """Whether the child is due."""
        return self.seconds() >= 1.0 / max(self.number("hz", 10.0), 1e-3)

    def begin(self) -> None:
        """Start the interval now."""
        self.begun = self.board[SECONDS]()

    def seconds(self) -> float:
        """The time since the interval began [s]."""
        return float(self.board[SECONDS]() - self.begun)


class DistanceController(RateController):
    """Ticks its child at first, and each time the robot has travelled `distance` [m]."""

    place: Any = None

    def step(self) -> str:
        """Tick the child when it is due; fail while the robot's pose is not known."""
        return FAILURE if context_of(self).pose() is None else super().step()

    def due(self) -> bool:
        """Whether the robot has travelled that far."""
        here = context_of(self).pose()
        return here is not None and here.distance(self.place) >= self.number("distance", 1.0)

    def begin(self) -> None:
        """Measure from here."""
        self.place = context_of(self).pose()


class SpeedController(RateController):
    """Ticks its child between `min_rate` and `max_rate` times a second: the faster the robot drives, the more often.

    A new goal is told to the child at once.
    """

    period = 1.0
    goals: Any = None

    def prepare(self) -> None:
        """Check the rates; TreeError when one is not positive."""
        if min(self.number("min_rate", 0.1), self.number("max_rate", 1.0)) <= 0.0:
            raise TreeError("SpeedController node cannot have rate <= 0.0")

    def step(self) -> str:
        """Tick the child when it is due; the period is renewed when it has passed."""
        goals = goals_on(self.board)
        if self.status == IDLE or goals != self.goals:
            self.goals, self.first, self.period = goals, True, 1.0 / self.number("max_rate", 1.0)
            self.begin()
        if not self.is_turn():
            return RUNNING
        if self.due():
            self.period = 1.0 / self._rate()
            self.begin()
        return self.children[0].tick()

    def due(self) -> bool:
        """Whether the period has passed."""
        return self.seconds() >= self.period

    def _rate(self) -> float:
        slow, fast = self.number("min_rate", 0.1), self.number("max_rate", 1.0)
        low, high = self.number("min_speed", 0.0), self.number("max_speed", 0.5)
        part = (context_of(self).speed() - low) / (high - low) if high != low else math.inf
        return max(min(slow + part * (fast - slow), fast), slow)


def goals_on(board: Board) -> tuple[Any, Any]:
    """Return the goal and the goals on a blackboard, to see whether they are still the same."""
    return board.get("goal"), board.get("goals")


class GoalUpdater(TreeNode):
    """Replaces the goal with the latest pose on the topic `goal_update`, if its time stamp is newer."""

    arity = (1, 1)

    def prepare(self) -> None:
        """Subscribe."""
        self.heard = context_of(self).listen("goal_update")

    def step(self) -> str:
        """Pass the goal on."""
        goal = self.get("input_goal")
        if self.heard and _stamp(self.heard[-1]) > _stamp(goal):
            goal = self.heard[-1]
        self.put("output_goal", goal)
        return self.children[0].tick()


def _stamp(pose: PoseStamped | None) -> int:
    return 0 if pose is None else Time.from_msg(pose.header.stamp).nanoseconds


class TimeExpired(TreeNode):
    """Succeeds each time `seconds` have passed since it began, or since it succeeded."""

    begun = 0.0

    def step(self) -> str:
        """Look at the clock."""
        now = context_of(self).seconds()
        if self.status == IDLE:
            self.begun = now
        if self.status == IDLE or now - self.begun < self.number("seconds", 1.0):
            return FAILURE
        self.begun = now
        return SUCCESS


class DistanceTraveled(TreeNode):
    """Succeeds each time the robot has travelled `distance` [m] since it began, or since it succeeded."""

    begun: Any = None

    def step(self) -> str:
        """Look where the robot is."""
        here = context_of(self).pose()
        if self.status == IDLE or self.begun is None:
            self.begun = here
            return FAILURE
        if here is None or here.distance(self.begun) < self.number("distance", 1.0):
            return FAILURE
        self.begun = here
        return SUCCESS


class ConditionNode(TreeNode):
    """A condition that is evaluated immediately: `answer(node)`."""

    answer: Callable[[TreeNode], bool] = staticmethod(lambda node: False)

    def step(self) -> str:
        """Evaluate the condition."""
        return SUCCESS if self.answer(self) else FAILURE


def _condition(name: str, answer: Callable[[TreeNode], bool]) -> type[ConditionNode]:
    return type(name, (ConditionNode,), {"answer": staticmethod(answer)})


def _near(node: TreeNode) -> bool:
    return bool(context_of(node).gap(node.get("goal")) <= 0.25)


def _drop_passed(node: TreeNode) -> bool:
    """RemovePassedGoals: removes goals, except the last, that are within `radius` [m]."""
    goals = list(node.get("input_goals"))
    while len(goals) > 1 and context_of(node).gap(goals[0]) < node.number("radius", 0.5):
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
    path, here = node.get("input_path"), context_of(node).pose()
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


def _chooses(what: str) -> type[ConditionNode]:
    """Return a selector: it outputs the latest name on its topic, or the default one."""

    def answer(node: TreeNode) -> bool:
        heard = context_of(node).listen_to_text(node.get("topic_name", f"{what}_selector"))
        node.put(f"selected_{what}", heard[-1] if heard else node.get(f"default_{what}", ""))
        return True

    return _condition(f"{what}_selector", answer)


CONDITIONS: dict[str, type[TreeNode]] = {
    **{node.__name__: node for node in (
        RateController, DistanceController, SpeedController, GoalUpdater, TimeExpired, DistanceTraveled)},
    "GoalReached": _condition("GoalReached", _near),
    "InitialPoseReceived": _condition("InitialPoseReceived", lambda node: context_of(node).pose() is not None),
    "RemovePassedGoals": _condition("RemovePassedGoals", _drop_passed),
    "TruncatePath": _condition("TruncatePath", _truncate),
    "TruncatePathLocal": _condition("TruncatePathLocal", _truncate_to_surroundings),
    "TransformAvailable": _condition("TransformAvailable", lambda node: context_of(node).knows(
        node.get("child", ""), node.get("parent", ""))),
    **{f"{name}Selector": _chooses(what) for name, what in (
        ("Planner", "planner"), ("Controller", "controller"), ("Smoother", "smoother"), ("GoalChecker", "goal_checker"))},
}  # fmt: skip
"""Node types by XML name."""
