"""The buffer: who is whose child, since when, and where."""

from __future__ import annotations

import _thread
import sys
from collections.abc import Callable, Iterable
from typing import NamedTuple

from . import describe, errors
from .cache import FrameCache
from .path import Path
from .pose import IDENTITY, Pose, canonical, compose, inverse, normalized
from .walk import common_time, walk

DEFAULT_CACHE_NS = 10_000_000_000
"""How much of the past is kept: ten seconds."""

UNIT_TOLERANCE = 10e-3
"""How far a quaternion's squared length may be from 1."""


class Lookup(NamedTuple):
    """A pose, and the time (nanoseconds) it holds for."""

    pose: Pose
    stamp: int


def to_stderr(level: str, text: str) -> None:
    """Print a complaint as tf2's logger does."""
    print(f"{level + ':':<9}{text}", file=sys.stderr)


class FrameBuffer:
    """Poses of frames in their parents over time, and what follows from them.

    Complaints about data that is ignored go to `report(level, text)`.

    >>> buffer = FrameBuffer()
    >>> for second in (1, 2):
    ...     _ = buffer.set("map", "robot", second * 10**9, (float(second), 0.0, 0.0, 0.0, 0.0, 0.0, 1.0))
    >>> buffer.lookup("map", "robot", 1_500_000_000).pose[0]
    1.5
    >>> buffer.lookup("robot", "map").pose[0]
    -2.0
    """

    def __init__(self, cache_ns: int = DEFAULT_CACHE_NS, report: Callable[[str, str], None] = to_stderr) -> None:
        self.cache_ns = cache_ns
        self.report = report
        self.frames: dict[str, FrameCache | None] = {}
        self.authorities: dict[str, str] = {}
        self.version = 0
        self._paths: dict[tuple[str, str], Path] = {}
        self._lock = _thread.allocate_lock()

    # -- filling

    def set(
        self,
        parent: str,
        child: str,
        stamp: int,
        pose: Pose,
        authority: str = "default_authority",
        *,
        static: bool = False,
    ) -> bool:
        """Tell the pose of `child` in `parent` at a time; False when it is ignored (`report` says why)."""
        if parent[:1] == "/":
            parent = parent[1:]
        if child[:1] == "/":
            child = child[1:]
        x, y, z, i, j, k, w = pose
        off = i * i + j * j + k * k + w * w - 1.0
        if not -1e-12 < off < 1e-12 or parent == child or not parent or not child or x + y + z != x + y + z:
            faults = list(_faults(parent, child, pose, authority))
            for fault in faults:
                self.report("Error", fault)
            if faults:
                return False
            pose = normalized(pose)
        with self._lock:
            cache = self.frames.get(child)
            if static or cache is None or not cache.follow(stamp, pose, parent):
                kept = self._insert(parent, child, stamp, pose, static)
            else:
                kept = True
            if kept:
                self.authorities[child] = authority
                self.version += 1
        if not kept:
            self.report(
                "Warning",
                f"TF_OLD_DATA ignoring data from the past for frame {child} at time {errors.seconds_text(stamp)} "
                f"according to authority {authority}\n"
                "Possible reasons are listed at http://wiki.ros.org/tf/Errors%20explained",
            )
        return kept

    def set_static(self, parent: str, child: str, pose: Pose, authority: str = "default_authority") -> bool:
        """Tell the pose of `child` in `parent` for all times."""
        return self.set(parent, child, 0, pose, authority, static=True)

    def extend(self, samples: Iterable[tuple[str, str, int, Pose]]) -> None:
        """`set` for each (parent, child, stamp, pose); the next of a moving frame, which nearly all are, costs less."""
        others: list[tuple[str, str, int, Pose]] = []
        with self._lock:
            for sample in samples:
                parent, child, stamp, pose = sample
                x, y, z, i, j, k, w = pose
                cache = self.frames.get(child)
                sound = -1e-12 < i * i + j * j + k * k + w * w - 1.0 + 0.0 * (x + y + z) < 1e-12  # no for what is NaN
                if sound and not others and cache is not None and cache.follow(stamp, pose, parent):
                    self.authorities[child] = "default_authority"
                else:
                    others.append(sample)
            self.version += 1
        for sample in others:
            self.set(*sample)

    def _insert(self, parent: str, child: str, stamp: int, pose: Pose, static: bool) -> bool:
        frames = self.frames
        cache = frames.get(child)
        if cache is None or cache.static != static:
            cache = frames[child] = FrameCache(child, self.cache_ns, static=static)
            self._paths.clear()
        straight, before = cache.single_parent, cache.newest_pose
        was = cache.parents[-1] if cache.parents else None
        if not cache.insert(stamp, pose, parent):
            return False
        if was != parent or not straight or not cache.single_parent or (static and before != pose):
            self._paths.clear()
        if parent not in frames:
            frames[parent] = None
        return True

    def clear(self) -> None:
        """Forget all that moves; static frames and the names of all frames stay."""
        with self._lock:
            for cache in self.frames.values():
                if cache is not None:
                    cache.clear()
            self._paths.clear()
            self.version += 1

    # -- asking

    def lookup(self, target: str, source: str, time: int = 0) -> Lookup:
        """The pose of `source` in `target` at a time; 0 is the newest time that all frames between them have.

        Raises LookupException, ConnectivityException, ExtrapolationException or InvalidArgumentException.
        """
        with self._lock:
            return Lookup(*self.find(target, source, time))

    def lookup_full(self, target: str, target_time: int, source: str, source_time: int, fixed: str) -> Lookup:
        """Where `source` was at `source_time`, seen from `target` at `target_time`, if `fixed` did not move."""
        with self._lock:
            for name, frame in (("target_frame", target), ("source_frame", source), ("fixed_frame", fixed)):
                self.require(f"lookupTransform argument {name}", frame)
            then, _ = self.find(fixed, source, source_time)
            now, stamp = self.find(target, fixed, target_time)
            return Lookup(canonical(compose(now, then)), stamp)

    def find(self, target: str, source: str, time: int) -> tuple[Pose, int]:
        """`lookup` for callers that hold the lock."""
        path = self._paths.get((target, source))
        if path is None:
            return self._explore(target, source, time)
        if path.version == self.version and path.asked == time:
            return path.found
        found = path.solve(time)
        if found is None:
            return self._explore(target, source, time)
        path.version, path.asked, path.found = self.version, time, found
        return found

    def _explore(self, target: str, source: str, time: int) -> tuple[Pose, int]:
        """The lookup by walking the tree; what is found is kept as a path."""
        if target == source:
            cache = self.frames.get(target)
            return IDENTITY, cache.newest if cache is not None and not time else time
        self.require("lookupTransform argument target_frame", target)
        self.require("lookupTransform argument source_frame", source)
        up, down, time = walk(self.frames, target, source, time)
        if all(cache.single_parent for cache in (*up, *down)):
            if len(self._paths) > 4096:
                self._paths.clear()
            path = self._paths[target, source] = Path(up, down)
            found = path.solve(time)
            assert found is not None
            return found
        pose = IDENTITY
        for cache in up:
            pose = compose(cache.at(time) or IDENTITY, pose)
        lower = IDENTITY
        for cache in down:
            lower = compose(cache.at(time) or IDENTITY, lower)
        return canonical(compose(inverse(lower), pose)), time

    def can(self, target: str, source: str, time: int = 0) -> tuple[bool, str]:
        """Whether `lookup` would succeed, and why not."""
        if target == source:
            return True, ""
        fault = self._unusable("canTransform", target_frame=target, source_frame=source)
        return (False, fault) if fault else self._try(target, source, time)

    def can_full(self, target: str, target_time: int, source: str, source_time: int, fixed: str) -> tuple[bool, str]:
        """Whether `lookup_full` would succeed, and why not."""
        fault = self._unusable("canTransform", target_frame=target, source_frame=source, fixed_frame=fixed)
        if fault:
            return False, fault
        found = self._try(target, fixed, target_time)
        return self._try(fixed, source, source_time) if found[0] else found

    def _try(self, target: str, source: str, time: int) -> tuple[bool, str]:
        try:
            with self._lock:
                self.find(target, source, time)
        except errors.TransformException as error:
            return False, str(error)
        return True, ""

    def _unusable(self, function: str, **frames: str) -> str:
        for argument, frame in frames.items():
            reason = errors.invalid_name(frame) or ("" if frame in self.frames else "frame does not exist")
            if reason:
                return f'Invalid frame ID "{frame}" passed to {function} argument {argument} - {reason}'
        return ""

    def require(self, argument: str, frame: str) -> None:
        """Raise InvalidArgumentException or LookupException for a frame that cannot be looked up."""
        if frame in self.frames:
            return
        reason = errors.invalid_name(frame)
        if reason:
            raise errors.InvalidArgumentException(f'Invalid argument "{frame}" passed to {argument} - {reason}')
        raise errors.LookupException(f'"{frame}" passed to {argument} does not exist. ')

    # -- the tree

    def latest_common_time(self, target: str, source: str) -> int:
        """The newest time at which `lookup` succeeds; 0 when only static frames lie between."""
        with self._lock:
            return common_time(self.frames, target, source)

    def chain(self, target: str, target_time: int, source: str, source_time: int, fixed: str) -> list[str]:
        """The frames passed from `source` by way of `fixed` to `target`."""
        with self._lock:
            for name, frame in (("target_frame", target), ("source_frame", source), ("fixed_frame", fixed)):
                self.require(f"_chainAsVector argument {name}", frame)
            first = self._steps(fixed, source, source_time)
            second = self._steps(target, fixed, target_time)
        return first + second[1:] if first and second and first[-1] == second[0] else first + second

    def _steps(self, target: str, source: str, time: int) -> list[str]:
        if target == source:
            return []
        up, down, _ = walk(self.frames, target, source, time)
        top = up[-1].parent if up else source
        return [*(cache.name for cache in up), str(top), *(cache.name for cache in reversed(down))]

    def parent(self, frame: str, time: int = 0) -> str | None:
        """The parent of a frame at a time; None for a root and outside of what is held."""
        with self._lock:
            cache = self.frames.get(frame)
            return None if cache is None else cache.parent_at(time)

    def all_frames_as_string(self) -> str:
        """A line for each frame that has a parent."""
        with self._lock:
            return describe.as_string(self.frames)

    def all_frames_as_yaml(self, now: int = 0) -> str:
        """Each frame with its parent, broadcaster, rate and times."""
        with self._lock:
            return describe.as_yaml(self.frames, self.authorities, now)

    def all_frames_as_dot(self, now: int = 0) -> str:
        """The tree for Graphviz."""
        with self._lock:
            return describe.as_dot(self.frames, self.authorities, now)


