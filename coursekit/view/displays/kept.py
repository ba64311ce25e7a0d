"""The base of displays that go on showing what came before: the last few messages, each where it was."""

from __future__ import annotations

from typing import ClassVar

from coursekit.nodes.rviz.config import DisplayConfig
from coursekit.view.scene import Pose, Scene
from coursekit.view.scene_shapes import Shape

from .display import StampedDisplay


class KeptDisplay(StampedDisplay):
    """Shows as many of the newest messages as the option `length` says."""

    length: ClassVar[str] = "history_length"

    def __init__(self, config: DisplayConfig, number: int) -> None:
        super().__init__(config, number)
        self._place = 0

    @property
    def newest(self) -> str:
        """The name of the thing of the newest message."""
        return f"{self._place}"

    def keep(self, scene: Scene, *shapes: Shape, pose: Pose | None = None) -> None:
        """Show these of a new message, in the place of the oldest."""
        self._place = (self._place + 1) % max(1, int(self.options[self.length]))
        scene.put(self.key, self.newest, *shapes, pose=pose)

    def move(self, pose: Pose, scene: Scene) -> None:
        """The newest to the pose of its frame; those before stay."""
        if scene.has(self.key, self.newest):
            scene.place(self.key, self.newest, pose)


__all__ = ["KeptDisplay"]
