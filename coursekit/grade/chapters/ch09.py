"""Chapter 9: costs around walls, the cheapest way, a round that is driven, four robots that never meet."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING, Any

from coursekit.grade.exercise import exercise
from coursekit.grade.outputs import course_said, exit_code, last_words, said
from coursekit.grade.plain import called, fields, items, shown, whole
from coursekit.grade.verdict import NO_HINT, Wrong
from coursekit.grade.work import Work

if TYPE_CHECKING:
    from collections.abc import Sequence
    from random import Random

    import numpy as np

Cell = tuple[int, int]
PACKAGE, STOPS = "s9_py_delivery", ((1.2, 0.0), (2.4, -0.4), (0.6, 0.3))
NEAR, ROUND_SECONDS, MOST_TICKS = 0.5, 32.0, 5000
"""So near [m] the robot comes to a stop; so long [s] the round may take; so many ticks a plan may have."""
SIMULATION = "launch coursekit_robots simulation.launch.py world:=robot_world"
JUMP = 0.3
"""Further than this [m] she does not come between two odometry messages, unless she was put there."""


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
    """nav2's formula, also with other radii and scalings."""
    cost, chance = work.function("inflation_cost"), work.dice("ch09.q1")
    for inscribed, scaling, radius in ((0.2, 3.0, 0.55), (0.3, 10.0, 1.0), (0.1, 1.5, 2.0)):
        gaps = [0.0, inscribed / 2, inscribed, inscribed + 0.05, inscribed + 0.2, radius, radius + 0.01, 9.0]
        for gap in [*gaps, *(round(chance.uniform(inscribed, radius), 3) for _ in range(12))]:
            _judge_cost(cost, (gap, inscribed, scaling, radius))
    _judge_cost(cost, (0.3,))


def _judge_cost(cost: Any, given: tuple[float, ...]) -> None:
    gap, inscribed, scaling, radius = given if len(given) > 1 else (*given, 0.2, 3.0, 0.55)
    exact = 252 * math.exp(-scaling * (gap - inscribed))
    if inscribed < gap <= radius and abs(exact - round(exact)) < 1e-6:
        return  # two ways to write the same sum may differ here
    need = 254 if gap <= 0 else 253 if gap <= inscribed else int(exact) if gap <= radius else 0
    told = f"{need} at {gap:g} m, with inscribed {inscribed:g}, scaling {scaling:g} and radius {radius:g}"
    answer = called(cost, *given, told=f"inflation_cost at {gap:g} m")
    got = whole(answer, f"an integer: {told}", "Is there a return in each case, and is it cut off?")
    if got != need:
        edge = gap in (0.0, inscribed, radius)
        cut = inscribed < gap <= radius and got == round(exact)
        cause = "It is at the edge of a case." if edge else "Cut off, not rounded." if cut else _why_cost(got, *given)
        raise Wrong(told, gave=f"{got}", cause=cause, hint=0 if edge else 1 if cut else NO_HINT)


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
        "The heap may hold tuples (price plus steps still to come, price, way so far). heappop gives the smallest.",
        "A cell that was taken from the heap once has its cheapest way: skip it when it comes again.",
    ),
)
def planner(work: Work) -> None:
    """Ways that may be driven, and none is cheaper."""
    import numpy as np

    find, chance = work.function("find_way"), np.random.default_rng(work.dice("ch09.q2").getrandbits(60))
    open_floor = np.zeros((6, 9), int)
    _judge_way(find, open_floor, (0, 0), (5, 8), "an empty floor of 6 x 9")
    _judge_way(find, open_floor, (2, 2), (2, 2), "start and goal in one cell")
    closed = open_floor.copy()
    closed[:, 4] = 253
    _judge_way(find, closed, (2, 1), (2, 7), "a floor that 253 cuts in two")
    dear = open_floor.copy()
    dear[0:5, 4] = 200
    _judge_way(find, dear, (0, 1), (0, 7), "a dear strip that one can go around")
    for number in range(1, 25):
        costs = chance.integers(0, 253, (14, 17)) * (chance.random((14, 17)) < 0.5)
        costs[chance.random((14, 17)) < 0.25] = 254
        costs[0, 0] = costs[13, 16] = 0
        _judge_way(find, costs, (0, 0), (13, 16), f"random floor {number}")


