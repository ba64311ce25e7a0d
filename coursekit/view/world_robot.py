"""A robot of a simulated world in its scene: links as in its description, wheels at their current rotation."""

from __future__ import annotations

import math
from typing import Any

from coursekit.geometry.plane import Pose2D
from coursekit.geometry.pose import compose
from coursekit.sim.robot import Robot
from coursekit.urdf import MeshError
from coursekit.urdf.kinematics import Kinematics
from coursekit.urdf.shapes import link_surfaces

from .displays.robot_model import MOST_FACES
from .scene import HERE, Pose, Scene
from .scene_shapes import Label, Triangles, simpler
from .world_shapes import robot_shape

ROBOTS = "robots"
_RED = (0.78, 0.18, 0.14, 1.0)
_HEADROOM = 0.15
"""The height of the contact label above the robot [m]."""


class RobotShape:
    """The shape of a robot: the links of its description, else its collision parts."""

    def __init__(self, scene: Scene, robot: Robot, assembly: Any) -> None:
        self.robot = robot
        self._lift = 0.0
        self._kinematics: Kinematics | None = None
        self._joints: list[str] = []
        links = _link_shapes(assembly)
        if links:
            self._lift, self._kinematics = assembly.lift, Kinematics(assembly.description)
            joints = assembly.description.joints.items()
            self._joints = [name for name, joint in joints if joint.moves and joint.mimic is None]
        else:
            links = {"": [robot_shape(robot.model.parts)]} if robot.model.parts else {}
        self._links = list(links)
        for link, shapes in links.items():
            scene.put(ROBOTS, self._key(link), *shapes)
        self._top = max((part.high for part in robot.model.parts), default=0.0) + _HEADROOM
        self.place(scene, robot)

    def _key(self, link: str) -> str:
        return f"{self.robot.name}::{link}"

    def place(self, scene: Scene, robot: Robot) -> None:
        """Move the robot to its current pose and joint positions."""
        base = upright(robot.place)
        poses: dict[str, Pose] = {"": HERE}
        if self._kinematics is not None:
            base = compose(base, (0.0, 0.0, self._lift, 0.0, 0.0, 0.0, 1.0))
            poses = self._kinematics.poses({name: robot.angles[name] for name in self._joints if name in robot.angles})
        for link in self._links:
            scene.place(ROBOTS, self._key(link), compose(base, poses[link]))
        self._tell_contacts(scene, robot)

    def _tell_contacts(self, scene: Scene, robot: Robot) -> None:
        text = f"touches {', '.join(sorted(robot.contacts))}" if robot.contacts else ""
        key = f"{robot.name}::touches"
        if not text:
            scene.remove(ROBOTS, key)
            return
        x, y, _ = robot.place
        pose = (x, y, self._top, 0.0, 0.0, 0.0, 1.0)
        label = Label(text, _RED)
        if not scene.has(ROBOTS, key) or scene.things[ROBOTS, key].shapes != (label,):
            scene.put(ROBOTS, key, label, pose=pose)
        scene.place(ROBOTS, key, pose)

    def forget(self, scene: Scene) -> None:
        """Remove the robot."""
        for key in [key for key in scene.things if key[0] == ROBOTS and key[1].startswith(f"{self.robot.name}::")]:
            scene.remove(*key)


def _link_shapes(assembly: Any) -> dict[str, list[Triangles]]:
    """Return the triangles of each link that has any; empty without a description or with a missing mesh."""
    robot = assembly.description if assembly is not None else None
    if robot is None:
        return {}
    triangles_by_link: dict[str, list[Triangles]] = {}
    for link in robot.links:
        try:
            surfaces = link_surfaces(robot, link)
        except MeshError:
            return {}
        if surfaces:
            triangles_by_link[link] = [
                Triangles(*simpler((surface.vertices, surface.faces), MOST_FACES), surface.colour) for surface in surfaces
            ]
    return triangles_by_link


def upright(place: Pose2D) -> Pose:
    """Convert a planar pose to a 3D pose.

    >>> [round(number, 3) for number in upright(Pose2D(1.0, 2.0, math.pi / 2))]
    [1.0, 2.0, 0.0, 0.0, 0.0, 0.707, 0.707]
    """
    half = place.theta / 2
    return (place.x, place.y, 0.0, 0.0, 0.0, math.sin(half), math.cos(half))


__all__ = ["ROBOTS", "RobotShape", "upright"]
