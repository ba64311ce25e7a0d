"""Chapter 7: a pose seen from another, the stages of a robot, a robot that goes silent, four that do not collide."""

from __future__ import annotations

import cmath
import itertools
import math
import re
from collections.abc import Sequence
from typing import Any

from coursekit.grade.exercise import exercise
from coursekit.grade.outputs import heard, last_words, said
from coursekit.grade.plain import called, close, field, fields, near, numbers
from coursekit.grade.trial import Seen
from coursekit.grade.verdict import NO_HINT, Wrong
from coursekit.grade.work import Work

CLIENT, MANAGER, MONITOR = "s7_py_client_robot", "s7_py_task_manager", "s7_py_robot_task_monitoring"
STEP, TURN = 0.01, math.radians(1)
"""The most that a robot moves [m] and turns [rad] in a step."""
APART = 0.4
"""Robots' middles closer than this may touch [m]."""
SEEDS = range(1, 40)
"""Of the manager's dice: with these there is enough work that can be done without collisions."""
Spot = tuple[float, float, float]


@exercise(
    "ch07.q1",
    "Seen from me",
    points=2,
    hints=(
        "First without turns: how far is the other one from me, along the axes of the common frame?",
        "Then turn that by my yaw, backwards: if I look along y, what lies along y is ahead of me.",
        "Yaws are compared by their difference. -3.0 and 3.0 are near each other.",
    ),
)
def seen_from_me(work: Work) -> None:
    """The same as tf2 says, for many poses."""
    function, chance = work.function("seen"), work.dice("ch07.q1")
    for index in range(20):
        me, other = (tuple(round(chance.uniform(-3, 3), 2) for _ in range(3)) for _ in range(2))
        if index == 0:
            me, other = (1.0, 1.0, 0.0), (2.0, 3.0, 0.5)
        told = f"seen({me}, {other})"
        got = called(function, me, other, told=told)
        _judge_seen(numbers(got, 3, f"three finite numbers (x, y, yaw) from {told}"), me, other, told)


def _judge_seen(got: tuple[float, ...], me: Sequence[float], other: Sequence[float], told: str) -> None:
    x, y, yaw = got
    wanted = _relative(me, other)
    answer, right = (f"({a:.3f}, {b:.3f}, {c:.3f})" for a, b, c in (got, wanted))
    if not close((x, y), wanted[:2], 1e-6):
        raise Wrong(f"{right} from {told}", gave=answer, cause=_slip((x, y), me, other), hint=1)
    if not near(math.remainder(yaw - wanted[2], math.tau), 0.0, 1e-6):
        cause = "How much does the other look further to the left than I?"
        raise Wrong(f"{right} from {told}", gave=answer, cause=cause, share=0.5, hint=2)
    if not abs(yaw) <= math.pi + 1e-9:
        cause = "A full turn changes nothing."
        raise Wrong(f"a yaw between -pi and pi from {told}", gave=f"{yaw:.3f}", cause=cause, share=0.75, hint=2)


def _relative(me: Sequence[float], other: Sequence[float]) -> Spot:
    from coursekit.tf import compose, inverse

    def pose(one: Sequence[float]) -> Any:
        return (one[0], one[1], 0.0, 0.0, 0.0, math.sin(one[2] / 2), math.cos(one[2] / 2))

    x, y, _, _, _, turn, cosine = compose(inverse(pose(me)), pose(other))
    return x, y, math.remainder(2 * math.atan2(turn, cosine), math.tau)


def _slip(got: tuple[float, float], me: Sequence[float], other: Sequence[float]) -> str:
    shift = complex(other[0] - me[0], other[1] - me[1])
    for cause, value in (
        ("My yaw is not used: these are still the common frame's axes.", shift),
        ("Turned by my yaw, but in the wrong direction.", shift * cmath.rect(1.0, me[2])),
        ("Yaws are in radians already, as sin and cos take them.", shift * cmath.rect(1.0, -math.radians(me[2]))),
        ("The other minus me, not me minus the other.", -shift * cmath.rect(1.0, -me[2])),
    ):
        if abs(complex(*got) - value) < 1e-6:
            return cause
    return "Draw it: where is ahead of me, where is my left?"


