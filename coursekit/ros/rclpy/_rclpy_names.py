"""Errors and enumerations of rclpy's C module."""

from __future__ import annotations

from enum import IntEnum


class RCLError(RuntimeError):
    """An error of the ROS client library."""


class RMWError(RuntimeError):
    """An error of the middleware."""


class InvalidHandle(RuntimeError):
    """Something was used after it had been destroyed."""


class NodeNameNonExistentError(RCLError):
    """No node of that name is in the graph."""


class UnknownROSArgsError(RuntimeError):
    """Arguments after --ros-args that ROS does not know."""


class RCLInvalidROSArgsError(RCLError):
    """Arguments after --ros-args that ROS cannot read."""


class UnsupportedEventTypeError(RCLError):
    """A QoS event that the middleware does not report."""


class TimerCancelledError(RCLError):
    """A cancelled timer was called."""


class _Named(IntEnum):
    """Integers that print as their names in every Python version, as pybind11's enums do."""

    def __str__(self) -> str:
        return f"{type(self).__name__}.{self.name}"


class ClockType(_Named):
    """The kind of clock a time belongs to."""

    UNINITIALIZED = 0
    ROS_TIME = 1
    SYSTEM_TIME = 2
    STEADY_TIME = 3


class ClockChange(_Named):
    """The kind of a clock jump."""

    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4


class SignalHandlerOptions(_Named):
    """Which signals rclpy reacts to."""

    NO = 0
    SIGINT = 1
    SIGTERM = 2
    ALL = 3


for _kind in [kind for kind in vars().values() if isinstance(kind, type) and kind.__module__ == __name__]:
    _kind.__module__ = "rclpy._rclpy_pybind11"  # as tracebacks name them
