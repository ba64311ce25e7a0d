"""Planners that are C++ classes."""

from __future__ import annotations

from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path

from coursekit.nodes.compiled.frames import packed
from coursekit.nodes.nav2.cpp_plugins import CppPlugin


class CppPlanner(CppPlugin):
    """A class derived from nav2_core::GlobalPlanner."""

    served, base = "planner", "nav2_core::GlobalPlanner"
    what, created = "global planner", "Created global planner plugin {name} of type {kind}"

    def plan(self, start: PoseStamped, goal: PoseStamped) -> Path:
        """Call createPlan."""
        path: Path = self.ask("plan", rest=self.costs() + packed(start, goal)).message(Path)
        return path
