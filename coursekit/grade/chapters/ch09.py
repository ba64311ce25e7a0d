"""Chapter 9: costs around walls, the cheapest path, a driven patrol, four robots that never meet."""

from __future__ import annotations

import math
from contextlib import suppress
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from coursekit.grade.chapters.measures.cheapest import Cell, cells_of, path_back, prices
from coursekit.grade.chapters.measures.warehouse import delivered, expect_apart, expect_drivable, warehouse
from coursekit.grade.exercise import exercise
from coursekit.grade.figures.drives import driven, estimates_and_plans
from coursekit.grade.figures.floors import closed_floor, crew, inflated, path_over_costs, spots
from coursekit.grade.outputs import course_said, exit_code, last_words, said
from coursekit.grade.plain import called, fields, shown, whole
from coursekit.grade.verdict import NO_HINT, Wrong
from coursekit.grade.work import Work
from coursekit.systems.command_lines import join_words

if TYPE_CHECKING:
    from collections.abc import Sequence
    from random import Random

    import numpy as np

PACKAGE, STOPS = "s9_py_delivery", ((1.2, 0.0), (2.4, -0.4), (0.6, 0.3))
NEAR, ROUND_SECONDS = 0.5, 32.0
"""The distance that counts as reaching a stop [m], and the maximum duration of the round [s]."""
SIMULATION = "launch coursekit_robots simulation.launch.py world:=robot_world"
JUMP = 0.3
"""The distance between two odometry messages [m] above which she was moved without driving."""


@exercise(
    "ch09.q1",
    "Inflation",
    points=1,
    hints=(
        "Four cases, from the wall outward. Which of them does a distance of exactly 0.2 belong to?",
        "int() cuts off what is behind the point.",
    ),
)
def inflation(work: Work) -> None:
    """Check nav2's formula, also with other radii and scalings."""
    cost, chance = work.function("inflation_cost"), work.dice("ch09.q1")
    for inscribed, scaling, radius in ((0.2, 3.0, 0.55), (0.3, 10.0, 1.0), (0.1, 1.5, 2.0)):
        gaps = [0.0, inscribed / 2, inscribed, inscribed + 0.05, inscribed + 0.2, radius, radius + 0.01, 9.0]
        asked: list[tuple[float, float]] = []
        work.illustrate(inflated, asked, inscribed, scaling, radius)
        for gap in [*gaps, *(round(chance.uniform(inscribed, radius), 3) for _ in range(12))]:
            _judge_cost(cost, (gap, inscribed, scaling, radius), asked)
    _judge_cost(cost, (0.3,), [])


def _judge_cost(cost: Any, given: tuple[float, ...], asked: list[tuple[float, float]]) -> None:
    """Raise Wrong unless it is nav2's cost; the answer at its distance is added to `asked`."""
    gap, inscribed, scaling, radius = given if len(given) > 1 else (*given, 0.2, 3.0, 0.55)
    exact = 252 * math.exp(-scaling * (gap - inscribed))
    if inscribed < gap <= radius and abs(exact - round(exact)) < 1e-6:
        return  # two ways of computing the same sum may differ here
    need = 254 if gap <= 0 else 253 if gap <= inscribed else int(exact) if gap <= radius else 0
    told = f"{need} at {gap:g} m, with inscribed {inscribed:g}, scaling {scaling:g} and radius {radius:g}"
    answer = called(cost, *given, told=f"inflation_cost at {gap:g} m")
    got = whole(answer, f"an integer: {told}", "Is there a return in each case, and is it cut off?")
    asked.append((gap, got))
    if got != need:
        edge = gap in (0.0, inscribed, radius)
        cut = inscribed < gap <= radius and got == round(exact)
        cause = "It is at the edge of a case." if edge else "Cut off, not rounded." if cut else _why_cost(got, *given)
        raise Wrong(told, gave=f"{got}", cause=cause, hint=0 if edge else 1 if cut else NO_HINT, at=[(gap, got)])


def _why_cost(got: int, gap: float, inscribed: float = 0.2, scaling: float = 3.0, radius: float = 0.55) -> str:
    if inscribed < gap <= radius and got == 0:
        return "Is `radius` used, or the number that it is by default?"
    if got == int(252 * math.exp(-scaling * gap)):
        return "The cost begins to fall at `inscribed`, not at the wall: it is the distance beyond that which counts."
    if got == int(252 * math.exp(-3.0 * (gap - inscribed))):
        return "Is `scaling` used, or the number that it is by default?"
    return "Which of the cases is it, and what does its formula give?"


