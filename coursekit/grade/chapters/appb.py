"""Appendix B: planar poses, an uncertainty ellipse, an object seen from a robot, photographs from all sides."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from coursekit.geometry.pose import Quaternion, multiply, rotate
from coursekit.grade.chapters.measures.photographs import Flat, judge_views, told
from coursekit.grade.exercise import exercise
from coursekit.grade.figures.photographs import photographed
from coursekit.grade.outputs import heard, last_words, said
from coursekit.grade.plain import called, close, field, fields, near, number, numbers, shown
from coursekit.grade.verdict import NO_HINT, Wrong
from coursekit.grade.work import Work

PALLET = (2.0, 1.0, 0.0)
"""The position of the pallet of the third exercise in map [m]."""
SIDES = {
    "a pallet": [(0.6, 0.4), (-0.6, 0.4), (-0.6, -0.4), (0.6, -0.4)],
    "a pallet elsewhere, turned by 50°": [(-3.08, 2.72), (-3.85, 1.80), (-3.24, 1.29), (-2.47, 2.21)],
    "a triangle": [(5.0, 0.0), (5.9, 0.3), (5.2, 0.9)],
    "a hexagon": [(math.cos(n * math.pi / 3), 4.0 + math.sin(n * math.pi / 3)) for n in range(6)],
}
"""Outlines to photograph [m]."""


def _about(axis: int, angle: float) -> Quaternion:
    parts = [0.0, 0.0, 0.0]
    parts[axis] = math.sin(angle / 2)
    return parts[0], parts[1], parts[2], math.cos(angle / 2)


def _rpy(roll: float, pitch: float, yaw: float) -> Quaternion:
    return multiply(_about(2, yaw), multiply(_about(1, pitch), _about(0, roll)))


def _fill(message: Any, values: tuple[float, ...]) -> Any:
    for name, value in zip("xyzw", values, strict=False):
        setattr(message, name, float(value))
    return message


@exercise(
    "appb.q1",
    "There and back",
    points=1,
    hints=(
        "The notebook has a function that makes a Quaternion of three angles; on the floor, two of them are 0.",
        "Back: three angles of four numbers. Formulas that use z and w alone hold for a robot that is not tilted.",
    ),
)
def there_and_back(work: Work) -> None:
    """Check headings of all sizes in one direction; -q, tilted and upright poses in the other."""
    to_pose, to_flat = work.function("to_pose"), work.function("to_flat")
    chance = work.dice("appb.q1")
    by_chance = tuple(round(chance.uniform(-3, 3), 2) for _ in range(3))
    for x, y, theta in ((1.0, -2.0, 0.0), (0.5, 0.25, 1.2), (-3.0, 4.0, -2.5), (0.0, 0.0, 3.1), (2.0, 2.0, 7.0), by_chance):
        _judge_pose(to_pose, x, y, theta)
    for name, angles in (("upright", (0.0, 0.0, 0.8)), ("tilted", (0.2, -0.3, -2.0)), ("upright", (0.0, 0.0, by_chance[2]))):
        turn = _rpy(*angles)
        yaw = math.atan2(*rotate(turn, (1.0, 0.0, 0.0))[1::-1])
        for spelt, sign in ((name, 1.0), (f"{name}, all four numbers negated (the same turn)", -1.0)):
            _judge_flat(to_flat, _signed(turn, sign), yaw, spelt)


def _signed(q: Quaternion, sign: float) -> Quaternion:
    return sign * q[0], sign * q[1], sign * q[2], sign * q[3]


def _judge_pose(to_pose: Callable[..., Any], x: float, y: float, theta: float) -> None:
    from geometry_msgs.msg import Pose, Pose2D

    given = f"to_pose of x={x}, y={y}, theta={theta}"
    pose = _message(Pose, given, to_pose, Pose2D(x=x, y=y, theta=theta))
    place, turn = _xyz(pose.position, given), _turn_of(pose.orientation, given)
    if not close(place, (x, y, 0.0), 1e-6):
        raise Wrong(f"the position ({x}, {y}, 0) from {given}", gave=told(place), hint=NO_HINT)
    nose, up = rotate(turn, (1.0, 0.0, 0.0)), rotate(turn, (0.0, 0.0, 1.0))
    if not close(up, (0.0, 0.0, 1.0), 1e-6):
        cause = "About which axis does theta turn?"
        raise Wrong(f"an upright pose from {given}", gave=f"its z axis is {told(up)}", cause=cause, hint=0)
    wanted = (math.cos(theta), math.sin(theta), 0.0)
    if not close(nose, wanted, 1e-6):
        cause = "Is there a half missing, or one too many?"
        if close(nose, (math.cos(math.degrees(theta)), math.sin(math.degrees(theta)), 0.0), 1e-6):
            cause = "theta is in radians, and a quaternion is made of radians: nothing is to be turned into degrees."
        raise Wrong(f"x axis along {told(wanted)} from {given}", gave=told(nose), cause=cause, hint=0)


def _judge_flat(to_flat: Callable[..., Any], turn: Quaternion, yaw: float, spelt: str) -> None:
    from geometry_msgs.msg import Pose, Pose2D

    pose = Pose()
    _fill(pose.position, (1.5, -0.5, 0.2))
    _fill(pose.orientation, turn)
    flat = _message(Pose2D, f"to_flat of a pose that is {spelt}", to_flat, pose)
    if not close((flat.x, flat.y), (1.5, -0.5), 1e-6):
        wanted = "x and y as they were, 1.5 and -0.5, from to_flat"
        raise Wrong(wanted, gave=f"{shown(flat.x)}, {shown(flat.y)}", share=0.5, hint=NO_HINT)
    wanted = f"theta = {yaw:.3f} from to_flat of a pose that is {spelt}"
    theta = number(flat.theta, wanted, share=0.5)
    if not (abs(theta) < math.pi + 1e-9 and near(math.remainder(theta - yaw, math.tau), 0.0, 1e-6)):
        cause = "The yaw is the direction of the x axis on the floor, between -pi and pi."
        cause = "theta is wanted in radians." if near(theta, math.degrees(yaw), 1e-4) else cause
        raise Wrong(wanted, gave=f"{theta:.3f}", cause=cause, share=0.5, hint=1)


@exercise(
    "appb.q2",
    "The ellipse",
    points=2,
    hints=(
        "Four of the 36 numbers matter. Which are they, when a row has six?",
        "The axes of the ellipse are the eigenvectors of the 2 x 2 table; what are the eigenvalues, in which unit?",
    ),
)
def the_ellipse(work: Work) -> None:
    """Check axes of many lengths and directions, in matrices with other non-zero entries."""
    function, chance = work.function("ellipse"), work.dice("appb.q2")
    by_chance = (round(chance.uniform(0.5, 0.9), 2), round(chance.uniform(0.1, 0.3), 2), chance.uniform(-3, 3))
    for a, b, yaw in ((0.6, 0.2, 0.0), (0.6, 0.2, math.pi / 2), (2.0, 0.3, -1.1), (0.05, 0.02, 2.5), by_chance):
        given = f"half-axes {a} m and {b} m, the longer one at {math.degrees(yaw):.0f}°"
        answer = called(function, _estimate(a, b, yaw), told=f"an estimate with {given}")
        got = numbers(answer, 3, "a tuple of three finite floats, (a, b, yaw)")
        if not math.isclose(got[0], a, rel_tol=1e-6) or not math.isclose(got[1], b, rel_tol=1e-6):
            mixed = math.isclose(got[0], b, rel_tol=1e-6) and math.isclose(got[1], a, rel_tol=1e-6)
            cause = "The longer one comes first." if mixed else "The table holds variances, and not of x and y only."
            answer = f"a = {got[0]:.3f}, b = {got[1]:.3f}"
            raise Wrong(f"a = {a:.3f}, b = {b:.3f} for {given}", gave=answer, cause=cause, hint=None if mixed else 1)
        if not near(math.remainder(got[2] - yaw, math.pi), 0.0, 1e-6):
            degrees = math.degrees(math.remainder(got[2], math.pi))
            cause = "Which vector belongs to the longer axis, and which way round are rows and columns?"
            if near(math.remainder(got[2] - math.degrees(yaw), 180.0), 0.0, 1e-4):
                cause = "yaw is wanted in radians."
            raise Wrong(
                f"yaw at {math.degrees(yaw):.0f}° (or opposite) for {given}",
                gave=f"{degrees:.1f}°",
                cause=cause,
                share=0.5,
                hint=1,
            )


def _estimate(a: float, b: float, yaw: float) -> Any:
    from geometry_msgs.msg import PoseWithCovarianceStamped

    estimate, cos, sin = PoseWithCovarianceStamped(), math.cos(yaw), math.sin(yaw)
    table = [[0.01 * min(row, column) + (7.0 if row == column else 0.0) for column in range(6)] for row in range(6)]
    table[0][0] = (a * cos) ** 2 + (b * sin) ** 2
    table[1][1] = (a * sin) ** 2 + (b * cos) ** 2
    table[0][1] = table[1][0] = (a * a - b * b) * cos * sin
    estimate.header.frame_id = "map"
    estimate.pose.covariance = [number for row in table for number in row]
    return estimate


@exercise(
    "appb.q3",
    "The lookout",
    points=2,
    hints=(
        "What is the vector from Vera to the pallet, in map? And how do the same three numbers read in Vera's axes?",
        "Her orientation turns from her axes into those of map. You need the opposite turn: a matrix's transpose does it.",
    ),
)
def the_lookout(work: Work) -> None:
    """Check that the node publishes the pallet in her frame with the poses' stamps, on the floor and on a ramp."""
    work.built("b_geometry")
    chance = work.dice("appb.q3")
    somewhere = (chance.uniform(-2, 2), chance.uniform(-2, 2), 0.0)
    poses = {
        1: ((0.0, 0.0, 0.0), _rpy(0.0, 0.0, 0.0)),
        2: ((1.0, 1.0, 0.0), _rpy(0.0, 0.0, 0.0)),
        3: ((1.0, 1.0, 0.0), _rpy(0.0, 0.0, math.pi / 2)),
        4: ((-1.5, 2.0, 0.0), _rpy(0.0, 0.0, -2.2)),
        5: ((0.5, -1.0, 0.3), _rpy(0.0, -0.4, 0.9)),
        6: ((2.5, 1.5, 0.1), _rpy(0.3, 0.1, 3.0)),
        7: (somewhere, _rpy(chance.uniform(-0.4, 0.4), chance.uniform(-0.4, 0.4), chance.uniform(-3, 3))),
    }
    spoken = [(0.5 + 0.1 * second, "/vera/pose", "geometry_msgs/msg/PoseStamped", _fields(second, *pose))
              for second, pose in poses.items()]  # fmt: skip
    seen = work.try_out("run b_geometry lookout_exe", publish=spoken, record=["/vera/pallet"], seconds=2.5)
    points = [message for _, message in heard(seen, "/vera/pallet")]
    if len(points) != len(poses):
        got = f"{len(points)}; it said: {last_words(said(seen))}"
        raise Wrong(f"{len(poses)} points on /vera/pallet for {len(poses)} poses", got, hint=NO_HINT)
    frames = {field(point, "header.frame_id", str, "/vera/pallet") for point in points}
    if frames != {"base_link"}:
        raise Wrong("points in base_link", f"frame_id {shown(sorted(frames))}", "In which frame are the numbers?")
    if [field(point, "header.stamp.sec", int, "/vera/pallet") for point in points] != list(poses):
        raise Wrong("each point with the stamp of its pose", "other stamps", "When was the pallet seen there?", share=0.5)
    for message, (place, turn) in zip(points, poses.values(), strict=True):
        _judge_sight(fields(message, ("point.x", "point.y", "point.z"), "/vera/pallet"), place, turn)


