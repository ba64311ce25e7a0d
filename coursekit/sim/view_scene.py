"""The objects that a camera sees in a simulation: upright edges with their looks, cached until objects change."""

from __future__ import annotations

from typing import Any
from weakref import WeakKeyDictionary

import numpy as np

from coursekit.geometry.plane import ORIGIN, Array, Pose2D

from .solids import Ball, Disc, Part, Skin, ring
from .textures import ROBOT_COLOUR, USUAL, all_textures, floor_of
from .world import TEXTURES, Thing

ROUND = 16
_kept: WeakKeyDictionary[Any, ViewScene] = WeakKeyDictionary()


class ViewScene:
    """The edges (n, 6) and looks (n, 4) of all objects; those of moving ones follow their bodies."""

    def __init__(self, simulation: Any) -> None:
        self.changes: int = simulation.changes
        fixed = [_thing(thing, thing.place) for thing in simulation.fixed_things()]
        self._fixed = np.concatenate([edges for edges, _ in fixed] or [np.zeros((0, 6))])
        self._looks = np.concatenate([looks for _, looks in fixed] or [np.zeros((0, 4))])
        self._moving = [(body, *_thing(thing, ORIGIN)) for thing, body in simulation.things.values()]
        for robot in simulation.robots.values():
            edges = _edges(robot.model.parts)
            self._moving.append((robot.body, edges, np.tile((0.0, *ROBOT_COLOUR), (len(edges), 1))))
        self.textures = all_textures()
        self.floor = floor_of(simulation.world.floor)

    @staticmethod
    def of(simulation: Any) -> ViewScene:
        """Return the current scene of a simulation."""
        kept = _kept.get(simulation)
        if kept is None or kept.changes != simulation.changes:
            kept = _kept[simulation] = ViewScene(simulation)
        return kept

    def edges(self, without: Any) -> tuple[Array, Array]:
        """Return all current edges and looks, except those of one body."""
        edges, looks = [self._fixed], [self._looks]
        for body, local, look in self._moving:
            if body is not without:
                place = Pose2D(body.position.x, body.position.y, body.angle)
                moved = local.copy()
                moved[:, :4] = place.transform(local[:, :4].reshape(-1, 2)).reshape(-1, 4)
                edges.append(moved)
                looks.append(look)
        return np.concatenate(edges), np.concatenate(looks)


def _thing(thing: Thing, place: Pose2D) -> tuple[Array, Array]:
    edges = _edges(thing.parts)
    edges[:, :4] = place.transform(edges[:, :4].reshape(-1, 2)).reshape(-1, 4)
    red, green, blue = thing.colour or USUAL.get(thing.texture, (0.8, 0.8, 0.8))
    return edges, np.tile((float(TEXTURES.index(thing.texture)), blue, green, red), (len(edges), 1))


def _edges(parts: tuple[Part, ...]) -> Array:
    rows = []
    for part in parts:
        outline = _outline(part)
        rows.append(np.column_stack((outline, np.full(len(outline), part.low), np.full(len(outline), part.high))))
    return np.concatenate(rows) if rows else np.zeros((0, 6))


def _outline(part: Part) -> Array:
    if isinstance(part, (Disc, Ball)):
        turn = np.linspace(0, 2 * np.pi, ROUND, endpoint=False)
        return ring(np.column_stack((part.x + part.radius * np.cos(turn), part.y + part.radius * np.sin(turn))))
    if isinstance(part, Skin):
        return part.cut((part.low + part.high) / 2).edges
    return ring(np.array(part.points), part.closed)


__all__ = ["ViewScene"]
