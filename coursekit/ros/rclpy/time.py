"""Points in time. In ROS 2: rclpy.time."""

from __future__ import annotations

from typing import Any

from builtin_interfaces.msg import Time as TimeMsg

from rclpy._rclpy_pybind11 import ClockType
from rclpy.duration import Duration

CONVERSION_CONSTANT = 10**9
"""Nanoseconds in a second."""

_LARGEST = 2**63 - 1


class Time:
    """A point in time in nanoseconds of one kind of clock; times of different clocks cannot be compared.

    >>> Time(seconds=2) - Time(seconds=3)
    Duration(nanoseconds=-1000000000)
    """

    __slots__ = ("_clock_type", "_ns")

    def __init__(
        self, *, seconds: float = 0, nanoseconds: float = 0, clock_type: ClockType = ClockType.SYSTEM_TIME
    ) -> None:
        if not isinstance(clock_type, ClockType):
            raise TypeError("Clock type must be a ClockType enum")
        if seconds < 0:
            raise ValueError("Seconds value must not be negative")
        if nanoseconds < 0:
            raise ValueError("Nanoseconds value must not be negative")
        total = int(seconds * CONVERSION_CONSTANT) + int(nanoseconds)
        if total > _LARGEST:
            raise OverflowError("Total nanoseconds value is too large to store in C time point.")
        self._ns = total
        self._clock_type = clock_type

    @classmethod
    def _of(cls, nanoseconds: int, clock_type: ClockType) -> Time:
        """Create a time from values that are known to be valid."""
        time = object.__new__(cls)
        time._ns = nanoseconds
        time._clock_type = clock_type
        return time

    @property
    def nanoseconds(self) -> int:
        """Nanoseconds since the clock's epoch."""
        return self._ns

    def seconds_nanoseconds(self) -> tuple[int, int]:
        """Return whole seconds and the nanoseconds beyond them.

        >>> Time(nanoseconds=1_500_000_000).seconds_nanoseconds()
        (1, 500000000)
        """
        return divmod(self._ns, CONVERSION_CONSTANT)

    @property
    def clock_type(self) -> ClockType:
        """The kind of clock that the time belongs to."""
        return self._clock_type

    def __repr__(self) -> str:
        return f"Time(nanoseconds={self._ns}, clock_type={self._clock_type.name})"

    def __add__(self, other: Duration) -> Time:
        if not isinstance(other, Duration):
            return NotImplemented
        try:
            return Time(nanoseconds=self._ns + other.nanoseconds, clock_type=self._clock_type)
        except OverflowError as error:
            raise OverflowError("Addition leads to overflow in C storage.") from error
        except ValueError as error:
            raise ValueError("Addition leads to negative time.") from error

    __radd__ = __add__

    def __sub__(self, other: Any) -> Any:
        if isinstance(other, Time):
            if self._clock_type != other._clock_type:
                raise TypeError("Can't subtract times with different clock types")
            return Duration(nanoseconds=self._ns - other._ns)
        if not isinstance(other, Duration):
            return NotImplemented
        try:
            return Time(nanoseconds=self._ns - other.nanoseconds, clock_type=self._clock_type)
        except OverflowError as error:
            raise OverflowError("Subtraction leads to overflow in C storage.") from error
        except ValueError as error:
            raise ValueError("Subtraction leads to negative time.") from error

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

    def _other(self, other: object) -> int:
        """The other time's nanoseconds; TypeError for anything else: `time == 5` must not silently be False."""
        if not isinstance(other, Time):
            raise TypeError("Can't compare time with object of type: ", type(other))
        if self._clock_type != other._clock_type:
            raise TypeError("Can't compare times with different clock types")
        return other._ns

    def to_msg(self) -> TimeMsg:
        """Return a builtin_interfaces/msg/Time (without the kind of clock).

        >>> msg = Time(seconds=1, nanoseconds=500).to_msg()
        >>> msg.sec, msg.nanosec
        (1, 500)
        """
        seconds, nanoseconds = divmod(self._ns, CONVERSION_CONSTANT)
        return TimeMsg(sec=seconds, nanosec=nanoseconds)

    @classmethod
    def from_msg(cls, msg: Any, clock_type: ClockType = ClockType.ROS_TIME) -> Time:
        """Return the time of a builtin_interfaces/msg/Time; TypeError for anything else.

        >>> from builtin_interfaces.msg import Time as TimeMsg
        >>> Time.from_msg(TimeMsg(sec=1, nanosec=500)).nanoseconds
        1000000500
        """
        if not isinstance(msg, TimeMsg):
            raise TypeError("Must pass a builtin_interfaces.msg.Time object")
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec, clock_type=clock_type)
