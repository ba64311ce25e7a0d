"""Data that must be ignored, with the reasons in tf2's words."""

from __future__ import annotations

from collections.abc import Iterator

from coursekit.geometry.pose import Pose

from .errors import seconds_text

UNIT_TOLERANCE = 10e-3
"""Largest allowed deviation of a quaternion's squared length from 1."""


def faults(parent: str, child: str, pose: Pose, authority: str) -> Iterator[str]:
    """Yield the reasons to reject a pose; none when it can be accepted after normalizing its quaternion.

    >>> list(faults("odom", "", (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0), "driver"))
    ['TF_NO_CHILD_FRAME_ID: Ignoring transform from authority "driver" because child_frame_id not set ']
    """
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


def too_old(child: str, stamp: int, authority: str) -> str:
    """The reason to ignore a pose older than the span of the cache."""
    return (
        f"TF_OLD_DATA ignoring data from the past for frame {child} at time {seconds_text(stamp)} "
        f"according to authority {authority}\n"
        "Possible reasons are listed at http://wiki.ros.org/tf/Errors%20explained"
    )
