"""Marker and MarkerArray: shapes drawn by programs, by namespace and id, for their lifetime."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from coursekit.nodes.rviz.config import DisplayConfig
from coursekit.tf import compose
from coursekit.view.scene import Pose, Scene, Thing

from .display import Display, NoTransform
from .facts import Fact, header_facts, pose_facts
from .marker_shapes import shapes_of
from .poses import finite, numbers

if TYPE_CHECKING:
    import numpy as np
    from visualization_msgs.msg import Marker as MarkerMsg

    from coursekit.view.scene_stage import Stage

DELETE, DELETE_ALL = 2, 3
TYPES = ("ARROW", "CUBE", "SPHERE", "CYLINDER", "LINE_STRIP", "LINE_LIST", "CUBE_LIST", "SPHERE_LIST", "POINTS",
         "TEXT_VIEW_FACING", "MESH_RESOURCE", "TRIANGLE_LIST")  # fmt: skip
MOST = 10_000
"""The maximum number of markers kept: a program that never deletes any does not fill the memory."""


@dataclass
class _Living:
    msg: Any
    name: str
    ends: int
    """The end of its lifetime [ns]; 0: never"""
    drawn: bool = False


class Marker(Display):
    """Messages with one marker each."""

    kind = "Marker"

    def __init__(self, config: DisplayConfig, number: int) -> None:
        super().__init__(config, number)
        self._waiting = deque(maxlen=1000)
        self.living: dict[str, _Living] = {}

    def forget(self) -> None:
        """Forget all markers."""
        self.living = {}

    def redraw(self, scene: Scene) -> None:
        """Draw all live markers again."""
        super().redraw(scene)
        for marker in self.living.values():
            marker.drawn = False

    def facts(self, name: str, thing: Thing, here: np.ndarray, stage: Stage) -> list[Fact]:
        """Return namespace, id and type of a marker, and its pose."""
        if name not in self.living:
            return super().facts(name, thing, here, stage)
        msg = self.living[name].msg
        what = [("Namespace", msg.ns), ("Id", f"{msg.id}"), ("Type", TYPES[msg.type])]
        return [*what, *([("Text", msg.text)] if msg.text else []), *header_facts(msg), *pose_facts(numbers(msg.pose))]

    def markers(self, msg: MarkerMsg) -> list[Any]:
        """Return the markers of a message."""
        return [msg]

    def draw(self, stage: Stage, scene: Scene) -> None:
        """Apply new messages, remove expired markers, place the others."""
        now = stage.now()
        for msg in self.taken():
            for marker in self.markers(msg):
                self._apply(marker, now)
        for name, living in list(self.living.items()):
            if living.ends and now >= living.ends:
                del self.living[name]
        self._place(stage, scene)
        scene.keep_only(self.key, set(self.living))

    def _apply(self, marker: MarkerMsg, now: int) -> None:
        name = f"{marker.ns}/{marker.id}"
        if marker.action == DELETE_ALL:
            self.living = {key: shown for key, shown in self.living.items() if marker.ns and shown.msg.ns != marker.ns}
        elif marker.action == DELETE:
            self.living.pop(name, None)
        else:
            life = marker.lifetime.sec * 1_000_000_000 + marker.lifetime.nanosec
            self.living.pop(name, None)
            self.living[name] = _Living(marker, name, now + life if life > 0 else 0)
            if len(self.living) > MOST:
                self.living.pop(next(iter(self.living)))

    def _place(self, stage: Stage, scene: Scene) -> None:
        fault, missing = "", ""
        for marker in self.living.values():
            try:
                pose = self._pose(marker.msg, stage)
                if not marker.drawn:
                    scene.put(self.key, marker.name, *shapes_of(marker.msg), pose=pose)
                    marker.drawn = True
                scene.place(self.key, marker.name, pose)
            except NoTransform as error:
                missing = missing or f"{marker.name}: {error}"
            except ValueError as error:
                fault = fault or f"{marker.name}: {error}"
                scene.remove(self.key, marker.name)
        self.unsay("Markers")
        self.unsay("Transform")
        if missing:
            self.say("Transform", "Error", missing)
        if fault:
            self.say("Markers", "Error", fault)
        elif self.count:
            self.say("Markers", "Ok", f"{len(self.living)} marker{'s' * (len(self.living) != 1)}")

    def _pose(self, msg: MarkerMsg, stage: Stage) -> Pose:
        """Return the marker's pose: a `frame_locked` one follows its frame, others stay at the pose of their stamp."""
        frame = stage.pose(msg.header.frame_id) if msg.frame_locked else stage.pose_at(msg.header, newest=True)
        own = numbers(msg.pose)
        if not finite(own):
            raise ValueError("its pose has invalid floating point values (nans or infs)")
        return compose(frame, own)


class MarkerArray(Marker):
    """Messages with many markers."""

    kind = "MarkerArray"

    def markers(self, msg: Any) -> list[Any]:
        """Return all markers of a message."""
        return list(msg.markers)
