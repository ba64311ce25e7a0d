"""The true world of a simulator as a scene: fixed and movable things, robots, and the beams of their LiDARs."""

from __future__ import annotations

import math
import threading
from collections.abc import Callable
from typing import Any

import numpy as np

from coursekit.nodes.gazebo.devices import RayDevice
from coursekit.nodes.gazebo.simulators import Simulator
from coursekit.sim.lidar import Lidar
from coursekit.sim.robot import Robot
from coursekit.sim.world import Thing

from .scene import Pose, Scene
from .scene_camera import Camera, camera_of
from .scene_shapes import Lines, Triangles
from .scene_still import Still
from .world_robot import ROBOTS, RobotShape, upright
from .world_shapes import fan, thing_shape

FLOOR, THINGS, LASER = "floor", "things", "laser"
_FLOOR_COLOUR = (0.89, 0.88, 0.85, 1.0)
_LINE_COLOUR = (0.74, 0.73, 0.70, 1.0)
_BEAM_COLOUR = (0.25, 0.5, 0.95, 0.22)
_MARGIN = 1.0
"""The margin of the floor around all things [m]."""
_BELOW = -0.02
"""The height of the floor [m], low enough that things on it do not flicker."""
LASER_NS = 100_000_000
"""The period of redrawing the beams, in simulated time [ns]."""


