"""Loop closing: finding keyframes in older submaps."""

from __future__ import annotations

import math
from collections import OrderedDict
from dataclasses import dataclass

import numpy as np

from coursekit.geometry.plane import Array, Pose2D
from coursekit.slam.contradiction import Usual, contradiction
from coursekit.slam.graph import PoseGraph
from coursekit.slam.keyframe import Keyframe
from coursekit.slam.loop_field import LoopField
from coursekit.slam.matcher import sample
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.refine import refine
from coursekit.slam.shortest_paths import shortest_ways
from coursekit.slam.submap import Submap

WITNESSES = 4
"""Number of a submap's keyframes with which a loop is compared."""


@dataclass(frozen=True)
class Loop:
    """A keyframe found in a submap: the motion from one of the submap's keyframes to it."""

    first: int
    second: int
    motion: Pose2D
    precision: Array
    score: float


class LoopSearch:
    """Searches for loops among finished submaps; a loop is accepted once a second one agrees with it.

    `keyframes` is SLAM's own list: scans that look through each other's walls are not a loop.
    """

    def __init__(self, params: SlamParameters, keyframes: list[Keyframe]) -> None:
        self.params = params
        self._keyframes = keyframes
        self._usual = Usual()
        self.submaps: list[Submap] = []
        self._fields: OrderedDict[int, tuple[LoopField, Submap]] = OrderedDict()
        self._pending: list[Loop] = []
        self.rejected = 0
        self._members = np.zeros(0, dtype=np.int64)
        self._starts = np.zeros(1, dtype=np.int64)

    def add(self, submap: Submap) -> None:
        """Add a finished submap for later searches."""
        self.submaps.append(submap)
        self._members = np.concatenate([self._members, np.fromiter(submap.members, dtype=np.int64)])
        self._starts = np.append(self._starts, len(self._members))

    def search(self, keyframe: Keyframe, graph: PoseGraph) -> list[Loop]:
        """Return the loops that this keyframe confirms."""
        if not self.submaps or not self.params.matching or not self.params.loop_candidates:
            return []
        ways = _ways(graph, keyframe.number)
        self._usual.learn(self._keyframes, graph.poses)
        loops = []
        for submap, near in self._candidates(keyframe.number, graph, ways):
            loop = self._try(keyframe, submap, near, graph, float(ways[near]))
            if loop is not None:
                loops.append(loop)
        return self._settle(loops, graph)

    def _candidates(self, number: int, graph: PoseGraph, ways: Array) -> list[tuple[Submap, int]]:
        """Return submaps whose keyframes may be near, nearest first, with the nearest keyframe of each."""
        p, members = self.params, self._members
        gaps = np.hypot(*(graph.poses[members, :2] - graph.poses[number, :2]).T)
        starts = self._starts[:-1]
        shortest = np.minimum.reduceat(ways[members], starts)
        nearest = np.minimum.reduceat(gaps, starts)
        reach = p.loop_view + np.minimum(0.5 + p.loop_drift * shortest, p.loop_distance)
        ranked = np.argsort(nearest, kind="stable")
        chosen = ranked[((shortest > p.loop_least_way) & (nearest < reach))[ranked]][: p.loop_candidates]
        spans = [(int(k), slice(self._starts[k], self._starts[k + 1])) for k in chosen]
        return [(self.submaps[k], int(members[span][np.argmin(gaps[span])])) for k, span in spans]

    def _window(self, way: float) -> tuple[float, float]:
        """Return the possible error of the estimate after a path of this length [m], [rad]."""
        p = self.params
        return min(0.5 + p.loop_drift * way, p.loop_distance), min(0.2 + 0.3 * p.loop_drift * way, p.loop_angle)

    def _try(self, keyframe: Keyframe, submap: Submap, near: int, graph: PoseGraph, way: float) -> Loop | None:
        """Search one submap."""
        p = self.params
        guess = submap.members[near] @ graph.pose(near).to(graph.pose(keyframe.number))
        distance, angle = self._window(way)
        points = keyframe.scan.points
        pose, score = self._field(submap).find(sample(points, 100), guess, distance, angle, p.loop_angle_step, p.loop_score)
        if score <= p.loop_score:
            return None
        refined = refine(points, submap, pose, pose, np.zeros((3, 3)), gate=0.4, rounds=15)
        if refined.inliers < p.loop_inliers or refined.pose.distance(pose) > 0.4:
            return None
        nearest = sorted(submap.members, key=lambda m: (submap.members[m].distance(refined.pose), m))
        alike = self._field(submap).rival(sample(points, 100), refined.pose) > p.loop_rival
        if alike or self._contradicts(keyframe, submap, nearest[:WITNESSES], refined.pose):
            self.rejected += 1
            return None
        first = nearest[0]
        return Loop(
            first,
            keyframe.number,
            submap.members[first].to(refined.pose),
            loop_precision(refined.information),
            score,
        )

    def _contradicts(self, keyframe: Keyframe, submap: Submap, members: list[int], pose: Pose2D) -> bool:
        """Whether the keyframe, at a pose in a submap, sees through the submap's walls, or the submap through its walls."""
        pairs = [(self._keyframes[m].scan, keyframe.scan, submap.members[m].to(pose)) for m in members]
        return contradiction(pairs) > self._usual.limit

    def _field(self, submap: Submap) -> LoopField:
        """Return the fields of a submap; the most recently used ones are cached."""
        key = submap.anchor
        if key not in self._fields:
            self._fields[key] = (LoopField(submap.points[: submap.count], self.params.loop_cell), submap)
            submap.restore()
            if len(self._fields) > self.params.loop_fields:
                self._fields.popitem(last=False)[1][1].finish()
        self._fields.move_to_end(key)
        return self._fields[key][0]

    def _settle(self, loops: list[Loop], graph: PoseGraph) -> list[Loop]:
        """Return the loops that agree with another one; the others wait, and are dropped after a while."""
        settled: list[Loop] = []
        for loop in loops:
            friends = [other for other in self._pending if _agree(loop, other, graph)]
            if friends:
                settled += [loop, *friends]
                self._pending = [other for other in self._pending if other not in friends]
            else:
                self._pending.append(loop)
        if loops:
            newest = loops[-1].second
            old = [loop for loop in self._pending if loop.second < newest - self.params.loop_patience]
            self.rejected += len(old)
            self._pending = [loop for loop in self._pending if loop not in old]
        return settled


