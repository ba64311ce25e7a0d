"""Messages that move a robot: they are never delivered late, and a velocity is ended by a stop."""

from __future__ import annotations

VELOCITIES = ("geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped")
"""Commands that hold until the next one; a message of zeros stops."""
MOVING = (
    *VELOCITIES,
    "ackermann_msgs/msg/AckermannDrive",
    "ackermann_msgs/msg/AckermannDriveStamped",
    "trajectory_msgs/msg/JointTrajectory",
    "std_msgs/msg/Float64MultiArray",
)
"""Types of messages that drive wheels and joints."""


class Punctual:
    """Tells messages that were held up on the way from those that come as fast as others of their publisher.

    The clocks of two computers differ: what counts is how much longer a message took than the fastest one.
    """

    TOO_LATE = 500_000_000
    """A velocity this old is no command any more [ns]."""
    OTHER_CLOCK = 3_000_000_000
    """Where all are late for this long, the other computer's clock was set [ns]."""

    def __init__(self) -> None:
        self._fastest: int | None = None
        self._late_since: int | None = None

    def is_late(self, stamp: int, now: int) -> bool:
        """Whether the message that was sent at `stamp` (their clock) and is here at `now` (ours) was held up [ns].

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
