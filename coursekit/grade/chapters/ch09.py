"""Chapter 9: costs around walls, the cheapest way, a round that is driven, four robots that never meet."""

from __future__ import annotations

import math
import random
from collections.abc import Mapping, Sequence
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

from coursekit.grade.exercise import exercise
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work

if TYPE_CHECKING:
    import numpy as np

Cell = tuple[int, int]
PACKAGE, STOPS = "s9_py_delivery", ((1.2, 0.0), (2.4, -0.4), (0.6, 0.3))
NEAR, ROUND_SECONDS, MOST_TICKS = 0.5, 32.0, 5000
"""So near [m] the robot comes to a stop; so long [s] the round may take; so many ticks a plan may have."""


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
    cost = work.function("inflation_cost")
    for inscribed, scaling, radius in ((0.2, 3.0, 0.55), (0.3, 10.0, 1.0), (0.1, 1.5, 2.0)):
        for gap in (0.0, inscribed / 2, inscribed, inscribed + 0.05, inscribed + 0.2, radius, radius + 0.01, 9.0):
            _expect_cost(cost(gap, inscribed, scaling, radius), gap, inscribed, scaling, radius)
    _expect_cost(cost(0.3), 0.3, 0.2, 3.0, 0.55)


def _expect_cost(got: Any, gap: float, inscribed: float, scaling: float, radius: float) -> None:
    from coursekit.nav.inflation import cost_at

    need = cost_at(gap, inscribed, scaling) if gap <= radius else 0
    told = f"{need} at {gap:g} m, with inscribed {inscribed:g}, scaling {scaling:g} and radius {radius:g}"
    if isinstance(got, bool) or not isinstance(got, int):
        raise Wrong(f"an integer: {told}", f"{got!r:.40}", "Is there a return in each case, and is it cut off?")
    if abs(got - need) > 1:
        cause = "It is at the edge of a case." if gap in (0.0, inscribed, radius) else ""
        raise Wrong(told, f"{got}", cause)


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

    find, chance = work.function("find_way"), np.random.default_rng(92)
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
    got, least = find(costs.copy(), start, goal), _least(costs, start, goal)
    if math.isinf(least):
        if got is not None:
            raise Wrong(f"None on {told}: no way leads there", f"{got!r:.60}", "Nothing of 253 and more may be entered.")
        return
    way = _cells(got, told)
    if not way or way[0] != start or way[-1] != goal:
        raise Wrong(f"a way from {start} to {goal} on {told}", f"{way!r:.60}", "Both ends belong to it.", share=0.1)
    for before, after in pairwise(way):
        _expect_step(costs, before, after, told)
    price = sum(1 + costs[cell] / 50 for cell in way[1:])
    if price > least + 1e-6:
        cause = "Is the goal taken when it comes out of the heap, not when it goes in? Are the costs of the cells counted?"
        raise Wrong(f"a way of price {least:.2f} on {told}", f"one of {price:.2f}", cause, share=0.5)


def _expect_step(costs: np.ndarray, before: Cell, after: Cell, told: str) -> None:
    inside = 0 <= after[0] < costs.shape[0] and 0 <= after[1] < costs.shape[1]
    if abs(before[0] - after[0]) + abs(before[1] - after[1]) != 1 or not inside:
        raise Wrong(f"steps to one of the four neighbours on {told}", f"{before} to {after}", share=0.1)
    if costs[after] >= 253:
        raise Wrong(f"no cell of 253 and more on {told}", f"{after} costs {costs[after]}", share=0.1)


def _cells(got: Any, told: str) -> list[Cell]:
    try:
        return [(int(row), int(column)) for row, column in got]
    except (TypeError, ValueError):
        raise Wrong(f"a list of cells (row, column) for {told}", f"{got!r:.60}", "Is there a return?") from None


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
        "goToPose returns at once. Loop until isTaskComplete() says so, before the next goal is given.",
    ),
)
def patrol(work: Work) -> None:
    """The robot comes to every stop, in order, and the program says so and ends."""
    work.built(PACKAGE)
    file = _map_of_the_room(work)
    seen = work.try_out(
        "launch coursekit_robots simulation.launch.py world:=robot_world",
        f"launch nav2_bringup bringup_launch.py map:={file} use_sim_time:=True",
        later=[(3.0, f"run {PACKAGE} patrol_exe --ros-args -p use_sim_time:=true")],
        record=["/odom"],
        seconds=ROUND_SECONDS,
    )
    said = [line for line in seen.outputs[2].splitlines() if line.startswith("stop ")]
    _expect_stops([msg["pose"]["pose"]["position"] for _, msg in seen.messages.get("/odom", [])], seen.outputs[2])
    if said != [f"stop {number}: SUCCEEDED" for number in range(1, len(STOPS) + 1)]:
        got = "; ".join(said) or "no line that begins with `stop`"
        raise Wrong("a line for each stop, like `stop 1: SUCCEEDED`", got, share=0.5)
    if seen.exit_codes[2] != 0:
        raise Wrong("exit status 0 after the last stop", f"{seen.exit_codes[2]}", "Does main end?", share=0.75)


