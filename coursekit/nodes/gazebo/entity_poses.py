"""Which models and links a simulator has, and where they currently are."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from geometry_msgs.msg import Pose

from coursekit.geometry.plane import Pose2D
from coursekit.geometry.rotation import yaw_of
from coursekit.sim.errors import known

if TYPE_CHECKING:
    from coursekit.nodes.gazebo.server import Gazebo

WORLD = ("", "world", "map", "/map")
"""Names that stand for the world frame."""
Speed = tuple[float, float, float]


class EntityPoses:
    """Poses of what a simulator's node contains; `name` is a model's, or `model::link`."""

    def __init__(self, node: Gazebo) -> None:
        self._node = node
        self.deleted: set[str] = set()
        """Models from the world file that were deleted."""

    def models(self) -> list[str]:
        """Return the names of all models, in the order they were added."""
        simulation, gone = self._node.simulation, self.deleted
        names = list(simulation.world.models) or [thing.name for thing in simulation.world.things]
        there = {*simulation.names(), *simulation.world.models}
        later = [name for name in self._node.assemblies if name not in names or name in gone]
        return [name for name in names if name in there and name not in gone] + later

    def links(self) -> list[str]:
        """Return all links, as `model::link`."""
        models, assemblies = self.models(), self._node.assemblies
        return [f"{name}::{link}" for name in models if name in assemblies for link in assemblies[name].frames]

    def where(self, name: str) -> tuple[Pose2D, Speed]:
        """Return the pose and velocity in the world. LookupError suggests similar names."""
        model, _, link = name.partition("::")
        if model not in self.models():
            raise LookupError(f"entity [{name}] does not exist. {known(model, self.models())}")
        place, speed = self._model(model)
        if link:
            assembly = self._node.assemblies.get(model)
            if assembly is None or link not in assembly.frames:
                there = ", ".join(assembly.frames) if assembly is not None else "none that are told apart"
                raise LookupError(f"entity [{name}] does not exist. Links of '{model}' are: {there}.")
            pose = assembly.frames[link]
            place = place @ Pose2D(float(pose[0, 3]), float(pose[1, 3]), math.atan2(pose[1, 0], pose[0, 0]))
        return place, speed

    def _model(self, name: str) -> tuple[Pose2D, Speed]:
        simulation = self._node.simulation
        if name in simulation.names():
            return simulation.pose_of(name), simulation.velocity_of(name)
        return simulation.world.models[name], (0.0, 0.0, 0.0)

    def frame(self, name: str) -> Pose2D:
        """Return the pose of a reference frame, or raise LookupError."""
        return Pose2D() if name in WORLD else self.where(name)[0]


def planar_pose(pose: Pose) -> Pose2D:
    """Return a 3D pose as a 2D pose."""
    q = pose.orientation
    return Pose2D(pose.position.x, pose.position.y, yaw_of((q.x, q.y, q.z, q.w)))


__all__ = ["WORLD", "EntityPoses", "Speed", "planar_pose"]
