"""Chapter 7: a pose seen from another, the stages of a robot, a robot that goes silent, four that do not collide."""

from __future__ import annotations

import itertools
import math
import random
import re
from collections.abc import Sequence
from typing import Any

from coursekit.grade.exercise import exercise
from coursekit.grade.trial import Seen
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work

CLIENT, MANAGER, MONITOR = "s7_py_client_robot", "s7_py_task_manager", "s7_py_robot_task_monitoring"
STEP, TURN = 0.01, math.radians(1)
"""The most that a robot moves [m] and turns [rad] in a step."""
APART = 0.4
"""Robots' middles closer than this may touch [m]."""
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
    function = work.function("seen")
    dice = random.Random(7)
    for index in range(20):
        me, other = (tuple(round(dice.uniform(-3, 3), 2) for _ in range(3)) for _ in range(2))
        if index == 0:
            me, other = (1.0, 1.0, 0.0), (2.0, 3.0, 0.5)
        _judge_seen(function(me, other), me, other)


def _judge_seen(got: Any, me: Sequence[float], other: Sequence[float]) -> None:
    told = f"seen({tuple(me)}, {tuple(other)})"
    if not isinstance(got, tuple | list) or len(got) != 3:
        raise Wrong(f"three numbers (x, y, yaw) from {told}", repr(got)[:80])
    wanted = _relative(me, other)
    x, y, yaw = (float(one) for one in got)
    shown, right = (f"({a:.3f}, {b:.3f}, {c:.3f})" for a, b, c in ((x, y, yaw), wanted))
    if math.dist((x, y), wanted[:2]) > 1e-6:
        raise Wrong(f"{right} from {told}", shown, _slip((x, y), me, other))
    if abs(math.remainder(yaw - wanted[2], math.tau)) > 1e-6:
        raise Wrong(f"{right} from {told}", shown, "How much does the other look further to the left than I?", share=0.5)
    if abs(yaw) > math.pi + 1e-9:
        raise Wrong(f"a yaw between -pi and pi from {told}", f"{yaw:.3f}", "A full turn changes nothing.", share=0.75)


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
        ("Turned by my yaw, but in the wrong direction.", shift * complex(math.cos(me[2]), math.sin(me[2]))),
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
        "The angle that is left, brought between -pi and pi, tells which way round is shorter: math.remainder does that.",
        "Is what is left no more than one step? Then go there exactly, and return the next stage.",
    ),
)
def stages(work: Work) -> None:
    """All steps of a robot that works alone: how far, how fast, to where."""
    work.built(CLIENT)
    for seed in (7, 30):
        robot = f"run {CLIENT} client_exe --ros-args -r __ns:=/robot1 -r get_two_poses:=/get_two_poses"
        topics = [f"/robot1/{name}" for name in ("robot_status", "pickup_pose", "delivery_pose")]
        manager = f"run {MANAGER} manager_exe --ros-args -p seed:={seed}"
        _judge_stages(work.try_out(manager, robot, record=topics, seconds=60.0))


