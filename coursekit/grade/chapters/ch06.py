"""Chapter 6: a cart that lifts, an arm by hand, wheels that roll, a body that can be and does not fall over."""

from __future__ import annotations

import itertools
import math
import random
from typing import TYPE_CHECKING, Any

from coursekit.grade.body import FLOOR, extent, inverse, outside, poses, solids, turned
from coursekit.grade.exercise import exercise
from coursekit.grade.trial import Seen
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work

if TYPE_CHECKING:
    from coursekit.urdf import Robot

PACKAGE = "s6_py_urdf"
WHEEL, ASIDE, HIGH = 0.0375, 0.094, 0.0659
"""Of the course's robot: the wheels' radius, how far from the middle they run, how high base_link is [m]."""


@exercise(
    "ch06.q1",
    "A cart that lifts",
    points=2,
    hints=(
        "A cylinder stands along z. Turn the visual, by a right angle about x, and leave the joint's frame upright.",
        "A prismatic joint needs an axis and a limit with four attributes: lower, upper, effort, velocity.",
    ),
)
def cart(work: Work) -> None:
    """The links are where they should be, at rest and when the joints move."""
    robot = _load(work, f"src/{PACKAGE}/urdf/cart.urdf")
    if robot.root != "base_footprint":
        raise Wrong("the root base_footprint", robot.root, "Every other link is the child of some joint.")
    kinds = {"base_joint": "fixed", "left_wheel_joint": "continuous"}
    kinds |= {"right_wheel_joint": "continuous", "lift_joint": "prismatic"}
    for name, kind in kinds.items():
        found = robot.joints.get(name)
        if found is None or found.type != kind:
            raise Wrong(f"a {kind} joint {name}", f"it is {found.type}" if found else f"joints: {', '.join(robot.joints)}")
    _judge_cart_places(robot)
    for side in ("left", "right"):
        _judge_wheel(robot, side)
    _judge_lift(robot)


def _judge_cart_places(robot: Robot) -> None:
    wanted = {"base_link": (0.0, 0.0, 0.15), "left_wheel_link": (0.0, 0.2, 0.15)}
    wanted |= {"right_wheel_link": (0.0, -0.2, 0.15), "lift_link": (0.0, 0.0, 0.21)}
    found = poses(robot, {})
    for name, place in wanted.items():
        if name not in found:
            raise Wrong(f"a link {name}", f"links: {', '.join(found)}")
        if math.dist(found[name][:3], place) > 1e-4:
            cause = "The origin of a joint is given in its parent link's frame."
            raise Wrong(f"{name} at {_place(place)}", _place(found[name][:3]), cause, share=0.25)


def _judge_wheel(robot: Robot, side: str) -> None:
    link = f"{side}_wheel_link"
    across = extent(robot, link, {})
    if any(abs(got - need) > 0.003 for got, need in zip(across, (0.3, 0.05, 0.3), strict=True)):
        cause = "Does its axle lie along y, in the visual's origin?"
        raise Wrong(f"{link} 0.3 m long, 0.05 m wide, 0.3 m high", _place(across), cause, share=0.5)
    after = poses(robot, {f"{side}_wheel_joint": math.pi / 2})[link]
    before = poses(robot, {})[link]
    forward = turned(after, turned(inverse(before), (0.0, 0.0, 1.0)))
    if forward[0] < 0.99:
        what = "backwards" if forward[0] < -0.99 else "not about y"
        cause = "Which way does the top of the wheel go? See the axis of the joint."
        raise Wrong(f"{side}_wheel_joint rolls forward", f"a quarter turn goes {what}", cause, share=0.5)


