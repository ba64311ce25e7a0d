"""The base of displays that keep earlier messages: the last few, each at its own pose."""

from __future__ import annotations

from typing import ClassVar

from coursekit.nodes.rviz.config import DisplayConfig
from coursekit.view.scene import Pose, Scene
from coursekit.view.scene_shapes import Shape

from .display import StampedDisplay


class KeptDisplay(StampedDisplay):
    """Shows the newest messages; the option named by `length` sets how many."""

    length: ClassVar[str] = "history_length"

    def __init__(self, config: DisplayConfig, number: int) -> None:
        super().__init__(config, number)
        self._place = 0

    @property
    def newest(self) -> str:
        """The name of the newest message's thing."""
        return f"{self._place}"

    def keep(self, scene: Scene, *shapes: Shape, pose: Pose | None = None) -> None:
        """Show the shapes of a new message, in place of the oldest ones."""
        self._place = (self._place + 1) % max(1, int(self.options[self.length]))
        scene.put(self.key, self.newest, *shapes, pose=pose)

    def move(self, pose: Pose, scene: Scene) -> None:
        """Move the newest message to the pose of its frame; earlier ones stay."""
        if scene.has(self.key, self.newest):
            scene.place(self.key, self.newest, pose)


__all__ = ["KeptDisplay"]
