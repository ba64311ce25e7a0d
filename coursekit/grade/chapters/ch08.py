"""Chapter 8: an inverse sensor model, a ray caster, a scan matcher and an explorer, each beside the truth."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from coursekit.grade.exercise import exercise
from coursekit.grade.plain import called, is_infinite, items, near, number, numbers, shown, whole
from coursekit.grade.verdict import NO_HINT, Wrong
from coursekit.grade.work import Work

if TYPE_CHECKING:
    from random import Random

    import numpy as np

    from coursekit.grade.matching import Puzzle

CELL, MOST_GOALS = 0.05, 120
_LOST = "Walls get lost when the end of the beam misses its cell: the noise is 1 cm, a cell 5 cm."
PLACES = [(0.0, 0.0), (2.4, -0.4), (4.2, 0.6), (3.6, 2.4), (2.2, 3.4), (0.6, 2.4)]
"""In robot_world, from where it is mapped."""


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
    """Signs and silence in the right places; then a room is mapped with it."""
    model, chance = work.function("inverse_sensor_model"), work.dice("ch08.q1")
    _judge_signs(model, chance)
    _judge_passer_by(model)
    _judge_room(model, chance.getrandbits(60))


def _added(model: Any, r: float, z: float) -> float:
    told = f"inverse_sensor_model({r:g}, {z:g})"
    return number(called(model, r, z, told=told), f"a finite number from {told}")


def _judge_signs(model: Any, chance: Random) -> None:
    for z in (1.0, 7.0, round(chance.uniform(1.5, 5.0), 2)):
        before, at, behind = (_added(model, r, z) for r in (z / 2, z, z + 1.0))
        if not before < 0:
            wanted = f"less than 0 at {z / 2:g} m, when the beam ended at {z:g} m"
            raise Wrong(wanted, gave=f"{before:g}", cause="It went through there.", hint=0)
        if not at > 0:
            wanted = f"more than 0 where the beam ended, at {z:g} m"
            raise Wrong(wanted, gave=f"{at:g}", cause="There it met something.", hint=0)
        if behind != 0:
            wanted = f"0 for a cell 1 m behind the end at {z:g} m"
            raise Wrong(wanted, gave=f"{behind:g}", cause="No beam has been there.", share=0.25, hint=0)
    through = _added(model, 3.0, math.inf)
    if not through < 0:
        raise Wrong("less than 0 for a cell that a beam went through that met nothing", gave=f"{through:g}", hint=0)


def _judge_passer_by(model: Any) -> None:
    left = 5 * _added(model, 2.0, 2.0) + 15 * _added(model, 2.0, 4.0)
    if not left < -0.4:
        cause = "A wall must not count so much more than a free cell."
        raise Wrong("a free floor after 5 beams met a person and 15 passed", f"log-odds {left:.2f}", cause, share=0.5)
    stays = 5 * _added(model, 2.0, 2.0) + 5 * _added(model, 2.0, 4.0)
    if not stays > 0:
        cause = "One beam that slips past a thin wall must not count as much as one that meets it."
        raise Wrong("still a wall after 5 beams met it and 5 slipped past", f"log-odds {stays:.2f}", cause, share=0.5)


def _judge_room(model: Any, seed: int) -> None:
    from coursekit.nav.map_compare import compare, outline_points
    from coursekit.nav.map_file import GridMap
    from coursekit.sim import load_world

    cut = load_world(_world("robot_world")).cut(0.2)
    cells, corner = _mapped(model, cut, seed)
    try:
        told = compare(GridMap(cells, CELL, corner), outline_points(cut.edges, cut.circles))
    except ValueError as why:
        raise Wrong("a map of robot_world that has walls and free cells", str(why), _LOST, share=0.25, hint=1) from None
    if not (told.thickness <= 0.14 and told.false <= 0.05):
        cause = "Walls grow thick when cells well before or behind the end count as wall."
        raise Wrong("walls about a cell or two thick in the map of robot_world", str(told), cause, share=0.5, hint=1)
    if not told.iou >= 0.8:
        raise Wrong("nearly all walls in the map of robot_world", str(told), _LOST, share=0.5, hint=1)


def _mapped(model: Any, cut: Any, seed: int) -> tuple[np.ndarray, tuple[float, float, float]]:
    import numpy as np

    from coursekit.geometry.plane import Pose2D
    from coursekit.sim import Lidar

    odds, corner, chance = np.zeros((160, 180)), (-2.0, -2.0, 0.0), np.random.default_rng(seed)
    lidar = Lidar(noise=0.01)
    for x, y in PLACES:
        place = Pose2D(x, y, 0.0)
        for k, z in enumerate(lidar.measure(lidar.look(cut, place), chance)):
            _add_beam(model, odds, (x - corner[0], y - corner[1]), k * lidar.step, float(z))
    return np.where(odds > 0.4, 100, np.where(odds < -0.4, 0, -1)).astype(np.int8), corner


def _add_beam(model: Any, odds: np.ndarray, start: tuple[float, float], angle: float, z: float) -> None:
    """Ask the model about each cell that a beam crosses, and some behind its end."""
    c, s, seen = math.cos(angle), math.sin(angle), set()
    for step in range(int((min(z, 6.0) + 0.3) / 0.025)):
        at = (int((start[1] + step * 0.025 * s) // CELL), int((start[0] + step * 0.025 * c) // CELL))
        if at in seen or not (0 <= at[0] < odds.shape[0] and 0 <= at[1] < odds.shape[1]):
            continue
        seen.add(at)
        along = ((at[1] + 0.5) * CELL - start[0]) * c + ((at[0] + 0.5) * CELL - start[1]) * s
        odds[at] += _added(model, along, z)


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
    """The same distances as the simulator's LiDAR, in rooms and among random walls."""
    from coursekit.sim import load_world

    cast, chance = work.function("cast_ray"), work.dice("ch08.q2")
    _judge_single(cast)
    room = [tuple(one) for one in load_world(_world("robot_world")).cut(0.2).edges.tolist()]
    for walls in (room, [tuple(chance.uniform(-6, 6) for _ in range(4)) for _ in range(12)]):
        for _ in range(60):
            place = chance.uniform(-1, 5), chance.uniform(-1, 4), chance.uniform(-7, 7)
            _judge_ray(cast, walls, place, chance.uniform(1, 9))


