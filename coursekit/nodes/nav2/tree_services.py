"""The behaviour tree nodes that call services, with nav2's names and ports."""

from __future__ import annotations

from typing import Any

from nav2_msgs.srv import ClearCostmapAroundRobot, ClearCostmapExceptRegion, ClearEntireCostmap, IsPathValid
from std_srvs.srv import Empty

from coursekit.nav.behavior_tree import FAILURE, RUNNING, SUCCESS, TreeNode
from coursekit.nodes.nav2.tree_context import context_of


class CallNode(TreeNode):
    """A node that calls a service: `kind` and `request(node)`. It succeeds if `answered` accepts the response."""

    kind: Any
    server = ""

    def prepare(self) -> None:
        """Create the client."""
        self.client = context_of(self).service(self.kind, self.ports.get("service_name") or self.server)
        self._sent: Any = None

    def request(self) -> Any:
        """The request to send."""
        return self.kind.Request()

    def answered(self, answer: Any) -> bool:
        """Whether the response means success."""
        return True

    def step(self) -> str:
        """Call the service, then poll for the response on each tick."""
        if self.status != RUNNING:
            if not self.client.service_is_ready():
                return FAILURE
            self._sent = self.client.call_async(self.request())
        if not self._sent.done():
            return RUNNING
        return SUCCESS if self.answered(self._sent.result()) else FAILURE


class ClearAll(CallNode):
    """ClearEntireCostmap."""

    kind, server = ClearEntireCostmap, "local_costmap/clear_entirely_local_costmap"


class ClearAround(CallNode):
    """ClearCostmapAroundRobot."""

    kind: Any
    kind, server = ClearCostmapAroundRobot, "local_costmap/clear_around_local_costmap"

    def request(self) -> Any:
        """The distance from the robot, `reset_distance` [m]."""
        return self.kind.Request(reset_distance=self.number("reset_distance", 1.0))


class ClearExcept(ClearAround):
    """ClearCostmapExceptRegion."""

    kind, server = ClearCostmapExceptRegion, "local_costmap/clear_except_local_costmap"


class PathIsValid(CallNode):
    """IsPathValid."""

    kind, server = IsPathValid, "is_path_valid"

    def request(self) -> Any:
        """Check the current path."""
        return IsPathValid.Request(path=self.get("path"))

    def answered(self, answer: IsPathValid.Response) -> bool:
        """Whether the path is free."""
        return bool(answer.is_valid)


class LocaliseAnew(CallNode):
    """ReinitializeGlobalLocalization."""

    kind, server = Empty, "reinitialize_global_localization"


SERVICES: dict[str, type[TreeNode]] = {
    "ClearEntireCostmap": ClearAll, "ClearCostmapAroundRobot": ClearAround, "ClearCostmapExceptRegion": ClearExcept,
    "IsPathValid": PathIsValid, "ReinitializeGlobalLocalization": LocaliseAnew,
}  # fmt: skip
"""The nodes by their names in XML."""
