"""Submaps from keyframes with known poses: to continue after loading, and for localization."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable, Sequence

import numpy as np

from coursekit.geometry.plane import Array, Pose2D
from coursekit.slam.keyframe import Keyframe
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.scan import Scan
from coursekit.slam.submap import Submap


def submap_of(
    keyframes: Sequence[Keyframe], numbers: Iterable[int], poses: Array, params: SlamParameters
) -> Submap:
    """Return one submap of these keyframes, in the frame of the first.

    >>> params = SlamParameters()
    >>> keyframes = [Keyframe(k, Scan.from_points(np.array([[2.0 - k, 0.0]]), params)) for k in (0, 1)]  # one post, twice
    >>> submap = submap_of(keyframes, (0, 1), np.array([[5.0, 5.0, 0.0], [6.0, 5.0, 0.0]]), params)
    >>> submap.members[1], submap.count, submap.points[0].tolist()
    (Pose2D(x=1.0, y=0.0, theta=0.0), 1, [2.0, 0.0])
    """
    chosen = list(numbers)
    frame = Pose2D.of(poses[chosen[0]])
    submap = Submap(params, chosen[0])
    for number in chosen:
        submap.members[number] = frame.to(Pose2D.of(poses[number]))
        submap.insert(keyframes[number].scan, submap.members[number])
    return submap


def cover(keyframes: Sequence[Keyframe], poses: Array, params: SlamParameters) -> list[Submap]:
    """Return finished submaps that overlap by half and contain every keyframe, as mapping would have left them.

    >>> params = SlamParameters(submap_keyframes=4)
    >>> keyframes = [Keyframe(k, Scan.from_points(np.array([[2.0, 0.0]]), params)) for k in range(6)]
    >>> [list(submap.members) for submap in cover(keyframes, np.zeros((6, 3)), params)]
    [[0, 1, 2, 3], [2, 3, 4, 5], [4, 5]]
    """
    size, submaps = params.submap_keyframes, []
    for first in range(0, len(keyframes), max(size // 2, 1)):
        submaps.append(submap_of(keyframes, range(first, min(first + size, len(keyframes))), poses, params))
        submaps[-1].finish()
    return submaps


def around(keyframes: Sequence[Keyframe], poses: Array, place: Pose2D, params: SlamParameters) -> Submap:
    """Return a submap of the keyframes nearest to a pose, not yet full.

    >>> params = SlamParameters(submap_keyframes=6)
    >>> keyframes = [Keyframe(k, Scan.from_points(np.array([[2.0, 0.0]]), params)) for k in range(9)]
    >>> row = np.column_stack([np.arange(9.0), np.zeros(9), np.zeros(9)])  # a keyframe per metre
    >>> list(around(keyframes, row, Pose2D(4.2, 0.0, 0.0), params).members)
    [4, 5]
    """
    gaps = np.hypot(poses[:, 0] - place.x, poses[:, 1] - place.y)
    nearest = np.argsort(gaps, kind="stable")[: max(params.submap_keyframes // 2 - 1, 1)]
    return submap_of(keyframes, (int(number) for number in nearest), poses, params)


def map_submap(points: Array, params: SlamParameters) -> tuple[Submap, Pose2D]:
    """Return one submap of bare points (n, 2), such as the walls of a drawn map, and its frame's pose in the map.

    >>> submap, frame = map_submap(np.array([[10.0, 20.0], [12.0, 20.0]]), SlamParameters())
    >>> frame, submap.count
    (Pose2D(x=11.0, y=20.0, theta=0.0), 2)
    """
    submap = Submap(params)
    submap.members[0] = Pose2D()
    if not len(points):
        return submap, Pose2D()
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    everything = dataclasses.replace(params, match_range=math.inf)
    submap.insert(Scan.from_points(points - middle, everything), Pose2D())
    return submap, Pose2D.of((*middle, 0.0))
