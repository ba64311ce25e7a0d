"""Chapter 1: querying the graph, driving a turtle, setting up a scene."""

from __future__ import annotations

import math
import re
from itertools import pairwise
from typing import Any

from coursekit.grade.command_advice import has_word_ros2, why_refused
from coursekit.grade.exercise import exercise
from coursekit.grade.figures.turtles import PAPER, walked
from coursekit.grade.outputs import course_said, exit_code, last_words, said, way_of
from coursekit.grade.plain import close, numbers, shown, texts
from coursekit.grade.verdict import NO_HINT, Wrong
from coursekit.grade.work import Work
from coursekit.systems.command_lines import split_words

TURTLESIM = "run turtlesim turtlesim_node"
CMD_VEL, POSE, TWIST = "/turtle1/cmd_vel", "/turtle1/pose", "geometry_msgs/msg/Twist"
RED, PEN = (255, 0, 0), 5
BARE = (255, 255, 255)
"""What turtles sense where nothing is drawn."""
LIFTED = "A pen that is off draws nothing: `off` stays 0."
ASIDE = range(-4, 5)
"""The offsets from the line, in pixels, at which turtles sense the paper's colour."""
START = 5.544445
"""The start coordinate of turtle1 [m]."""
PIXEL = 1 / 45
"""A pixel of turtlesim's paper [m]."""
LEAST_SHARE = (9 - START) / (PAPER - START)
"""The least part of the way to one wall that has to be driven towards the other: with less, the wall comes first."""
_SPAWN, _SET_PEN = (re.compile(name, re.IGNORECASE) for name in ("spawn", "set_?pen"))


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
    """Check the two facts against a fresh graph with the same two programs."""
    kind, count = work.value("rosout_type", str).strip(), work.value("rosout_publishers", int)
    seen = work.try_out(beside=["run demo_nodes_py talker", "run demo_nodes_py listener"], seconds=1.0)
    if kind not in seen.topics.get("/rosout", []):
        cause = "Is that another topic's type?" if kind.count("/msg/") == 1 else "Is it in full?"
        if " " in kind:
            cause = "The type stands alone, with nothing before or after it."
        raise Wrong("the type that `ros2 topic info /rosout` prints", gave=shown(kind), cause=cause, hint=1)
    right = len(seen.publishers.get("/rosout", []))
    if count != right:
        cause = "Has one of the two ended? Run its cell again, then ask again." if 0 <= count < right else ""
        wanted = "the number of publishers while talker and listener run, and nothing else"
        raise Wrong(wanted, gave=shown(count), cause=cause, share=0.5, hint=0)


@exercise(
    "ch01.q2",
    "Into the corner",
    points=2,
    hints=("First turn on the spot, then drive.", "Up and to the right is 45 degrees, about 0.785 radians."),
)
def corner(work: Work) -> None:
    """Check that the moves bring a fresh turtle to the corner."""
    plan, now = [], 0.5
    for forward, turn, seconds in _triples(work, "moves"):
        _expect_radians(turn)
        if not 0 < seconds <= 30 or now > 120:
            wanted = "moves of more than 0 and at most 30 seconds, of two minutes in all"
            raise Wrong(wanted, gave=f"{seconds:g} s", hint=NO_HINT)
        steps = max(1, math.ceil(seconds / 0.5))
        plan += [(now + seconds * step / steps, CMD_VEL, TWIST, _twist(forward, turn)) for step in range(steps)]
        now += seconds
    plan.append((now, CMD_VEL, TWIST, _twist(0.0, 0.0)))
    seen = work.try_out(beside=[TURTLESIM], seconds=now + 0.5, publish=plan, record=[POSE])
    way = way_of(seen, POSE)
    work.illustrate(walked, way, (9.0, PAPER, 9.0, PAPER))
    _no_wall(seen, way)
    x, y, _ = way[-1]
    if not (x > 9 and y > 9):
        raise Wrong("an end beyond x = 9 and y = 9", f"x = {x:.2f}, y = {y:.2f}", _why_elsewhere(x, y))