def _judge_lift(robot: Robot) -> None:
    size = extent(robot, "lift_link", {})
    if any(abs(got - need) > 0.001 for got, need in zip(size, (0.4, 0.3, 0.02), strict=True)):
        raise Wrong("lift_link 0.4 x 0.3 x 0.02 m", _place(size), share=0.75)
    limit = robot.joints["lift_joint"].limit
    assert limit is not None
    if abs(limit.lower) > 1e-6 or abs(limit.upper - 0.4) > 1e-6:
        raise Wrong("lift_joint from 0 to 0.4 m", f"from {limit.lower:g} to {limit.upper:g}", share=0.5)
    high = poses(robot, {"lift_joint": 0.4})["lift_link"][:3]
    if math.dist(high, (0.0, 0.0, 0.61)) > 1e-4:
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
    """The same places as the library's, for other angles and other arms."""
    tip = work.function("tip")
    dice = random.Random(6)
    for index in range(12):
        upper, fore = (0.4, 0.3) if index < 6 else (dice.uniform(0.2, 0.9), dice.uniform(0.2, 0.9))
        shoulder, elbow = dice.uniform(-3, 3), dice.uniform(-3, 3)
        told = f"tip({shoulder:.2f}, {elbow:.2f}" + (f", {upper:.2f}, {fore:.2f})" if index >= 6 else ")")
        given = (shoulder, elbow) if index < 6 else (shoulder, elbow, upper, fore)
        got = tip(*given)
        if not isinstance(got, tuple | list) or len(got) != 2:
            raise Wrong(f"a pair (x, y) from {told}", repr(got)[:80])
        place = _arm_tip(shoulder, elbow, upper, fore)
        if math.dist(place, [float(one) for one in got]) > 1e-6:
            cause = "Only with other lengths: are they used?" if index >= 6 else "Degrees? Or the elbow's angle alone?"
            shown = f"({float(got[0]):.3f}, {float(got[1]):.3f})"
            raise Wrong(f"({place[0]:.3f}, {place[1]:.3f}) from {told}", shown, cause, share=0.5 if index >= 6 else 0.0)


def _arm_tip(shoulder: float, elbow: float, upper: float, fore: float) -> tuple[float, float]:
    from coursekit.urdf import parse
    from coursekit.urdf.kinematics import Kinematics

    links = "".join(f'<link name="l{index}"/>' for index in range(4))
    joint = '<joint name="j{0}" type="{1}"><origin xyz="{2} 0 0"/><parent link="l{0}"/><child link="l{3}"/>{4}</joint>'
    axis = '<axis xyz="0 0 1"/>'
    joints = joint.format(0, "continuous", 0, 1, axis) + joint.format(1, "continuous", upper, 2, axis)
    joints += joint.format(2, "fixed", fore, 3, "")
    x, y, *_ = Kinematics(parse(f'<robot name="arm">{links}{joints}</robot>')).poses({"j0": shoulder, "j1": elbow})["l3"]
    return x, y


@exercise(
    "ch06.q3",
    "Wheels that roll",
    points=3,
    hints=(
        "The left wheels go around a circle, too, and the right ones around another. What are their radii?",
        "Rolling: the wheel's own angle times its own radius is the way along the floor.",
    ),
)
def rolling(work: Work) -> None:
    """The way of each wheel's place over the floor is the way that its rim unrolls."""
    work.built(PACKAGE)
    for radius in (1.0, 0.4, 0.05):
        seen = work.try_out(
            f"run {PACKAGE} rolling_exe --ros-args -p radius:={radius}", record=["/joint_states", "/tf"], seconds=1.5
        )
        if "/py_rolling_node" not in seen.nodes:
            said = (seen.outputs[0].strip().splitlines() or ["nothing"])[-1]
            cause = "Was it built after the last change?"
            raise Wrong("a node /py_rolling_node", f"it is not there; it said: {said}", cause)
        _judge_rolling(seen, radius)


def _judge_rolling(seen: Seen, radius: float) -> None:
    frames = [(one["transform"], one["header"]) for _, all_ in seen.messages["/tf"] for one in all_["transforms"]]
    states = [message for _, message in seen.messages["/joint_states"]]
    if len(states) < 40 or len(frames) < 40:
        raise Wrong("joint states and frames at 30 Hz", f"{len(states)} and {len(frames)} in 1.5 s")
    first, last = _moved(frames[0][0]), _moved(frames[len(states) - 1][0])
    turn = last[2] - first[2]
    for index, name in enumerate(states[0]["name"]):
        side = ASIDE if name.startswith("left") else -ASIDE
        way = turn * (math.hypot(first[0], first[1]) - side)
        unrolled = WHEEL * (states[-1]["position"][index] - states[0]["position"][index])
        if abs(way - unrolled) > 1e-3 + 0.005 * abs(way):
            raise Wrong(
                f"on a circle of {radius:g} m, {name} unrolls {way:.3f} m, as its place on the robot goes",
                f"{unrolled:.3f} m",
                _slip(way, unrolled, turn * radius),
                share=0.4 if abs(unrolled - turn * radius) < 0.01 and radius == 1.0 else 0.0,
            )