@exercise(
    "ch07.q2",
    "The stages",
    points=3,
    hints=(
        "Stages 0 to 2 and 3 to 5 are the same three, with another pose. Which one is it?",
        "The sign of the remaining angle, brought between -pi and pi, is the shorter direction: math.remainder does that.",
        "Is what is left no more than one step? Then go there exactly, and return the next stage.",
    ),
)
def stages(work: Work) -> None:
    """All steps of a robot that works alone: how far, how fast, to where."""
    work.built(CLIENT)
    for seed in work.dice("ch07.q2").sample(range(1, 10_000), 2):
        robot = f"run {CLIENT} client_exe --ros-args -r __ns:=/robot1 -r get_two_poses:=/get_two_poses"
        topics = [f"/robot1/{name}" for name in ("robot_status", "pickup_pose", "delivery_pose")]
        manager = f"run {MANAGER} manager_exe --ros-args -p seed:={seed}"
        _judge_stages(work.try_out(manager, robot, record=topics, seconds=75.0))


def _reports(seen: Seen, number: int) -> list[tuple[int, Spot]]:
    """What a robot has told of itself: stage and place, in order."""
    topic = f"/robot{number}/robot_status"
    return [(field(one, "task_stage", int, topic), _spot(field(one, "pose", dict, topic))) for _, one in heard(seen, topic)]


