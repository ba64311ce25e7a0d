"""The sliders of a running joint_state_publisher_gui."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from coursekit.nodes.robots.boards import Board, boards
from coursekit.processes.session import current

from .errors import BadArgument, NotThere
from .panel import Panel, static
from .panel_node import appears

START = "Start one: %ros2 run joint_state_publisher_gui joint_state_publisher_gui &"
shown: list[Callable[[Board], None]] = []
"""Callbacks for a board whose sliders a cell shows: they close its window."""


class JointPanel(Panel):
    """See `joint_sliders`."""

    _esm = static("joints.js")
    _css = static("joints.css")

    def __init__(self, node: str = "") -> None:
        super().__init__()
        self._wanted = node if not node or node.startswith("/") else f"/{node}"
        self._board: Board | None = None
        boards.watch(self._news)
        try:
            appears(lambda: self._find() is not None)
            self._board = self._find()
            if self._board is None:
                raise NotThere(f"No {self._wanted or 'joint_state_publisher_gui'} runs. {START}")
            appears(lambda: bool(self.board.model.free))  # the node starts before the robot description arrives
        except BaseException:
            self.close()
            raise

    def _find(self) -> Board | None:
        running = boards.running(current())
        return next((node for node in reversed(running) if self._wanted in ("", node.full_name)), None)

    def _news(self, board: Board) -> None:
        if board is self._board or (self._board is not None and not self._board.running):
            self._board = self._find() or self._board
            self.changed()

    @property
    def board(self) -> Board:
        """The node whose joints are shown."""
        assert self._board is not None
        return self._board

    # -- from code

    @property
    def positions(self) -> dict[str, float]:
        """The positions of the joints [rad or m]."""
        return {name: joint.position or 0.0 for name, joint in self.board.model.free.items()}

    def move(self, name: str, position: float) -> None:
        """Move a slider [rad or m]; LookupError for an unknown joint, ValueError if `position` is no number."""
        try:
            self.board.move(name, position)
        except LookupError as error:
            raise NotThere(error.args[0]) from None
        except (TypeError, ValueError):
            raise BadArgument(f"The joint '{name}' cannot be put to {position!r}: give a number, rad or m") from None

    def center(self) -> None:
        """Press the Center button."""
        self.board.center()

    def randomize(self) -> None:
        """Press the Randomize button."""
        self.board.randomize()

    # -- what is shown

    def text(self) -> str:
        """A line for each joint."""
        if self._board is None:
            return "joint sliders: none"
        ended = "" if self.board.running else ", ended"
        lines = [f"joint sliders of {self.board.full_name}: {len(self.board.model.free)}{ended}"]
        for row in self._rows():
            lines.append(f"{row['name']}: {row['value']:.3f}  {row['least']:.3f} .. {row['greatest']:.3f}")
        return "\n".join(lines)

    def _rows(self) -> list[dict[str, Any]]:
        return [
            {
                "name": joint.name,
                "value": 0.0 if joint.position is None else joint.position,
                "least": _drawable(joint.least),
                "greatest": _drawable(joint.greatest),
            }
            for joint in self.board.model.free.values()
            if joint.least < joint.greatest
        ]

    def shown(self) -> dict[str, Any]:
        """Return the rows of sliders."""
        if self._board is None:
            return {"node": "", "running": False, "rows": []}
        return {"node": self.board.full_name, "running": self.board.running, "rows": self._rows()}

    def on_move(self, message: dict[str, Any]) -> None:
        """Handle a moved slider."""
        name, value = message.get("name"), message.get("value")
        if name in self.board.model.free and isinstance(value, int | float) and math.isfinite(value):
            self.board.move(str(name), float(value))

    def on_center(self, _message: dict[str, Any]) -> None:
        """Handle the Center button."""
        self.board.center()

    def on_randomize(self, _message: dict[str, Any]) -> None:
        """Handle the Randomize button."""
        self.board.randomize()

    def leave(self) -> None:
        """Stop listening."""
        boards.unwatch(self._news)


def _drawable(limit: float) -> float:
    """Clip a limit to +-1000 for drawing."""
    return max(-1000.0, min(1000.0, limit))


def joint_sliders(node: str = "") -> JointPanel:
    """Show a slider for every joint of a running joint_state_publisher_gui: the named node, or the newest.

    From code: `joint_sliders().move("head_swivel", 0.5)`. LookupError: no such node runs.

    In ROS 2: the window of `ros2 run joint_state_publisher_gui joint_state_publisher_gui`.
    """
    panel = JointPanel(node)
    for listener in shown:
        listener(panel.board)
    return panel


__all__ = ["JointPanel", "joint_sliders"]
