"""Pose, PoseArray and Odometry as arrows, Path as a line; and the numbers in their messages."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from coursekit.nodes.rviz.config import DisplayConfig
from coursekit.tf import compose
from coursekit.view.scene import Pose, Scene, Thing
from coursekit.view.scene_shapes import Band, Shape, Triangles, arrow, colour_of, rotation, scattered, tube

from .axes import axes
from .covariance import doubt
from .display import Display, NoTransform, StampedDisplay
from .facts import Fact, header_facts, pose_facts
from .kept import KeptDisplay

if TYPE_CHECKING:
    from geometry_msgs.msg import Pose as PoseMsg
    from geometry_msgs.msg import PoseArray as PoseArrayMsg
    from geometry_msgs.msg import PoseStamped as PoseStampedMsg
    from geometry_msgs.msg import PoseWithCovarianceStamped as PoseWithCovarianceMsg
    from nav2_msgs.msg import ParticleCloud as ParticleCloudMsg
    from nav_msgs.msg import Odometry as OdometryMsg
    from nav_msgs.msg import Path as PathMsg

    from coursekit.view.scene_stage import Stage


ABOVE = np.array([0.0, 0.0, 0.01])
"""The height of a path above the floor [m]."""


def numbers(pose: PoseMsg) -> Pose:
    """Return the numbers of a geometry_msgs/Pose; a zero quaternion counts as no rotation, as in RViz."""
    p, q = pose.position, pose.orientation
    size = math.sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w)
    turn = (q.x / size, q.y / size, q.z / size, q.w / size) if size > 1e-9 else (0.0, 0.0, 0.0, 1.0)
    return (p.x, p.y, p.z, *turn)


def finite(pose: Pose) -> bool:
    """Whether all numbers of a pose are finite.

    >>> finite((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)), finite((math.nan, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0))
    (True, False)
    """
    return all(map(math.isfinite, pose))


def shapes_of_pose(o: dict[str, Any]) -> list[Shape]:
    """Return an arrow or axes, according to the display's options."""
    if o["shape"] == "Axes":
        return [*axes(o["axes_length"], o["axes_radius"], o["alpha"])]
    colour = colour_of(o["color"], o["alpha"])
    return [arrow(o["shaft_length"], o["shaft_radius"], o["head_length"], o["head_radius"], colour)]


