"""Controllers, goal checkers and progress checkers that are C++ classes."""

from __future__ import annotations

import math
import struct
import sys
from collections.abc import Callable
from typing import Any

from geometry_msgs.msg import Pose, PoseStamped, Twist, TwistStamped
from nav_msgs.msg import Path

from coursekit.geometry.plane import Pose2D
from coursekit.nav.checkers import GoalChecker
from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.nodes.nav2.cpp_plugins import CppPlugin
from coursekit.nodes.nav2.transform_lookup import stamped
from coursekit.nodes.scanning.planar import plane, to_pose

_NO_MATTER = -sys.float_info.max
"""A tolerance of what does not matter: std::numeric_limits<double>::lowest()."""


class CppController(CppPlugin):
    """A class derived from nav2_core::Controller."""

    served, base = "path_controller", "nav2_core::Controller"
    what, created = "controller", "Created controller : {name} of type {kind}"

    def __init__(self, *given: Any) -> None:
        super().__init__(*given)
        self._lent: dict[int, int] = {}

    def follow(self, path: Path) -> None:
        """Call setPlan."""
        self.ask("follow", rest=packed(path))

    def limit(self, speed: float, percentage: bool) -> None:
        """Call setSpeedLimit."""
        self.ask("limit", rest=struct.pack("<dq", speed, percentage))

    def command(self, here: PoseStamped, velocity: Twist, checker: GoalChecker | CppGoalChecker) -> Twist:
        """Call computeVelocityCommands."""
        if id(checker) not in self._lent:
            self._lent[id(checker)] = self.share(answering(checker))
        rest = self.costs() + packed(here, velocity, self._lent[id(checker)])
        twist: Twist = self.ask("velocity", rest=rest).message(TwistStamped).twist
        return twist


class CppGoalChecker(CppPlugin):
    """A class derived from nav2_core::GoalChecker, as a GoalChecker."""

    served, base = "goal_checker", "nav2_core::GoalChecker"
    what, created = "goal checker", "Created goal checker : {name} of type {kind}"

    def change(self, what: str) -> None:
        """Do nothing: it has no such functions."""

    def reset(self) -> None:
        """Call reset."""
        self.ask("reset")

    def reached(self, here: Pose2D, goal: Pose2D, speeds: tuple[float, float] = (0.0, 0.0)) -> bool:
        """Call isGoalReached."""
        return bool(self.ask("reached", rest=packed(to_pose(here), to_pose(goal), _twist(*speeds))).integer())

    def near(self, here: Pose2D, goal: Pose2D) -> bool:
        """Whether the position is within its tolerances."""
        answer = self.ask("tolerances")
        known, tolerance = answer.integer(), answer.message(Pose).position.x
        return bool(known) and math.hypot(here.x - goal.x, here.y - goal.y) <= tolerance


class CppProgressChecker(CppPlugin):
    """A class derived from nav2_core::ProgressChecker, as a ProgressChecker."""

    served, base = "progress_checker", "nav2_core::ProgressChecker"
    what, created = "progress_checker", "Created progress_checker : {name} of type {kind}"

    def change(self, what: str) -> None:
        """Do nothing: it has no such functions."""

    def reset(self) -> None:
        """Call reset."""
        self.ask("reset")

    def gets_on(self, x: float, y: float, _now: float, yaw: float = 0.0) -> bool:
        """Call check."""
        here = stamped(Pose2D(x, y, yaw), self.costmap.frame, self.node.get_clock().now().to_msg())
        return bool(self.ask("check", rest=packed(here)).integer())


def answering(checker: GoalChecker | CppGoalChecker) -> Callable[[Unpacker], bytes]:
    """Return a function that answers the questions of a C++ controller to a goal checker."""

    def answer(frame: Unpacker) -> bytes:
        what = frame.text()
        if what == "reset":
            checker.reset()
            return b""
        if what == "reached":
            here, goal = (plane(pose.position, pose.orientation) for pose in (frame.message(Pose), frame.message(Pose)))
            twist = frame.message(Twist)
            return packed(int(checker.reached(here, goal, (twist.linear.x, twist.angular.z))))
        if isinstance(checker, CppGoalChecker):
            return checker.ask("tolerances").rest()
        return packed(1, *_tolerances(checker))

    return answer


def _tolerances(checker: GoalChecker) -> tuple[Pose, Twist]:
    pose, twist = to_pose(Pose2D(checker.xy_tolerance, checker.xy_tolerance, checker.yaw_tolerance)), Twist()
    pose.position.z = _NO_MATTER
    linear, angular = checker.still or (_NO_MATTER, _NO_MATTER)
    for vector, speed in ((twist.linear, linear), (twist.angular, angular)):
        vector.x = vector.y = vector.z = speed
    return pose, twist


def _twist(forward: float, turn: float) -> Twist:
    twist = Twist()
    twist.linear.x, twist.angular.z = forward, turn
    return twist
