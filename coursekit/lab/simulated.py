"""The simulator that runs in this notebook, and its robots: facts known only in a simulation."""

from __future__ import annotations

from typing import Any

from coursekit.processes.session import current

from .errors import NotThere


def simulator() -> Any:
    """Return the newest running simulator; LookupError when none runs."""
    from coursekit.nodes.gazebo.simulators import simulators

    running = simulators.running(current())
    if not running:
        raise NotThere("No simulator runs. Start one: %ros2 launch gazebo_ros gazebo.launch.py world:=robot_world &")
    return running[-1]


def robot_name(name: str = "") -> str:
    """Return the robot of that name, or the only one; LookupError lists the existing robots."""
    robots = list(simulator().simulation.robots)
    if name in robots or (not name and len(robots) == 1):
        return name or robots[0]
    if not robots:
        raise NotThere("No robot yet. Spawn one: %ros2 run gazebo_ros spawn_entity.py -entity NAME -file FILE")
    raise NotThere(f"Which robot? Say robot=NAME. There are: {', '.join(robots)}.")
