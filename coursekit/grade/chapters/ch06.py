"""Chapter 6: a cart that lifts, an arm computed by hand, rolling wheels, a stable body, an arm in C++."""

from __future__ import annotations

import itertools
import math
from random import Random
from typing import TYPE_CHECKING, Any

from coursekit.grade.chapters.measures.arm import arm_tip, why_tip
from coursekit.grade.chapters.measures.body import (
    FLOOR,
    centre_of_mass,
    contacts,
    extent,
    inverse,
    outside,
    poses,
    solids,
    turned,
)
from coursekit.grade.chapters.measures.rolling import judge_rolling
from coursekit.grade.exercise import exercise
from coursekit.grade.figures.arms import arm
from coursekit.grade.figures.bodies import sides, standing
from coursekit.grade.outputs import expect_node, heard
from coursekit.grade.plain import called, close, fields, near, numbers, shown
from coursekit.grade.verdict import NO_HINT, Wrong
from coursekit.grade.work import Work
from coursekit.urdf.model import Cylinder

if TYPE_CHECKING:
    from coursekit.urdf import Robot

PACKAGE, CPP = "s6_py_urdf", "s6_cpp_urdf"
POSTURES = 300
"""The maximum number of postures tried."""


@exercise(
    "ch06.q1",
    "A cart that lifts",
    points=2,
    hints=(
        "A cylinder's axis is z. Rotate the visual by a right angle about x, and leave the joint's frame upright.",
        "A prismatic joint needs an axis and a limit with four attributes: lower, upper, effort, velocity.",
    ),
)
def cart(work: Work) -> None:
    """Check the poses of the links, at rest and with moved joints."""
    robot = work.robot(f"src/{PACKAGE}/urdf/cart.urdf")
    work.illustrate(sides, robot)
    if robot.name != "cart":
        raise Wrong("a robot named cart", gave=shown(robot.name), cause="The name is in <robot name=...>.")
    if robot.root != "base_footprint":
        raise Wrong("the root base_footprint", gave=robot.root, cause="Every other link is the child of some joint.")
    kinds = {"base_joint": "fixed", "left_wheel_joint": "continuous"}
    kinds |= {"right_wheel_joint": "continuous", "lift_joint": "prismatic"}
    for name, kind in kinds.items():
        joint = robot.joints.get(name)
        if joint is None or joint.type != kind:
            got = f"it is {joint.type}" if joint else f"joints: {', '.join(robot.joints) or 'none'}"
            raise Wrong(f"a {kind} joint {name}", got, hint=1 if kind == "prismatic" else None)
    _judge_cart_places(robot)
    for side in ("left", "right"):
        _judge_wheel(robot, side)
    _judge_lift(robot)


def _judge_cart_places(robot: Robot) -> None:
    wanted = {"base_link": (0.0, 0.0, 0.15), "left_wheel_link": (0.0, 0.2, 0.15)}
    wanted |= {"right_wheel_link": (0.0, -0.2, 0.15), "lift_link": (0.0, 0.0, 0.21)}
    pose_by_link = poses(robot, {})
    for name, place in wanted.items():
        if name not in pose_by_link:
            raise Wrong(f"a link {name}", f"links: {', '.join(pose_by_link)}", hint=NO_HINT)
        if not close(_floats(pose_by_link[name][:3]), place, 1e-4):
            cause = "The origin of a joint is given in its parent link's frame."
            at = [_floats(pose_by_link[name][1:3])]
            raise Wrong(f"{name} at {_place(place)}", _place(pose_by_link[name][:3]), cause, share=0.25, at=at)
    size = extent(robot, "base_link", {})
    if not _same_size(size, (0.5, 0.3, 0.1), 0.001):
        raise Wrong("base_link 0.5 x 0.3 x 0.1 m", _place(size), share=0.25, hint=0)


def _floats(values: Any) -> list[float]:
    return [float(value) for value in values]


def _same_size(got: Any, need: tuple[float, ...], tolerance: float) -> bool:
    return all(near(float(value), other, tolerance) for value, other in zip(got, need, strict=True))


def _judge_wheel(robot: Robot, side: str) -> None:
    link = f"{side}_wheel_link"
    across = extent(robot, link, {})
    if not _same_size(across, (0.3, 0.05, 0.3), 0.003):
        wanted, at = f"{link} 0.3 m long, 0.05 m wide, 0.3 m high", [_floats(poses(robot, {})[link][1:3])]
        raise Wrong(wanted, _place(across), _why_size(robot, link), share=0.5, hint=0, at=at)
    after = poses(robot, {f"{side}_wheel_joint": math.pi / 2})[link]
    before = poses(robot, {})[link]
    forward = turned(after, turned(inverse(before), (0.0, 0.0, 1.0)))
    if not forward[0] > 0.99:
        what = "a quarter turn rolls backwards" if forward[0] < -0.99 else "it does not turn about y"
        cause = "Which way does the top of the wheel go? See the joint's <axis>: it is x, where no <axis> is given."
        raise Wrong(f"{side}_wheel_joint rolls forward", what, cause, share=0.5)