def _judge_single(cast: Any) -> None:
    wall = [(2.0, -1.0, 2.0, 1.0)]
    told = "one wall from (2, -1) to (2, 1), seen from (0, 0)"
    for angle, need, cause in (
        (0.0, 2.0, "A wall straight ahead."),
        (math.pi, math.inf, "It lies behind: t is negative there."),
        (1.0, math.inf, "The ray passes beside it: s is beyond 0 to 1 there."),
        (math.pi / 2, math.inf, "The ray is parallel to it."),
    ):
        _judge_cast(cast, (wall, 0.0, 0.0, angle), need, f"{told} at angle {angle:.2f}", cause, hint=1)
    along, parallel = [(1.0, 1.0, 3.0, 1.0)], "one wall from (1, 1) to (3, 1), seen from (0, 0) at angle 0"
    _judge_cast(cast, (along, 0.0, 0.0, 0.0), math.inf, parallel, "The ray is parallel to it.", hint=1)
    far = "It is further than range_max."
    _judge_cast(cast, (wall, 0.0, 0.0, 0.0, 1.5), math.inf, f"{told} with range_max 1.5", far)
    two = [(1.0, -1.0, 1.0, 1.0), *wall, (3.0, -1.0, 3.0, 1.0)]
    _judge_cast(cast, (two, 0.0, 0.0, 0.0), 1.0, f"{told}, and others at x = 1 and 3", "Which is the nearest?")


def _judge_ray(cast: Any, walls: Any, place: tuple[float, float, float], reach: float) -> None:
    x, y, angle = place
    truth = _distance(walls, x, y, angle, reach)
    if abs(truth - reach) > 1e-6:
        told = f"{len(walls)} walls from ({x:.2f}, {y:.2f}) at {angle:.2f} rad"
        _judge_cast(cast, (list(walls), x, y, angle, reach), truth, told, share=0.5)


def _judge_cast(
    cast: Any, given: tuple[Any, ...], need: float, told: str, cause: str = "", share: float = 0.0, hint: int | None = None
) -> None:
    got = called(cast, *given, told=f"cast_ray: {told}")
    wanted = f"{'math.inf' if math.isinf(need) else f'{need:.4g} m'} for {told}"
    if is_infinite(got):
        fine = math.isinf(need)
    else:
        fine = near(number(got, wanted, share=share), need, 1e-6)
    if not fine:
        found = _why_ray(got, need, *given) or cause
        raise Wrong(wanted, gave=shown(got, 40), cause=found, share=share, hint=None if found != cause else hint)


def _why_ray(got: Any, need: float, walls: Any, x: float, y: float, angle: float, reach: float = 10.0) -> str:
    if abs(angle) > 1e-9 and near(got, _distance(walls, x, y, math.radians(angle), reach), 1e-6):
        return "The angle is in radians already, as sin and cos take it."
    if math.isinf(need) and near(got, reach, 1e-9):
        return "Where there is no wall within `range_max`, `math.inf` is asked for."
    return "It is further than range_max." if math.isinf(need) and not near(got, 0.0, reach) else ""


