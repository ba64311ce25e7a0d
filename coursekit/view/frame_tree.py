"""The tree of frames as a picture and as text, with its faults."""

from __future__ import annotations

from typing import Any

from . import frame_text
from .drawing import Drawing
from .drawing_png import pdf
from .drawn import Drawn
from .frame_facts import FrameFacts, take
from .frame_picture import draw


class FrameTree(Drawn):
    """The frames of a buffer as they were at one moment.

    `details` adds broadcaster and times to each frame, as view_frames does.

    >>> from coursekit.tf import FrameBuffer
    >>> buffer = FrameBuffer()
    >>> _ = buffer.set_static("base_link", "laser", (0.1, 0.0, 0.2, 0.0, 0.0, 0.0, 1.0))
    >>> print(FrameTree(buffer).text())
    frames: 2 frames, 1 tree
    base_link
    `-- laser  static

    In ROS 2: `ros2 run tf2_tools view_frames`.
    """

    title = "tree of frames"

    def __init__(self, buffer: Any, now_ns: int = 0, *, details: bool = False) -> None:
        self.facts: FrameFacts = take(buffer, now_ns)
        self.details = details

    def drawing(self) -> Drawing:
        """Return the picture's shapes."""
        return draw(self.facts, self.details)

    def pdf(self) -> bytes:
        """Return the picture as a PDF file."""
        return pdf(self.drawing())

    def text(self) -> str:
        """Return the tree as text."""
        return frame_text.described(self.facts)


__all__ = ["FrameTree"]