def _why_elsewhere(x: float, y: float) -> str:
    """Return the likely cause of an end outside of the corner."""
    right, up = x - START, y - START
    if min(right, up) > 1:
        if min(right, up) > LEAST_SHARE * max(right, up):
            return "The direction is right: drive for longer."
        return "From the start the corner lies at 45 degrees, halfway between right and up."
    if up < -1:
        return "It looks right at the start, and positive turns go to the left."
    return "Forward is where it looks; it looks right at the start."


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
    """Check that a second turtle is in place, and that turtle1's pen is red and five pixels wide."""
    name, where = work.variant("turtle", "bob"), (work.variant("x", 2.5), work.variant("y", 3.5))
    commands = texts(work.value("commands", list), "a list of texts in `commands`")
    if any(map(has_word_ros2, commands)):
        raise Wrong("command lines without the word ros2", gave=shown(commands), hint=NO_HINT)
    looks = [(6.5, "/spawn", "turtlesim/srv/Spawn", {"x": 6.0, "y": _beside(off), "name": _look(off)}) for off in ASIDE]
    colours = {off: f"/{_look(off)}/color_sensor" for off in ASIDE}
    seen = work.try_out(
        *commands, beside=[TURTLESIM], seconds=7.0, publish=[(5.0, CMD_VEL, TWIST, _twist(1.0, 0.0))],
        call=looks, record=[f"/{name}/pose", *colours.values()],
    )  # fmt: skip
    if not course_said(seen, f"/{name}/pose"):
        complaint = _complaint(seen, commands, besides=_SET_PEN)
        cause = why_refused(complaint)
        there = ", ".join(name for name in seen.topics if "pose" in name and "look" not in name)
        raise Wrong(f"a turtle named {name}", f"topics: {there}{complaint}", cause, hint=NO_HINT if cause else 0)
    place = way_of(seen, f"/{name}/pose")[-1][:2]
    if not close(place, where, 0.01):
        raise Wrong(f"{name} at ({where[0]:g}, {where[1]:g})", f"({place[0]:.2f}, {place[1]:.2f})", share=0.5, hint=NO_HINT)
    line = {off: _colours(seen, topic) for off, topic in colours.items()}
    if not any(RED in colours for colours in line.values()):
        drawn = ", ".join(str(key) for key in sorted(line[0] - {BARE})) or "no line"
        wanted = f"turtle1 draws in red {RED}"
        complaint = _complaint(seen, commands, besides=_SPAWN)
        cause = _pen_cause(commands) or why_refused(complaint) or (LIFTED if drawn == "no line" else "")
        raise Wrong(wanted, f"where it went there is {drawn}{complaint}", cause, share=0.5, hint=1)
    wide, right = sum(RED in line[off] for off in ASIDE), sum(map(_is_drawn, ASIDE))
    if wide != right:
        what = "a thinner one" if wide < right else "a thicker one"
        raise Wrong(f"a line of width {PEN}", what, "SetPen has a field for it.", share=0.75, hint=1)


def _is_drawn(off: int) -> bool:
    """Whether a line of the right width extends this many pixels to the side, as turtlesim draws it."""
    from coursekit.sim.paper import Paper

    paper = Paper(PAPER)
    paper.line("turtle1", (START, START), (START + 1, START), RED, PEN)
    return paper.colour_at(6.0, _beside(off)) == RED


def _beside(off: int) -> float:
    return START + off * PIXEL


def _look(off: int) -> str:
    return f"look_{off - ASIDE[0]}"


def _colours(seen: Any, topic: str) -> set[tuple[Any, ...]]:
    """Return the colours that a turtle has sensed below itself."""
    messages = (message for _, message in course_said(seen, topic) if isinstance(message, dict))
    return {tuple(message.get(channel) for channel in "rgb") for message in messages}


def _complaint(seen: Any, commands: list[str], besides: re.Pattern[str]) -> str:
    """Return the output of the first command that failed, besides those for something else."""
    for index, command in enumerate(commands):
        if exit_code(seen, index) and not besides.search(command):
            return f"; `{command[:60]}` said: {last_words(said(seen, index))}"
    return ""


def _pen_cause(commands: list[str]) -> str:
    """Explain that YAML reads an unquoted `off` as false, which is no field name."""
    given = [word.replace(" ", "") for command in commands for word in split_words(command)]
    unquoted = any(text in word for word in given for text in ("{off:", ",off:"))
    return "YAML reads off as false. Between quotes it is a name: \"off\": 0" if unquoted else ""


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
    """Check for a line of 8 m with a full rotation and no wall contact."""
    steps = _triples(work, "dance")
    if other := [when for when, _, _ in steps if not 0 <= when <= 20]:
        raise Wrong("times from 0 to 20 seconds", gave=shown(other[:8]), hint=NO_HINT)
    for _, _, turn in steps:
        _expect_radians(turn)
    plan = [(when, CMD_VEL, TWIST, _twist(forward, turn)) for when, forward, turn in steps]
    seen = work.try_out(beside=[TURTLESIM], seconds=22.0, publish=plan, record=[POSE])
    poses = way_of(seen, POSE)
    work.illustrate(walked, poses)
    _no_wall(seen, poses)
    length = sum(math.dist(a[:2], b[:2]) for a, b in pairwise(poses))
    turned = sum(abs(math.remainder(b[2] - a[2], math.tau)) for a, b in pairwise(poses))
    if not length >= 8:
        raise Wrong("at least 8 m of line", f"{length:.1f} m", share=0.25, hint=0)
    if not turned >= math.tau - 0.05:
        raise Wrong("at least one full turn in all", f"{turned:.1f} of {math.tau:.1f} rad", share=0.5, hint=1)


def _triples(work: Work, name: str) -> list[tuple[float, ...]]:
    answer = work.value(name, list)
    wanted = f"`{name}`, a list of three finite numbers each"
    triples = [numbers(triple, 3, wanted) for triple in answer[:1000]]
    if any(not abs(number) <= 1000 for triple in triples for number in triple) or len(answer) > 1000:
        raise Wrong(wanted, gave=shown(answer), hint=NO_HINT)
    return triples


def _expect_radians(turn: float) -> None:
    if not abs(turn) <= math.tau:
        cause = "Are these degrees? Turn rates are in radians a second: 45° is 0.785."
        raise Wrong("turns of no more than a whole one, 6.28 rad, in a second", gave=f"{turn:g}", cause=cause, hint=NO_HINT)


def _twist(forward: float, turn: float) -> dict[str, Any]:
    return {"linear": {"x": forward}, "angular": {"z": turn}}


def _no_wall(seen: Any, way: list[tuple[float, ...]]) -> None:
    told = "\n".join(seen.beside)
    if "Oh no! I hit the wall!" in told:
        last = told.strip().splitlines()[-1]
        raise Wrong("no wall on the way", last, "Shorter, or turn earlier.", share=0.25, hint=NO_HINT, at=way[-1:])