class WorldScene:
    """The view of the world of the simulator returned by `find`, which may be None."""

    def __init__(self, find: Callable[[], Simulator | None]) -> None:
        self.scene = Scene()
        self.lock = threading.RLock()
        self.lasers = True
        """Whether LiDAR beams are drawn."""
        self._find = find
        self._simulator: Simulator | None = None
        self._changes = -1
        self._robots: dict[str, RobotShape] = {}
        self._looks: dict[str, Any] = {}
        self._all_there: list[str] = []
        """The names of the things that existed when the floor was drawn."""
        self._swept = -LASER_NS

    @property
    def simulator(self) -> Simulator | None:
        """The simulator whose world is shown."""
        return self._find()

    def update(self) -> Scene:
        """Bring the scene up to date."""
        with self.lock:
            simulator = self._find()
            if simulator is not self._simulator:
                for display in (FLOOR, THINGS, ROBOTS, LASER):
                    self.scene.clear(display)
                self._simulator, self._changes, self._swept = simulator, -1, -LASER_NS
                self._robots, self._looks, self._all_there = {}, {}, []
            if simulator is not None:
                with simulator.simulation.busy:
                    self._draw(simulator)
            return self.scene

    def _draw(self, simulator: Simulator) -> None:
        simulation = simulator.simulation
        if self._changes != simulation.changes:
            self._changes = simulation.changes
            self._build(simulator)
        for name in simulation.things:
            self.scene.place(THINGS, name, upright(simulation.pose_of(name)))
        for robot in simulation.robots.values():
            self._robots[robot.name].place(self.scene, robot)
        if not self.lasers:
            self.scene.clear(LASER)
        elif abs(simulation.now_ns - self._swept) >= LASER_NS or not self._all_swept(simulator):
            self._swept = simulation.now_ns
            self._sweep(simulator)

    # -- contents

    def _build(self, simulator: Simulator) -> None:
        simulation = simulator.simulation
        there = [*simulation.fixed_things(), *(thing for thing, _ in simulation.things.values())]
        self.scene.keep_only(THINGS, {thing.name for thing in there})
        for thing in there:
            if thing.parts:
                self._show(thing, upright(simulation.pose_of(thing.name)))
        for name in [name for name in self._robots if name not in simulation.robots]:
            self._robots.pop(name).forget(self.scene)
        for robot in simulation.robots.values():
            known = self._robots.get(robot.name)
            if known is None or known.robot is not robot:
                self._robots[robot.name] = RobotShape(self.scene, robot, simulator.assemblies.get(robot.name))
        if self._all_there != (now_there := [thing.name for thing in there] + list(self._robots)):
            self._all_there = now_there
            self._lay_floor()

    def _show(self, thing: Thing, pose: Pose) -> None:
        """Place a thing; its shape is rebuilt if another thing has taken its name."""
        look = (thing.parts, thing.texture, thing.colour)
        if self.scene.has(THINGS, thing.name) and self._looks.get(thing.name) == look:
            self.scene.place(THINGS, thing.name, pose)
            return
        self._looks[thing.name] = look
        self.scene.put(THINGS, thing.name, thing_shape(thing), pose=pose)

    def _lay_floor(self) -> None:
        bounds = self.scene.bounds([THINGS, ROBOTS])
        low, high = bounds if bounds is not None else (np.full(3, -1.0), np.full(3, 1.0))
        (x0, y0), (x1, y1) = np.floor(low[:2] - _MARGIN), np.ceil(high[:2] + _MARGIN)
        corners = np.array([(x0, y0, 0), (x1, y0, 0), (x1, y1, 0), (x0, y1, 0)], float)
        along = [(x, y, 0) for x in _steps(x0, x1) for y in (y0, y1)]
        across = [(x, y, 0) for y in _steps(y0, y1) for x in (x0, x1)]
        pose = (0.0, 0.0, _BELOW, 0.0, 0.0, 0.0, 1.0)
        floor = Triangles(corners, np.array([(0, 1, 2), (0, 2, 3)]), _FLOOR_COLOUR)
        self.scene.put(FLOOR, "floor", floor, pose=pose)
        lines = Lines(np.array(along + across, float), _LINE_COLOUR)
        self.scene.put(FLOOR, "lines", lines, pose=(0.0, 0.0, _BELOW / 2, 0.0, 0.0, 0.0, 1.0))

    # -- LiDAR beams

    def _all_swept(self, simulator: Simulator) -> bool:
        return all(self.scene.has(LASER, name) for name in lidars(simulator))

    def _sweep(self, simulator: Simulator) -> None:
        lidar_by_name = lidars(simulator)
        self.scene.keep_only(LASER, set(lidar_by_name))
        for name, (robot, lidar) in lidar_by_name.items():
            ranges = np.minimum(simulator.simulation.scan(lidar, robot), lidar.range_max)
            turn = lidar.bearings()
            ends = np.column_stack((ranges * np.cos(turn), ranges * np.sin(turn)))
            shape = fan((0.0, 0.0), lidar.height, ends, _BEAM_COLOUR)
            self.scene.put(LASER, name, shape, pose=upright(robot.place @ lidar.mount))

    # -- for a panel

    def seen(self) -> bool:
        """Whether there is something to look at."""
        return self._simulator is not None

    def images(self) -> list[Any]:
        """Return no images: none are shown beside the scene."""
        return []

    def camera(self) -> Camera:
        """Return a camera high in the south that shows all things."""
        camera = camera_of(self.scene, [THINGS, ROBOTS], 3.0)
        return Camera(camera.distance * 0.7, -math.pi / 2, 1.05, camera.target)

    def names(self) -> dict[int, str]:
        """Return the models of the scene's things by number, without the floor and the beams."""
        with self.lock:
            things = self.scene.things.items()
            return {
                thing.number: name.partition("::")[0] for (display, name), thing in things if display in (THINGS, ROBOTS)
            }

    def png(self, width: int = 640, height: int = 400) -> bytes:
        """Return a still picture of the current scene."""
        with self.lock:
            return Still(self.camera(), width, height).png(self.scene, [FLOOR])


def lidars(simulator: Simulator) -> dict[str, tuple[Robot, Lidar]]:
    """Return the robots' LiDARs with more than one beam, each with a unique name."""
    lidars: dict[str, tuple[Robot, Lidar]] = {}
    for name, robot in simulator.simulation.robots.items():
        devices = simulator.assemblies[name].devices if name in simulator.assemblies else []
        rays = [device for device in devices if isinstance(device, RayDevice) and device.lidar.beams > 1]
        lidars |= {f"{name} {number}": (robot, ray.lidar) for number, ray in enumerate(rays)}
    return lidars


def _steps(low: float, high: float) -> np.ndarray:
    """Return the positions of the floor's lines: one metre apart, or more in a large world."""
    return np.arange(low, high + 0.5, max(1.0, round((high - low) / 100)))


__all__ = ["FLOOR", "LASER", "ROBOTS", "THINGS", "WorldScene", "lidars"]