@exercise(
    "ch09.q2",
    "The planner",
    points=3,
    hints=(
        "The heap may hold tuples (price plus steps still to come, price, path so far). heappop gives the smallest.",
        "When a cell is first taken from the heap, its cheapest path is known: skip it when it comes again.",
    ),
)
def planner(work: Work) -> None:
    """Check for drivable paths, of which none is cheaper."""
    import numpy as np

    find, chance = work.function("find_path"), np.random.default_rng(work.dice("ch09.q2").getrandbits(60))
    open_floor = np.zeros((6, 9), int)
    _judge_path(work, find, open_floor, (0, 0), (5, 8), "an empty floor of 6 x 9")
    _judge_path(work, find, open_floor, (2, 2), (2, 2), "start and goal in one cell")
    closed = open_floor.copy()
    closed[:, 4] = 253
    _judge_path(work, find, closed, (2, 1), (2, 7), "a floor that 253 cuts in two")
    dear = open_floor.copy()
    dear[0:5, 4] = 200
    _judge_path(work, find, dear, (0, 1), (0, 7), "a dear strip that one can go around")
    for number in range(1, 25):
        costs = chance.integers(0, 253, (14, 17)) * (chance.random((14, 17)) < 0.5)
        costs[chance.random((14, 17)) < 0.25] = 254
        costs[0, 0] = costs[13, 16] = 0
        _judge_path(work, find, costs, (0, 0), (13, 16), f"random floor {number}")


def _judge_path(work: Work, find: Any, costs: np.ndarray, start: Cell, goal: Cell, told: str) -> None:
    got, price = called(find, costs.copy(), start, goal, told=f"find_path on {told}"), prices(costs, start)
    least = float(price[goal])
    if math.isinf(least):
        if got is not None:
            with suppress(Wrong):
                work.illustrate(closed_floor, costs, cells_of(got, told), start, goal, told)
            empty = type(got) in (list, tuple) and not got
            cause = "An empty list is not None." if empty else "Nothing of 253 and more may be entered."
            raise Wrong(f"None on {told}: no path leads there", gave=shown(got, 60), cause=cause)
        return
    work.illustrate(path_over_costs, costs, [], path_back(price, goal), told)
    path = cells_of(got, told)
    work.illustrate(path_over_costs, costs, path, path_back(price, goal), told)
    if not path or path[0] != start or path[-1] != goal:
        turned = path[:1] == [goal] and path[-1:] == [start]
        cause = "It is the wrong way round." if turned else "Both ends belong to it."
        expected = f"a path from {start} to {goal} on {told}"
        raise Wrong(expected, gave=shown(path, 60), cause=cause, share=0.1, at=spots(start, goal))
    for before, after in pairwise(path):
        _expect_step(costs, before, after, told)
    paid = sum(1 + float(costs[cell]) / 50 for cell in path[1:])
    if not paid <= least + 1e-6:
        cause = "Is the goal taken when it comes out of the heap, not when it goes in? Are the costs of the cells counted?"
        wanted = f"a path of price {least:.2f} on {told}"
        raise Wrong(wanted, gave=f"one of {paid:.2f}", cause=cause, share=0.5, hint=1)


def _expect_step(costs: np.ndarray, before: Cell, after: Cell, told: str) -> None:
    inside = 0 <= after[0] < costs.shape[0] and 0 <= after[1] < costs.shape[1]
    at = spots(after)
    if abs(before[0] - after[0]) + abs(before[1] - after[1]) != 1 or not inside:
        gave = f"{before} to {after}"
        raise Wrong(f"steps to one of the four neighbours on {told}", gave=gave, share=0.1, hint=NO_HINT, at=at)
    if not costs[after] < 253:
        gave = f"{after}, which costs {costs[after]}"
        raise Wrong(f"no cell of 253 and more on {told}", gave=gave, share=0.1, hint=NO_HINT, at=at)


@exercise(
    "ch09.q3",
    "The round",
    points=3,
    hints=(
        "Three things before the first goal: the pose for amcl, waiting for navigation, and rclpy.init() before all.",
        "goToPose returns at once. Loop until isTaskComplete() is true before you send the next goal.",
    ),
)
def patrol(work: Work) -> None:
    """Check that the robot reaches every stop in order, and that the program reports it and ends."""
    work.built(PACKAGE)
    course_map = join_words([f"map:={_course_map()}"])
    navigation = f"launch nav2_bringup bringup_launch.py {course_map} use_sim_time:=True"
    seen = work.try_out(
        beside=[SIMULATION, navigation],
        later=[(3.0, f"run {PACKAGE} patrol_exe --ros-args -p use_sim_time:=true")],
        record=["/odom", "/plan", "/amcl_pose"],
        seconds=ROUND_SECONDS,
    )
    place = "pose.pose.position"
    track = [fields(message, (f"{place}.x", f"{place}.y"), "/odom") for _, message in course_said(seen, "/odom")]
    work.illustrate(driven, _course_map(), track, *estimates_and_plans(seen), STOPS)
    _expect_stops(track, last_words(said(seen)))
    lines = [line for line in said(seen).splitlines() if line.startswith("stop ")]
    if lines != [f"stop {number}: SUCCEEDED" for number in range(1, len(STOPS) + 1)]:
        got = "; ".join(lines)[:300] or "no line that begins with `stop`"
        wanted = "a line for each stop, like `stop 1: SUCCEEDED`"
        raise Wrong(wanted, got, _why_lines(said(seen)), share=0.5, hint=NO_HINT)
    if exit_code(seen) != 0:
        raise Wrong("exit status 0 after the last stop", f"{exit_code(seen)}", "Does main end?", share=0.75)


