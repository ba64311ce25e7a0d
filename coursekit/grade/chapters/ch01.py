"""Chapter 1: asking the graph, driving a turtle, setting a scene."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

from coursekit.grade.exercise import exercise
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work

TURTLESIM = "run turtlesim turtlesim_node"
CMD_VEL, POSE, TWIST = "/turtle1/cmd_vel", "/turtle1/pose", "geometry_msgs/msg/Twist"


@exercise(
    "ch01.q1",
    "Ask the graph",
    points=1,
    hints=(
        "`%ros2 topic info /rosout` answers both.",
        "Types are written in full: package/msg/Name. Every node publishes its log there.",
    ),
)
def ask(work: Work) -> None:
    """The two facts, as a fresh graph with the same two programs has them."""
    kind, count = work.value("rosout_type", str), work.value("rosout_publishers", int)
    seen = work.try_out("run demo_nodes_py talker", "run demo_nodes_py listener", seconds=1.0)
    if kind not in seen.topics["/rosout"]:
        raise Wrong("the type that `ros2 topic info /rosout` prints", repr(kind), "Is it written in full?")
    if count != len(seen.publishers["/rosout"]):
        raise Wrong("the number of publishers while talker and listener run", str(count), share=0.5)


@exercise(
    "ch01.q2",
    "Into the corner",
    points=2,
    hints=("First turn on the spot, then drive.", "Up and to the right is 45 degrees, about 0.785 radians."),
)
def corner(work: Work) -> None:
    """The moves bring a fresh turtle to the corner."""
    moves = _triples(work, "moves")
    plan, now = [], 0.5
    for forward, turn, seconds in moves:
        if not 0 < seconds <= 30:
            raise Wrong("moves of more than 0 and at most 30 seconds", f"{seconds} s")
        steps = max(1, math.ceil(seconds / 0.5))
        plan += [(now + seconds * step / steps, CMD_VEL, TWIST, _twist(forward, turn)) for step in range(steps)]
        now += seconds
    plan.append((now, CMD_VEL, TWIST, _twist(0.0, 0.0)))
    seen = work.try_out(TURTLESIM, seconds=now + 0.5, publish=plan, record=[POSE])
    _no_wall(seen)
    pose = seen.messages[POSE][-1][1]
    if not (pose["x"] > 9 and pose["y"] > 9):
        raise Wrong(
            "an end beyond x = 9 and y = 9",
            f"x = {pose['x']:.2f}, y = {pose['y']:.2f}",
            "Forward is where it looks; it looks right at the start.",
        )


@exercise(
    "ch01.q3",
    "Set the stage",
    points=2,
    hints=(
        "Two service calls: /spawn and /turtle1/set_pen.",
        "`%ros2 interface show turtlesim/srv/SetPen` shows the fields; mind the quotes around the braces.",
    ),
)
def stage(work: Work) -> None:
    """A second turtle stands at its place, and turtle1's pen is thick and red."""
    name, where = work.variant("turtle", "bob"), (work.variant("x", 2.5), work.variant("y", 3.5))
    commands = work.value("commands", list)
    if not all(isinstance(one, str) for one in commands):
        raise Wrong("a list of texts", repr(commands)[:120])
    if any(one.split()[:1] == ["ros2"] for one in commands):
        raise Wrong("command lines without the word ros2", repr(commands)[:120])
    red = (5.0, CMD_VEL, TWIST, _twist(1.0, 0.0))
    seen = work.try_out(
        TURTLESIM, *commands, seconds=7.0, publish=[red],
        record=[f"/{name}/pose", "/turtle1/color_sensor", POSE],
    )  # fmt: skip
    poses = seen.messages.get(f"/{name}/pose")
    if not poses:
        raise Wrong(f"a turtle named {name}", f"topics: {', '.join(name for name in seen.topics if 'pose' in name)}")
    place = poses[-1][1]
    if math.dist((place["x"], place["y"]), where) > 0.01:
        raise Wrong(f"{name} at ({where[0]:g}, {where[1]:g})", f"({place['x']:.2f}, {place['y']:.2f})", share=0.5)
    colours = {(one["r"], one["g"], one["b"]) for _, one in seen.messages["/turtle1/color_sensor"]}
    if (255, 0, 0) not in colours:
        raise Wrong("turtle1 draws in red (255, 0, 0)", f"under its pen: {sorted(colours)[:4]}", share=0.5)


@exercise(
    "ch01.q4",
    "A figure",
    points=2,
    hints=(
        "A velocity holds for one second: publish it again before that.",
        "Going round in a circle of radius r: turn = forward / r.",
    ),
)
def dance(work: Work) -> None:
    """A line of 8 m with a full turn and no wall."""
    steps = _triples(work, "dance")
    if any(not 0 <= when <= 20 for when, _, _ in steps):
        raise Wrong("times from 0 to 20 seconds", f"{[when for when, _, _ in steps][:8]}")
    plan = [(when, CMD_VEL, TWIST, _twist(forward, turn)) for when, forward, turn in steps]
    seen = work.try_out(TURTLESIM, seconds=22.0, publish=plan, record=[POSE])
    _no_wall(seen)
    poses = [pose for _, pose in seen.messages[POSE]]
    length = sum(math.dist((a["x"], a["y"]), (b["x"], b["y"])) for a, b in pairwise(poses))
    turned = sum(abs(math.remainder(b["theta"] - a["theta"], math.tau)) for a, b in pairwise(poses))
    if length < 8:
        raise Wrong("at least 8 m of line", f"{length:.1f} m", share=0.25)
    if turned < math.tau - 0.05:
        raise Wrong("at least one full turn in all", f"{turned:.1f} of {math.tau:.1f} rad", share=0.5)


def _triples(work: Work, name: str) -> list[tuple[float, float, float]]:
    found = work.value(name, list)
    try:
        return [(float(one), float(two), float(three)) for one, two, three in found]
    except (TypeError, ValueError):
        raise Wrong("a list of three numbers each", repr(found)[:120]) from None


def _twist(forward: float, turn: float) -> dict[str, Any]:
    return {"linear": {"x": forward}, "angular": {"z": turn}}


def _no_wall(seen: Any) -> None:
    if "Oh no! I hit the wall!" in seen.outputs[0]:
        raise Wrong("no wall on the way", seen.outputs[0].strip().splitlines()[-1], "Shorter, or turn earlier.", share=0.25)
