"""A trip that was left in the middle: its session has ended, and it is collected whenever Python likes."""

import rclpy
from rclpy.node import Node

from coursekit.nav.behavior_tree import RUNNING, TreeNode
from coursekit.nodes.nav2.trip import Crew, Trip
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


def test_an_abandoned_trip_touches_nothing_when_it_is_collected() -> None:
    with Session(virtual=True).use():
        rclpy.init()
        node, tree = Node("navigator"), Endless("Endless", {}, [], {})
        crew = Crew(node, lambda: None, lambda pose: None)  # type: ignore[arg-type, return-value]
        going = Trip(tree, crew, lambda: False, lambda: True, lambda trip: None, 0.1).run()
        going.send(None)
        rclpy.shutdown()
    going.close()
    assert not tree.halted and not crew.goes_on


def test_a_trip_that_ends_halts_its_tree() -> None:
    with Session(virtual=True).use():
        rclpy.init()
        node, tree = Node("navigator"), Endless("Endless", {}, [], {})
        crew = Crew(node, lambda: None, lambda pose: None)  # type: ignore[arg-type, return-value]
        going = Trip(tree, crew, lambda: True, lambda: True, lambda trip: None, 0.1).run()
        try:
            going.send(None)
        except StopIteration as end:
            assert end.value == "stopped"
        assert tree.halted and crew.goes_on
        rclpy.shutdown()
