"""Chapter 8: an inverse sensor model, a ray caster, a scan matcher and an explorer, each compared with the truth."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from coursekit.grade.chapters.measures.mapping import added, mapped
from coursekit.grade.chapters.measures.matches import puzzle_in, try_match, why_pose
from coursekit.grade.chapters.measures.rays import Ray, RayJudge, Walls, distance
from coursekit.grade.exercise import exercise
from coursekit.grade.figures.scans import matched, rays_among
from coursekit.grade.plain import called, items, shown, whole
from coursekit.grade.verdict import NO_HINT, Wrong
from coursekit.grade.work import Work

if TYPE_CHECKING:
    from random import Random

    from coursekit.grade.chapters.measures.exploring import Unseen

MOST_GOALS = 120
_LOST = "Walls get lost when the end of the beam misses its cell: the noise is 1 cm, a cell 5 cm."


def _world(name: str) -> Path:
    from ament_index_python.packages import get_package_share_directory

    return Path(get_package_share_directory("coursekit_maps")) / "worlds" / f"{name}.yaml"


@exercise(
    "ch08.q1",
    "The inverse sensor model",
    points=2,
    hints=(
        "Three cases: the cell lies before the end of the beam, at it, or behind it. What does the beam know of each?",
        "The cell at the end reaches half a cell before and behind its middle; allow a little more for the noise.",
    ),
)
def sensor_model(work: Work) -> None:
    """Check the signs and zeros of the model; then map a room with it."""
    model, chance = work.function("inverse_sensor_model"), work.dice("ch08.q1")
    _judge_signs(model, chance)
    _judge_passer_by(model)
    _judge_room(work, model, chance.getrandbits(60))


def _judge_signs(model: Any, chance: Random) -> None:
    for z in (1.0, 7.0, round(chance.uniform(1.5, 5.0), 2)):
        before, at, behind = (added(model, r, z) for r in (z / 2, z, z + 1.0))
        if not before < 0:
            wanted = f"less than 0 at {z / 2:g} m, when the beam ended at {z:g} m"
            raise Wrong(wanted, gave=f"{before:g}", cause="It went through there.", hint=0)
        if not at > 0:
            wanted = f"more than 0 where the beam ended, at {z:g} m"
            raise Wrong(wanted, gave=f"{at:g}", cause="There it met something.", hint=0)
        if behind != 0:
            wanted = f"0 for a cell 1 m behind the end at {z:g} m"
            raise Wrong(wanted, gave=f"{behind:g}", cause="No beam has been there.", share=0.25, hint=0)
    through = added(model, 3.0, math.inf)
    if not through < 0:
        raise Wrong("less than 0 for a cell that a beam went through that met nothing", gave=f"{through:g}", hint=0)


def _judge_passer_by(model: Any) -> None:
    left = 5 * added(model, 2.0, 2.0) + 15 * added(model, 2.0, 4.0)
    if not left < -0.4:
        cause = "A wall must not count so much more than a free cell."
        raise Wrong("a free floor after 5 beams met a person and 15 passed", f"log-odds {left:.2f}", cause, share=0.5)
    stays = 5 * added(model, 2.0, 2.0) + 5 * added(model, 2.0, 4.0)
    if not stays > 0:
        cause = "One beam that slips past a thin wall must not count as much as one that meets it."
        raise Wrong("still a wall after 5 beams met it and 5 slipped past", f"log-odds {stays:.2f}", cause, share=0.5)


def _judge_room(work: Work, model: Any, seed: int) -> None:
    from coursekit.grade.figures.maps import map_beside_truth
    from coursekit.nav.map_compare import compare, outline_points
    from coursekit.sim import load_world

    cut = load_world(_world("robot_world")).cut(0.2)
    grid, outline = mapped(model, cut, seed), outline_points(cut.edges, cut.circles)
    work.illustrate(map_beside_truth, grid, outline)
    try:
        told = compare(grid, outline)
    except ValueError as why:
        raise Wrong("a map of robot_world that has walls and free cells", str(why), _LOST, share=0.25, hint=1) from None
    if not (told.thickness <= 0.14 and told.false <= 0.05):
        cause = "Walls grow thick when cells well before or behind the end count as wall."
        raise Wrong("walls about a cell or two thick in the map of robot_world", str(told), cause, share=0.5, hint=1)
    if not told.iou >= 0.8:
        raise Wrong("nearly all walls in the map of robot_world", str(told), _LOST, share=0.5, hint=1)


@exercise(
    "ch08.q2",
    "The ray caster",
    points=2,
    hints=(
        "Two equations, two unknowns, t and s. Cross products (a*d - b*c) solve them without much writing.",
        "A parallel wall gives a division by zero: leave it out. A negative t lies behind the ray's start.",
    ),
)
def ray_caster(work: Work) -> None:
    """Check for the same distances as the simulator's LiDAR, in rooms and among random walls."""
    from coursekit.sim import load_world

    judge, chance = RayJudge(work), work.dice("ch08.q2")
    _judge_single(judge)
    room = [tuple(edge) for edge in load_world(_world("robot_world")).cut(0.2).edges.tolist()]
    in_room = _judge_rays(judge, room, chance)
    _judge_rays(judge, [tuple(chance.uniform(-6, 6) for _ in range(4)) for _ in range(12)], chance)
    work.illustrate(rays_among, room, in_room)