def _map_of_the_room(work: Work) -> Path:
    """The student's own; the course's where there is none: grading does not drive once more to make it."""
    from ament_index_python.packages import get_package_share_directory

    own = work.workspace / "room.yaml"
    return own if own.is_file() else Path(get_package_share_directory("coursekit_maps")) / "robot_world.yaml"


def _expect_stops(track: Sequence[Mapping[str, float]], output: str) -> None:
    """Each stop is come to after the one before it."""
    at = 0
    for number, (x, y) in enumerate(STOPS, 1):
        gaps = [math.hypot(place["x"] - x, place["y"] - y) for place in track[at:]]
        first = next((k for k, gap in enumerate(gaps) if gap < NEAR), None)
        if first is None:
            last = (output.strip().splitlines() or ["nothing was printed"])[-1]
            cause = f"Does each goal wait for the end of the one before? The program's last line: {last:.160}"
            nearest = f"never nearer than {min(gaps):.1f} m" if gaps else "the robot did not move"
            raise Wrong(f"Vera at stop {number}, ({x:g}, {y:g})", nearest, cause, share=0.25 * (number > 1))
        at += first


@exercise(
    "ch09.q4",
    "The task manager",
    points=3,
    hints=(
        "Plan one robot's trip after the other: with `leg` to the load, with `leg` home, then `reserve`.",
        "Who gets the next load? Whoever is at home first. And which one: far ones early, or near ones early?",
    ),
)
def task_manager(work: Work) -> None:
    """No collision, everything delivered, and in half the time of one robot."""
    manage = work.function("manage")
    told = [_judge_plan(manage, number) for number in range(1, 6)]
    slow = [(ticks, alone, number) for number, (ticks, alone) in enumerate(told, 1) if ticks > alone / 2]
    if slow:
        ticks, alone, number = slow[0]
        cause = "Do the robots drive at the same time, and does each get its share?"
        raise Wrong(f"at most {alone // 2} ticks in warehouse {number}", f"{ticks}", cause, share=0.5)


def _judge_plan(manage: Any, number: int) -> tuple[int, int]:
    """Ticks until the last load is at home, and what one robot alone would need."""
    free, homes, loads = _warehouse(number)
    got, told = manage(free.copy(), dict(homes), list(loads)), f"warehouse {number}"
    if not isinstance(got, dict) or set(got) != set(homes):
        raise Wrong(f"a dictionary with a way for each of {', '.join(homes)}", f"{got!r:.60}")
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


def _warehouse(number: int) -> tuple[np.ndarray, dict[str, Cell], list[Cell]]:
    """Aisles between shelves; homes at the left, each a bay, and loads in bays of the shelves."""
    import numpy as np

    dice, aisles, width = random.Random(90 + number), 2 + number % 2, 16 + number
    free = np.zeros((4 * aisles + 2, width), bool)
    rows = [4 * k + 2 for k in range(aisles)]
    free[rows, 2:-1] = free[[row + 1 for row in rows], 2:-1] = True
    free[1 : rows[-1] + 2, 2] = free[rows[0] : rows[-1] + 2, width - 2] = True
    homes = {f"robot{k + 1}": (2 * k + 1, 1) for k in range(4)}
    bays = [(row - 1, column) for row in rows for column in range(5, width - 3, 3)]
    loads = dice.sample(bays, 8)
    for cell in [*homes.values(), *loads]:
        free[cell] = True
    return free, homes, loads


def _expect_drivable(free: np.ndarray, way: list[Cell], home: Cell, told: str) -> None:
    if not way or way[0] != home:
        raise Wrong(f"a way of {told} that begins at its home {home}", f"{way[:3]}")
    if len(way) > MOST_TICKS:
        raise Wrong(f"at most {MOST_TICKS} ticks for {told}", f"{len(way)}")
    for before, after in pairwise(way):
        if abs(before[0] - after[0]) + abs(before[1] - after[1]) > 1:
            raise Wrong(f"{told} stays or goes to a neighbour in each tick", f"{before} to {after}")
        inside = 0 <= after[0] < free.shape[0] and 0 <= after[1] < free.shape[1]
        if not inside or not free[after]:
            raise Wrong(f"{told} on free cells", f"{after} is none")


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
                raise Wrong(f"one robot to a cell in {told}", f"{other} and {name} both in {here} at tick {tick}")
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
