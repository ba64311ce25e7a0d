"""The history of one frame in its parent."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from operator import lt

from coursekit.geometry.pose import IDENTITY, Pose, Segment, interpolate, segment

from . import errors


class FrameCache:
    """Poses of a frame by stamp, oldest first; samples older than `span_ns` before the newest are dropped.

    A static frame has one pose for all times. The parent may change: each sample has its own.

    >>> cache = FrameCache("robot", span_ns=10 * 10**9)
    >>> for second, x in ((1, 0.0), (3, 4.0)):
    ...     _ = cache.insert(second * 10**9, (x, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0), "map")
    >>> cache.at(2 * 10**9)[0], cache.at(4 * 10**9)
    (2.0, None)
    """

    __slots__ = (
        "_asked_after", "name", "newest", "newest_pose", "parents", "poses", "segment", "since", "single_parent", "span_ns",
        "stamps", "static", "until",
    )  # fmt: skip

    def __init__(self, name: str, span_ns: int, *, static: bool = False) -> None:
        self.name = name
        self.span_ns = span_ns
        self.static = static
        self._empty()

    def clear(self) -> None:
        """Drop the samples; a static frame keeps its pose, because it is published only once."""
        if not self.static:
            self._empty()

    def _empty(self) -> None:
        self.stamps: list[int] = []
        self.poses: list[Pose] = []
        self.parents: list[str] = []
        self.newest = 0
        self.newest_pose = IDENTITY
        self.single_parent = True
        self._forget_segment()

    def _forget_segment(self) -> None:
        """Forget `segment`: the motion between two samples with repeated lookups, valid for since < t < until."""
        self.since = self.until = self._asked_after = 0
        self.segment: Segment = ()

    def follow(self, stamp: int, pose: Pose, parent: str) -> bool:
        """Add a newer sample with the same parent, by far the most frequent case; False for any other sample."""
        stamps = self.stamps
        if stamp <= self.newest or not stamps or not self.single_parent or parent != self.parents[-1] or self.static:
            return False
        stamps.append(stamp)
        self.poses.append(pose)
        self.parents.append(parent)
        self.newest, self.newest_pose = stamp, pose
        while stamps[0] < stamp - self.span_ns:
            if self.since == stamps[0]:
                self._forget_segment()
            del stamps[0], self.poses[0], self.parents[0]
        return True

    def follow_all(self, stamps: Sequence[int], poses: Sequence[Pose], parents: Sequence[str]) -> bool:
        """`follow` for consecutive samples; False, with none added, when one of them does not fit."""
        first = stamps[0]
        if first <= self.newest or not self.stamps or not self.single_parent or self.static:
            return False
        if parents.count(self.parents[-1]) != len(parents) or not all(map(lt, stamps, stamps[1:])):
            return False
        self.stamps += stamps
        self.poses += poses
        self.parents += parents
        self.newest, self.newest_pose = stamps[-1], poses[-1]
        if self.stamps[0] < self.newest - self.span_ns:
            self._prune()
        return True

    def insert(self, stamp: int, pose: Pose, parent: str) -> bool:
        """Add a sample; False when it is older than the span of the cache.

        >>> cache, here = FrameCache("robot", span_ns=10 * 10**9), (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
        >>> [cache.insert(second * 10**9, here, "map") for second in (30, 25, 15)]
        [True, True, False]
        """
        if self.static:
            self.stamps, self.poses, self.parents = [0], [pose], [parent]
            self.newest, self.newest_pose = 0, pose
            return True
        stamps = self.stamps
        if not stamps or stamp >= self.newest:
            if stamps and stamp == self.newest and self.poses[-1] == pose and self.parents[-1] == parent:
                return True
            stamps.append(stamp)
            self.poses.append(pose)
            self.parents.append(parent)
            self.newest, self.newest_pose = stamp, pose
        elif not self._insert_older(stamp, pose, parent):
            return False
        if not (self.single_parent and parent == self.parents[0] == self.parents[-1]):
            self.single_parent = self.parents.count(parent) == len(stamps)
        if stamps[0] < self.newest - self.span_ns:
            self._prune()
        return True

    def _insert_older(self, stamp: int, pose: Pose, parent: str) -> bool:
        if stamp < self.newest - self.span_ns:
            return False
        place = bisect_right(self.stamps, stamp)
        before = place - 1
        if before < 0 or (self.stamps[before], self.poses[before], self.parents[before]) != (stamp, pose, parent):
            self._forget_segment()
            self.stamps.insert(place, stamp)
            self.poses.insert(place, pose)
            self.parents.insert(place, parent)
        return True

    def _prune(self) -> None:
        self._forget_segment()
        gone = bisect_right(self.stamps, self.newest - self.span_ns - 1)
        del self.stamps[:gone], self.poses[:gone], self.parents[:gone]
        if not self.single_parent:
            self.single_parent = self.parents.count(self.parents[-1]) == len(self.parents)

    def at(self, stamp: int) -> Pose | None:
        """Return the interpolated pose at a time; 0 is the newest. None outside of the span of the samples."""
        stamps = self.stamps
        if not stamps:
            return None
        if not stamp or self.static or stamp == self.newest:
            return self.newest_pose
        return self.between(stamp)

    def between(self, stamp: int) -> Pose | None:
        """`at` for a moving frame, at a time that is neither 0 nor that of the newest sample."""
        stamps = self.stamps
        after = bisect_right(stamps, stamp)
        if not after or after == len(stamps):
            return None
        here = after - 1
        then = stamps[here]
        pose = self.poses[here]
        if then == stamp or not (self.single_parent or self.parents[here] == self.parents[after]):
            return pose
        if then == self._asked_after and (piece := segment(pose, self.poses[after])) is not None:
            self.since, self.until, self.segment = then, stamps[after], piece
        self._asked_after = then
        return interpolate(pose, self.poses[after], (stamp - then) / (stamps[after] - then))

    def parent_at(self, stamp: int) -> str | None:
        """Return the parent at a time; 0 is the newest. None outside of the span of the samples.

        >>> cache, here = FrameCache("cup", span_ns=10 * 10**9), (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
        >>> _ = cache.insert(1 * 10**9, here, "table"), cache.insert(2 * 10**9, here, "gripper")
        >>> cache.parent_at(1_500_000_000), cache.parent_at(0)
        ('table', 'gripper')
        """
        if not self.stamps:
            return None
        if not stamp or self.static:
            return self.parents[-1]
        after = bisect_right(self.stamps, stamp)
        if not after or (after == len(self.stamps) and stamp != self.newest):
            return None
        return self.parents[after - 1]

    def why_not(self, stamp: int) -> str:
        """Return the reason why there is no pose at a time; '' when there are no samples at all.

        >>> cache, here = FrameCache("robot", span_ns=10 * 10**9), (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
        >>> _ = cache.insert(1 * 10**9, here, "map"), cache.insert(2 * 10**9, here, "map")
        >>> print(cache.why_not(500_000_000))
        Lookup would require extrapolation into the past.  Requested time 0.500000 but the earliest data is at time 1.000000
        """
        if not self.stamps:
            return ""
        if len(self.stamps) == 1:
            return errors.only_one(stamp, self.newest)
        if stamp > self.newest:
            return errors.too_new(stamp, self.newest)
        return errors.too_old(stamp, self.stamps[0])

    @property
    def parent(self) -> str | None:
        """The parent of the newest sample."""
        return self.parents[-1] if self.parents else None

    @property
    def oldest(self) -> int:
        """The stamp of the oldest sample; 0 when there is none."""
        return self.stamps[0] if self.stamps else 0
