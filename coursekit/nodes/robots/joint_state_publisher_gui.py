"""`ros2 run joint_state_publisher_gui joint_state_publisher_gui`: joint states from sliders, which a notebook shows."""

from __future__ import annotations

import random

from coursekit.nodes.robots.boards import boards
from coursekit.nodes.robots.joint_state_publisher import JointStatePublisher, run
from coursekit.processes.session import current
from coursekit.urdf.errors import close


class JointStatePublisherGui(JointStatePublisher):
    """A joint_state_publisher whose positions are set by hand.

    The sliders are drawn by `joint_sliders()` of coursekit.lab; without a notebook it publishes the zero positions.
    """

    def __init__(self, file: str | None = None) -> None:
        self.session = current()
        self.running = True
        self._chance = random.Random(0 if self.session.clock.virtual else None)
        self._entered = False
        super().__init__(file)
        self.full_name = self.get_fully_qualified_name()
        self._entered = True
        self._said: list[str] = []
        self._speak = self.create_guard_condition(self._log)
        boards.add(self)

    def changed(self) -> None:
        """Update the sliders."""
        if self._entered:
            boards.tell(self)

    def _say(self, text: str) -> None:
        """Log from the node's own thread: buttons are handled in the notebook's."""
        self._said.append(text)
        self._speak.trigger()

    def _log(self) -> None:
        while self._said:
            self.get_logger().info(self._said.pop(0))

    def move(self, name: str, position: float) -> None:
        """Set the position of a joint (rad or m), within its limits; raises LookupError if it has no slider."""
        joint = self.model.free.get(name)
        if joint is None:
            raise LookupError(f"There is no slider for joint '{name}'. {close(name, self.model.free)}")
        joint.position = min(max(float(position), joint.least), joint.greatest)
        self.changed()

    def center(self) -> None:
        """Set all joints to their zero positions."""
        self._say("Centering")
        for joint in self.model.free.values():
            joint.position = joint.zero
        self.changed()

    def randomize(self) -> None:
        """Set all joints to random positions within their limits."""
        self._say("Randomizing")
        for joint in self.model.free.values():
            joint.position = self._chance.uniform(joint.least, joint.greatest)
        self.changed()

    def destroy_node(self) -> None:
        """Destroy the node and its sliders."""
        self.running = False
        boards.remove(self)
        super().destroy_node()


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(JointStatePublisherGui, args)
