"""Image: the newest image of a topic, beside the scene."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from coursekit.nodes.rviz.config import DisplayConfig
from coursekit.view.scene import Scene

from .display import Display

if TYPE_CHECKING:
    from coursekit.view.scene_stage import Stage


class Image(Display):
    """Shows raw and compressed topics; `picture` is in BGR order."""

    kind = "Image"

    def __init__(self, config: DisplayConfig, number: int) -> None:
        super().__init__(config, number)
        self.picture: Any = None
        self.drawn = 0
        """The number of images so far"""

    def forget(self) -> None:
        """Drop the image."""
        self.picture = None
        self.drawn += 1

    def redraw(self, scene: Scene) -> None:
        """Do nothing: the options do not affect the image."""

    def draw(self, stage: Stage, scene: Scene) -> None:
        """Take the newest image."""
        from cv_bridge import CvBridgeError

        from coursekit.nodes.images.transport import to_bgr

        for msg in self.taken()[-1:]:
            try:
                self.picture = to_bgr(msg)
            except (CvBridgeError, ValueError) as error:
                self.say("Image", "Error", str(error))
                return
            self.drawn += 1
            height, width = self.picture.shape[:2]
            self.say("Image", "Ok", f"{width}x{height} {getattr(msg, 'encoding', '') or 'compressed'}")