class PoseStamped(StampedDisplay):
    """The newest pose."""

    kind = "Pose"

    def facts(self, name: str, thing: Thing, here: np.ndarray, stage: Stage) -> list[Fact]:
        """Return the pose of the message."""
        return [*header_facts(self.shown), *pose_facts(numbers(self.shown.pose))]

    def show(self, msg: PoseStampedMsg, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Draw an arrow or axes."""
        if not finite(numbers(msg.pose)):
            self.say("Message", "Error", "Message contained invalid floating point values (nans or infs)")
            return
        self.unsay("Message")
        if not scene.has(self.key, "pose"):
            scene.put(self.key, "pose", *shapes_of_pose(self.options))
        self.move(pose, scene)

    def move(self, pose: Pose, scene: Scene) -> None:
        """Move the shape to the pose in its frame."""
        if scene.has(self.key, "pose"):
            scene.place(self.key, "pose", compose(pose, numbers(self.shown.pose)))


class PoseWithCovariance(StampedDisplay):
    """The newest pose, for example amcl's."""

    kind = "PoseWithCovariance"

    def facts(self, name: str, thing: Thing, here: np.ndarray, stage: Stage) -> list[Fact]:
        """Return the pose of the message."""
        return [*header_facts(self.shown), *pose_facts(numbers(self.shown.pose.pose))]

    def show(self, msg: PoseWithCovarianceMsg, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Draw the pose's shape and its uncertainty."""
        here = numbers(msg.pose.pose)
        if not finite(here):
            self.say("Message", "Error", "Message contained invalid floating point values (nans or infs)")
            return
        self.unsay("Message")
        shapes = shapes_of_pose(self.options)
        if self.options["covariance"]:
            shapes += doubt(msg.pose.covariance, here)
        scene.put(self.key, "pose", *shapes)
        self.move(pose, scene)

    def move(self, pose: Pose, scene: Scene) -> None:
        """Move the shapes to the pose in its frame."""
        if scene.has(self.key, "pose"):
            scene.place(self.key, "pose", compose(pose, numbers(self.shown.pose.pose)))


class PoseArray(StampedDisplay):
    """All poses of the newest message, as one shape."""

    kind = "PoseArray"

    def show(self, msg: PoseArrayMsg, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Draw arrows."""
        poses = np.array([pose for pose in map(numbers, msg.poses) if finite(pose)]).reshape(-1, 7)
        self.say("Poses", "Ok", f"{len(poses)} poses")
        colour, length = colour_of(self.options["color"], self.options["alpha"]), float(self.options["arrow_length"])
        parts = [tube(0.0, 0.77 * length, 0.03 * length, sides=6), tube(0.77 * length, length, 0.1 * length, 0.0, sides=8)]
        bodies = [scattered(body, poses[:, :3], poses[:, 3:]) for body in parts]
        scene.put(self.key, "poses", *(Triangles(*body, colour) for body in bodies if len(poses)), pose=pose)


class ParticleCloud(StampedDisplay):
    """All particles of the newest message of nav2's amcl; arrows are longer for likelier particles."""

    kind = "ParticleCloud"

    def show(self, msg: ParticleCloudMsg, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Draw flat arrows."""
        weighted = [(numbers(particle.pose), particle.weight) for particle in msg.particles]
        good = [(place, weight) for place, weight in weighted if finite(place) and math.isfinite(weight)]
        self.say("Particles", "Ok", f"{len(good)} particles")
        if not good:
            scene.put(self.key, "particles", pose=pose)
            return
        places, weights = np.array([place for place, _ in good]), np.array([weight for _, weight in good])
        least, most = self.options["min_arrow_length"], self.options["max_arrow_length"]
        lengths = least + (most - least) * weights / max(float(weights.max()), 1e-12)
        vertices, faces = scattered(_FLAT_ARROW, np.zeros((len(good), 3)))
        sized = vertices.reshape(len(good), -1, 3) * lengths[:, None, None]
        turned = np.einsum("nij,nvj->nvi", rotation(places[:, 3:]), sized) + places[:, None, :3]
        colour = colour_of(self.options["color"], self.options["alpha"])
        scene.put(self.key, "particles", Triangles(turned.reshape(-1, 3), faces, colour), pose=pose)


_FLAT_ARROW = (
    np.array([[0, -0.05, 0], [0, 0.05, 0], [0.7, 0.05, 0], [0.7, -0.05, 0], [0.7, 0.2, 0], [0.7, -0.2, 0], [1, 0, 0]]),
    np.array([[0, 3, 2], [0, 2, 1], [5, 6, 4], [0, 2, 3], [0, 1, 2], [5, 4, 6]]),
)
"""An arrow of one metre, visible from both sides."""


class Odometry(Display):
    """An arrow for each pose along the path; a new one after enough translation or rotation."""

    kind = "Odometry"

    def __init__(self, config: DisplayConfig, number: int) -> None:
        super().__init__(config, number)
        self.trail: list[tuple[Any, Pose]] = []
        """Messages, with the pose in each"""
        self._made = 0

    def forget(self) -> None:
        """Forget the trail."""
        self.trail = []

    def redraw(self, scene: Scene) -> None:
        """Redraw every arrow in place; with fewer to keep, remove the oldest."""
        while len(self.trail) > max(1, int(self.options["keep"])):
            self._drop(scene)
        for back, (msg, here) in enumerate(reversed(self.trail)):
            scene.put(self.key, f"{self._made - back}", *self._shapes(msg, here))

    def facts(self, name: str, thing: Thing, here: np.ndarray, stage: Stage) -> list[Fact]:
        """Return the pose of an arrow, and the velocity there."""
        back = self._made - int(name)
        if back >= len(self.trail):
            return super().facts(name, thing, here, stage)
        msg, pose = self.trail[-1 - back]
        ahead, turn = msg.twist.twist.linear.x, msg.twist.twist.angular.z
        return [*header_facts(msg), *pose_facts(pose), ("Velocity", f"{ahead:.2f} m/s, {turn:.2f} rad/s")]

    def draw(self, stage: Stage, scene: Scene) -> None:
        """Add arrows for new messages."""
        messages = self.taken()
        for index, msg in enumerate(messages):
            here = numbers(msg.pose.pose)
            if self.trail and not self._far(self.trail[-1][1], here):
                continue
            try:
                pose = stage.pose_at(msg.header)
            except NoTransform as error:
                self.say("Transform", "Error", str(error))
                self.put_back(messages[index:])
                return
            self.say("Transform", "Ok", "Transform OK")
            self._add(msg, here, compose(pose, here), scene)

    def _far(self, before: Pose, now: Pose) -> bool:
        if math.dist(before[:3], now[:3]) > self.options["position_tolerance"]:
            return True
        same = min(1.0, abs(sum(a * b for a, b in zip(before[3:], now[3:], strict=True))))
        return 2 * math.acos(same) > self.options["angle_tolerance"]

    def _add(self, msg: OdometryMsg, here: Pose, pose: Pose, scene: Scene) -> None:
        self.trail.append((msg, here))
        self._made += 1
        scene.put(self.key, f"{self._made}", *self._shapes(msg, here), pose=pose)
        if len(self.trail) > max(1, int(self.options["keep"])):
            self._drop(scene)

    def _drop(self, scene: Scene) -> None:
        self.trail.pop(0)
        scene.remove(self.key, f"{self._made - len(self.trail)}")

    def _shapes(self, msg: OdometryMsg, here: Pose) -> list[Shape]:
        return shapes_of_pose(self.options) + (doubt(msg.pose.covariance, here) if self.options["covariance"] else [])


class Path(KeptDisplay):
    """The last `buffer_length` paths as ribbons of `line_width` metres."""

    kind = "Path"
    length = "buffer_length"

    def show(self, msg: PathMsg, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Draw a ribbon through the poses."""
        points = np.array([numbers(stamped.pose)[:3] for stamped in msg.poses]).reshape(-1, 3)
        points = points[np.isfinite(points).all(axis=1)]
        self.say("Path", "Ok", f"{len(points)} poses")
        shapes = [ribbon(points, self.options["line_width"], colour_of(self.options["color"], self.options["alpha"]))]
        self.keep(scene, *(shapes if len(points) > 1 else []), pose=pose)


def ribbon(points: np.ndarray, width: float, colour: tuple[float, float, float, float]) -> Band:
    """Return a flat ribbon along points (n, 3), `width` metres wide, a little above them."""
    along = np.diff(points, axis=0)
    along = along / np.maximum(np.linalg.norm(along[:, :2], axis=1, keepdims=True), 1e-9)
    bent = np.concatenate([along[:1], along[:-1] + along[1:], along[-1:]])
    size = np.linalg.norm(bent[:, :2], axis=1, keepdims=True)
    side = np.where(size > 1e-6, np.stack([-bent[:, 1], bent[:, 0], 0 * bent[:, 0]], axis=1), (1.0, 0.0, 0.0))
    side *= width / 2 / np.where(size > 1e-6, size, 1.0)
    vertices = np.stack([points - side, points + side], axis=1).reshape(-1, 3) + ABOVE
    first = np.arange(len(along))[:, None] * 2
    faces = np.concatenate([first + np.array(corner) for corner in ([0, 2, 1], [1, 2, 3])])
    ends = np.stack([points[:-1], points[1:]], axis=1).reshape(-1, 3) + ABOVE
    return Band(vertices, faces, colour, ends=ends, width=float(width))
