"""Messages that move a robot: they are never delivered late, and a velocity command is ended by a stop."""

from __future__ import annotations

VELOCITIES = ("geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped")
"""Commands that hold until the next one; a message of zeros stops the robot."""
MOVING = (
    *VELOCITIES,
    "ackermann_msgs/msg/AckermannDrive",
    "ackermann_msgs/msg/AckermannDriveStamped",
    "trajectory_msgs/msg/JointTrajectory",
    "std_msgs/msg/Float64MultiArray",
)
"""Types of messages that drive wheels and joints."""


class Punctual:
    """Detects messages that took longer than others of their publisher.

    The clocks of two computers differ: a message's delay is measured relative to the fastest one.
    """

    TOO_LATE = 500_000_000
    """A velocity command this old is no longer valid [ns]."""
    OTHER_CLOCK = 3_000_000_000
    """If all messages are late for this long, the other computer's clock was set [ns]."""

    def __init__(self) -> None:
        self._fastest: int | None = None
        self._late_since: int | None = None

    def is_late(self, stamp: int, now: int) -> bool:
        """Return whether a message sent at `stamp` (their clock) and received at `now` (our clock) was delayed [ns].

        >>> check = Punctual()
        >>> check.is_late(0, 1000), check.is_late(100, 1_000_000_000)
        (False, True)
        """
        took = now - stamp
        if self._fastest is None or took < self._fastest:
            self._fastest = took
        if took - self._fastest <= self.TOO_LATE:
            self._late_since = None
            return False
        if self._late_since is None:
            self._late_since = now
        if now - self._late_since > self.OTHER_CLOCK:
            self._fastest, self._late_since = took, None
            return False
        return True