def _fields(second: int, place: tuple[float, ...], turn: Quaternion) -> dict[str, Any]:
    position, orientation = dict(zip("xyz", place, strict=True)), dict(zip("xyzw", turn, strict=True))
    header = {"frame_id": "map", "stamp": {"sec": second}}
    return {"header": header, "pose": {"position": position, "orientation": orientation}}


def _judge_sight(point: tuple[float, ...], place: tuple[float, ...], turn: Quaternion) -> None:
    """Raise Wrong unless the point, given in her frame, is at the pallet."""
    step = rotate(turn, (point[0], point[1], point[2]))
    end = tuple(a + b for a, b in zip(place, step, strict=True))
    if close(end, PALLET, 1e-6):
        return
    nose = rotate(turn, (1.0, 0.0, 0.0))
    flat = abs(turn[0]) + abs(turn[1]) < 1e-9
    raise Wrong(
        f"the pallet, seen from {told(place)} with the nose along {told(nose)}",
        f"{told(point)}, and a robot that drives there arrives at {told(end)}",
        "Is she turned into the hall's axes, or the hall into hers?" if flat else "On a ramp roll and pitch count, too.",
        share=0.0 if flat else 0.5,
        hint=1,
    )


@exercise(
    "appb.q4",
    "Once around",
    points=3,
    hints=(
        "Counter-clockwise, the outside is on the right of the line from corner to corner.",
        "The pose looks back, against the direction out; atan2 makes an angle of a direction.",
    ),
)
def once_around(work: Work) -> None:
    """Check with outlines of several kinds that every side is seen whole from outside, without collisions."""
    from geometry_msgs.msg import Point32, PolygonStamped, PoseArray

    function, chance = work.function("views"), work.dice("appb.q4")
    outlines = SIDES | {"a pallet anywhere": _pallet(chance.uniform(-5, 5), chance.uniform(-5, 5), chance.uniform(-3, 3))}
    for place, (name, corners) in enumerate(outlines.items()):
        outline = PolygonStamped()
        outline.header.frame_id, outline.header.stamp.sec = ("map", "dock")[place % 2], 7 + place
        outline.polygon.points = [Point32(x=x, y=y) for x, y in corners]
        asked = _message(PoseArray, f"views of {name}", function, outline)
        header = asked.header
        frame, second = shown(header.frame_id), shown(header.stamp.sec)
        if (frame, second) != (repr(outline.header.frame_id), repr(outline.header.stamp.sec)):
            raise Wrong("the header of the outline", gave=f"frame_id {frame}, stamp {second} s", share=0.25, hint=NO_HINT)
        if not 1 <= len(asked.poses) <= len(corners):
            raise Wrong(f"1 to {len(corners)} photographs of {name}", gave=str(len(asked.poses)), hint=NO_HINT)
        poses = [_standing(pose, name) for pose in asked.poses]
        work.illustrate(photographed, corners, poses, name)
        judge_views(poses, corners, name)


