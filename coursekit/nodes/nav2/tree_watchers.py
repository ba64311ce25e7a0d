"""Behaviour tree nodes that watch the path, the goal and the battery, with nav2's names and ports."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from rclpy.qos import qos_profile_system_default
from sensor_msgs.msg import BatteryState

from coursekit.nav.behavior_tree import FAILURE, IDLE, RUNNING, SUCCESS, TreeNode
from coursekit.nodes.nav2.crew import crew_of

if TYPE_CHECKING:
    from nav_msgs.msg import Path


def length(path: Path) -> float:
    """Return the length of a path message [m].

    >>> from builtin_interfaces.msg import Time
    >>> import numpy as np
    >>> from coursekit.nodes.nav2.whereabouts import path_message
    >>> length(path_message(np.array([[0.0, 0.0, 0.0], [3.0, 4.0, 0.0]]), "map", Time()))
    5.0
    """
    points = [(pose.pose.position.x, pose.pose.position.y) for pose in path.poses]
    return sum(math.dist(first, second) for first, second in pairwise(points))


class PathAge(TreeNode):
    """PathExpiringTimer: succeeds each time the path has been the same for `seconds`."""

    begun: float | None = None
    path: Any = None

    def step(self) -> str:
        """Start anew with a new path, and after a success."""
        now, path = crew_of(self).seconds(), self.get("path")
        if self.begun is None or path != self.path:
            self.begun, self.path = now, path
            return FAILURE
        if now - self.begun < self.number("seconds", 1.0):
            return FAILURE
        self.begun = now
        return SUCCESS


class NewGoal(TreeNode):
    """GlobalUpdatedGoal: succeeds once for each goal, which starts the tree anew."""

    told = False

    def step(self) -> str:
        """Tell it at the first tick."""
        status, self.told = FAILURE if self.told else SUCCESS, True
        return status


class OncePerGoal(TreeNode):
    """GoalUpdatedController: ticks its child for each new goal, which starts the tree anew, and while it is running."""

    arity = (1, 1)

    def step(self) -> str:
        """Tick the child at first, and until it ends."""
        if self.status == IDLE or self.children[0].status == RUNNING:
            return self.children[0].tick()
        return RUNNING


class Detour(TreeNode):
    """PathLongerOnApproach: near the goal its child is ticked if the new path is much longer than the one before.

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


class LowBattery(TreeNode):
    """IsBatteryLow: whether its percentage (0 to 1), or with `is_voltage` its voltage, is at most `min_battery`."""

    def prepare(self) -> None:
        """Listen."""
        topic = self.ports.get("battery_topic", "/battery_status")
        self._heard = crew_of(self).listen(topic, BatteryState, qos_profile_system_default)

    def step(self) -> str:
        """Compare the latest message; without one the battery is not low."""
        if not self._heard:
            return FAILURE
        by_voltage = str(self.get("is_voltage", "false")).lower() in ("true", "1")
        state = self._heard[-1].voltage if by_voltage else self._heard[-1].percentage
        return SUCCESS if state <= self.number("min_battery", 0.0) else FAILURE


WATCHERS: dict[str, type[TreeNode]] = {
    "PathExpiringTimer": PathAge, "GlobalUpdatedGoal": NewGoal, "GoalUpdatedController": OncePerGoal,
    "PathLongerOnApproach": Detour, "IsBatteryLow": LowBattery,
}  # fmt: skip
"""The nodes by their XML names."""