def _faults(parent: str, child: str, pose: Pose, authority: str):  # type: ignore[no-untyped-def]
    """Why data must be ignored."""
    if child == parent:
        yield (
            f'TF_SELF_TRANSFORM: Ignoring transform from authority "{authority}" with frame_id and  '
            f'child_frame_id "{child}" because they are the same'
        )
    if not child:
        yield f'TF_NO_CHILD_FRAME_ID: Ignoring transform from authority "{authority}" because child_frame_id not set '
    if not parent:
        yield (
            f'TF_NO_FRAME_ID: Ignoring transform with child_frame_id "{child}"  from authority "{authority}" '
            "because frame_id not set"
        )
    place = " ".join(f"{number:f}" for number in pose[:3])
    turn = " ".join(f"{number:f}" for number in pose[3:])
    if any(number != number for number in pose):
        yield (
            f'TF_NAN_INPUT: Ignoring transform for child_frame_id "{child}" from authority "{authority}" because '
            f"of a nan value in the transform ({place}) ({turn})"
        )
    if not abs(sum(part * part for part in pose[3:]) - 1.0) < UNIT_TOLERANCE:
        yield (
            f'TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id "{child}" from authority '
            f'"{authority}" because of an invalid quaternion in the transform ({turn})'
        )


__all__ = ["DEFAULT_CACHE_NS", "FrameBuffer", "Lookup"]
