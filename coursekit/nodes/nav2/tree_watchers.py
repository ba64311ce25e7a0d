"""Behaviour tree nodes that watch the path, the goal and the battery, with nav2's names and ports."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from nav_msgs.msg import Odometry
from rclpy.qos import qos_profile_system_default
from rclpy.time import Time
from sensor_msgs.msg import BatteryState

from coursekit.nav.behavior_tree import FAILURE, IDLE, RUNNING, SUCCESS, TreeNode
from coursekit.nodes.nav2.condition_nodes import goals_on
from coursekit.nodes.nav2.tree_context import context_of

if TYPE_CHECKING:
    from nav_msgs.msg import Path


def length(path: Path) -> float:
    """Return the length of a path message [m].

    >>> from builtin_interfaces.msg import Time
    >>> import numpy as np
    >>> from coursekit.nodes.nav2.transform_lookup import path_message
    >>> length(path_message(np.array([[0.0, 0.0, 0.0], [3.0, 4.0, 0.0]]), "map", Time()))
    5.0
    """
    points = [(pose.pose.position.x, pose.pose.position.y) for pose in path.poses]
    return sum(math.dist(first, second) for first, second in pairwise(points))


class PathExpiringTimer(TreeNode):
    """Succeeds each time the path has been the same for `seconds`."""

    begun: float | None = None
    path: Any = None

    def step(self) -> str:
        """Start anew with a new path, and after a success."""
        now, path = context_of(self).seconds(), self.get("path")
        if self.begun is None or path != self.path:
            self.begun, self.path = now, path
            return FAILURE
        if now - self.begun < self.number("seconds", 1.0):
            return FAILURE
        self.begun = now
        return SUCCESS


class GoalWatcher(TreeNode):
    """Compares the goal with the one of its last tick."""

    goals: Any = None

    def is_new(self) -> bool:
        """Whether the goal is another one; at the very first tick it is."""
        before, self.goals = self.goals, goals_on(self.board)
        return bool(before != self.goals)


class GoalUpdated(GoalWatcher):
    """Succeeds when the goal is not the one of the last tick; never at its first one."""

    def step(self) -> str:
        """Compare the goals."""
        return SUCCESS if self.is_new() and self.status != IDLE else FAILURE


class GlobalUpdatedGoal(GoalWatcher):
    """Succeeds at its first tick, and when the goal is not the one of the last tick, of an earlier goal's as well."""

    def step(self) -> str:
        """Compare the goals."""
        return SUCCESS if self.is_new() else FAILURE


class GoalUpdatedController(GoalWatcher):
    """Ticks its child at first, for each new goal, and while it is running."""

    arity = (1, 1)

    def step(self) -> str:
        """Tick the child if there is a reason to."""
        if self.is_new() or self.status == IDLE or self.children[0].status == RUNNING:
            return self.children[0].tick()
        return RUNNING


class IsStuck(TreeNode):
    """Succeeds while the last two messages of odometry say that the robot brakes harder than a robot can [m/s^2]."""

    hardest = -10.0

    def prepare(self) -> None:
        """Listen."""
        self._heard = context_of(self).listen("odom", Odometry, most=3)

    def step(self) -> str:
        """Compare them; the first two messages say nothing yet, as in nav2."""
        if len(self._heard) < 3:
            return FAILURE
        before, now = self._heard[-2], self._heard[-1]
        seconds = (Time.from_msg(now.header.stamp) - Time.from_msg(before.header.stamp)).nanoseconds * 1e-9
        change = now.twist.twist.linear.x - before.twist.twist.linear.x
        return SUCCESS if seconds > 0 and change / seconds < self.hardest else FAILURE


class PathLongerOnApproach(TreeNode):
    """Near the goal its child is ticked if the new path is much longer than the one before.

    Near is within `prox_len` [m], and longer is `length_factor` times as long.
    """

    arity = (1, 1)
    path: Any = None

    def step(self) -> str:
        """Tick the child, or succeed."""
        new = self.get("path")
        if self._is_detour(new):
            status = self.children[0].tick()
            if status == RUNNING:
                return status
        else:
            status = SUCCESS
        self.path = new
        return status

    def _is_detour(self, new: Path) -> bool:
        if self.path is None or new == self.path or not self.path.poses:
            return False
        before = length(self.path)
        return before < self.number("prox_len", 3.0) and length(new) > before * self.number("length_factor", 2.0)


class IsBatteryLow(TreeNode):
    """Whether its percentage (0 to 1), or with `is_voltage` its voltage, is at most `min_battery`."""

    def prepare(self) -> None:
        """Listen."""
        topic = self.ports.get("battery_topic", "/battery_status")
        self._heard = context_of(self).listen(topic, BatteryState, qos_profile_system_default)

    def step(self) -> str:
        """Compare the latest message; without one the battery is not low."""
        if not self._heard:
            return FAILURE
        by_voltage = str(self.get("is_voltage", "false")).lower() in ("true", "1")
        state = self._heard[-1].voltage if by_voltage else self._heard[-1].percentage
        return SUCCESS if state <= self.number("min_battery", 0.0) else FAILURE


_NODES = (
    PathExpiringTimer, PathLongerOnApproach, IsBatteryLow, GoalUpdated, GlobalUpdatedGoal, GoalUpdatedController, IsStuck,
)  # fmt: skip
WATCHERS: dict[str, type[TreeNode]] = {node.__name__: node for node in _NODES}
"""The nodes by their XML names."""
