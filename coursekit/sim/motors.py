"""Joints with motors: an arm's, a gripper's, a turret's."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Reach:
    """How far [rad or m] and how fast [per second] a joint may go."""

    lower: float = -math.inf
    upper: float = math.inf
    velocity: float = math.inf
    effort: float = 0.0
    """Its largest effort [Nm or N], 0 where none is given."""

    def speed_of(self, effort: float) -> float:
        """How fast an effort moves the joint: as against a viscous brake, so that all it can push gives all its speed."""
        most = self.effort if 0.0 < self.effort < math.inf else 10.0
        return effort / most * (self.velocity if self.velocity < math.inf else 1.0)


class Motors:
    """The motors of a robot; `angles` has the positions of all its joints, `speeds` those of joints with motors.

    >>> motors = Motors({}, {"arm": Reach(-1.0, 1.0, 2.0)})
    >>> motors.command("arm", "position", 3.0); motors.step(0.1)
    >>> motors.angles["arm"], motors.speeds["arm"]
    (0.2, 2.0)
    """

    def __init__(self, angles: dict[str, float], reach: dict[str, Reach] | None = None) -> None:
        self.angles, self.reach = angles, reach or {}
        self.speeds: dict[str, float] = {}
        self.mimics: dict[str, tuple[str, float, float]] = {}
        """By joint: the one that it follows, the factor, the offset."""
        self._goals: dict[str, tuple[str, float]] = {}

    def command(self, joint: str, mode: str, goal: float) -> None:
        """Go to a "position", at a "velocity", or push with an "effort", from now on."""
        self._goals[joint] = (mode, goal)

    def put(self, joint: str, position: float) -> None:
        """Be there at once, and stay."""
        self._goals[joint] = ("position", position)
        self.angles[joint] = self._within(joint, position)

    def moved(self) -> dict[str, float]:
        """The positions of joints that were ever told where to go."""
        return {joint: self.angles[joint] for joint in (*self._goals, *self.mimics) if joint in self.angles}

    def restart(self) -> None:
        """No joint is moved any more."""
        self._goals.clear()
        self.speeds.clear()

    def step(self, dt: float) -> None:
        """Move on for `dt` seconds."""
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
