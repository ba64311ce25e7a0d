"""Navigation to a goal with a user's behaviour tree."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from geometry_msgs.msg import PoseStamped
from rclpy.logging import get_logger

from coursekit.files import installed
from coursekit.nav.behavior_tree import RUNNING, SUCCESS, Kinds, TreeError, TreeNode, read_tree
from coursekit.nav.planner import length
from coursekit.nav.second_thoughts import remaining
from coursekit.nav.tree_blackboard import SECONDS
from coursekit.nav.tree_branches import BRANCHES
from coursekit.nav.tree_controls import CONTROLS
from coursekit.nodes.compiled.classes import CppFault
from coursekit.nodes.nav2.condition_nodes import CONDITIONS
from coursekit.nodes.nav2.crew import Crew
from coursekit.nodes.nav2.running import Beat
from coursekit.nodes.nav2.tree_actions import ACTIONS
from coursekit.nodes.nav2.tree_cancels import CANCELS
from coursekit.nodes.nav2.tree_watchers import WATCHERS
from coursekit.nodes.scanning.planar import points_of

if TYPE_CHECKING:
    from coursekit.nodes.nav2.tree_log import TreeLog

KINDS: dict[str, type[TreeNode]] = {**CONTROLS, **BRANCHES, **ACTIONS, **CANCELS, **CONDITIONS, **WATCHERS}
MOST_BYTES = 2**20


def load_tree(file: str, crew: Crew, goals: list[PoseStamped], kinds: Kinds = KINDS) -> TreeNode:
    """Load the tree of a file for these goals; raises TreeError with the file, the fault and its remedy."""
    try:
        with Path(installed(file)).open("rb") as stream:
            text = stream.read(MOST_BYTES).decode()
    except (OSError, ValueError) as fault:
        reason = getattr(fault, "strerror", None) or "it is no text"
        raise TreeError(f"Couldn't open input XML file: {file} ({reason}): name a behaviour tree's .xml in full") from None
    board = {"node": crew, SECONDS: crew.seconds, "goal": goals[-1] if goals else None, "goals": goals}
    try:
        return read_tree(text, kinds, board)
    except TreeError as fault:
        raise TreeError(f"Error loading XML file: {file} {fault}") from None


class Trip:
    """Navigation to one goal with a tree: `await run()` returns 'succeeded', 'failed' or 'stopped' (when `stop()` is true).

    `tell(trip)` is called ten times a second, `goes_on()` at the end: whether a newer goal keeps the robot moving.
    """

    def __init__(
        self, tree: TreeNode, crew: Crew, stop: Callable[[], bool], goes_on: Callable[[], bool],
        tell: Callable[[Trip], None], period: float, log: TreeLog | None = None,
    ) -> None:  # fmt: skip
        self._log = log
        if log is not None:
            log.watch(tree.board)
        self._goes_on = goes_on
        self.tree, self.crew, self._stop, self._tell, self._period = tree, crew, stop, tell, period

    @property
    def goals(self) -> list[PoseStamped]:
        """The remaining goals."""
        return list(self.tree.board["goals"])

    @property
    def recoveries(self) -> int:
        """The number of recoveries."""
        return int(self.tree.board.get("number_recoveries", 0))

    @property
    def distance(self) -> float:
        """The remaining length of the path [m]."""
        here, path = self.crew.pose(), self.tree.board.get("path")
        if here is None or path is None or not path.poses:
            return 0.0
        return length(remaining(points_of(path), here.x, here.y))

    async def run(self) -> str:
        """Run the tree to its end: 'succeeded', 'failed' or 'stopped'."""
        beat, told, abandoned = Beat(self.crew.node, self._period), -math.inf, False
        try:
            while not self._stop():
                status = self.tree.tick()
                self._flush()
                if status != RUNNING:
                    return "succeeded" if status == SUCCESS else "failed"
                if self.crew.seconds() - told >= 0.1:
                    told = self.crew.seconds()
                    self._tell(self)
                await beat.next()
            return "stopped"
        except (TreeError, CppFault) as fault:
            get_logger("BehaviorTreeEngine").error(f"Behavior tree threw exception: {fault}. Exiting with failure.")
            return "failed"
        except GeneratorExit:  # collected long after its node was destroyed: there is nothing left to stop or to report to
            abandoned = True
            raise
        finally:
            if not abandoned:
                beat.stop()
                self.crew.goes_on = self._goes_on()
                self.tree.halt()
                self._flush()
                self.tree.retire()

    def _flush(self) -> None:
        if self._log is not None:
            self._log.flush()