def _judge_way(find: Any, costs: np.ndarray, start: Cell, goal: Cell, told: str) -> None:
    got, least = called(find, costs.copy(), start, goal, told=f"find_way on {told}"), _least(costs, start, goal)
    if math.isinf(least):
        if got is not None:
            cause = "Nothing of 253 and more may be entered."
            raise Wrong(f"None on {told}: no way leads there", gave=shown(got, 60), cause=cause)
        return
    way = _cells(got, told)
    if not way or way[0] != start or way[-1] != goal:
        cause = "Both ends belong to it."
        raise Wrong(f"a way from {start} to {goal} on {told}", gave=shown(way, 60), cause=cause, share=0.1)
    for before, after in pairwise(way):
        _expect_step(costs, before, after, told)
    price = sum(1 + float(costs[cell]) / 50 for cell in way[1:])
    if not price <= least + 1e-6:
        cause = "Is the goal taken when it comes out of the heap, not when it goes in? Are the costs of the cells counted?"
        wanted = f"a way of price {least:.2f} on {told}"
        raise Wrong(wanted, gave=f"one of {price:.2f}", cause=cause, share=0.5, hint=1)


def _expect_step(costs: np.ndarray, before: Cell, after: Cell, told: str) -> None:
    inside = 0 <= after[0] < costs.shape[0] and 0 <= after[1] < costs.shape[1]
    if abs(before[0] - after[0]) + abs(before[1] - after[1]) != 1 or not inside:
        raise Wrong(f"steps to one of the four neighbours on {told}", gave=f"{before} to {after}", share=0.1, hint=NO_HINT)
    if not costs[after] < 253:
        gave = f"{after}, which costs {costs[after]}"
        raise Wrong(f"no cell of 253 and more on {told}", gave=gave, share=0.1, hint=NO_HINT)


def _cells(got: Any, told: str) -> list[Cell]:
    wanted = f"a list of cells (row, column) for {told}"
    found = items(got, wanted)
    if len(found) > 2 * MOST_TICKS:
        raise Wrong(wanted, gave=f"{len(found)} cells", hint=NO_HINT)
    pairs = [[whole(part, wanted) for part in items(one, wanted)] for one in found]
    if any(len(pair) != 2 for pair in pairs):
        raise Wrong(wanted, gave=shown(got, 60), hint=NO_HINT)
    return [(row, column) for row, column in pairs]


def _least(costs: np.ndarray, start: Cell, goal: Cell) -> float:
    """The price of the cheapest way, by relaxing all cells until nothing changes."""
    import numpy as np

    price = np.full((costs.shape[0] + 2, costs.shape[1] + 2), np.inf)
    inner, entry = price[1:-1, 1:-1], np.where(costs < 253, 1 + costs / 50, np.inf)
    inner[start] = 0.0
    while True:
        around = np.minimum.reduce([price[:-2, 1:-1], price[2:, 1:-1], price[1:-1, :-2], price[1:-1, 2:]])
        better = np.minimum(inner, around + entry)
        if np.array_equal(better, inner):
            return float(inner[goal])
        inner[:] = better


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
    """The robot comes to every stop, in order, and the program says so and ends."""
    work.built(PACKAGE)
    seen = work.try_out(
        beside=[SIMULATION, f"launch nav2_bringup bringup_launch.py map:={_course_map()} use_sim_time:=True"],
        later=[(3.0, f"run {PACKAGE} patrol_exe --ros-args -p use_sim_time:=true")],
        record=["/odom"],
        seconds=ROUND_SECONDS,
    )
    place = "pose.pose.position"
    track = [fields(one, (f"{place}.x", f"{place}.y"), "/odom") for _, one in course_said(seen, "/odom")]
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
    """The course's map of the room: whether the student's own is good is asked elsewhere."""
    from ament_index_python.packages import get_package_share_directory

    return get_package_share_directory("coursekit_maps") + "/robot_world.yaml"


def _expect_stops(track: Sequence[tuple[float, ...]], last: str) -> None:
    """Each stop is come to after the one before it, and driven to."""
    if any(not math.dist(one, other) < JUMP for one, other in pairwise(track)):
        raise Wrong("Vera drives the round", "she was moved without driving", hint=NO_HINT)
    at = 0
    for number, (x, y) in enumerate(STOPS, 1):
        gaps = [math.hypot(one[0] - x, one[1] - y) for one in track[at:]]
        first = next((k for k, gap in enumerate(gaps) if gap < NEAR), None)
        if first is None:
            cause = f"Does each goal wait for the end of the one before? The program's last words: {last[:160]}"
            nearest = f"never nearer than {min(gaps):.1f} m" if gaps else "the robot did not move"
            share = 0.25 * (number > 1)
            raise Wrong(f"Vera at stop {number}, ({x:g}, {y:g})", nearest, cause, share=share, hint=1 if number > 1 else 0)
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
    """No collision, everything delivered, and in half the time of one robot."""
    manage, chance = work.function("manage"), work.dice("ch09.q4")
    told = [_judge_plan(manage, number, chance) for number in range(1, 6)]
    slow = [(ticks, alone, number) for number, (ticks, alone) in enumerate(told, 1) if ticks > alone / 2]
    if slow:
        ticks, alone, number = slow[0]
        cause = "Do the robots drive at the same time, and does each get its share?"
        raise Wrong(f"at most {alone // 2} ticks in warehouse {number}", gave=f"{ticks}", cause=cause, share=0.5, hint=1)


