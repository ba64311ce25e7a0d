"""Rolling wheels: their distances over the floor, and causes of wrong ones."""

from __future__ import annotations

import math
from typing import Any

from coursekit.grade.outputs import heard
from coursekit.grade.plain import field, fields, near, number, shown
from coursekit.grade.trial import Seen
from coursekit.grade.verdict import NO_HINT, Wrong

WHEEL, ASIDE = 0.0375, 0.094
"""The wheels' radius, and their distance from the centre line, for the course's robot [m]."""
WHEELS = {f"{side}_{end}_joint" for side in ("left", "right") for end in ("front", "back")}


def judge_rolling(seen: Seen, radius: float) -> None:
    """Raise Wrong unless all wheels unroll the lengths of their paths on a circle of that radius [m]."""
    frames = [transform for _, message in heard(seen, "/tf") for transform in field(message, "transforms", list, "/tf")]
    states = [message for _, message in heard(seen, "/joint_states")]
    if len(states) < 40 or len(frames) < 40:
        raise Wrong("joint states and frames at 30 Hz", f"{len(states)} and {len(frames)} in 1.5 s", hint=NO_HINT)
    steps = min(len(states), len(frames)) - 1
    first, last = _moved(frames[0]), _moved(frames[steps])
    turn = math.remainder(last[2] - first[2], math.tau)
    if not near(turn, math.radians(steps), 1e-3) or not near(math.hypot(first[0], first[1]), radius, 1e-3):
        raise Wrong(f"a circle of {radius:g} m, 1° a step", "another path", "Is py_state_publisher_node.py as it was given?")
    before, after = _angles(states[0]), _angles(states[steps])
    for name in sorted(WHEELS):
        aside = ASIDE if name.startswith("left") else -ASIDE
        judge_wheel_s_distance(name, radius, turn, aside, WHEEL * (after[name] - before[name]))


def judge_wheel_s_distance(name: str, radius: float, turn: float, aside: float, unrolled: float) -> None:
    """Raise Wrong unless a wheel at this lateral offset unrolls its distance [m] during a robot's rotation [rad]."""
    distance = turn * (radius - aside)
    if not near(unrolled, distance, 1e-3 + 0.005 * abs(distance)):
        middle = near(unrolled, turn * radius, 0.01)
        raise Wrong(
            f"on a circle of {radius:g} m, {name} unrolls {distance:.3f} m, as its place on the robot goes",
            f"{unrolled:.3f} m",
            _slip(radius, turn, aside, unrolled),
            share=0.4 if middle and radius == 1.0 else 0.0,
            hint=0 if middle else 1,
        )


def _angles(state: Any) -> dict[str, float]:
    """Return the wheels' angles by joint."""
    names, values = field(state, "name", list), field(state, "position", list)
    angle_by_joint = {name: value for name, value in zip(names, values, strict=False) if type(name) is str}
    if not set(angle_by_joint) >= WHEELS:
        raise Wrong("angles of the four wheels' joints", shown(names), hint=NO_HINT)
    return {name: number(angle_by_joint[name], f"a finite angle of {name}") for name in WHEELS}


def _slip(radius: float, turn: float, aside: float, unrolled: float) -> str:
    distance = turn * (radius - aside)
    causes = {
        "That is the distance of the robot's middle: the inner wheels roll less, the outer ones more.": turn * radius,
        "The right length, but backwards.": -distance,
        "That is the other side's distance: to the left, the left wheels are the inner ones.": turn * (radius + aside),
        "That is right on a circle of 1 m only: is `radius` used?": turn * (1.0 - aside),
        "An angle is asked for: the length on the floor, divided by the wheel's radius.": WHEEL * distance,
        "Radians are asked for, as `step` is.": math.degrees(distance),
    }
    for cause, length in causes.items():
        if near(unrolled, length, 1e-3 + 0.005 * abs(length)):
            return cause
    return "The length on the floor is the wheel's angle times its radius, 0.0375 m. Which wheels are the inner ones?"


def _moved(frame: Any) -> tuple[float, float, float]:
    x, y = fields(frame, ("transform.translation.x", "transform.translation.y"), "/tf")
    z, w = fields(frame, ("transform.rotation.z", "transform.rotation.w"), "/tf")
    return x, y, 2 * math.atan2(z, w)