def _distance(walls: Any, x: float, y: float, angle: float, reach: float) -> float:
    """What the simulator's LiDAR measures in a direction [m]."""
    import numpy as np

    from coursekit.geometry.plane import Pose2D
    from coursekit.sim import Cut, Lidar

    lidar = Lidar(beams=1, angle_min=0.0, angle_max=0.0, range_min=0.0, range_max=50.0)
    truth = float(lidar.look(Cut(np.array(walls), np.zeros((0, 3))), Pose2D(x, y, angle))[0])
    return truth if truth <= reach else math.inf


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
    """Poses beside the truth, in three worlds."""
    match, chance = work.function("match"), work.dice("ch08.q3")
    worlds = 2 * ("office", "robot_world", "tec_warehouse")
    found = [
        _try_match(match, _puzzle(_world(name), chance), f"{name} {number}")
        for number, name in enumerate(worlds, 1)
    ]
    bad = [one for one in found if not (one[0] <= 0.03 and one[1] <= 0.02)]
    if bad:
        off, turned, told, moved = max(bad)
        share = 0.0 if len(bad) == len(found) else 0.5
        seen = f"{len(bad)} are not; {told} is {off:.3f} m and {turned:.3f} rad off"
        hint = NO_HINT if off <= 0.03 else 0 if off > 0.15 else 1
        raise Wrong("all six scans to 3 cm and 0.02 rad", seen, _why_pose(off, turned, moved), share=share, hint=hint)


def _why_pose(off: float, turned: float, moved: float) -> str:
    if moved < 1e-9:
        return "It still stands where the guess was."
    if off > 0.35:
        return "That is further off than the guess: are the points turned by the heading first, and then moved?"
    if off <= 0.03 and turned > 0.02:
        return "The place is right, the heading is not: is it in radians, and are finer headings tried at the end?"
    if off > 0.15:
        return "Do the tries reach 0.3 m and 0.15 rad around the guess?"
    return "Near, but not there: finer steps at the end?"


def _puzzle(world: Path, chance: Random) -> Puzzle:
    """A scan that nobody has seen, and that fits in one place only: in a corridor it may fit further on as well."""
    from coursekit.grade.matching import Puzzle

    while True:
        puzzle = Puzzle(world, chance.getrandbits(60))
        x, y, heading = puzzle.truth
        ways = [(far, k * math.pi / 8) for far in (0.06, 0.1, 0.15, 0.2, 0.3, 0.4) for k in range(16)]
        beside = [(x + far * math.cos(way), y + far * math.sin(way), heading) for far, way in ways]
        if min(puzzle.misfit(one) for one in beside) > 1.5 * puzzle.misfit(puzzle.truth):
            return puzzle


def _try_match(match: Any, puzzle: Any, told: str) -> tuple[float, float, str, float]:
    """How far off the pose is [m, rad], of which scan, and how far it is from the guess [m]."""
    got = called(match, puzzle.points.copy(), puzzle.gap, puzzle.guess, told=f"match, the scan {told}")
    x, y, heading = numbers(got, 3, "three finite numbers (x, y, heading) from match")
    turned = abs(math.remainder(heading - puzzle.truth[2], math.tau))
    off, moved = (math.hypot(x - one[0], y - one[1]) for one in (puzzle.truth, puzzle.guess))
    return off, turned, told, moved


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
    """It goes where it can, and sees nearly all."""
    next_goal, chance = work.function("next_goal"), work.dice("ch08.q4")
    for name in ("robot_world", "office", "tec_warehouse"):
        _explore(next_goal, name, chance.random())


def _explore(next_goal: Any, name: str, part: float) -> None:
    from coursekit.grade.chapters.measures.exploring import Unseen

    world, goals = Unseen(_world(name), part=part), 0
    while goals < MOST_GOALS and world.known() < 0.95:
        got = called(next_goal, world.cells.copy(), world.here, told=f"next_goal in {name}")
        if got is None:
            break
        goals += 1
        world.go(_allowed(world, got, name))
    if not (known := world.known()) >= 0.95:
        what = f"{known:.0%} of it after {goals} goals"
        cause = "It gave up early." if goals < MOST_GOALS else "Does she go where something unknown can be seen?"
        raise Wrong(f"95 % of the floor of {name} seen", what, cause, share=0.5 if known > 0.7 else 0.0, hint=1)


def _allowed(world: Any, got: Any, name: str) -> tuple[int, int]:
    wanted = "a cell (row, column) of two integers, or None, from next_goal"
    cell = [whole(one, wanted) for one in items(got, wanted)]
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
        raise Wrong(told, gave=gave, cause=cause, share=0.25, hint=None if swapped else 0)
    return row, column
