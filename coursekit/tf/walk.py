"""Walking the tree step by step at a given time, with tf2's reasons for failing."""

from __future__ import annotations

from collections.abc import Mapping

from . import errors
from .cache import FrameCache
from .describe import as_string

Frames = Mapping[str, "FrameCache | None"]
"""Every known frame; None for a frame without a known pose (the root of a tree)."""

DEEPEST = 1000
"""More steps than this mean that the tree has a loop."""


def walk(frames: Frames, target: str, source: str, time: int) -> tuple[list[FrameCache], list[FrameCache], int]:
    """Edges from the source, and from the target, up to their common ancestor; and the time (0 resolved).

    The parents are those at that time. Raises as a lookup does.

    >>> map_, laser = FrameCache("robot", 10**10), FrameCache("laser", 10**10, static=True)
    >>> here = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
    >>> _ = map_.insert(5, here, "map"), laser.insert(0, here, "robot")
    >>> up, down, time = walk({"map": None, "robot": map_, "laser": laser}, "map", "laser", 0)
    >>> [edge.name for edge in up], down, time
    (['laser', 'robot'], [], 5)
    """
    if not time:
        time = common_time(frames, target, source)
    up: list[FrameCache] = []
    reason: str | None = None
    frame = source
    while (cache := frames[frame]) is not None:
        parent = cache.parent_at(time)
        if parent is None:  # the target may be on the part already walked
            reason = cache.why_not(time)
            break
        if frame == target:
            return up, [], time
        up.append(cache)
        frame = parent
        _check_depth(frames, up)
    return *_meet(frames, up, frame, target, source, time, reason), time


def _meet(
    frames: Frames, up: list[FrameCache], top: str, target: str, source: str, time: int, reason: str | None
) -> tuple[list[FrameCache], list[FrameCache]]:
    """Walk from the target to `top`, where the walk from the source ended."""
    down: list[FrameCache] = []
    frame = target
    while frame != top and (cache := frames[frame]) is not None:
        parent = cache.parent_at(time)
        if parent is None:
            raise errors.ExtrapolationException(errors.looking_up(cache.why_not(time), target, source))
        if frame == source:
            return [], down
        down.append(cache)
        frame = parent
        _check_depth(frames, down)
    if frame != top and reason is not None:
        raise errors.ExtrapolationException(errors.looking_up(reason, target, source))
    if frame != top:
        raise errors.ConnectivityException(errors.unconnected(target, source))
    while up and down and up[-1] is down[-1]:
        up.pop()
        down.pop()
    return up, down


def common_time(frames: Frames, target: str, source: str) -> int:
    """Return the newest time at which source and target are connected; 0 with only static frames between them.

    >>> odom, robot, here = FrameCache("odom", 10**10), FrameCache("robot", 10**10), (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
    >>> _ = odom.insert(5, here, "map"), robot.insert(7, here, "odom")
    >>> common_time({"map": None, "odom": odom, "robot": robot}, "map", "robot")
    5
    """
    if source == target:
        cache = frames[source]
        return cache.newest if cache is not None else 0
    up = _newest_parents(frames, source, target)
    if up and up[-1][1] == target:
        return _least(stamp for stamp, _ in up)
    above = [parent for _, parent in up]
    down = _newest_parents(frames, target, source, *above)
    if down and down[-1][1] == source:
        return _least(stamp for stamp, _ in down)
    if not down or down[-1][1] not in above:
        raise errors.ConnectivityException(errors.unconnected(target, source))
    up = up[: above.index(down[-1][1]) + 1]
    return _least(stamp for stamp, _ in (*up, *down))


def _newest_parents(frames: Frames, frame: str, *ends: str) -> list[tuple[int, str]]:
    """(newest stamp, parent) of a frame, its parent, and so on, until a parent is one of `ends`, or the root."""
    steps: list[tuple[int, str]] = []
    while (cache := frames[frame]) is not None and cache.parent is not None:
        frame = cache.parent
        steps.append((cache.newest, frame))
        if frame in ends:
            break
        _check_depth(frames, steps)
    return steps


def _least(stamps: object) -> int:
    return min((stamp for stamp in stamps if stamp), default=0)  # type: ignore[attr-defined]


def _check_depth(frames: Frames, steps: list) -> None:  # type: ignore[type-arg]
    if len(steps) > DEEPEST:
        raise errors.LookupException(f"The tf tree is invalid because it contains a loop.\n{as_string(frames)}\n")
