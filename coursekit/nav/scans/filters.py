"""Range filters: ranges that are too near, too far, isolated, or a veil between two objects become NaN."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from coursekit.nav.scans.making import Array

Mask = npt.NDArray[np.bool_]


def within(ranges: Array, lower: float, upper: float, too_near: float = math.nan, too_far: float = math.nan) -> Array:
    """Replace ranges of at most `lower` or at least `upper`.

    >>> within(np.array([0.1, 1.0, 9.0]), 0.2, 5.0).tolist()
    [nan, 1.0, nan]
    """
    return np.where(ranges <= lower, too_near, np.where(ranges >= upper, too_far, ranges))


def without(ranges: Array, gone: Mask) -> Array:
    """Set some ranges to NaN."""
    return np.where(gone, np.nan, ranges)


def in_box(points: Array, low: Array, high: Array) -> Mask:
    """Return a mask of the points (n, 3) in a box."""
    inside: Mask = (points >= low) & (points <= high)
    return np.asarray(inside.all(axis=1))


def _neighbours(ranges: Array, offsets: list[int]) -> Array:
    """Return the ranges at these beam offsets, (offsets, n); NaN beyond the ends."""
    reach = max(abs(offset) for offset in offsets)
    wide = np.pad(ranges, reach, constant_values=np.nan)
    return np.array([wide[reach + offset : reach + offset + len(ranges)] for offset in offsets])


def speckles_by_distance(ranges: Array, window: int, largest: float, far: float) -> Array:
    """Keep runs of `window` beams within `largest` of their first beam, and ranges beyond `far`; drop the rest."""
    if window > len(ranges):
        return ranges.copy()
    following = np.lib.stride_tricks.sliding_window_view(ranges, window)
    with np.errstate(invalid="ignore"):
        near: Mask = np.abs(following - following[:, :1]) <= largest
        alike: Mask = np.asarray(near.all(axis=1))
        kept: Mask = ranges > far
    for k in range(window):
        kept[k : k + len(alike)] |= alike
    return without(ranges, ~kept)


def speckles_by_neighbours(ranges: Array, window: int, largest: float, far: float, increment: float) -> Array:
    """Remove speckles: points with fewer than `window` of the 2 · `window` neighbouring points within `largest`."""
    offsets = [k for k in range(-window, window + 1) if k]
    with np.errstate(invalid="ignore"):
        others, cosines = _neighbours(ranges, offsets), np.cos(np.array(offsets) * increment)[:, None]
        squared = ranges**2 + others**2 - 2 * ranges * others * cosines
        kept = ((squared <= largest**2).sum(axis=0) >= window) | (ranges > far)
    return without(ranges, ~kept)


def veils(
    ranges: Array, increment: float, angles: tuple[float, float], neighbours: int, window: int, start_too: bool = False
) -> Array:
    """Remove points between a near and a far object, as measured by beams that touch both.

    Where the line to a neighbouring beam's point meets the beam at an angle outside `angles` [rad], farther points go.
    """
    offsets = [k for k in range(-window, window + 1) if k]
    turn = np.array(offsets)[:, None] * increment
    with np.errstate(invalid="ignore"):
        others = _neighbours(ranges, offsets)
        across = np.abs(np.arctan2(others * np.sin(turn), ranges - others * np.cos(turn)))
        outside: Mask = (across < angles[0]) | (across > angles[1])
    edge: Mask = np.asarray(outside.any(axis=0))
    gone: Mask = edge & np.bool_(start_too)
    for k in np.flatnonzero(edge):
        beside = slice(max(k - neighbours, 0), k + neighbours + 1)
        gone[beside] |= ranges[beside] > ranges[k]
    return without(ranges, gone)
