"""Work on a goal that was left in the middle: its session has ended, and it is collected whenever Python likes."""

from collections.abc import Iterator
from typing import Any

import pytest
import rclpy
from rclpy.node import Node

from coursekit.nav.behavior_tree import RUNNING, TreeNode
from coursekit.nodes.nav2.tree_context import TreeContext
from coursekit.nodes.nav2.tree_run import PREEMPTED, TreeRun
from coursekit.processes.session import Session


class Endless(TreeNode):
    """Never done; tells when it is halted."""

    halted = False

    def step(self) -> str:
        """Goes on."""
        return RUNNING

    def halt(self) -> None:
        """Tell it."""
        self.halted = True


@pytest.fixture
def tree() -> Iterator[Endless]:
    """A tree to go by, in a session that has begun."""
    with Session(virtual=True).use():
        rclpy.init()
        yield Endless("Endless", {}, [], {})
        rclpy.try_shutdown()


def going(tree: Endless, end: str) -> Any:
    """The work on a goal, before its first tick."""
    tree_context = TreeContext(Node("navigator"), lambda: None, lambda pose: None, lambda target, source: False)  # type: ignore[arg-type, return-value]
    return TreeRun(tree, tree_context, lambda: end, lambda: None, 0.1).run()


def test_an_abandoned_run_touches_nothing_when_it_is_collected(tree: Endless) -> None:
    run = going(tree, "")
    run.send(None)
    rclpy.shutdown()
    run.close()
    assert not tree.halted


@pytest.mark.parametrize(("end", "halted"), [("canceled", True), (PREEMPTED, False)])
def test_a_tree_is_halted_unless_it_goes_on_with_another_goal(tree: Endless, end: str, halted: bool) -> None:
    with pytest.raises(StopIteration) as returned:
        going(tree, end).send(None)
    assert returned.value.value == end and tree.halted == halted