def _judge_single(judge: RayJudge) -> None:
    wall = [(2.0, -1.0, 2.0, 1.0)]
    told = "one wall from (2, -1) to (2, 1), seen from (0, 0)"
    for angle, need, cause in (
        (0.0, 2.0, "A wall straight ahead."),
        (math.pi, math.inf, "It lies behind: t is negative there."),
        (1.0, math.inf, "The ray passes beside it: s is beyond 0 to 1 there."),
        (math.pi / 2, math.inf, "The ray is parallel to it."),
    ):
        judge.expect(need, (wall, 0.0, 0.0, angle), f"{told} at angle {angle:.2f}", cause, hint=1)
    along, parallel = [(1.0, 1.0, 3.0, 1.0)], "one wall from (1, 1) to (3, 1), seen from (0, 0) at angle 0"
    judge.expect(math.inf, (along, 0.0, 0.0, 0.0), parallel, "The ray is parallel to it.", hint=1)
    far = "It is further than range_max."
    judge.expect(math.inf, (wall, 0.0, 0.0, 0.0, 1.5), f"{told} with range_max 1.5", far)
    three = [(1.0, -1.0, 1.0, 1.0), *wall, (3.0, -1.0, 3.0, 1.0)]
    judge.expect(1.0, (three, 0.0, 0.0, 0.0), f"{told}, and others at x = 1 and 3", "Which is the nearest?")


def _judge_rays(judge: RayJudge, walls: Walls, chance: Random) -> list[Ray]:
    """Check sixty rays among these walls, and return them."""
    rays = []
    for _ in range(60):
        x, y, angle = chance.uniform(-1, 5), chance.uniform(-1, 4), chance.uniform(-7, 7)
        reach = chance.uniform(1, 9)
        truth = distance(walls, x, y, angle, reach)
        if abs(truth - reach) > 1e-6:
            told = f"{len(walls)} walls from ({x:.2f}, {y:.2f}) at {angle:.2f} rad"
            rays.append(judge.expect(truth, (list(walls), x, y, angle, reach), told, share=0.5))
    return rays


