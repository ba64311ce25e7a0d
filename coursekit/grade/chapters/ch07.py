"""Chapter 7: a relative pose, the stages of a robot, a robot that falls silent, four robots without collisions."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Sequence

from coursekit.grade.chapters.measures.relative import judge_seen
from coursekit.grade.chapters.measures.reports import Report, carried, reports, spot_of
from coursekit.grade.chapters.measures.stages import STEP, judge_stage, judge_step
from coursekit.grade.exercise import exercise
from coursekit.grade.figures.robots import four_robots, seen_by_me, table, worked
from coursekit.grade.outputs import heard, last_words, said
from coursekit.grade.plain import called, numbers
from coursekit.grade.trial import Seen
from coursekit.grade.verdict import NO_HINT, Wrong
from coursekit.grade.work import Work

CLIENT, MANAGER, MONITOR = "s7_py_client_robot", "s7_py_task_manager", "s7_py_robot_task_monitoring"
APART = 0.4
"""The distance between robots' centres below which they may touch [m]."""
SEEDS = range(1, 40)
"""Seeds of the manager's random numbers for which enough work is possible without collisions."""


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
    """Check against tf2 for many poses."""
    function, chance = work.function("seen"), work.dice("ch07.q1")
    for index in range(20):
        me, other = (tuple(round(chance.uniform(-3, 3), 2) for _ in range(3)) for _ in range(2))
        if index == 0:
            me, other = (1.0, 1.0, 0.0), (2.0, 3.0, 0.5)
        told = f"seen({me}, {other})"
        got = called(function, me, other, told=told)
        answer = numbers(got, 3, f"three finite numbers (x, y, yaw) from {told}")
        work.illustrate(seen_by_me, me, other, answer)
        judge_seen(answer, me, other, told)


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
    """Check all steps of a robot working alone: distances, speeds and goals."""
    work.built(CLIENT)
    for seed in work.dice("ch07.q2").sample(range(1, 10_000), 2):
        robot = f"run {CLIENT} client_exe --ros-args -r __ns:=/robot1 -r get_two_poses:=/get_two_poses"
        topics = [f"/robot1/{name}" for name in ("robot_status", "pickup_pose", "delivery_pose")]
        manager = f"run {MANAGER} manager_exe --ros-args -p seed:={seed}"
        _judge_stages(work, work.try_out(manager, robot, record=topics, seconds=75.0))