def _judge_stages(seen: Seen) -> None:
    told = _reports(seen, 1)
    goals = [[_spot(one) for _, one in heard(seen, f"/robot1/{kind}_pose")] for kind in ("pickup", "delivery")]
    if len(told) < 100 or not all(goals):
        what = f"{len(told)} reports; it said: {last_words(said(seen, 1))}"
        raise Wrong("a robot that asks for work and reports 30 times a second", what, "Was it built?")
    task, begun = -1, 0
    for index, ((old, before), (new, after)) in enumerate(itertools.pairwise(told)):
        if old == 6:
            task, begun = task + (new == 0), index + 1
            continue
        _judge_step(old, new, before, after)
        if new != old:
            if not 0 <= task < min(map(len, goals)):
                raise Wrong("poses of the manager before work begins", f"stage {old} without them", hint=NO_HINT)
            _judge_stage(old, told[begun][1], after, goals[old // 3][task], index + 1 - begun)
            begun = index + 1
    if task < 1:
        share = 0.1 * max(0, min(told[-1][0], 6)) if task == 0 else 0.0
        stage = f"it is still in stage {told[-1][0]}"
        raise Wrong("a load delivered and new poses within 75 s", stage, share=share, hint=NO_HINT)


def _judge_step(old: int, new: int, before: Spot, after: Spot) -> None:
    moved, turned = math.dist(before[:2], after[:2]), abs(math.remainder(after[2] - before[2], math.tau))
    if not 0 <= old <= 5 or new not in (old, old + 1):
        raise Wrong(f"stage {old} or {old + 1} after a step in stage {old}", f"stage {new}", hint=NO_HINT)
    if moved > STEP + 1e-6 or turned > TURN + 1e-6:
        cause = "theta is in radians: 1° is math.radians(1)." if near(turned, 1.0, 1e-6) else ""
        seen = f"{moved:.4f} m and {math.degrees(turned):.2f}°"
        raise Wrong(f"in stage {old} at most 0.01 m and 1° a step", seen, cause, hint=NO_HINT if cause else 2)
    if old in (1, 4) and turned > 1e-6:
        wanted = f"in stage {old} the robot moves straight on"
        raise Wrong(wanted, f"it turns by {math.degrees(turned):.2f}°", share=0.3, hint=1)
    if old not in (1, 4) and moved > 1e-6:
        raise Wrong(f"in stage {old} the robot turns on the spot", f"it moves by {moved:.4f} m", share=0.3, hint=1)


def _judge_stage(stage: int, begin: Spot, end: Spot, goal: Spot, steps: int) -> None:
    if stage in (1, 4):
        off, whole, what = math.dist(end[:2], goal[:2]), math.dist(begin[:2], goal[:2]) / STEP, "place"
    else:
        aim = math.atan2(goal[1] - begin[1], goal[0] - begin[0]) if stage in (0, 3) else goal[2]
        off = abs(math.remainder(end[2] - aim, math.tau))
        whole, what = abs(math.remainder(begin[2] - aim, math.tau)) / TURN, "yaw"
    unit = "m" if what == "place" else "rad"
    if off > 1e-4:
        cause = "The last, shorter step has to end at the goal." if off < TURN * 1.1 else "To which of the two poses?"
        if steps < whole - 1.5 and near(off / (STEP if what == "place" else TURN), whole - steps, 0.01):
            cause = "The next stage comes too early: only when nothing is left, this one is over."
        raise Wrong(f"stage {stage} ends exactly at its {what}", f"{off:.3f} {unit} beside it", cause, share=0.4)
    if steps > whole + 2.5:
        cause = "Does it turn the longer way round?" if what == "yaw" else "Are the steps too small?"
        raise Wrong(f"stage {stage} takes {math.ceil(whole)} steps", f"{steps} steps", cause, share=0.5)


def _spot(pose: Any) -> Spot:
    x, y, theta = fields(pose, ("x", "y", "theta"), "a pose")
    return x, y, theta


@exercise(
    "ch07.q3",
    "A robot that goes silent",
    points=2,
    hints=(
        "Two things have to be remembered: the stage that was heard last, and how many cycles ago that was.",
        "Never heard is not the same as silent. And stage 0 is a stage like any other.",
    ),
)
def silent(work: Work) -> None:
    """The table, cycle by cycle, of robots that speak, fall silent, come back, or never were."""
    work.built(MONITOR)
    begin = 0.5 + 1 / 60  # between two cycles
    times = {
        1: (4, [begin + 0.1 * step for step in range(16)]),
        3: (0, [begin + 0.9 * step for step in range(6)]),
        4: (work.dice("ch07.q3").choice((1, 2, 3, 5)), [begin, begin + 2.0, begin + 2.1]),
    }
    spoken = [
        (
            when,
            f"/robot{robot}/robot_status",
            "s7_robot_network_interface/msg/RobotStatus",
            {"robot_id": robot, "task_stage": stage},
        )
        for robot, (stage, whens) in times.items()
        for when in whens
    ]
    seen = work.try_out(f"run {MONITOR} logger_exe", publish=spoken, seconds=5.2)
    shown: dict[int, list[int]] = {robot: [] for robot in range(1, 5)}
    for robot, stage in re.findall(r"^ +([1-4]) \| (\d{1,3}) ", said(seen), re.M):
        shown[int(robot)].append(int(stage))
    if min(len(stages) for stages in shown.values()) < 120:
        what = f"the logger said: {last_words(said(seen))}"
        raise Wrong("a table of four robots, 30 times a second", what, "Was it built?")
    _judge_silence(shown, times[4][0])


def _judge_silence(shown: dict[int, list[int]], back: int) -> None:
    found = {robot: [stage for stage, _ in itertools.groupby(stages)] for robot, stages in shown.items()}
    cases = (
        (2, [8], "a robot that was never heard", "Not silent for long enough: that is not a fault yet.", 0.5),
        (1, [8, 4, 7], "a robot that reports stage 4, then falls silent", "", 0.0),
        (
            3,
            [8, 0],
            "a robot that reports stage 0 each 0.9 s",
            "Each status restarts the count. Do you treat stage 0 as no status?",
            0.5,
        ),
        (4, [8, back, 7, back, 7], "a robot that falls silent, comes back, and falls silent again", "", 0.5),
    )
    for robot, wanted, what, cause, share in cases:
        if found[robot] != wanted:
            raise Wrong(f"the stages {_row(wanted)} of {what}", _row(found[robot]), cause, share=share, hint=1)
    silent = shown[1].count(4) - 45 + 1  # it reports for 45 cycles
    if silent != 30:
        cause = "The first cycle after a status is number 1." if abs(silent - 30) < 3 else "Is each cycle counted?"
        raise Wrong("stage 7 in the 30th silent cycle in a row", f"in cycle {silent}", cause, share=0.5, hint=0)


def _row(stages: Sequence[int]) -> str:
    return ", ".join(str(one) for one in stages[:8]) + (", ..." if len(stages) > 8 else "")


@exercise(
    "ch07.q4",
    "No collisions",
    points=3,
    hints=(
        "Draw two poses, and look whether the way over them keeps clear of all the other ways. If it does not, draw again.",
        "How far are two ways from each other? Take points each few centimetres on both, and the nearest pair of them.",
        "What if no draw fits? One position is certainly free: the robot's own.",
    ),
)
def no_collisions(work: Work) -> None:
    """Four robots work for a minute and a half, with several seeds."""
    work.built(MANAGER)
    for seed in work.dice("ch07.q4").sample(SEEDS, 2):
        told = work.try_out(*_crew(seed), record=[f"/robot{n}/robot_status" for n in range(1, 5)], seconds=90.0)
        _judge_crew(told)


def _crew(seed: int) -> list[str]:
    robots = [
        f"run {CLIENT} client_exe --ros-args -r __ns:=/robot{n} -r get_two_poses:=/get_two_poses -p robot_id:={n}"
        for n in range(1, 5)
    ]
    return [f"run {MANAGER} safe_exe --ros-args -p seed:={seed}", *robots]


def _judge_crew(seen: Seen) -> None:
    told = [_reports(seen, number) for number in range(1, 5)]
    if min(len(one) for one in told) < 2500 or any(one[-1][0] == 6 == one[-60][0] for one in told):
        what = f"the manager said: {last_words(said(seen))}"
        raise Wrong("four robots at work for 90 seconds", what, "Does `choose` return?")
    for robot, reports in enumerate(told, 1):
        for (_, before), (_, after) in itertools.pairwise(reports):
            if not math.dist(before[:2], after[:2]) <= STEP + 1e-6:
                raise Wrong("steps of at most 0.01 m", f"robot{robot} jumps", "Is exercise 2 solved?", share=0.2)
    for (one, first), (two, second) in itertools.combinations(enumerate(told, 1), 2):
        for cycle, ((_, a), (_, b)) in enumerate(zip(first, second, strict=False)):
            gap = math.dist(a[:2], b[:2])
            if not gap >= APART:
                where = f"after {cycle / 30:.0f} s robot{one} and robot{two} are {gap:.3f} m apart"
                cause = "Whole routes count: from the robot's position, over the pickup, to the delivery."
                raise Wrong(f"always {APART} m between two robots", where, cause, share=0.2, hint=1)
    _judge_deliveries(told)


def _judge_deliveries(told: list[list[tuple[int, Spot]]]) -> None:
    done = [sum(way > 0.5 for way in _carried(one)) for one in told]
    if sum(done) < 8 or min(done) < 1:
        each = ", ".join(f"robot{n} {count}" for n, count in enumerate(done, 1))
        cause = "Are there enough tries before it gives up, and does every robot get work?"
        raise Wrong("8 loads in 90 seconds carried 0.5 m or further, one by each robot", each, cause, share=0.6, hint=2)


def _carried(told: list[tuple[int, Spot]]) -> list[float]:
    """How far each load was carried [m]."""
    found: list[float] = []
    picked: Spot | None = None
    for (old, _), (new, place) in itertools.pairwise(told):
        if (old, new) == (2, 3):
            picked = place
        elif (old, new) == (4, 5) and picked is not None:
            found.append(math.dist(picked[:2], place[:2]))
    return found
