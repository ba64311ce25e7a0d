"""The view of a stage: moved by the user, following a frame, or restored."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from coursekit.nodes.rviz.config import FLAT, going_with, make_view
from coursekit.suggestions import did_you_mean

from .displays import NoTransform
from .scene_camera import Camera

if TYPE_CHECKING:
    from .scene_stage import Stage

Place = tuple[float, float, float, float]
"""The pose of a frame: x, y, z [m] and yaw [rad]"""
ORBIT, FOLLOWER = "Orbit", "ThirdPersonFollower"


class ViewControl:
    """The view of a stage. `frame` is RViz's Target Frame, '' the fixed frame; `type` is the kind of camera."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.frame, self.type = "", ORBIT
        self.moved: dict[str, Any] | None = None
        """The camera as moved by the user, in the target frame; None: as configured"""
        self.go_home()

    def place(self) -> Place | None:
        """Return the pose of the target frame; None if there is none, or it cannot be placed."""
        if not self.frame:
            return None
        try:
            x, y, z, qx, qy, qz, qw = self.stage.pose(self.frame)
        except NoTransform:
            return None
        yaw = math.atan2(2 * (qw * qz + qx * qy), 1 - 2 * (qy * qy + qz * qz))
        return x, y, z, yaw if self.type == FOLLOWER else 0.0

    def camera(self) -> Camera | None:
        """Return the camera in the fixed frame; None if neither the user nor the configuration sets one."""
        view = self.moved or self.stage.config.view
        if not view:
            return None
        place = self.place() or (0.0, 0.0, 0.0, 0.0)
        x, y = _turned(view["target"][:2], place[3])
        target = place[0] + x, place[1] + y, place[2] + view["target"][2]
        return Camera(view["distance"], view["yaw"] + place[3], view["pitch"], target, self.type == FLAT)

    def move(self, given: Mapping[str, Any]) -> None:
        """Move the camera to distance, yaw, pitch and target in the fixed frame, for the user. Raises ValueError."""
        numbers = {key: given[key] for key in ("distance", "yaw", "pitch", "target") if key in given}
        self.moved = self._in_frame(make_view(numbers) or {})

    def follow(self, frame: str, type_: str = ORBIT) -> None:
        """Make the camera follow a frame, or none for ''; a ThirdPersonFollower also rotates with the frame.

        A TopDownOrtho looks straight down, x to the right.
        """
        now = self.stage.camera().as_dict()
        self.frame, self.type = frame, type_
        if type_ == FLAT:
            now |= {"yaw": -math.pi / 2, "pitch": math.pi / 2}
        self.moved = self._in_frame(now)
        if frame:
            self.moved["target"] = [0.0, 0.0, 0.0]

    def go_home(self) -> None:
        """Restore the configured view."""
        view = self.stage.config.view or {}
        self.frame, self.type = str(view.get("target_frame", "")), str(view.get("type", ORBIT))
        self.moved = None

    # -- saved views

    def view(self) -> dict[str, Any] | None:
        """Return the view for a configuration file."""
        return {**self.moved, **going_with(self.frame, self.type)} if self.moved else self.stage.config.view

    def save(self, name: str) -> None:
        """Save the current view under a name."""
        now = self._in_frame(self.stage.camera().as_dict())
        self.stage.config.views[name] = {**now, **going_with(self.frame, self.type)}

    def use(self, name: str) -> None:
        """Restore a saved view; LookupError lists the saved views."""
        views = self.stage.config.views
        if name not in views:
            there = f"There are: {', '.join(views)}" if views else "None is saved yet"
            raise LookupError(" ".join(filter(None, [f"There is no view '{name}'.", did_you_mean(name, views), there])))
        view = views[name]
        self.frame, self.type = view.get("target_frame", ""), view.get("type", ORBIT)
        self.moved = {key: view[key] for key in ("distance", "yaw", "pitch", "target")}

    def _in_frame(self, view: dict[str, Any]) -> dict[str, Any]:
        """Transform a view from the fixed frame to the target frame."""
        place = self.place() or (0.0, 0.0, 0.0, 0.0)
        x, y, z = (there - here for there, here in zip(view["target"], place, strict=False))
        x, y = _turned((x, y), -place[3])
        return {**view, "yaw": view["yaw"] - place[3], "target": [x, y, z]}


def _turned(point: Any, angle: float) -> tuple[float, float]:
    x, y = point
    return x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle)


__all__ = ["FOLLOWER", "ORBIT", "Place", "ViewControl"]
