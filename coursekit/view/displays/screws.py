"""Wrench, TwistStamped and AccelStamped: an arrow for the linear part, an arrow with a ring for the angular part."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from coursekit.view.scene import Pose, Scene
from coursekit.view.scene_shapes import Colour, Triangles, arrow, colour_of, scattered, towards, tube

from .kept import KeptDisplay

if TYPE_CHECKING:
    from geometry_msgs.msg import AccelStamped as AccelMsg
    from geometry_msgs.msg import TwistStamped as TwistMsg
    from geometry_msgs.msg import WrenchStamped as WrenchMsg

    from coursekit.view.scene_stage import Stage

_SMALL = 0.01
"""The arrow length, relative to its width, below which it is hidden"""
_RING = 24


class _Screw(KeptDisplay):
    """Two vectors at the origin of the header's frame, for the last `history_length` messages."""

    names = ("linear", "angular")

    def vectors(self, msg: Any) -> tuple[Any, Any]:
        """Return the linear and the angular vector."""
        raise TypeError(f"{type(self).__name__} has to say what it shows")

    def show(self, msg: Any, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Draw arrows of `..._arrow_scale` metres per unit."""
        along, about = (np.array([vector.x, vector.y, vector.z]) for vector in self.vectors(msg))
        if not (np.isfinite(along).all() and np.isfinite(about).all()):
            self.say("Message", "Error", "Message contained invalid floating point values (nans or infs)")
            scene.clear(self.key)
            return
        self.unsay("Message")
        first, second = self.names
        sizes = float(np.linalg.norm(along)), float(np.linalg.norm(about))
        self.say("Values", "Ok", f"{first} {sizes[0]:.3g}, {second} {sizes[1]:.3g}")
        shapes = [*self._arrow(along, first, False), *self._arrow(about, second, True)]
        self.keep(scene, *shapes, pose=pose)

    def _arrow(self, vector: np.ndarray, name: str, ring: bool) -> list[Triangles]:
        scaled = vector * self.options[f"{name}_arrow_scale"]
        length, width = float(np.linalg.norm(scaled)), float(self.options["arrow_width"])
        if length < (_SMALL * width if self.options["hide_small_values"] else 1e-9):
            return []
        colour = colour_of(self.options[f"{name}_color"], self.options["alpha"])
        radius = min(0.05 * width, 0.1 * length)
        shapes = [arrow(0.8 * length, radius, 0.2 * length, 2 * radius, colour)]
        if ring:
            shapes.append(_ring(0.5 * length, 0.25 * length, radius / 2, colour))
        turn = towards(scaled).T
        return [Triangles(shape.vertices @ turn, shape.faces, shape.colour) for shape in shapes]


def _ring(at: float, radius: float, thick: float, colour: Colour) -> Triangles:
    """Return three quarters of a circle about x."""
    turn = np.linspace(0.0, 1.5 * np.pi, _RING)
    middle = np.stack([np.full(_RING, at), radius * np.cos(turn), radius * np.sin(turn)], axis=1)
    none = np.zeros(_RING)
    half = np.stack([np.sin(turn / 2), none, none, np.cos(turn / 2)], axis=1)
    size = 1.2 * radius * float(turn[1])
    vertices, faces = tube(-size / 2, size / 2, thick, sides=6)
    around = vertices[:, [2, 1, 0]] * (1, -1, 1)
    return Triangles(*scattered((around, faces), middle, half), colour)


class Wrench(_Screw):
    """The newest force [N] and torque [Nm]."""

    kind = "Wrench"
    names = ("force", "torque")

    def vectors(self, msg: WrenchMsg) -> tuple[Any, Any]:
        """Return force and torque."""
        return msg.wrench.force, msg.wrench.torque


class TwistStamped(_Screw):
    """The newest velocity [m/s, rad/s]."""

    kind = "TwistStamped"

    def vectors(self, msg: TwistMsg) -> tuple[Any, Any]:
        """Return the linear and angular velocity."""
        return msg.twist.linear, msg.twist.angular


class AccelStamped(_Screw):
    """The newest acceleration [m/s^2, rad/s^2]."""

    kind = "AccelStamped"

    def vectors(self, msg: AccelMsg) -> tuple[Any, Any]:
        """Return the linear and angular acceleration."""
        return msg.accel.linear, msg.accel.angular