def _ways(graph: PoseGraph, number: int) -> Array:
    """Return the shortest path lengths [m] from a keyframe to all others; a radian of rotation counts as a metre."""
    edges = graph.edges
    lengths = np.hypot(edges.z[:, 0], edges.z[:, 1]) + np.abs(edges.z[:, 2]) + 1e-6
    ways: Array = shortest_ways(edges.i, edges.j, lengths, graph.size, number)
    return ways


def _agree(one: Loop, other: Loop, graph: PoseGraph) -> bool:
    """Whether two loops agree on the drift: the circle through both of them closes."""
    if one.second == other.second and abs(one.first - other.first) < 3:
        return False
    out, back = graph.pose(one.second), graph.pose(one.first)
    circle = one.motion @ out.to(graph.pose(other.second)) @ other.motion.inverse() @ graph.pose(other.first).to(back)
    way = out.distance(graph.pose(other.second)) + back.distance(graph.pose(other.first))
    return math.hypot(circle.x, circle.y) < 0.1 + 0.03 * way and abs(circle.theta) < 0.05 + 0.01 * way and way < 15.0


def loop_precision(information: Array) -> Array:
    """Return the precision of a match, at best 2 cm and half a degree: neighbouring points share their errors.

    >>> errors = np.sqrt(np.diag(np.linalg.inv(loop_precision(1e9 * np.eye(3)))))  # a match as sharp as none is
    >>> errors.round(3).tolist()
    [0.02, 0.02, 0.009]
    """
    floor = np.diag([0.02**2, 0.02**2, 0.009**2])
    return np.linalg.inv(np.linalg.inv(0.1 * information + np.diag([1.0, 1.0, 1.0])) + floor)
