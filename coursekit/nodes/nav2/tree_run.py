"""The work on a goal with a user's behaviour tree."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from rclpy.logging import get_logger

from coursekit.files import installed
from coursekit.nav.behavior_tree import RUNNING, SUCCESS, Kinds, TreeError, TreeNode, read_tree
from coursekit.nav.tree_blackboard import SECONDS, Board
from coursekit.nav.tree_branches import BRANCHES
from coursekit.nav.tree_controls import CONTROLS
from coursekit.nodes.compiled.classes import CppFault
from coursekit.nodes.nav2.condition_nodes import CONDITIONS
from coursekit.nodes.nav2.running import AsyncRate
from coursekit.nodes.nav2.tree_actions import ACTIONS
from coursekit.nodes.nav2.tree_cancels import CANCELS
from coursekit.nodes.nav2.tree_context import TreeContext
from coursekit.nodes.nav2.tree_services import SERVICES
from coursekit.nodes.nav2.tree_watchers import WATCHERS

if TYPE_CHECKING:
    from coursekit.nodes.nav2.tree_log import TreeLog

KINDS: dict[str, type[TreeNode]] = {**CONTROLS, **BRANCHES, **ACTIONS, **SERVICES, **CANCELS, **CONDITIONS, **WATCHERS}
MOST_BYTES = 2**20


def text_of(file: str) -> str:
    """Return the text of a tree's file; raises TreeError with the file, the fault and its remedy."""
    try:
        with Path(installed(file)).open("rb") as stream:
            return stream.read(MOST_BYTES).decode()
    except (OSError, ValueError) as fault:
        reason = getattr(fault, "strerror", None) or "it is no text"
        raise TreeError(f"Couldn't open input XML file: {file} ({reason}): name a behaviour tree's .xml in full") from None


def board_of(context: TreeContext) -> Board:
    """Return a blackboard with what nav2 puts there before the first goal."""
    return {"node": context, SECONDS: context.seconds, "number_recoveries": 0}


def load_tree(file: str, text: str, board: Board, kinds: Kinds = KINDS) -> TreeNode:
    """Read a tree from the text of a file; raises TreeError with the file and the fault."""
    try:
        return read_tree(text, kinds, board)
    except TreeError as fault:
        raise TreeError(f"Error loading XML file: {file} {fault}") from None


PREEMPTED = "preempted"
"""How the work on a goal ends whose tree goes on with another one."""


class TreeRun:
    """Work on one goal with a tree: `await run()` returns 'succeeded', 'failed', or what `ended()` said.

    `ended()` is asked before each tick: '' to go on, PREEMPTED to leave the tree as it is, another word to halt it.
    `tell()` is called ten times a second.
    """

    def __init__(
        self, tree: TreeNode, context: TreeContext, ended: Callable[[], str], tell: Callable[[], None], period: float,
        log: TreeLog | None = None,
    ) -> None:  # fmt: skip
        self.tree, self.context, self._ended, self._tell, self._period, self._log = tree, context, ended, tell, period, log
        if log is not None:
            log.watch(tree.board)

    async def run(self) -> str:
        """Tick the tree until it ends or is to end."""
        rate, end, abandoned = AsyncRate(self.context.node, self._period), "failed", False
        try:
            end = await self._ticked(rate)
        except (TreeError, CppFault) as fault:
            get_logger("BehaviorTreeEngine").error(f"Behavior tree threw exception: {fault}. Exiting with failure.")
        except GeneratorExit:  # collected long after its node was destroyed: there is nothing left to stop
            abandoned = True
            raise
        finally:
            if not abandoned:
                rate.destroy()
                self._end(end)
        return end

    async def _ticked(self, rate: AsyncRate) -> str:
        """Tick the tree. Returns how it ended."""
        told = -math.inf
        while not (end := self._ended()):
            status = self._tick()
            if status != RUNNING:
                return "succeeded" if status == SUCCESS else "failed"
            if self.context.seconds() - told >= 0.1:
                told = self.context.seconds()
                self._tell()
            await rate.sleep()
        return end

    def _tick(self) -> str:
        status = self.tree.tick()
        self._flush()
        return status

    def _end(self, end: str) -> None:
        if end != PREEMPTED:
            self.tree.halt()
            self._flush()

    def _flush(self) -> None:
        if self._log is not None:
            self._log.flush()