def _why_lines(output: str) -> str:
    if "]: stop " in output:
        return "The logger writes a stamp and a name in front: the lines are to be printed with `print`."
    return "The word alone is `getResult().name`." if "TaskResult." in output else ""


def _course_map() -> str:
    """Return the course's map of the room: the student's map is judged elsewhere."""
    from ament_index_python.packages import get_package_share_directory

    return get_package_share_directory("coursekit_maps") + "/robot_world.yaml"


def _expect_stops(track: Sequence[tuple[float, ...]], last: str) -> None:
    """Raise Wrong unless each stop is reached after the one before, by driving."""
    if any(not math.dist(one, other) < JUMP for one, other in pairwise(track)):
        raise Wrong("Vera drives the round", "she was moved without driving", hint=NO_HINT)
    at = 0
    for number, (x, y) in enumerate(STOPS, 1):
        gaps = [math.hypot(point[0] - x, point[1] - y) for point in track[at:]]
        first = next((k for k, gap in enumerate(gaps) if gap < NEAR), None)
        if first is None:
            cause = f"Does each goal wait for the end of the one before? The program's last words: {last[:160]}"
            nearest = f"never nearer than {min(gaps):.1f} m" if gaps else "the robot did not move"
            share, hint = 0.25 * (number > 1), int(number > 1)
            raise Wrong(f"Vera at stop {number}, ({x:g}, {y:g})", nearest, cause, share=share, hint=hint, at=[(x, y)])
        at += first


@exercise(
    "ch09.q4",
    "The task manager",
    points=3,
    hints=(
        "Plan one robot's trip after the other: with `leg` to the load, with `leg` home, then `reserve`.",
        "Which robot gets the next load? The one that is home first. And which load: far ones early, or near ones early?",
    ),
)
def task_manager(work: Work) -> None:
    """Check for no collision and full delivery, in half the time of one robot."""
    manage, chance = work.function("manage"), work.dice("ch09.q4")
    told = [_judge_plan(work, manage, number, chance) for number in range(1, 6)]
    slow = [run for run in told if run.ticks > run.alone / 2]
    if slow:
        ticks, alone, number = slow[0].ticks, slow[0].alone, told.index(slow[0]) + 1
        work.illustrate(crew, *slow[0].drawn)
        cause = "Do the robots drive at the same time, and does each get its share?"
        raise Wrong(f"at most {alone // 2} ticks in warehouse {number}", gave=f"{ticks}", cause=cause, share=0.5, hint=1)


@dataclass(frozen=True)
class _Planned:
    """The ticks until the last load is at home, those one robot alone would need, and the data to draw."""

    ticks: int
    alone: int
    drawn: tuple[Any, ...]


def _judge_plan(work: Work, manage: Any, number: int, chance: Random) -> _Planned:
    import numpy as np

    free, homes, loads = warehouse(number, chance)
    told = f"warehouse {number}"
    work.illustrate(crew, free, homes, loads, {name: [home] for name, home in homes.items()}, told)
    got = called(manage, free.copy(), dict(homes), list(loads), told=f"manage, {told}")
    if type(got) is not dict or any(type(name) is not str for name in got) or set(got) != set(homes):
        cause = "Is there a `return`?" if got is None else ""
        wanted = f"a dictionary with a path for each of {', '.join(homes)}"
        raise Wrong(wanted, gave=shown(got, 60), cause=cause, hint=NO_HINT)
    paths = {name: cells_of(got[name], f"{name} in {told}") for name in homes}
    drawn = free, homes, loads, paths, told
    work.illustrate(crew, *drawn)
    for name, path in paths.items():
        expect_drivable(free, path, homes[name], f"{name} in {told}")
    expect_apart(paths, told)
    ticks = delivered(paths, homes, loads, told)
    price = prices(np.where(free, 0, 254), homes["robot1"])
    return _Planned(ticks, sum(2 * round(float(price[load])) for load in loads), drawn)
