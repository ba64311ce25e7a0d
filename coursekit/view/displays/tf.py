"""TF: axes and names of all frames, and arrows from each to its parent."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from coursekit.view.scene import Pose, Scene, Thing
from coursekit.view.scene_shapes import Label, Triangles, scattered, tube

from .axes import axes
from .display import Display, NoTransform
from .facts import Fact, pose_facts

if TYPE_CHECKING:
    from coursekit.nodes.rviz.config import DisplayConfig
    from coursekit.view.scene_stage import Stage

LENGTH, RADIUS = 0.12, 0.005
"""The size of an axis at marker_scale 1 [m]"""
_ARROW = (0.93, 0.72, 0.2, 1.0)


class TF(Display):
    """All frames of the buffer."""

    kind = "TF"

    def __init__(self, config: DisplayConfig, number: int) -> None:
        super().__init__(config, number)
        self._changes: dict[str, tuple[int, int]] = {}
        """For each moving frame: its newest stamp, and when that was first seen [ns]."""

    def draw(self, stage: Stage, scene: Scene) -> None:
        """Follow the frames."""
        poses, lost, old = self._poses(stage)
        self.poses = poses
        names: set[str] = set()
        for frame, pose in poses.items():
            names |= self._frame(frame, pose, scene)
            parent = stage.buffer.parent(frame)
            if self.options["show_arrows"] and parent in poses:
                names |= self._arrow(frame, pose, poses[parent], scene)
        scene.keep_only(self.key, names)
        self._tell(stage, poses, lost, old)

    def facts(self, name: str, thing: Thing, here: np.ndarray, stage: Stage) -> list[Fact]:
        """Return the frame, its parent, the age of its last change, and its pose in the fixed frame."""
        frame = name.partition(" ")[2]
        parent = stage.buffer.parent(frame) or "none"
        return [("Frame", frame), ("Parent", parent), ("Age", self._age(frame, stage)), *pose_facts(thing.pose)]

    def _age(self, frame: str, stage: Stage) -> str:
        if frame not in self._changes:
            return "static"
        return f"{max(0, stage.now() - self._changes[frame][1]) * 1e-9:.1f} s"

    def _poses(self, stage: Stage) -> tuple[dict[str, Pose], list[str], list[str]]:
        poses: dict[str, Pose] = {}
        lost: list[str] = []
        old: list[str] = []
        for frame in sorted(stage.buffer.frames):
            if self._is_old(frame, stage):
                old.append(frame)
                continue
            try:
                poses[frame] = stage.pose(frame)
            except NoTransform:
                lost.append(frame)
        return poses, lost, old

    def _is_old(self, frame: str, stage: Stage) -> bool:
        """Whether a moving frame has not changed for long; measured by arrival, since stamps may be in simulated time."""
        cache, now = stage.buffer.frames.get(frame), stage.now()
        if cache is None or cache.static:
            return False
        stamp, since = self._changes.get(frame, (None, now))
        if stamp != cache.newest:
            self._changes[frame] = cache.newest, now
            return False
        return now - since > self.options["frame_timeout"] * 1e9

    def _frame(self, frame: str, pose: Pose, scene: Scene) -> set[str]:
        names = {f"axes {frame}"}
        scale = float(self.options["marker_scale"])
        if not scene.has(self.key, f"axes {frame}"):
            bars = axes(LENGTH * scale, RADIUS * scale) if self.options["show_axes"] else ()
            label = (Label(frame),) if self.options["show_names"] else ()
            scene.put(self.key, f"axes {frame}", *bars, *label, pose=pose)
        scene.place(self.key, f"axes {frame}", pose)
        return names

    def _arrow(self, frame: str, pose: Pose, parent: Pose, scene: Scene) -> set[str]:
        """Place a unit arrow, stretched from the frame to its parent."""
        dx, dy, dz = (b - a for a, b in zip(pose[:3], parent[:3], strict=True))
        length = math.sqrt(dx * dx + dy * dy + dz * dz)
        if length < 1e-6:
            return set()
        name = f"arrow {frame}"
        if not scene.has(self.key, name):
            scene.put(self.key, name, _unit_arrow(float(self.options["marker_scale"])))
        turn = _turn_to(dx / length, dy / length, dz / length)
        scene.place(self.key, name, (*pose[:3], *turn), (length, 1.0, 1.0))
        return {name}

    def _tell(self, stage: Stage, poses: dict[str, Pose], lost: list[str], old: list[str]) -> None:
        self.statuses.clear()
        if not poses and not lost and not old:
            self.say("Frames", "Warn", "No tf data received. Does any node publish /tf or /tf_static?")
            return
        self.say("Frames", "Ok", f"{len(poses)} frames")
        if lost:
            text = f"No transform from {_few(lost)} to [{stage.fixed_frame}]: another tree"
            self.say("Frames", "Warn", text)
        if old:
            self.say("Age", "Warn", f"No new transform for {_few(old)} for {self.options['frame_timeout']:g} s")


def _few(names: list[str]) -> str:
    more = f" and {len(names) - 3} more" if len(names) > 3 else ""
    return ", ".join(f"[{name}]" for name in names[:3]) + more


def _unit_arrow(scale: float) -> Triangles:
    """Return an arrow from the origin to x = 1."""
    body = tube(0.0, 1.0, 0.0018 * scale, sides=6)
    return Triangles(*scattered(body, np.zeros((1, 3))), _ARROW)


def _turn_to(x: float, y: float, z: float) -> tuple[float, float, float, float]:
    """Return the quaternion that rotates the x axis onto a unit vector."""
    if x < -0.999999:
        return 0.0, 0.0, 1.0, 0.0
    w = math.sqrt((1.0 + x) / 2)
    return 0.0, -z / (2 * w), y / (2 * w), w
