"""The stage: the displays of one view, their frames, and their status."""

from __future__ import annotations

import threading
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from coursekit.nodes.rviz.config import Config, DisplayConfig
from coursekit.nodes.rviz.kinds import QOS
from coursekit.nodes.rviz.properties import changed
from coursekit.suggestions import similar
from coursekit.tf import ExtrapolationException, Pose, TransformException

from .displays import Display, NoTransform, NotYet, make_display
from .displays.image import Image
from .displays.robot_model import RobotModel
from .frame_listening import listen_to_frames
from .scene import HERE, Scene
from .scene_camera import Camera, camera_of
from .scene_still import Still
from .simulated_time import SimulatedTime
from .view_control import ViewControl

if TYPE_CHECKING:
    from rclpy.node import Node

WORLD = ("map", "odom", "world")
"""Preferred fixed frames, the best first."""

ROOM = 3.0
"""The minimum camera distance for robots that may drive around [m]."""


class Stage:
    """The content of a viewer. `update()` brings the scene up to date; nothing is drawn between two calls."""

    def __init__(self, node: Node, config: Config) -> None:
        self.node = node
        self.config = config
        self.scene = Scene()
        self.buffer = listen_to_frames(node)
        self.displays: list[Display] = []
        self.lock = threading.RLock()
        self.looking = ViewControl(self)
        self._guessed = ""
        self._count = 0
        self._time = SimulatedTime(node)
        for display in config.displays:
            self.add(display)

    # -- the displays

    def add(self, config: DisplayConfig) -> Display:
        """Add a display."""
        with self.lock:
            self._count += 1
            display = make_display(config, self._count)
            display.connect(self.node)
            self.displays.append(display)
            return display

    def names(self) -> list[str]:
        """Return the names of the displays."""
        return [display.config.name for display in self.displays]

    def find(self, name: str) -> Display:
        """Return the display of that name; LookupError lists the existing ones."""
        for display in self.displays:
            if display.config.name == name:
                return display
        known = ", ".join(self.names()) or "none"
        raise LookupError(f"There is no display '{name}'. There are: {known}")

    def switch(self, display: Display, on: bool) -> None:
        """Switch a display on or off."""
        with self.lock:
            display.config.enabled = on
            display.disconnect(self.node)
            self.scene.clear(display.key)
            display.connect(self.node)

    def retopic(self, display: Display, topic: str) -> None:
        """Change the topic of a display."""
        with self.lock:
            display.config.topic = topic if topic.startswith("/") else f"/{topic}"
            self.switch(display, display.config.enabled)

    def remove(self, display: Display) -> None:
        """Remove a display."""
        with self.lock:
            display.disconnect(self.node)
            self.scene.clear(display.key)
            self.displays.remove(display)

    def change(self, display: Display, options: Mapping[str, Any]) -> None:
        """Change some options of a display and redraw its content; ValueError names invalid ones."""
        with self.lock:
            display.config.options = changed(display.config, options)
            if set(options) & set(QOS):
                self.switch(display, display.config.enabled)
            else:
                display.redraw(self.scene)

    # -- frames

    @property
    def fixed_frame(self) -> str:
        """The fixed frame: as configured, else chosen as soon as frames or a robot are known."""
        return self.config.fixed_frame or self._guessed or self._root_of_a_robot() or "map"

    def fix(self, frame: str) -> None:
        """Change the fixed frame; '' chooses it automatically."""
        with self.lock:
            self.config.fixed_frame, self._guessed = frame, ""
            for display in self.displays:
                self.switch(display, display.config.enabled)

    def _guess(self) -> None:
        """Choose a frame with a usual name of the world, else the root of the largest tree."""
        if self.config.fixed_frame or self._guessed or not self.buffer.frames:
            return
        below: dict[str, int] = {}
        for frame in sorted(self.buffer.frames):
            root = self.root(frame)
            below[root] = below.get(root, 0) + 1
        named = [name for name in WORLD if name in below]
        self._guessed = named[0] if named else max(below, key=lambda name: below[name])

    def _root_of_a_robot(self) -> str:
        """Return a robot's root if there are no frames: a robot of one link has no joint, so no node publishes its frame."""
        if self.buffer.frames:
            return ""
        return next((robot.prefix(self) + robot.robot.root for robot in self.robots() if robot.robot is not None), "")

    def root(self, frame: str) -> str:
        """Return the root of a frame's tree."""
        seen = {frame}
        while (above := self.buffer.parent(frame)) is not None and above not in seen:
            seen.add(above)
            frame = above
        return frame

    def pose(self, frame: str, stamp: int = 0) -> Pose:
        """Return a frame's pose in the fixed frame at a time [ns], 0 for the newest.

        Raises NoTransform, or its subclass NotYet if a transform for that time may still come.
        """
        fixed = self.fixed_frame
        frame = frame.removeprefix("/")
        if frame == fixed:
            return HERE
        try:
            return self.buffer.lookup(fixed, frame, stamp).pose
        except TransformException as error:
            text = self._explain(frame, fixed, error)
            ahead = isinstance(error, ExtrapolationException) and self._ahead(frame, fixed, stamp)
            raise (NotYet if ahead else NoTransform)(text) from None

    def _ahead(self, frame: str, fixed: str, stamp: int) -> bool:
        """Whether a time is after the newest common time of two frames."""
        try:
            return stamp > self.buffer.latest_common_time(fixed, frame)
        except TransformException:
            return False

    def pose_at(self, header: Any, newest: bool = False) -> Pose:
        """Return the pose of a header's frame at its stamp; with `newest`, else the newest pose."""
        stamp = header.stamp.sec * 1_000_000_000 + header.stamp.nanosec
        try:
            return self.pose(header.frame_id, stamp)
        except NoTransform:
            if newest and stamp:
                return self.pose(header.frame_id)
            raise

    def _explain(self, frame: str, fixed: str, error: TransformException) -> str:
        known = sorted(self.buffer.frames)
        if not frame:
            return "The message names no frame: its header.frame_id is empty"
        if isinstance(error, ExtrapolationException):
            return f"For frame [{frame}]: no transform to [{fixed}] at its time. {error}"
        for name in (frame, fixed):
            if name not in known:
                near = similar(name, known, 1, 0.7)
                hint = f"Did you mean [{near[0]}]? " if near else ""
                return f"No transform from [{frame}] to [{fixed}]: frame [{name}] does not exist. {hint}{_there(known)}"
        return f"No transform from [{frame}] to [{fixed}]: they are in two trees, under [{self.root(frame)}] and " \
               f"[{self.root(fixed)}]"  # fmt: skip

    def now(self) -> int:
        """Return the simulation's time while there is one, else the node's [ns]."""
        return self._time.now()

    # -- status

    def update(self) -> Scene:
        """Bring the scene up to date."""
        with self.lock:
            self.buffer.catch_up()
            self._guess()
            for display in self.displays:
                display.update(self)
            return self.scene

    def global_status(self) -> tuple[str, str]:
        """Return RViz's Global Status, of the fixed frame."""
        if not self.buffer.frames:
            return "Warn", f"Fixed Frame: no tf data. Frame [{self.fixed_frame}] does not exist"
        if self.fixed_frame not in self.buffer.frames:
            return "Error", f"Fixed Frame: frame [{self.fixed_frame}] does not exist. {_there(sorted(self.buffer.frames))}"
        return "Ok", ""

    def robots(self) -> list[RobotModel]:
        """Return the enabled robot displays."""
        return [display for display in self.displays if isinstance(display, RobotModel) and display.config.enabled]

    def images(self) -> list[Image]:
        """Return the enabled image displays that have an image."""
        return [
            display
            for display in self.displays
            if isinstance(display, Image) and display.config.enabled and display.picture is not None
        ]

    # -- pictures

    def keys(self, *kinds: str) -> list[str]:
        """Return the keys of the displays of these kinds."""
        return [display.key for display in self.displays if display.kind in kinds]

    def seen(self) -> bool:
        """Whether the object to look at is placed: a robot, if any is shown."""
        robots = self.robots()
        return self.looking.camera() is not None or not robots or any(robot.poses for robot in robots)

    def camera(self) -> Camera:
        """Return the user's camera, else one that shows all but floors and clouds, with room for moving robots."""
        told = self.looking.camera()
        if told is not None:
            return told
        at_home = any(robot.robot is not None and self.fixed_frame in robot.robot.links for robot in self.robots())
        wide = ("Grid", "Map", "LaserScan", "PointCloud2")
        keys = self.keys("RobotModel") if at_home else [display.key for display in self.displays if display.kind not in wide]
        return camera_of(self.scene, keys, 0.5 if at_home else ROOM)

    def png(self, width: int = 640, height: int = 400) -> bytes:
        """Return a still picture of the current scene."""
        with self.lock:
            return Still(self.camera(), width, height).png(self.scene, self.keys("Grid", "Map"))


def _there(known: list[str]) -> str:
    if not known:
        return "There are no frames yet"
    more = f" and {len(known) - 8} more" if len(known) > 8 else ""
    return f"There are: {', '.join(known[:8])}{more}"


__all__ = ["Stage"]