def _judge_stages(seen: Seen) -> None:
    told = [message for _, message in seen.messages.get("/robot1/robot_status", [])]
    goals = [
        [_spot(message) for _, message in seen.messages.get(f"/robot1/{one}_pose", [])] for one in ("pickup", "delivery")
    ]
    if len(told) < 100 or not goals[0]:
        said = (seen.outputs[1].strip().splitlines() or ["nothing"])[-1]
        raise Wrong("a robot that asks for work and reports 30 times a second", f"it said: {said[:120]}", "Was it built?")
    begun, pairs = 0, list(itertools.pairwise(told))
    task = -1
    for index, (before, after) in enumerate(pairs):
        old, new = before["task_stage"], after["task_stage"]
        if old == 6:
            task, begun = task + (new == 0), index + 1
            continue
        _judge_step(old, new, _spot(before["pose"]), _spot(after["pose"]))
        if new != old:
            _judge_stage(old, _spot(told[begun]["pose"]), _spot(after["pose"]), goals[old // 3][task], index + 1 - begun)
            begun = index + 1
    if task < 1:
        stage = told[-1]["task_stage"]
        share = 0.1 * stage if task == 0 else 0.0
        raise Wrong("a load delivered and new poses within a minute", f"it is still in stage {stage}", share=share)


def _judge_step(old: int, new: int, before: Spot, after: Spot) -> None:
    moved, turned = math.dist(before[:2], after[:2]), abs(math.remainder(after[2] - before[2], math.tau))
    if new not in (old, old + 1):
        raise Wrong(f"stage {old} or {old + 1} after a step in stage {old}", f"stage {new}")
    if moved > STEP + 1e-6 or turned > TURN + 1e-6:
        raise Wrong(f"in stage {old} at most 0.01 m and 1° a step", f"{moved:.4f} m and {math.degrees(turned):.2f}°")
    if old in (1, 4) and turned > 1e-6:
        raise Wrong(f"in stage {old} the robot moves straight on", f"it turns by {math.degrees(turned):.2f}°", share=0.3)
    if old not in (1, 4) and moved > 1e-6:
        raise Wrong(f"in stage {old} the robot turns on the spot", f"it moves by {moved:.4f} m", share=0.3)


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
        raise Wrong(f"stage {stage} ends exactly at its {what}", f"{off:.3f} {unit} beside it", cause, share=0.4)
    if steps > whole + 2.5:
        cause = "Does it turn the longer way round?" if what == "yaw" else "Are the steps too small?"
        raise Wrong(f"stage {stage} takes {math.ceil(whole)} steps", f"{steps} steps", cause, share=0.5)


def _spot(pose: dict[str, float]) -> Spot:
    return pose["x"], pose["y"], pose["theta"]


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
    times = {
        1: (4, [0.5 + 0.1 * step for step in range(16)]),
        3: (0, [0.5 + 0.9 * step for step in range(6)]),
        4: (2, [0.5, 2.5, 2.6]),
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
    for robot, stage in re.findall(r"^ +(\d) \| (\d+) ", seen.outputs[0], re.M):
        shown[int(robot)].append(int(stage))
    if min(len(stages) for stages in shown.values()) < 120:
        said = (seen.outputs[0].strip().splitlines() or ["nothing"])[-1]
        raise Wrong("a table of four robots, 30 times a second", f"the logger's last line: {said[:120]}", "Was it built?")
    _judge_silence(shown)


def _judge_silence(shown: dict[int, list[int]]) -> None:
    found = {robot: [stage for stage, _ in itertools.groupby(stages)] for robot, stages in shown.items()}
    cases = (
        (2, [8], "a robot that was never heard", "Nobody misses it yet: that is no fault.", 0.5),
        (1, [8, 4, 7], "a robot that reports stage 4, then falls silent", "", 0.0),
        (
            3,
            [8, 0],
            "a robot that reports stage 0 each 0.9 s",
            "Each status starts the count anew. Is 0 taken for nothing?",
            0.5,
        ),
        (4, [8, 2, 7, 2, 7], "a robot that falls silent, comes back, and falls silent again", "", 0.5),
    )
    for robot, wanted, what, cause, share in cases:
        if found[robot] != wanted:
            raise Wrong(f"the stages {_row(wanted)} of {what}", _row(found[robot]), cause, share=share)
    cycles = shown[1].count(4)
    if abs(cycles - 75) > 2:
        raise Wrong("stage 7 after 30 silent cycles", f"after {cycles - 45}", "Is each cycle counted?", share=0.5)


def _row(stages: Sequence[int]) -> str:
    return ", ".join(str(one) for one in stages[:8]) + (", ..." if len(stages) > 8 else "")


@exercise(
    "ch07.q4",
    "No collisions",
    points=3,
    hints=(
        "Draw two poses, and look whether the way over them keeps clear of all the other ways. If it does not, draw again.",
        "How far are two ways from each other? Take points each few centimetres on both, and the nearest pair of them.",
        "What if no draw fits? There is one place that is certainly free: where the robot stands.",
    ),
)
def no_collisions(work: Work) -> None:
    """Four robots work for a minute and a half, with several seeds."""
    work.built(MANAGER)
    for seed in (7, 23):
        told = work.try_out(*_crew(seed), record=[f"/robot{n}/robot_status" for n in range(1, 5)], seconds=90.0)
        _judge_crew(told, seed)


def _crew(seed: int) -> list[str]:
    robots = [
        f"run {CLIENT} client_exe --ros-args -r __ns:=/robot{n} -r get_two_poses:=/get_two_poses -p robot_id:={n}"
        for n in range(1, 5)
    ]
    return [f"run {MANAGER} safe_exe --ros-args -p seed:={seed}", *robots]


def _judge_crew(seen: Seen, seed: int) -> None:
    told = [[message for _, message in seen.messages.get(f"/robot{n}/robot_status", [])] for n in range(1, 5)]
    if min(len(one) for one in told) < 2500 or any(one[-1]["task_stage"] == 6 == one[-60]["task_stage"] for one in told):
        said = (seen.outputs[0].strip().splitlines() or ["nothing"])[-1]
        raise Wrong("four robots at work for 90 seconds", f"the manager said: {said[:120]}", "Does `choose` return?")
    for (one, first), (two, second) in itertools.combinations(enumerate(told, 1), 2):
        for cycle, (a, b) in enumerate(zip(first, second, strict=False)):
            gap = math.dist(_spot(a["pose"])[:2], _spot(b["pose"])[:2])
            if gap < APART:
                where = f"after {cycle / 30:.0f} s robot{one} and robot{two} are {gap:.2f} m apart (seed {seed})"
                cause = "Whole ways count: from where it stands, over the pickup, to the delivery."
                raise Wrong(f"always {APART} m between two robots", where, cause, share=0.2)
    _judge_deliveries(told)


def _judge_deliveries(told: list[list[dict[str, Any]]]) -> None:
    ways = [_carried(one) for one in told]
    done = [sum(way > 0.5 for way in one) for one in ways]
    if sum(done) < 8 or min(done) < 1:
        each = ", ".join(f"robot{n} {count}" for n, count in enumerate(done, 1))
        cause = "Are there enough tries before it gives up, and does every robot get work?"
        raise Wrong("8 loads in 90 seconds carried 0.5 m or further, one by each robot", each, cause, share=0.6)


def _carried(told: list[dict[str, Any]]) -> list[float]:
    """How far each load was carried [m]."""
    found, picked = [], None
    for before, after in itertools.pairwise(told):
        if (before["task_stage"], after["task_stage"]) == (2, 3):
            picked = _spot(after["pose"])[:2]
        elif (before["task_stage"], after["task_stage"]) == (4, 5) and picked is not None:
            found.append(math.dist(picked, _spot(after["pose"])[:2]))
    return found
