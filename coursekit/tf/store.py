"""The known frames: their parents over time, and their transforms."""

from __future__ import annotations

import _thread
import sys
from collections.abc import Callable, Sequence

from coursekit.geometry.pose import Pose, are_units, normalized

from . import describe
from .cache import FrameCache
from .faults import faults, too_old
from .path import Path

DEFAULT_CACHE_NS = 10_000_000_000
"""Length of the history: ten seconds."""

Sample = tuple[str, str, int, Pose]
"""Parent, child, stamp [ns], and the child's pose in the parent."""


def to_stderr(level: str, text: str) -> None:
    """Print a warning or an error as tf2's logger does."""
    print(f"{level + ':':<9}{text}", file=sys.stderr)


class FrameStore:
    """Poses of frames in their parents over time. Warnings about ignored data go to `report(level, text)`.

    >>> store = FrameStore()
    >>> store.set("map", "robot", 10**9, (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)), store.parent("robot")
    (True, 'map')
    """

    def __init__(self, cache_ns: int = DEFAULT_CACHE_NS, report: Callable[[str, str], None] = to_stderr) -> None:
        self.cache_ns = cache_ns
        self.report = report
        self.frames: dict[str, FrameCache | None] = {}
        self.authorities: dict[str, str] = {}
        self.version = 0
        self._paths: dict[tuple[str, str], Path] = {}  # paths found by lookups, valid while the tree is unchanged
        self._lock = _thread.allocate_lock()

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
        """Set the pose of `child` in `parent` at a time [ns]; False when it is ignored (`report` gets the reason).

        A leading '/' of a name is dropped. A quaternion that is only nearly of length 1 is normalized.

        >>> store = FrameStore(report=lambda level, text: print(text))
        >>> store.set("map", "map", 10**9, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0))  # doctest: +ELLIPSIS
        TF_SELF_TRANSFORM: Ignoring transform from authority "default_authority" ... because they are the same
        False
        """
        if parent[:1] == "/":
            parent = parent[1:]
        if child[:1] == "/":
            child = child[1:]
        x, y, z, i, j, k, w = pose
        off = i * i + j * j + k * k + w * w - 1.0
        if not -1e-12 < off < 1e-12 or parent == child or not parent or not child or x + y + z != x + y + z:
            reasons = list(faults(parent, child, pose, authority))
            for fault in reasons:
                self.report("Error", fault)
            if reasons:
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
            self.report("Warning", too_old(child, stamp, authority))
        return kept

    def set_static(self, parent: str, child: str, pose: Pose, authority: str = "default_authority") -> bool:
        """Set the pose of `child` in `parent` for all times."""
        return self.set(parent, child, 0, pose, authority, static=True)

    def extend(self, samples: Sequence[Sample]) -> None:
        """`set` for each sample; samples of moving frames are added in batches per frame, at a fraction of the cost.

        >>> store = FrameStore()
        >>> store.extend([("map", "robot", stamp, (float(stamp), 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)) for stamp in (1, 2, 3)])
        >>> store.frames["robot"].stamps
        [1, 2, 3]
        """
        by_child: dict[str, list[Sample]] = {}
        for sample in samples:
            by_child.setdefault(sample[1], []).append(sample)
        if any(child[:1] == "/" for child in by_child):  # two names may mean one frame: the order matters
            others = [samples]
        else:
            with self._lock:
                others = [batch for child, batch in by_child.items() if not self._follow(child, batch)]
                self.version += 1
        for batch in others:
            for sample in batch:
                self.set(*sample)

    def _follow(self, child: str, batch: Sequence[Sample]) -> bool:
        """Add a batch of newer samples of a moving frame; False, with none added, when the batch does not qualify."""
        cache = self.frames.get(child)
        if cache is None:
            return False
        parents, _, stamps, poses = zip(*batch, strict=True)
        if not (are_units(poses) and cache.follow_all(stamps, poses, parents)):
            return False
        self.authorities[child] = "default_authority"
        return True

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
        """Drop the samples of moving frames; static frames and all frame names remain.

        >>> store, here = FrameStore(), (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
        >>> _ = store.set("map", "robot", 10**9, here), store.set_static("robot", "laser", here)
        >>> store.clear()
        >>> store.parent("robot"), store.parent("laser")
        (None, 'robot')
        """
        with self._lock:
            for cache in self.frames.values():
                if cache is not None:
                    cache.clear()
            self._paths.clear()
            self.version += 1

    # -- inspection

    def parent(self, frame: str, time: int = 0) -> str | None:
        """Return the parent of a frame at a time; None for a root and outside of the span of the cache."""
        with self._lock:
            cache = self.frames.get(frame)
            return None if cache is None else cache.parent_at(time)

    def all_frames_as_string(self) -> str:
        """A line for each frame that has a parent."""
        with self._lock:
            return describe.as_string(self.frames)

    def all_frames_as_yaml(self, now: int = 0) -> str:
        r"""Each frame with its parent, broadcaster, rate and times.

        >>> store = FrameStore()
        >>> _ = store.set("map", "robot", 10**9, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0), authority="odometry")
        >>> print("\n".join(store.all_frames_as_yaml(now=3 * 10**9).splitlines()[1:]))
          parent: 'map'
          broadcaster: 'odometry'
          rate: 10000.000
          most_recent_transform: 1.000000
          oldest_transform: 1.000000
          transform_delay: 2.000
          buffer_length: 0.000
        """
        with self._lock:
            return describe.as_yaml(self.frames, self.authorities, now)

    def all_frames_as_dot(self, now: int = 0) -> str:
        """The tree in Graphviz's language."""
        with self._lock:
            return describe.as_dot(self.frames, self.authorities, now)
