"""Motorized joints, as in an arm, a gripper or a turret."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Reach:
    """The position limits [rad or m] and the maximum velocity [per second] of a joint."""

    lower: float = -math.inf
    upper: float = math.inf
    velocity: float = math.inf
    effort: float = 0.0
    """Maximum effort [Nm or N], 0 if unspecified."""

    def speed_of(self, effort: float) -> float:
        """Return the velocity for an effort: proportional, as against a viscous brake, with full velocity at full effort.

        >>> Reach(velocity=2.0, effort=10.0).speed_of(5.0)
        1.0
        """
        most = self.effort if 0.0 < self.effort < math.inf else 10.0
        return effort / most * (self.velocity if self.velocity < math.inf else 1.0)


class Motors:
    """The motors of a robot; `angles` has the positions of all its joints, `speeds` the velocities of motorized joints.

    >>> motors = Motors({}, {"arm": Reach(-1.0, 1.0, 2.0)})
    >>> motors.command("arm", "position", 3.0); motors.step(0.1)
    >>> motors.angles["arm"], motors.speeds["arm"]
    (0.2, 2.0)
    """

    def __init__(self, angles: dict[str, float], reach: dict[str, Reach] | None = None) -> None:
        self.angles, self.reach = angles, reach or {}
        self.speeds: dict[str, float] = {}
        self.mimics: dict[str, tuple[str, float, float]] = {}
        """By joint: the joint that it follows, the factor, the offset."""
        self._goals: dict[str, tuple[str, float]] = {}

    def command(self, joint: str, mode: str, goal: float) -> None:
        """Command a "position", "velocity" or "effort" from now on."""
        self._goals[joint] = (mode, goal)

    def put(self, joint: str, position: float) -> None:
        """Set the position at once, and hold it."""
        self._goals[joint] = ("position", position)
        self.angles[joint] = self._within(joint, position)

    def moved(self) -> dict[str, float]:
        """Return the positions of all joints that have ever been commanded."""
        return {joint: self.angles[joint] for joint in (*self._goals, *self.mimics) if joint in self.angles}

    def restart(self) -> None:
        """Drop all commands."""
        self._goals.clear()
        self.speeds.clear()

    def step(self, dt: float) -> None:
        """Move the joints for `dt` seconds.

        >>> motors = Motors({}, {"arm": Reach(-1.0, 1.0, velocity=2.0)})
        >>> motors.command("arm", "velocity", 9.0)
        >>> for _ in range(2):
        ...     motors.step(0.4)
        ...     print(motors.angles["arm"], round(motors.speeds["arm"], 3))
        0.8 2.0
        1.0 0.5
        """
        for joint, (mode, goal) in self._goals.items():
            reach = self.reach.get(joint, Reach())
            was, most = self.angles.get(joint, 0.0), reach.velocity
            speeds = {"velocity": goal, "effort": reach.speed_of(goal), "position": (goal - was) / dt}
            wanted = speeds[mode]
            now = self._within(joint, was + max(-most, min(most, wanted)) * dt)
            self.angles[joint], self.speeds[joint] = now, (now - was) / dt
        for joint, (leader, factor, offset) in self.mimics.items():
            self.angles[joint] = self.angles.get(leader, 0.0) * factor + offset
            self.speeds[joint] = self.speeds.get(leader, 0.0) * factor

    def _within(self, joint: str, position: float) -> float:
        reach = self.reach.get(joint, Reach())
        return max(reach.lower, min(reach.upper, position))


__all__ = ["Motors", "Reach"]
