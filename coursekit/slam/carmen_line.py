"""One line of a CARMEN log."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from coursekit.geometry.plane import Pose2D

BEAMS = 100_000
"""Maximum number of beams."""


@dataclass(frozen=True)
class Reading:
    """One scan of the log."""

    kind: str
    stamp: float
    ranges: np.ndarray
    """(n,) float32 [m], as written."""
    odometry: Pose2D | None
    """None if the line has no pose: the log's ODOM lines provide it."""
    laser_pose: Pose2D
    laser: tuple[float, float, float] | None = None
    """Start angle, angle step and maximum range, if the line has them."""


def parse_laser(line: str) -> Reading:
    """Parse a FLASER, ROBOTLASER1 or RAWLASER1 line.

    Raises ValueError with the reason.

    >>> parse_laser("FLASER 2 1.0 2.0 0 0 0 0.5 0 0 12.5 host 12.5").odometry.x
    0.5
    """
    words = line.split()
    return {"FLASER": _flaser, "ROBOTLASER1": _robotlaser, "RAWLASER1": _rawlaser}[words[0]](words)


def parse_odometry(line: str) -> tuple[float, float, float, float]:
    """Parse stamp and pose of `ODOM x y theta speed turn acceleration stamp host stamp`. Raises ValueError with the reason.

    >>> parse_odometry("ODOM 1 2 0.5 0 0 0 7.5 host 7.5")
    (7.5, 1.0, 2.0, 0.5)
    """
    words = line.split()
    if len(words) < 8:
        raise ValueError(f"ODOM has {len(words)} words: expected 10")
    pose = _pose(words[1:4], "the odometry")
    return _number(words[7], "the stamp"), pose.x, pose.y, pose.theta


def parse_parameter(line: str) -> tuple[str, str]:
    """Return name and value of a PARAM line; ("", "") when it has none.

    >>> parse_parameter("PARAM robot_frontlaser_offset 0.04 nohost 0")
    ('robot_frontlaser_offset', '0.04')
    """
    words = line.split()
    return (words[1], words[2]) if len(words) > 2 else ("", "")


def _number(word: str, what: str) -> float:
    """Parse a finite number."""
    try:
        value = float(word)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise ValueError(f"{what} should be a number, found '{word[:20]}'")
    return value


def _count(words: list[str], at: int, rest: int) -> int:
    """Return the number of beams, checked against the words that follow: `rest` more than the beams."""
    try:
        count = int(words[at])
    except (ValueError, IndexError):
        raise ValueError("the number of beams is missing") from None
    if not 1 <= count <= BEAMS:
        raise ValueError(f"{count} beams: expected 1 to {BEAMS}")
    if len(words) < at + 1 + count + rest:
        raise ValueError(f"{count} beams announced, but the line ends after {len(words)} words")
    return count


def _ranges(words: list[str]) -> np.ndarray:
    """Parse ranges; NaN and inf are allowed."""
    try:
        return np.array([float(word) for word in words], dtype=np.float32)
    except ValueError as fault:
        raise ValueError(f"a range is no number: {fault}") from None


def _pose(words: list[str], what: str) -> Pose2D:
    """Parse three words as a pose."""
    x, y, theta = (_number(word, what) for word in words)
    if max(abs(x), abs(y)) > 1e7:
        raise ValueError(f"{what} is {x:g}, {y:g}: farther than 10 000 km")
    return Pose2D.of((x, y, theta))


def _flaser(words: list[str]) -> Reading:
    """FLASER n ranges laser_pose robot_pose stamp host stamp; the poses may be left out."""
    count = _count(words, 1, 3)
    tail = words[2 + count :]
    if len(tail) == 3:
        return Reading("FLASER", _number(tail[0], "the stamp"), _ranges(words[2 : 2 + count]), None, Pose2D())
    _count(words, 1, 7)
    if len(tail) > 9:
        raise ValueError(f"{count} beams announced, but {len(tail)} words follow them instead of 9")
    return Reading(
        "FLASER",
        _number(tail[6], "the stamp"),
        _ranges(words[2 : 2 + count]),
        _pose(tail[3:6], "the odometry"),
        _pose(tail[:3], "the laser's pose"),
    )


def _robotlaser(words: list[str]) -> Reading:
    """ROBOTLASER1 type start view step max accuracy remission n ranges m remissions poses speeds safety stamp host stamp."""
    ranges, laser, tail = _with_header(words, 12, 14)
    stamp, odometry = _number(tail[11], "the stamp"), _pose(tail[3:6], "the odometry")
    return Reading("ROBOTLASER1", stamp, ranges, odometry, _pose(tail[:3], "the laser's pose"), laser)


def _rawlaser(words: list[str]) -> Reading:
    """RAWLASER1 type start view step max accuracy remission n ranges m remissions stamp host stamp."""
    ranges, laser, tail = _with_header(words, 1, 3)
    return Reading("RAWLASER1", _number(tail[0], "the stamp"), ranges, None, Pose2D(), laser)


def _with_header(words: list[str], rest: int, usual: int) -> tuple[np.ndarray, tuple[float, float, float], list[str]]:
    """Return ranges, the laser, and the words after the remission values: at least `rest`, usually `usual`."""
    count = _count(words, 8, rest)
    start, view, step, limit = (_number(word, "the laser's header") for word in words[2:6])
    try:
        remissions = int(words[9 + count])
    except ValueError:
        raise ValueError("the number of remission values is missing") from None
    tail = words[10 + count + max(remissions, 0) :]
    if remissions < 0 or len(tail) < rest:
        raise ValueError(f"{remissions} remission values announced, but {len(tail)} words follow instead of {usual}")
    if not 0 < step < math.pi:
        step = view / count if view > 0 else math.pi / count
    return _ranges(words[9 : 9 + count]), (start, step, limit if limit > 0 else math.inf), tail