def _slip(way: float, unrolled: float, middle: float) -> str:
    if abs(unrolled - middle) < 0.01:
        return "That is the way of the robot's middle: the inner wheels have less to go, the outer ones more."
    if abs(unrolled + way) < 0.01:
        return "The right length, but backwards."
    return "Which wheels are the inner ones? And the floor's length is the angle times the wheel's radius, 0.0375 m."


def _moved(transform: dict[str, Any]) -> tuple[float, float, float]:
    shift, turn = transform["translation"], transform["rotation"]
    return shift["x"], shift["y"], 2 * math.atan2(turn["z"], turn["w"])


@exercise(
    "ch06.q4",
    "A body of your own",
    points=3,
    hints=(
        "Begin with a heavy, wide base and a light top. A box of size z on the floor has its middle at z/2.",
        "coursekit.urdf.inertia.check(load(file)) says what is wrong with masses; the viewer shows where things are.",
    ),
)
def own(work: Work) -> None:
    """All kinds of joints, possible masses, and it stands, wherever its joints are."""
    robot = _load(work, f"src/{PACKAGE}/urdf/own.urdf.xacro")
    kinds = {joint.type for joint in robot.joints.values()}
    missing = sorted({"fixed", "continuous", "revolute", "prismatic"} - kinds)
    if robot.root != "base_footprint" or len(robot.links) < 6:
        raise Wrong("base_footprint as the root of six links or more", f"{robot.root}, {len(robot.links)} links")
    if missing:
        raise Wrong("joints of all four kinds", f"none is {' or '.join(missing)}", share=0.25)
    for joint in robot.moving_joints():
        if joint.limit is not None and joint.type != "continuous" and joint.limit.upper - joint.limit.lower < 0.05:
            raise Wrong(f"room to move for {joint.name}", f"{joint.limit.lower:g} to {joint.limit.upper:g}", share=0.25)
    _judge_masses(robot)
    _judge_standing(robot)


def _judge_masses(robot: Robot) -> None:
    from coursekit.urdf import inertia

    for link in robot.links.values():
        if link.visuals and (not link.collisions or link.inertial is None):
            lacks = "<collision>" if not link.collisions else "<inertial>"
            raise Wrong(f"{link.name} with <collision> and <inertial>", f"it has no {lacks}", share=0.5)
    findings = inertia.check(robot)
    if findings:
        raise Wrong("masses and inertias that can be", str(findings[0]), "shapes.xacro has macros for them.", share=0.5)


def _judge_standing(robot: Robot) -> None:
    low = min(float(part[:, 2].min()) for part in solids(robot, {}))
    if abs(low) > FLOOR:
        raise Wrong("the lowest shape at z = 0", f"at z = {low:.3f} m", "Raise or lower the root's joint.", share=0.5)
    for positions in _postures(robot):
        past = outside(robot, positions)
        if past > 0:
            where = ", ".join(f"{name} = {value:.2f}" for name, value in positions.items() if value) or "all joints at 0"
            raise Wrong(
                "a robot that does not fall over",
                f"with {where} its centre of mass is {past * 100:.1f} cm outside of what it stands on",
                "A heavier or wider base, or a lighter top.",
                share=0.75,
            )


def _postures(robot: Robot) -> list[dict[str, float]]:
    ends = {}
    for joint in robot.moving_joints():
        turning = joint.type == "continuous" or joint.limit is None
        ends[joint.name] = (0.0, math.pi / 2, math.pi) if turning else (joint.limit.lower, joint.limit.upper)  # type: ignore[union-attr]
    every = itertools.islice(itertools.product(*ends.values()), 4096)
    found = [dict(zip(ends, one, strict=True)) for one in every]
    return [{}, *random.Random(6).sample(found, min(40, len(found)))]


def _load(work: Work, path: str) -> Robot:
    from coursekit.urdf import UrdfError, load

    file = work.file(path)
    try:
        return load(file)
    except UrdfError as error:
        place = f"{file.name}:{error.line}" if error.line else file.name
        raise Wrong("a description that ROS takes", f"{place}: {error.what}", error.cure.split("\n")[0]) from None


def _place(values: Any) -> str:
    return "(" + ", ".join(f"{value:.3f}" for value in values) + ")"
