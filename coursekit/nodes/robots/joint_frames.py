"""Conversion of joint positions to frames, as robot_state_publisher publishes them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from geometry_msgs.msg import TransformStamped
from tf2_py._convert import stamped

from coursekit.geometry.pose import Pose
from coursekit.urdf import Robot
from coursekit.urdf.kinematics import joint_motion
from coursekit.urdf.model import Joint

MOST_PLANS = 64
"""The maximum number of cached lists of joint names."""


class Edge(NamedTuple):
    """A joint as an edge between two frames."""

    parent: str
    child: str
    motion: Callable[[float], Pose]


class Source(NamedTuple):
    """The source of a joint's position: an index in the message, times a factor, plus an offset."""

    place: int
    factor: float
    offset: float


class JointFrames:
    """The frames of a robot's joints, their names with a prefix."""

    def __init__(self, robot: Robot, prefix: str) -> None:
        joints = [robot.joints[name] for name in sorted(robot.joints)]
        self._moving = [joint for joint in joints if joint.moves]
        self._still = [joint for joint in joints if joint.type in ("fixed", "planar")]  # other nodes publish floating joints
        self._mimics = [joint for joint in robot.joints.values() if joint.mimic is not None]
        self._motions = {joint.name: joint_motion(joint) for joint in (*self._moving, *self._still)}
        self._plans: dict[tuple[str, ...], list[tuple[Edge, Source]]] = {}
        self.prefix = prefix

    @property
    def prefix(self) -> str:
        """The prefix of each frame's name."""
        return self._prefix

    @prefix.setter
    def prefix(self, prefix: str) -> None:
        self._prefix = prefix
        self._plans.clear()

    def fixed(self, stamp_ns: int) -> list[TransformStamped]:
        """The frames that do not depend on joint states."""
        edges = [self._edge(joint) for joint in self._still]
        return [stamped(edge.parent, edge.child, stamp_ns, edge.motion(0.0)) for edge in edges]

    def moving(self, names: Sequence[str], positions: Sequence[float], stamp_ns: int) -> list[TransformStamped]:
        """The frames of the joints with these names and positions [rad, m], and of the joints that mimic them."""
        key = tuple(names)  # a robot publishes the same joints again and again
        plan = self._plans.get(key)
        if plan is None:
            if len(self._plans) >= MOST_PLANS:
                self._plans.clear()
            plan = self._plans[key] = self._plan(names)
        return [
            stamped(parent, child, stamp_ns, motion(positions[place] * factor + offset))
            for (parent, child, motion), (place, factor, offset) in plan
        ]

    def _plan(self, names: Sequence[str]) -> list[tuple[Edge, Source]]:
        sources = {name: Source(place, 1.0, 0.0) for place, name in enumerate(names)}
        for joint in self._mimics:
            mimic = joint.mimic
            if mimic is not None and mimic.joint in sources:
                place, factor, offset = sources[mimic.joint]
                own = Source(place, factor * mimic.multiplier, offset * mimic.multiplier + mimic.offset)
                sources.setdefault(joint.name, own)
        return [(self._edge(joint), sources[joint.name]) for joint in self._moving if joint.name in sources]

    def _edge(self, joint: Joint) -> Edge:
        return Edge(self._prefix + joint.parent, self._prefix + joint.child, self._motions[joint.name])
