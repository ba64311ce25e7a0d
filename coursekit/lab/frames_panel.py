"""The tree of frames in a notebook: a still picture, or a live view that follows /tf and /tf_static."""

from __future__ import annotations

from typing import Any

from coursekit.tf import TransformException
from coursekit.view.frame_listening import listen_to_frames
from coursekit.view.frame_tree import FrameTree

from .panel import Panel, static
from .panel_node import HiddenNode

LISTEN_SECONDS = 1.0
"""How long `frames()` listens before it shows the result."""


def frames(seconds: float = LISTEN_SECONDS, *, live: bool = False, details: bool = False) -> FrameTree | FramesPanel:
    """Show the tree of frames, as view_frames draws it, after listening for `seconds`.

    `details` adds broadcaster and times to each frame. `live=True` follows every change, and shows the pose of a
    frame when it is clicked.

    >>> %ros2 run tf2_ros static_transform_publisher --x 1 --frame-id odom --child-frame-id base_link &
    [static_transform_publisher: running]
    >>> frames()
    frames: 2 frames, 1 tree
    odom
    `-- base_link  static
    """
    if live:
        return FramesPanel(details=details)
    hidden = HiddenNode("frames")
    try:
        buffer = listen_to_frames(hidden.node)
        hidden.session.clock.sleep(seconds)
        buffer.catch_up()
        return FrameTree(buffer, buffer.now(hidden.session.clock.now()), details=details)
    finally:
        hidden.close()


class FramesPanel(Panel):
    """A live picture of the broadcast frames; `picture()` returns the current one."""

    _esm = static("frames.js", "drawing.js")
    _css = static("frames.css")
    keeps_states = True

    def __init__(self, *, details: bool = False) -> None:
        super().__init__("frames")
        self._details = details
        self._chosen = ""
        self._buffer = listen_to_frames(self.hidden.node, self.changed)

    def picture(self) -> FrameTree:
        """Return the current tree."""
        return FrameTree(self._buffer, self._buffer.now(self.session.clock.now()), details=self._details)

    def where(self, frame: str) -> str:
        """Return the pose of a frame in its parent and in the root of its tree, as text."""
        lines, parent = [frame], self._buffer.parent(frame)
        root = frame
        while (above := self._buffer.parent(root)) is not None and above != frame:
            root = above
        for other in dict.fromkeys(name for name in (parent, root) if name and name != frame):
            try:
                x, y, z, i, j, k, w = self._buffer.lookup(other, frame).pose
            except TransformException as error:
                lines.append(f"in {other}: {error}")
                continue
            lines.append(
                f"in {other}: position ({x:.3f}, {y:.3f}, {z:.3f}) m, quaternion ({i:.3f}, {j:.3f}, {k:.3f}, {w:.3f})"
            )
        return "\n".join(lines)

    def text(self) -> str:
        """Return the tree as text."""
        return self.picture().text()

    def shown(self) -> dict[str, Any]:
        """Return the picture, and the pose of the selected frame."""
        said = self.where(self._chosen) if self._chosen else ""
        return {"svg": self.picture().svg(), "chosen": self._chosen, "details": said, "times": self._details}

    def on_choose(self, message: dict[str, Any]) -> None:
        """Select the clicked frame; '' closes the text."""
        self._chosen = str(message.get("name", ""))
        self._push()

    def on_times(self, message: dict[str, Any]) -> None:
        """Show or hide broadcaster and times of all frames."""
        self._details = bool(message.get("on"))
        self._push()


__all__ = ["FramesPanel", "frames"]
