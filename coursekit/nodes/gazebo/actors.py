"""`<actor>` in SDF worlds: a person who walks along waypoints, visible to lasers and cameras, without contacts."""

from __future__ import annotations

import math
from itertools import pairwise

from coursekit.geometry.plane import Pose2D
from coursekit.sim.solids import Disc
from coursekit.sim.walk import Walk
from coursekit.sim.world import Thing
from coursekit.urdf.xml_tree import Element

from .value_parsing import flag, number, pose, yaw_of

BODY = Disc(0.0, 0.0, 0.25, 0.0, 1.75)
"""The shape of a person for lasers; the skin itself is not drawn [m]."""
COLOUR = (0.85, 0.55, 0.35)


def actor(element: Element) -> Thing:
    """Convert an `<actor>` to a thing. Raises UrdfError with the line.

    Its waypoints are poses in the world, as in Gazebo Classic; without any it stays at its `<pose>`.
    """
    name = element.get("name")
    if not name:
        raise element.error("has no name", "Write <actor name='walker'>.")
    walk = _walk(element)
    place = walk.at(0.0) if walk is not None else _flat(element)
    return Thing(name, (BODY,), place, mass=math.inf, colour=COLOUR, walk=walk, model=name, solid=False)


def _walk(element: Element) -> Walk | None:
    script = element.first("script")
    if script is None or not flag(script, "auto_start", True):
        return None
    times: list[float] = []
    poses: list[Pose2D] = []
    for trajectory in script.all("trajectory"):
        begin = times[-1] if times else 0.0
        for point in sorted(trajectory.all("waypoint"), key=lambda point: number(point, "time", 0.0)):
            time = number(point, "time", 0.0)
            if time < 0.0:
                raise point.error(f"has a time of {time:g}", "Give seconds from the beginning of the trajectory.")
            times.append(begin + time)
            poses.append(_flat(point))
    if not times:
        return None
    times, poses = _rising(times, poses)
    delay = number(script, "delay_start", 0.0)
    if delay < 0.0:
        raise script.error(f"has a delay_start of {delay:g}", "Give seconds, 0 or more.")
    return Walk(tuple(times), tuple(poses), flag(script, "loop", True), delay)


def _rising(times: list[float], poses: list[Pose2D]) -> tuple[list[float], list[Pose2D]]:
    """Keep only the last of waypoints with the same time."""
    kept = [number for number, (before, after) in enumerate(pairwise([*times, math.inf])) if before < after]
    return [times[number] for number in kept], [poses[number] for number in kept]


def _flat(element: Element) -> Pose2D:
    matrix = pose(element)
    return Pose2D(float(matrix[0, 3]), float(matrix[1, 3]), yaw_of(matrix))


__all__ = ["actor"]
