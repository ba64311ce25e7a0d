"""A world in motion: robots drive, push and collide; the same commands produce the same run."""

from __future__ import annotations

import math
import threading
from dataclasses import replace
from typing import Any

import numpy as np
import pymunk

from coursekit.geometry.plane import Array, Pose2D

from .bodies import FIXED, LOOSE, ROBOT, body_of, follow, moment, put, shapes_of
from .contacts import drag, obstacle, part, pass_by, touch
from .errors import WorldError, known
from .exclusive import alone
from .external_forces import ExternalForce
from .lidar import Lidar
from .outline_scene import OutlineScene
from .robot import Robot, RobotModel
from .solids import Part
from .world import Thing, World

STEP_NS = 5_000_000
"""Duration of one physics step [ns]."""
_DT = STEP_NS * 1e-9


class Simulation:
    """Robots in a world.

    >>> from coursekit.sim import RobotModel, World
    >>> simulation = Simulation(World("plain"))
    >>> cart = simulation.spawn(RobotModel("cart"))
    >>> cart.command(0.5); simulation.advance(2.0)
    >>> round(cart.place.x, 2)
    0.96
    """

    def __init__(self, world: World, seed: int = 0) -> None:
        self.world, self.seed = world, seed
        self.busy = threading.RLock()
        """Held while the world changes: a notebook's cell accesses it concurrently with the simulator's own thread."""
        self.now_ns = 0
        """The time reached by the physics; it may be up to one step behind the last `advance_to`."""
        self.changes = 0
        """Number of changes to the set of objects or to the pose of fixed ones."""
        self.robots: dict[str, Robot] = {}
        self.things: dict[str, tuple[Thing, pymunk.Body]] = {}
        self.space = pymunk.Space()
        self.space.iterations = 12
        self.space.collision_slop = 1e-3  # m; the library's own 0.1 is meant for pixels
        self.pushes: list[ExternalForce] = []
        """External forces; they are dropped when they are over, or their target is gone."""
        self._starts: dict[str, Pose2D] = {}
        self._doors: dict[str, list[Any]] = {}
        self._fixed: dict[str, Thing] = {}
        self._posts: dict[str, pymunk.Body] = {}
        """The bodies of fixed objects."""
        self._scenes: dict[float, OutlineScene] = {}
        self.space.on_collision(ROBOT, None, begin=touch, separate=part)
        self.space.on_collision(LOOSE, None, begin=pass_by)
        for thing in world.things:
            self.add(thing)

    # -- objects

    @alone
    def add(self, thing: Thing) -> None:
        """Add an object to the world; WorldError if its name is taken."""
        self._free(thing.name)
        if thing.moves:
            body = body_of(thing)
            shapes = shapes_of(thing.parts, body, thing.name, LOOSE)
            for shape in () if thing.solid else shapes:
                shape.filter = pymunk.ShapeFilter(mask=0)
            self.space.add(body, *shapes)
            self.things[thing.name] = (thing, body)
            if thing.hinge is not None:
                self._hang(thing, body)
        else:
            self._fixed[thing.name] = thing
            body = self._posts[thing.name] = pymunk.Body(body_type=pymunk.Body.STATIC)
            put(body, thing.place)
            self.space.add(body, *shapes_of(thing.parts, body, thing.name, FIXED))
        self._starts[thing.name] = thing.place
        self._changed()

    def _hang(self, thing: Thing, body: pymunk.Body) -> None:
        ground, hinge = self.space.static_body, thing.hinge
        assert hinge is not None
        angle = thing.place.theta
        limit = pymunk.RotaryLimitJoint(ground, body, angle + hinge.lower, angle + hinge.upper)
        self._doors[thing.name] = [pymunk.PivotJoint(ground, body, thing.place[:2]), limit]
        self.space.add(*self._doors[thing.name])

    @alone
    def spawn(self, model: RobotModel, name: str = "", place: Pose2D | None = None) -> Robot:
        """Add a robot, by default at the world's start. WorldError if the name is taken or something is in the way.

        >>> from coursekit.sim import Disc, RobotModel, World
        >>> simulation = Simulation(World("yard", (Thing("post", (Disc(0.0, 0.0, 0.3),)),)))
        >>> simulation.spawn(RobotModel("cart"), place=Pose2D(2.0, 0.0, 0.0)).place
        Pose2D(x=2.0, y=0.0, theta=0.0)
        >>> simulation.spawn(RobotModel("cart"), "other")  # doctest: +ELLIPSIS
        Traceback (most recent call last):
        coursekit.sim.errors.WorldError: ...
        """
        name = name or model.name
        self._free(name)
        at = self.world.start if place is None else Pose2D(*place)
        if not all(math.isfinite(part) for part in at):
            raise WorldError(f"cannot stand at {tuple(at)}", element=f"robot '{name}'", cure="Give numbers for x, y, yaw.")
        if model.fixed:
            body = pymunk.Body(body_type=pymunk.Body.STATIC)
        else:
            body = pymunk.Body(model.mass, moment(np.concatenate([part.corners() for part in model.parts]), model.mass))
        put(body, at)
        shapes = shapes_of(model.parts, body, name, ROBOT)
        if not model.fixed:
            self._check_room(name, shapes, at)
        robot = Robot(model, name, body, self.seed * 1000 + len(self.robots))
        body.robot = robot
        self.space.add(body, *shapes)
        self.robots[name] = robot
        self._starts[name] = at
        self._changed()
        return robot

    def _free(self, name: str) -> None:
        if name in self.robots or name in self.things or name in self._fixed:
            raise WorldError(f"there is a '{name}' already", file=self.world.file, cure="Give it another name.")

    def _check_room(self, name: str, shapes: list[Any], at: Pose2D) -> None:
        other = obstacle(self.space, shapes)
        if other is not None:
            where, start = f"x {at.x:.2f}, y {at.y:.2f}", self.world.start
            free = "beside it" if at[:2] == start[:2] else f"for example at {start.x:g}, {start.y:g}"
            raise WorldError(
                f"'{other.name}' is in the way at {where}", file=self.world.file, element=f"robot '{name}'",
                cure=f"Spawn it somewhere free, {free}.",
            )  # fmt: skip

    @alone
    def remove(self, name: str) -> None:
        """Remove a robot or object; LookupError suggests similar names."""
        body = self._body(name)
        self.space.remove(*self._doors.pop(name, []), *body.shapes, body)
        for table in (self.robots, self.things, self._fixed, self._posts, self._starts):
            table.pop(name, None)  # type: ignore[attr-defined]
        for robot in self.robots.values():
            robot.contacts.pop(name, None)
        self._changed()

    def names(self) -> list[str]:
        """Return the names of all fixed objects, movable objects and robots."""
        return [*self._fixed, *self.things, *self.robots]

    def _body(self, name: str) -> pymunk.Body:
        if name in self.robots:
            body: pymunk.Body = self.robots[name].body
            return body
        if name in self.things:
            return self.things[name][1]
        if name in self._posts:
            return self._posts[name]
        raise LookupError(f"there is no '{name}'. {known(name, self.names())}")

    def pose_of(self, name: str) -> Pose2D:
        """Return the current pose of a robot or object; LookupError suggests similar names."""
        if name in self._fixed:
            return self._fixed[name].place
        body = self._body(name)
        return Pose2D(body.position.x, body.position.y, body.angle)

    def start_of(self, name: str) -> Pose2D:
        """Return the initial pose of a robot or object, restored by a reset; LookupError suggests similar names."""
        if name not in self._starts:
            raise LookupError(f"there is no '{name}'. {known(name, self.names())}")
        return self._starts[name]

    def velocity_of(self, name: str) -> tuple[float, float, float]:
        """Return the velocity in the world's frame: m/s, m/s, rad/s."""
        body = self._body(name)
        return body.velocity.x, body.velocity.y, body.angular_velocity

    @alone
    def put(self, name: str, place: Pose2D, velocity: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> None:
        """Set the pose and velocity of a robot or object; LookupError suggests similar names.

        >>> from coursekit.sim import RobotModel, World
        >>> simulation = Simulation(World("plain"))
        >>> cart = simulation.spawn(RobotModel("cart"))
        >>> simulation.put("cart", Pose2D(1.0, 2.0, 0.5))
        >>> cart.place, simulation.start_of("cart")
        (Pose2D(x=1.0, y=2.0, theta=0.5), Pose2D(x=0.0, y=0.0, theta=0.0))
        """
        body = self._body(name)
        put(body, place)
        if name in self._fixed:
            thing = self._fixed[name]
            self._fixed[name] = Thing(thing.name, thing.parts, place, texture=thing.texture, colour=thing.colour)
            self._changed()
        else:
            body.velocity, body.angular_velocity = velocity[:2], velocity[2]
        self.space.reindex_shapes_for_body(body)

    @alone
    def reshape(self, name: str, parts: tuple[Part, ...]) -> None:
        """Replace a robot's parts: its arm has moved. LookupError suggests similar names."""
        body = self._body(name)
        robot = self.robots[name]
        for shape in list(body.shapes):
            self.space.remove(shape)
            shape.body = None  # otherwise the body still lists it
        robot.model = replace(robot.model, parts=parts)
        robot.contacts.clear()
        self.space.add(*shapes_of(parts, body, name, ROBOT))
        self.space.reindex_shapes_for_body(body)
        self._changed()

    @alone
    def reset(self, time: bool = True) -> None:
        """Reset everything to its initial pose; with `time` the clock too."""
        for name, place in self._starts.items():
            thing = self.things[name][0] if name in self.things else None
            if name not in self._fixed:
                self.put(name, place, thing.velocity if thing else (0.0, 0.0, 0.0))
        for robot in self.robots.values():
            robot.restart()
        self.pushes.clear()
        if time:
            self.now_ns = 0

    def fixed_things(self) -> list[Thing]:
        """Return the fixed objects, at their current poses."""
        return list(self._fixed.values())

    def _changed(self) -> None:
        self.changes += 1
        self._scenes.clear()

    # -- time

    def advance(self, seconds: float) -> None:
        """Advance the time."""
        self.advance_to(self.now_ns + round(seconds * 1e9))

    @alone
    def advance_to(self, time_ns: int) -> None:
        """Take whole steps until less than one is left."""
        while time_ns - self.now_ns >= STEP_NS:
            self._step()

    def _step(self) -> None:
        for robot in self.robots.values():
            robot.before_step(_DT, self.now_ns)
        for thing, body in self.things.values():
            if thing.walk is not None:
                follow(body, thing.walk.at((self.now_ns + STEP_NS) * 1e-9), _DT)
            elif thing.mass != math.inf and (body.velocity.length or body.angular_velocity):
                drag(body, thing.friction if thing.hinge is None else 0.1, _DT)
        if self.pushes:
            self._push()
        self.space.step(_DT)
        self.now_ns += STEP_NS

    def _push(self) -> None:
        there = {*self.robots, *self.things}
        self.pushes[:] = [push for push in self.pushes if push.name in there and not push.is_over(self.now_ns)]
        for push in self.pushes:
            if push.begin_ns <= self.now_ns:
                push.work(self._body(push.name))

    # -- sensing

    def scan(self, lidar: Lidar, robot: Robot | str | None = None, place: Pose2D | None = None) -> Array:
        """Return true distances for a LiDAR on a robot (or at a `place` in the world); it sees robots and loose objects.

        >>> from coursekit.sim import Disc, Lidar, World
        >>> simulation = Simulation(World("yard", (Thing("post", (Disc(3.0, 0.0, 0.5),)),)))
        >>> simulation.scan(Lidar(beams=1, angle_min=0.0), place=Pose2D(1.0, 0.0, 0.0)).tolist()
        [1.5]
        """
        carrier = self.robots[robot] if isinstance(robot, str) else robot
        at = place if place is not None else (carrier.place if carrier is not None else Pose2D()) @ lidar.mount
        return self.scene(lidar.height).look(lidar, at, carrier.body if carrier is not None else None)

    def scene(self, height: float) -> OutlineScene:
        """Return the outlines at a height, cached until an object is added or removed."""
        if height not in self._scenes:
            fixed = [thing.cut(height).moved(thing.place) for thing in self._fixed.values()]
            loose = [(body, thing.cut(height)) for thing, body in self.things.values()]
            loose += [(robot.body, OutlineScene.cut_of(robot.model.parts, height)) for robot in self.robots.values()]
            self._scenes[height] = OutlineScene(fixed, loose)
        return self._scenes[height]


__all__ = ["STEP_NS", "Simulation"]
