"""The buffer: the pose of any frame in any other, at any time that the buffer covers."""

from __future__ import annotations

from typing import NamedTuple

from coursekit.geometry.pose import IDENTITY, Pose, canonical, compose, inverse

from . import errors
from .path import Path
from .store import FrameStore
from .walk import common_time, walk


class Lookup(NamedTuple):
    """A pose and the time (nanoseconds) for which it holds."""

    pose: Pose
    stamp: int


class FrameBuffer(FrameStore):
    """A tree of frames; it derives the pose of any frame in any other.

    >>> buffer = FrameBuffer()
    >>> for second in (1, 2):
    ...     _ = buffer.set("map", "robot", second * 10**9, (float(second), 0.0, 0.0, 0.0, 0.0, 0.0, 1.0))
    >>> buffer.lookup("map", "robot", 1_500_000_000).pose[0]
    1.5
    >>> buffer.lookup("robot", "map").pose[0]
    -2.0
    """

    def lookup(self, target: str, source: str, time: int = 0) -> Lookup:
        """Return the pose of `source` in `target` at a time; 0 is the newest time common to all frames between them.

        Raises LookupException, ConnectivityException, ExtrapolationException or InvalidArgumentException.

        >>> buffer = FrameBuffer()
        >>> _ = buffer.set_static("map", "dock", IDENTITY), buffer.set_static("odom", "robot", IDENTITY)
        >>> buffer.lookup("map", "robot")  # doctest: +ELLIPSIS
        Traceback (most recent call last):
        tf2.ConnectivityException: Could not find a connection between 'map' and 'robot' because they are not part of ...
        """
        with self._lock:
            return Lookup(*self.find(target, source, time))

    def lookup_full(self, target: str, target_time: int, source: str, source_time: int, fixed: str) -> Lookup:
        """Return the pose of `source` at `source_time` in `target` at `target_time`, assuming that `fixed` did not move.

        Times in nanoseconds. Raises as `lookup` does.

        >>> buffer = FrameBuffer()
        >>> for second in (1, 2):
        ...     _ = buffer.set("map", "robot", second * 10**9, (float(second), 0.0, 0.0, 0.0, 0.0, 0.0, 1.0))
        >>> buffer.lookup_full("robot", 2 * 10**9, "robot", 10**9, "map").pose[0]  # a second ago it was a metre behind
        -1.0
        """
        with self._lock:
            for name, frame in (("target_frame", target), ("source_frame", source), ("fixed_frame", fixed)):
                self.require(f"lookupTransform argument {name}", frame)
            then, _ = self.find(fixed, source, source_time)
            now, stamp = self.find(target, fixed, target_time)
            return Lookup(canonical(compose(now, then)), stamp)

    def find(self, target: str, source: str, time: int) -> tuple[Pose, int]:
        """`lookup` for callers that already hold the lock."""
        path = self._paths.get((target, source))
        if path is None:
            return self._explore(target, source, time)
        if path.version == self.version and path.asked == time:
            return path.found
        stamped = path.solve(time)
        if stamped is None:
            return self._explore(target, source, time)
        path.version, path.asked, path.found = self.version, time, stamped
        return stamped

    def _explore(self, target: str, source: str, time: int) -> tuple[Pose, int]:
        """Look up by walking the tree; the path found is cached."""
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
            stamped = path.solve(time)
            assert stamped is not None
            return stamped
        pose = IDENTITY
        for cache in up:
            pose = compose(cache.at(time) or IDENTITY, pose)
        lower = IDENTITY
        for cache in down:
            lower = compose(cache.at(time) or IDENTITY, lower)
        return canonical(compose(inverse(lower), pose)), time

    def can(self, target: str, source: str, time: int = 0) -> tuple[bool, str]:
        """Return whether `lookup` would succeed, and if not, why.

        >>> buffer = FrameBuffer()
        >>> _ = buffer.set("map", "robot", 10**9, IDENTITY)
        >>> buffer.can("map", "robot"), buffer.can("map", "robot", 2 * 10**9)[0]
        ((True, ''), False)
        """
        if target == source:
            return True, ""
        fault = self._unusable("canTransform", target_frame=target, source_frame=source)
        return (False, fault) if fault else self._try(target, source, time)

    def can_full(self, target: str, target_time: int, source: str, source_time: int, fixed: str) -> tuple[bool, str]:
        """Return whether `lookup_full` would succeed, and if not, why."""
        fault = self._unusable("canTransform", target_frame=target, source_frame=source, fixed_frame=fixed)
        if fault:
            return False, fault
        first = self._try(target, fixed, target_time)
        return self._try(fixed, source, source_time) if first[0] else first

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
        """Return the newest time at which `lookup` succeeds; 0 when there are only static frames between the two.

        >>> buffer = FrameBuffer()
        >>> _ = buffer.set("map", "odom", 5 * 10**9, IDENTITY), buffer.set("odom", "robot", 7 * 10**9, IDENTITY)
        >>> buffer.latest_common_time("map", "robot")
        5000000000
        """
        with self._lock:
            return common_time(self.frames, target, source)

    def chain(self, target: str, target_time: int, source: str, source_time: int, fixed: str) -> list[str]:
        """Return the frames along the path from `source` via `fixed` to `target`.

        >>> buffer = FrameBuffer()
        >>> _ = buffer.set_static("map", "odom", IDENTITY), buffer.set_static("odom", "robot", IDENTITY)
        >>> buffer.chain("map", 0, "robot", 0, "odom")
        ['robot', 'odom', 'map']
        """
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
