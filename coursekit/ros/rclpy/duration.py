"""Durations. In ROS 2: rclpy.duration."""

from __future__ import annotations

from typing import Any

from builtin_interfaces.msg import Duration as DurationMsg

_NS = 10**9
_LARGEST = 2**63 - 1


class Duration:
    """A duration in nanoseconds, negative or positive, within 64 bits.

    >>> Duration(seconds=1.5).nanoseconds
    1500000000
    >>> str(Duration(nanoseconds=5)), str(Infinite)
    ('5 nanoseconds', 'Infinite')
    """

    __slots__ = ("_ns",)

    def __init__(self, *, seconds: float = 0, nanoseconds: float = 0) -> None:
        total = int(seconds * _NS) + int(nanoseconds)
        if not -_LARGEST - 1 <= total <= _LARGEST:
            raise OverflowError("Total nanoseconds value is too large to store in C duration.")
        self._ns = total

    @property
    def nanoseconds(self) -> int:
        """The whole duration in nanoseconds."""
        return self._ns

    def __repr__(self) -> str:
        return f"Duration(nanoseconds={self._ns})"

    def __str__(self) -> str:
        return "Infinite" if self._ns == _LARGEST else f"{self._ns} nanoseconds"

    def __eq__(self, other: object) -> bool:
        return self._ns == self._other(other)

    def __ne__(self, other: object) -> bool:
        return self._ns != self._other(other)

    def __lt__(self, other: object) -> bool:
        return self._ns < self._other(other)

    def __le__(self, other: object) -> bool:
        return self._ns <= self._other(other)

    def __gt__(self, other: object) -> bool:
        return self._ns > self._other(other)

    def __ge__(self, other: object) -> bool:
        return self._ns >= self._other(other)

    __hash__ = None  # type: ignore[assignment]

    @staticmethod
    def _other(other: object) -> int:
        if isinstance(other, Duration):
            return other._ns
        raise TypeError("Can't compare duration with object of type: ", type(other))

    def to_msg(self) -> DurationMsg:
        """Return a builtin_interfaces/msg/Duration (nanosec never negative)."""
        seconds, nanoseconds = divmod(self._ns, _NS)
        return DurationMsg(sec=seconds, nanosec=nanoseconds)

    @classmethod
    def from_msg(cls, msg: Any) -> Duration:
        """Return the duration of a builtin_interfaces/msg/Duration; TypeError for anything else."""
        if not isinstance(msg, DurationMsg):
            raise TypeError("Must pass a builtin_interfaces.msg.Duration object")
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec)

    def get_c_duration(self) -> Duration:
        """Return the duration itself: there is no C object behind it."""
        return self


Infinite = Duration(nanoseconds=_LARGEST)