@exercise(
    "ch08.q3",
    "A scan matcher",
    points=3,
    hints=(
        "First turn the points by the heading, then move them by x and y. points @ array does all of them in one go.",
        "Coarse first: steps of 10 cm and 0.05 rad over the whole window; then halve the steps around the best pose.",
    ),
)
def scan_matcher(work: Work) -> None:
    """Check poses against the truth, in three worlds."""
    match, chance = work.function("match"), work.dice("ch08.q3")
    worlds = 2 * ("office", "robot_world", "tec_warehouse")
    tries = [
        try_match(match, puzzle_in(_world(name), chance), f"{name} {number}")
        for number, name in enumerate(worlds, 1)
    ]
    bad = [match for match in tries if not (match.off <= 0.03 and match.turned <= 0.02)]
    worst = max(bad, key=lambda match: match.off) if bad else tries[0]
    work.illustrate(matched, worst.puzzle, worst.pose, worst.told, not bad)
    if bad:
        off, turned, told = worst.off, worst.turned, worst.told
        share = 0.0 if len(bad) == len(tries) else 0.5
        seen = f"{len(bad)} are not; {told} is {off:.3f} m and {turned:.3f} rad off"
        hint = NO_HINT if off <= 0.03 else 0 if off > 0.15 else 1
        cause = why_pose(off, turned, worst.moved())
        raise Wrong("all six scans to 3 cm and 0.02 rad", seen, cause, share=share, hint=hint)


@exercise(
    "ch08.q4",
    "An explorer",
    points=3,
    hints=(
        "scipy.ndimage.label gives each connected area of free cells a number: only those with hers can be reached.",
        "scipy.ndimage.binary_dilation makes the unknown one cell larger: where that meets free cells is the frontier.",
    ),
)
def explorer(work: Work) -> None:
    """Check that it chooses reachable goals, and sees nearly everything."""
    from coursekit.grade.chapters.measures.exploring import Unseen
    from coursekit.grade.figures.maps import explored

    next_goal, chance = work.function("next_goal"), work.dice("ch08.q4")
    worlds: list[tuple[str, Unseen, list[tuple[int, int]]]] = []
    for name in ("robot_world", "office", "tec_warehouse"):
        world = Unseen(_world(name), part=chance.random())
        worlds.append((name, world, [world.here]))
        work.illustrate(explored, worlds)
        _explore(next_goal, *worlds[-1])


def _explore(next_goal: Any, name: str, world: Unseen, stops: list[tuple[int, int]]) -> None:
    """Let the function choose goals; `stops` collects her positions."""
    goals = 0
    while goals < MOST_GOALS and world.known() < 0.95:
        got = called(next_goal, world.cells.copy(), world.here, told=f"next_goal in {name}")
        if got is None:
            break
        goals += 1
        world.go(_allowed(world, got, name))
        stops.append(world.here)
    if not (known := world.known()) >= 0.95:
        what = f"{known:.0%} of it after {goals} goals"
        cause = "It gave up early." if goals < MOST_GOALS else "Does she go where something unknown can be seen?"
        raise Wrong(f"95 % of the floor of {name} seen", what, cause, share=0.5 if known > 0.7 else 0.0, hint=1)


def _allowed(world: Any, got: Any, name: str) -> tuple[int, int]:
    wanted = "a cell (row, column) of two integers, or None, from next_goal"
    cell = [whole(item, wanted) for item in items(got, wanted)]
    if len(cell) != 2:
        raise Wrong(wanted, gave=shown(got), hint=NO_HINT)
    row, column = cell
    rows, columns = world.cells.shape
    if not (0 <= row < rows and 0 <= column < columns):
        told = f"a cell of the map, {rows} rows and {columns} columns"
        raise Wrong(told, gave=f"({row}, {column})", cause="Row first, then column.")
    if not world.can_go((row, column)):
        kind = {0: "free, but no free cells lead there", 100: "a wall", -1: "unknown"}[int(world.cells[row, column])]
        swapped = column < rows and row < columns and world.can_go((column, row))
        cause = "Row first, then column." if swapped else ""
        gave = f"({row}, {column}), {kind}"
        told = f"a free cell in {name} that can be reached"
        at = [(column + 0.5, row + 0.5)]
        raise Wrong(told, gave=gave, cause=cause, share=0.25, hint=None if swapped else 0, at=at)
    return row, column