def _why_size(robot: Robot, link: str) -> str:
    visual = robot.links[link].visuals[0]
    if isinstance(visual.geometry, Cylinder) and (visual.geometry.radius, visual.geometry.length) != (0.15, 0.05):
        return "A cylinder has a radius, which is half of its diameter, and a length, which is the wheel's width."
    if max(map(abs, visual.origin.rpy)) > math.tau:
        return "Angles are in radians: a right angle is 1.5708."
    return "Does its axle lie along y, in the visual's origin?"


def _judge_lift(robot: Robot) -> None:
    size = extent(robot, "lift_link", {})
    if not _same_size(size, (0.4, 0.3, 0.02), 0.001):
        raise Wrong("lift_link 0.4 x 0.3 x 0.02 m", _place(size), share=0.75, hint=0)
    limit = robot.joints["lift_joint"].limit
    if limit is None or not near(limit.lower, 0.0, 1e-6) or not near(limit.upper, 0.4, 1e-6):
        got = f"from {limit.lower:g} to {limit.upper:g}" if limit else "no limit"
        raise Wrong("lift_joint from 0 to 0.4 m", got, share=0.5, hint=1)
    high = poses(robot, {"lift_joint": 0.4})["lift_link"][:3]
    if not close(_floats(high), (0.0, 0.0, 0.61), 1e-4):
        raise Wrong("the lift 0.4 m higher when lift_joint is at 0.4", f"it is at {_place(high)}", "See <axis>.", share=0.5)


@exercise(
    "ch06.q2",
    "By hand",
    points=2,
    hints=(
        "Where is the elbow? Only the shoulder's angle matters for that.",
        "In which direction does the forearm point, seen from the base? Two turns about the same axis add up.",
    ),
)
def by_hand(work: Work) -> None:
    """Check against the library's positions, for other angles and other arms."""
    tip, chance = work.function("tip"), work.dice("ch06.q2")
    for index in range(12):
        upper, fore = (0.4, 0.3) if index < 6 else (chance.uniform(0.2, 0.9), chance.uniform(0.2, 0.9))
        shoulder, elbow = chance.uniform(-3, 3), chance.uniform(-3, 3)
        told = f"tip({shoulder:.2f}, {elbow:.2f}" + (f", {upper:.2f}, {fore:.2f})" if index >= 6 else ")")
        given = (shoulder, elbow) if index < 6 else (shoulder, elbow, upper, fore)
        got = numbers(called(tip, *given, told=told), 2, f"a pair (x, y) of finite numbers from {told}")
        place = arm_tip(shoulder, elbow, upper, fore)
        work.illustrate(arm, (shoulder, elbow), (upper, fore), place, got)
        if not close(got, place, 1e-6):
            cause = "Only with other lengths: are they used?" if index >= 6 else why_tip(got, shoulder, elbow)
            answer = f"({got[0]:.3f}, {got[1]:.3f})"
            share = 0.5 if index >= 6 else 0.0
            raise Wrong(f"({place[0]:.3f}, {place[1]:.3f}) from {told}", gave=answer, cause=cause, share=share, hint=1)


@exercise(
    "ch06.q3",
    "Wheels that roll",
    points=3,
    hints=(
        "The left wheels go around a circle, too, and the right ones around another. What are their radii?",
        "Rolling: the wheel's own angle times its own radius is the distance along the floor.",
    ),
)
def rolling(work: Work) -> None:
    """Check that each wheel's distance over the floor equals the distance unrolled by its rim."""
    work.built(PACKAGE, "rolling", "py_rolling_node")
    for radius in (1.0, work.dice("ch06.q3").uniform(0.3, 0.8), 0.05):
        command = f"run {PACKAGE} rolling_exe --ros-args -p radius:={radius:.3f}"
        seen = work.try_out(command, record=["/joint_states", "/tf"], seconds=1.5)
        expect_node(seen, "/py_rolling_node")
        judge_rolling(seen, round(radius, 3))


@exercise(
    "ch06.q4",
    "A body of your own",
    points=3,
    hints=(
        "Begin with a heavy, wide base and a light top. A box of size z on the floor has its middle at z/2.",
        "coursekit.urdf.inertia.check(load(file)) reports wrong masses; the viewer shows where things are.",
    ),
)
def own(work: Work) -> None:
    """Check for all types of joints, possible masses, and stability at all joint positions."""
    robot = work.robot(f"src/{PACKAGE}/urdf/own.urdf.xacro")
    work.illustrate(sides, robot)
    kinds = {joint.type for joint in robot.joints.values()}
    missing = sorted({"fixed", "continuous", "revolute", "prismatic"} - kinds)
    if robot.root != "base_footprint" or len(robot.links) < 6:
        raise Wrong("base_footprint as the root of six links or more", f"{robot.root}, {len(robot.links)} links", hint=0)
    if missing:
        raise Wrong("joints of all four kinds", f"none is {' or '.join(missing)}", share=0.25, hint=NO_HINT)
    for joint in robot.moving_joints():
        limit = joint.limit
        if limit is not None and joint.type != "continuous" and not limit.upper - limit.lower >= 0.05:
            raise Wrong(f"room to move for {joint.name}", f"{limit.lower:g} to {limit.upper:g}", share=0.25, hint=NO_HINT)
    _judge_masses(robot)
    _judge_standing(work, robot)