def _pallet(x: float, y: float, yaw: float) -> list[Flat]:
    cos, sin = math.cos(yaw), math.sin(yaw)
    return [(x + cos * u - sin * v, y + sin * u + cos * v) for u, v in SIDES["a pallet"]]


def _standing(pose: Any, name: str) -> tuple[Flat, float]:
    """Return position and yaw of an upright pose on the floor."""
    turn = _turn_of(pose.orientation, f"views of {name}")
    up, nose = rotate(turn, (0.0, 0.0, 1.0)), rotate(turn, (1.0, 0.0, 0.0))
    x, y, z = _xyz(pose.position, f"views of {name}")
    if not (near(z, 0.0, 1e-6) and up[2] >= 1.0 - 1e-6):
        gave = f"z = {z:.2f} m, the z axis along {told(up)}"
        raise Wrong("poses on the floor, upright", gave=gave, share=0.25, hint=NO_HINT)
    return (x, y), math.atan2(nose[1], nose[0])


def _turn_of(q: Any, given: str) -> Quaternion:
    wanted = f"a quaternion of length 1 from {given}"
    x, y, z, w = (number(part, wanted) for part in (q.x, q.y, q.z, q.w))
    length = math.hypot(x, y, z, w)
    if not near(length, 1.0, 1e-4):
        raise Wrong(wanted, gave=f"length {length:.3f}: {told((x, y, z, w))}", hint=0)
    return x, y, z, w


def _xyz(place: Any, given: str) -> tuple[float, float, float]:
    x, y, z = (number(part, f"a finite place from {given}") for part in (place.x, place.y, place.z))
    return x, y, z


def _message(kind: type[Any], given: str, function: Callable[..., Any], *arguments: Any) -> Any:
    """Return a function's result, which must be a message of that type."""
    got = called(function, *arguments, told=given)
    if type(got) is not kind:
        cause = "Is there a return?" if got is None else ""
        raise Wrong(f"a {kind.__name__} from {given}", gave=shown(got), cause=cause, hint=NO_HINT)
    return got
