"""The path between two frames, cached for the next lookup."""

from __future__ import annotations

from collections.abc import Sequence
from math import sin

from coursekit.geometry.pose import IDENTITY, Pose, between, canonical, compose, inverse

from .cache import FrameCache


class Path:
    """Edges from the source up to the common ancestor, and from the target up to it.

    It is valid until a frame on it gets another parent or a static frame on it changes. Neighbouring static edges are
    folded into one. `version`, `asked` and `found` remember the last lookup.
    """

    __slots__ = ("asked", "down", "found", "moving", "up", "version")

    def __init__(self, up: Sequence[FrameCache], down: Sequence[FrameCache]) -> None:
        self.up = _fold(up)
        self.down = _fold(down)
        self.moving = [cache for cache in (*up, *down) if not cache.static]
        self.version = -1
        self.asked = 0
        self.found: tuple[Pose, int] = (IDENTITY, 0)

    def solve(self, time: int) -> tuple[Pose, int] | None:
        """The pose of the source in the target, and its stamp; None when an edge has no pose at that time.

        >>> robot = FrameCache("robot", 10**10)
        >>> for second, x in ((1, 0.0), (2, 1.0)):
        ...     _ = robot.insert(second * 10**9, (x, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0), "map")
        >>> Path([robot], []).solve(1_250_000_000)[0][0], Path([], [robot]).solve(1_250_000_000)[0][0]
        (0.25, -0.25)
        """
        if not time:
            time = latest_common(self.moving)
        if not self.up:
            lower = product(self.down, time)
            return None if lower is None else (canonical(inverse(lower)), time)
        pose = product(self.up, time)
        if pose is not None and self.down:
            lower = product(self.down, time)
            pose = None if lower is None else between(lower, pose)
        return None if pose is None else (canonical(pose), time)


def latest_common(moving: Sequence[FrameCache]) -> int:
    """The newest time common to all of these frames; 0 when there is none.

    >>> odom, robot, here = FrameCache("odom", 10**10), FrameCache("robot", 10**10), (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
    >>> _ = odom.insert(5, here, "map"), robot.insert(7, here, "odom")
    >>> latest_common([odom, robot])
    5
    """
    latest = 0
    for cache in moving:
        newest = cache.newest
        if newest and (not latest or newest < latest):
            latest = newest
    return latest


def product(edges: Sequence[FrameCache], time: int) -> Pose | None:
    """The pose of the first edge's frame in the parent of the last.

    This is `compose` over the edges, inlined: half of a lookup's time is spent here.
    """
    following = iter(edges)
    first = next(following)
    pose = first.newest_pose if first.newest == time or first.static else first.between(time)
    if pose is None:
        return None
    x, y, z, bi, bj, bk, bw = pose
    for edge in following:
        if edge.since < time < edge.until:  # `interpolate`, inlined too
            ax, dx, ay, dy, az, dz, i, j, k, w, ni, nj, nk, nw, angle = edge.segment
            ratio = (time - edge.since) / (edge.until - edge.since)
            turned = ratio * angle
            p = sin(angle - turned)
            r = sin(turned)
            ax += ratio * dx
            ay += ratio * dy
            az += ratio * dz
            i = p * i + r * ni
            j = p * j + r * nj
            k = p * k + r * nk
            w = p * w + r * nw
        else:
            pose = edge.newest_pose if edge.newest == time or edge.static else edge.between(time)
            if pose is None:
                return None
            ax, ay, az, i, j, k, w = pose
        t = j * z - k * y
        u = k * x - i * z
        v = i * y - j * x
        t += t
        u += u
        v += v
        x += ax + w * t + j * v - k * u
        y += ay + w * u + k * t - i * v
        z += az + w * v + i * u - j * t
        bi, bj, bk, bw = (
            w * bi + i * bw + j * bk - k * bj,
            w * bj + j * bw + k * bi - i * bk,
            w * bk + k * bw + i * bj - j * bi,
            w * bw - i * bi - j * bj - k * bk,
        )
    return x, y, z, bi, bj, bk, bw


def _fold(edges: Sequence[FrameCache]) -> list[FrameCache]:
    folded: list[FrameCache] = []
    for edge in edges:
        if edge.static and folded and folded[-1].static:
            both = FrameCache(edge.name, edge.span_ns, static=True)
            both.insert(0, compose(edge.newest_pose, folded[-1].newest_pose), edge.parents[-1])
            folded[-1] = both
        else:
            folded.append(edge)
    return folded