def _judge_stages(work: Work, seen: Seen) -> None:
    told = reports(seen, 1)
    goals = [[spot_of(message) for _, message in heard(seen, f"/robot1/{kind}_pose")] for kind in ("pickup", "delivery")]
    if len(told) < 100 or not all(goals):
        what = f"{len(told)} reports; it said: {last_words(said(seen, 1))}"
        raise Wrong("a robot that asks for work and reports 30 times a second", what, "Was it built?")
    work.illustrate(worked, told, *goals)
    task, begun = -1, 0
    for index, ((old, before), (new, after)) in enumerate(itertools.pairwise(told)):
        if old == 6:
            task, begun = task + (new == 0), index + 1
            continue
        judge_step(old, new, before, after)
        if new != old:
            if not 0 <= task < min(map(len, goals)):
                raise Wrong("poses of the manager before work begins", f"stage {old} without them", hint=NO_HINT)
            judge_stage(old, told[begun][1], after, goals[old // 3][task], index + 1 - begun)
            begun = index + 1
    if task < 1:
        share = 0.1 * max(0, min(told[-1][0], 6)) if task == 0 else 0.0
        stage = f"it is still in stage {told[-1][0]}"
        raise Wrong("a load delivered and new poses within 75 s", stage, share=share, hint=NO_HINT)


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
    """Check the table, cycle by cycle, for robots that report, fall silent, return, or never existed."""
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
    work.illustrate(table, shown, {robot: whens for robot, (_, whens) in times.items()})
    _judge_silence(shown, times[4][0])


def _judge_silence(shown: dict[int, list[int]], back: int) -> None:
    stages_by_robot = {robot: [stage for stage, _ in itertools.groupby(stages)] for robot, stages in shown.items()}
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
        if stages_by_robot[robot] != wanted:
            raise Wrong(f"the stages {_row(wanted)} of {what}", _row(stages_by_robot[robot]), cause, share=share, hint=1)
    silent = shown[1].count(4) - 45 + 1  # it reports for 45 cycles
    if silent != 30:
        cause = "The first cycle after a status is number 1." if abs(silent - 30) < 3 else "Is each cycle counted?"
        raise Wrong("stage 7 in the 30th silent cycle in a row", f"in cycle {silent}", cause, share=0.5, hint=0)


def _row(stages: Sequence[int]) -> str:
    return ", ".join(str(stage) for stage in stages[:8]) + (", ..." if len(stages) > 8 else "")


@exercise(
    "ch07.q4",
    "No collisions",
    points=3,
    hints=(
        "Draw two poses, and check that the path over them keeps clear of all the others. If it does not, draw again.",
        "How far are two paths from each other? Take points every few centimetres on both, and the nearest pair of them.",
        "What if no draw fits? One position is certainly free: the robot's own.",
    ),
)
def no_collisions(work: Work) -> None:
    """Check four robots at work for a minute and a half, with several seeds."""
    work.built(MANAGER)
    for seed in work.dice("ch07.q4").sample(SEEDS, 2):
        told = work.try_out(*_crew(seed), record=[f"/robot{n}/robot_status" for n in range(1, 5)], seconds=90.0)
        _judge_crew(work, told)


def _crew(seed: int) -> list[str]:
    robots = [
        f"run {CLIENT} client_exe --ros-args -r __ns:=/robot{n} -r get_two_poses:=/get_two_poses -p robot_id:={n}"
        for n in range(1, 5)
    ]
    return [f"run {MANAGER} safe_exe --ros-args -p seed:={seed}", *robots]


def _judge_crew(work: Work, seen: Seen) -> None:
    told = [reports(seen, number) for number in range(1, 5)]
    if min(len(track) for track in told) < 2500 or any(track[-1][0] == 6 == track[-60][0] for track in told):
        what = f"the manager said: {last_words(said(seen))}"
        raise Wrong("four robots at work for 90 seconds", what, "Does `choose` return?")
    work.illustrate(four_robots, [[place for _, place in track] for track in told])
    for robot, steps in enumerate(told, 1):
        for (_, before), (_, after) in itertools.pairwise(steps):
            if not math.dist(before[:2], after[:2]) <= STEP + 1e-6:
                cause, at = "Is exercise 2 solved?", [after[:2]]
                raise Wrong("steps of at most 0.01 m", f"robot{robot} jumps", cause, share=0.2, at=at)
    for (one, first), (two, second) in itertools.combinations(enumerate(told, 1), 2):
        for cycle, ((_, a), (_, b)) in enumerate(zip(first, second, strict=False)):
            gap = math.dist(a[:2], b[:2])
            if not gap >= APART:
                where = f"after {cycle / 30:.0f} s robot{one} and robot{two} are {gap:.3f} m apart"
                cause = "Whole routes count: from the robot's position, over the pickup, to the delivery."
                raise Wrong(f"always {APART} m between two robots", where, cause, share=0.2, hint=1, at=[a[:2], b[:2]])
    _judge_deliveries(told)


def _judge_deliveries(told: list[list[Report]]) -> None:
    done = [sum(way > 0.5 for way in carried(track)) for track in told]
    if sum(done) < 8 or min(done) < 1:
        each = ", ".join(f"robot{n} {count}" for n, count in enumerate(done, 1))
        cause = "Are there enough tries before it gives up, and does every robot get work?"
        raise Wrong("8 loads in 90 seconds carried 0.5 m or further, one by each robot", each, cause, share=0.6, hint=2)
