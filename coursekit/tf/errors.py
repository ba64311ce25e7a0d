"""The exceptions of a lookup, with tf2's names and texts."""

from __future__ import annotations


class TransformException(Exception):
    """Any failure of tf2."""

    __module__ = "tf2"


class ConnectivityException(TransformException):
    """Both frames are known, but no path joins them."""

    __module__ = "tf2"


class LookupException(TransformException):
    """A frame is unknown, or the tree has a loop."""

    __module__ = "tf2"


class ExtrapolationException(TransformException):
    """The requested time is outside of the span of the buffer."""

    __module__ = "tf2"


class InvalidArgumentException(TransformException):
    """The name of a frame is empty or begins with '/'."""

    __module__ = "tf2"


class TimeoutException(TransformException):
    """A server did not answer in time."""

    __module__ = "tf2"


def seconds_text(ns: int) -> str:
    """A time in tf2's format.

    >>> seconds_text(1_500_000_000)
    '1.500000'
    """
    return f"{ns / 1e9:.6f}"


def only_one(asked: int, held: int) -> str:
    """The text for a buffer with a single sample."""
    return (
        f"Lookup would require extrapolation at time {seconds_text(asked)}, "
        f"but only time {seconds_text(held)} is in the buffer"
    )


def too_new(asked: int, latest: int) -> str:
    """The text for a time after the newest sample."""
    return (
        f"Lookup would require extrapolation into the future.  Requested time {seconds_text(asked)} "
        f"but the latest data is at time {seconds_text(latest)}"
    )


def too_old(asked: int, earliest: int) -> str:
    """The text for a time before the oldest sample."""
    return (
        f"Lookup would require extrapolation into the past.  Requested time {seconds_text(asked)} "
        f"but the earliest data is at time {seconds_text(earliest)}"
    )


def looking_up(text: str, target: str, source: str) -> str:
    """An extrapolation's text with the frames of the lookup."""
    return f"{text}, when looking up transform from frame [{source}] to frame [{target}]"


def unconnected(target: str, source: str) -> str:
    """The text for frames in two different trees."""
    return (
        f"Could not find a connection between '{target}' and '{source}' because they are not part of the same tree."
        "Tf has two or more unconnected trees."
    )


def invalid_name(frame: str) -> str | None:
    """Return why a name is not a valid frame name; None for a valid one.

    >>> invalid_name("/map"), invalid_name("map")
    ("in tf2 frame_ids cannot start with a '/'", None)
    """
    if not frame:
        return "in tf2 frame_ids cannot be empty"
    if frame[0] == "/":
        return "in tf2 frame_ids cannot start with a '/'"
    return None
