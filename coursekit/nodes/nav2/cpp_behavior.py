"""Behaviours and tasks at waypoints that are C++ classes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from geometry_msgs.msg import PoseStamped

from coursekit.nodes.compiled.frames import packed
from coursekit.nodes.nav2.cpp_plugins import CppListeningPlugin, CppPlugin


class CppBehavior(CppListeningPlugin):
    """A class derived from nav2_core::Behavior, which serves its own action."""

    served, base = "behavior", "nav2_core::Behavior"
    what, created = "behavior {name} of type {kind}", "Creating behavior plugin {name} of type {kind}"


class CppTask(CppPlugin):
    """A class derived from nav2_core::WaypointTaskExecutor, as a Task."""

    served, base = "waypoint_task", "nav2_core::WaypointTaskExecutor"
    what, created = "waypoint_task_executor", "Created waypoint_task_executor : {name} of type {kind}"
    subscription: Any = None

    def configure(self) -> None:
        """Lend it the server's node."""
        self.ask("configure", self.name, self.share(self.node), 0)

    def change(self, what: str) -> None:
        """Do nothing: it has no such functions."""

    async def process(self, pose: PoseStamped, number: int, stop: Callable[[], bool]) -> bool:
        """Call processAtWaypoint."""
        return bool(self.ask("process", rest=packed(pose, number)).integer())