def _judge_plan(manage: Any, number: int, chance: Random) -> tuple[int, int]:
    """Ticks until the last load is at home, and what one robot alone would need."""
    free, homes, loads = _warehouse(number, chance)
    told = f"warehouse {number}"
    got = called(manage, free.copy(), dict(homes), list(loads), told=f"manage, {told}")
    if type(got) is not dict or any(type(name) is not str for name in got) or set(got) != set(homes):
        cause = "Is there a `return`?" if got is None else ""
        wanted = f"a dictionary with a way for each of {', '.join(homes)}"
        raise Wrong(wanted, gave=shown(got, 60), cause=cause, hint=NO_HINT)
    ways = {name: _cells(got[name], f"{name} in {told}") for name in homes}
    for name, way in ways.items():
        _expect_drivable(free, way, homes[name], f"{name} in {told}")
    _expect_apart(ways, told)
    ticks = _delivered(ways, homes, loads, told)
    home = homes["robot1"]
    alone = sum(2 * round(_least(_costs(free), home, load)) for load in loads)
    return ticks, alone


def _costs(free: np.ndarray) -> np.ndarray:
    import numpy as np

    return np.where(free, 0, 254)


def _warehouse(number: int, chance: Random) -> tuple[np.ndarray, dict[str, Cell], list[Cell]]:
    """Aisles between shelves; homes at the left, each a bay, and loads in bays of the shelves."""
    import numpy as np

    aisles, width = 2 + number % 2, 16 + number
    free = np.zeros((4 * aisles + 2, width), bool)
    rows = [4 * k + 2 for k in range(aisles)]
    free[rows, 2:-1] = free[[row + 1 for row in rows], 2:-1] = True
    free[1 : rows[-1] + 2, 2] = free[rows[0] : rows[-1] + 2, width - 2] = True
    homes = {f"robot{k + 1}": (2 * k + 1, 1) for k in range(4)}
    bays = [(row - 1, column) for row in rows for column in range(5, width - 3, 3)]
    loads = chance.sample(bays, 8)
    for cell in [*homes.values(), *loads]:
        free[cell] = True
    return free, homes, loads


def _expect_drivable(free: np.ndarray, way: list[Cell], home: Cell, told: str) -> None:
    if not way or way[0] != home:
        raise Wrong(f"a way of {told} that begins at its home {home}", gave=f"{way[:3]}", hint=NO_HINT)
    if len(way) > MOST_TICKS:
        raise Wrong(f"at most {MOST_TICKS} ticks for {told}", gave=f"{len(way)}", hint=NO_HINT)
    for before, after in pairwise(way):
        if abs(before[0] - after[0]) + abs(before[1] - after[1]) > 1:
            raise Wrong(f"{told} stays or goes to a neighbour in each tick", gave=f"{before} to {after}", hint=NO_HINT)
        inside = 0 <= after[0] < free.shape[0] and 0 <= after[1] < free.shape[1]
        if not inside or not free[after]:
            raise Wrong(f"{told} on free cells", gave=f"{after}, which is none", hint=NO_HINT)


def _at(way: list[Cell], tick: int) -> Cell:
    return way[min(tick, len(way) - 1)]


def _expect_apart(ways: dict[str, list[Cell]], told: str) -> None:
    for tick in range(1, max(map(len, ways.values()))):
        seen: dict[Cell, str] = {}
        moves = {(_at(way, tick - 1), _at(way, tick)): name for name, way in ways.items()}
        for name, way in ways.items():
            here, before = _at(way, tick), _at(way, tick - 1)
            other = seen.setdefault(here, name)
            if other != name:
                raise Wrong(f"one robot to a cell in {told}", f"{other} and {name} both in {here} at tick {tick}", hint=0)
            if here != before and (here, before) in moves:
                what = f"{name} and {moves[here, before]} change places at tick {tick}: {before}, {here}"
                raise Wrong(f"no two robots through each other in {told}", what, "The moves are to be reserved, too.")


def _delivered(ways: dict[str, list[Cell]], homes: dict[str, Cell], loads: list[Cell], told: str) -> int:
    """The tick when the last load is at home."""
    left, carried, done, last = set(loads), dict.fromkeys(ways, False), 0, 0
    for tick in range(max(map(len, ways.values()))):
        for name, way in ways.items():
            here = _at(way, tick)
            if carried[name] and here == homes[name]:
                carried[name], done, last = False, done + 1, tick
            elif not carried[name] and here in left:
                left.remove(here)
                carried[name] = True
    if done < len(loads):
        cause = "After each load the robot has to come home before it can take another."
        raise Wrong(f"all {len(loads)} loads of {told} at home", f"{done}", cause, share=0.25 if done else 0.0)
    return last