def _judge_masses(robot: Robot) -> None:
    from coursekit.urdf import inertia

    for link in robot.links.values():
        if link.visuals and (not link.collisions or link.inertial is None):
            lacks = "<collision>" if not link.collisions else "<inertial>"
            raise Wrong(f"{link.name} with <collision> and <inertial>", f"it has no {lacks}", share=0.5, hint=1)
    findings = inertia.check(robot)
    if findings:
        cause = "shapes.xacro has macros for them."
        raise Wrong("masses and inertias that can be", str(findings[0]), cause, share=0.5, hint=1)


def _judge_standing(work: Work, robot: Robot) -> None:
    low = min(float(part[:, 2].min()) for part in solids(robot, {}))
    if not near(low, 0.0, FLOOR):
        cause = "Raise or lower the root's joint."
        raise Wrong("the lowest shape at z = 0", f"at z = {low:.3f} m", cause, share=0.5, hint=0)
    for positions in _postures(robot, work.dice("ch06.q4")):
        past = outside(robot, positions)
        if not past <= 0:
            x, y, _ = _floats(centre_of_mass(robot, positions))
            work.illustrate(standing, robot, positions, contacts(robot, positions), (x, y))
            where = ", ".join(f"{name} = {value:.2f}" for name, value in positions.items() if value) or "all joints at 0"
            raise Wrong(
                "a robot that does not fall over",
                f"with {where} its centre of mass is {past * 100:.1f} cm outside the area of its contacts with the floor",
                "A heavier or wider base, or a lighter top.",
                share=0.75,
                hint=0,
                at=[(x, y)],
            )


def _postures(robot: Robot, chance: Random) -> list[dict[str, float]]:
    """Return postures: all joints at 0, and combinations of the joints' limits (or all around), sampled if many."""
    ends: dict[str, list[float]] = {}
    for joint in robot.moving_joints():
        limit = None if joint.type == "continuous" else joint.limit
        around = [k * math.pi / 4 for k in range(8)]
        ends[joint.name] = around if limit is None else [float(limit.lower), float(limit.upper)]
    if math.prod(map(len, ends.values())) <= POSTURES:
        return [{}, *(dict(zip(ends, corner, strict=True)) for corner in itertools.product(*ends.values()))]
    return [{}, *({name: chance.choice(values) for name, values in ends.items()} for _ in range(POSTURES))]


def _place(values: Any) -> str:
    return "(" + ", ".join(f"{value:.3f}" for value in values) + ")"


@exercise(
    "ch06.q5",
    "The arm in C++",
    points=0,
    hints=(
        "It is the formula of exercise 2, with std::cos and std::sin. Two turns about the same axis add up.",
        "Assign to place.x and place.y; the function returns place.",
    ),
)
def arm_in_cpp(work: Work) -> None:
    """Check the tip's position for each published pair of angles."""
    work.compiled(CPP, "cpp_tip_node")
    chance = work.dice("ch06.q5")
    angles = [(chance.uniform(-3, 3), chance.uniform(-3, 3)) for _ in range(6)]
    states = [{"name": ["shoulder", "elbow"], "position": list(pair)} for pair in angles]
    kind = "sensor_msgs/msg/JointState"
    publish = [(1.0 + 0.2 * at, "/arm_states", kind, state) for at, state in enumerate(states)]
    seen = work.try_out(f"run {CPP} tip_exe", record=["/tip"], publish=publish, seconds=3.0)
    expect_node(seen, "/cpp_tip_node")
    points = [fields(message, ("x", "y"), "/tip") for _, message in heard(seen, "/tip")]
    if len(points) != len(angles):
        raise Wrong(f"{len(angles)} points on /tip, one for each pair of angles", f"{len(points)}", hint=NO_HINT)
    for (shoulder, elbow), got in zip(angles, points, strict=True):
        place = arm_tip(shoulder, elbow, 0.4, 0.3)
        if not close(got, place, 1e-6):
            told = f"({place[0]:.3f}, {place[1]:.3f}) for the shoulder at {shoulder:.2f} and the elbow at {elbow:.2f} rad"
            raise Wrong(told, f"({got[0]:.3f}, {got[1]:.3f})", why_tip(got, shoulder, elbow), hint=0)
