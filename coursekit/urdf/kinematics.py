"""Forward kinematics: the poses of all links for given joint positions.

A robot's tree never changes while its joints move, so it is compiled once: `_compile` generates a Python function with
one line of arithmetic for each number that is not constant. Constant parts, zeros and ones are computed in advance.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from coursekit.geometry.pose import Pose
from coursekit.geometry.rotation import quaternion_of

from .errors import close
from .model import Joint, Origin, Robot

if TYPE_CHECKING:
    import numpy as np

Term = float | str
"""A constant, or the name of a variable in the generated function."""


def pose_of(origin: Origin) -> Pose:
    """Convert an origin to a pose.

    >>> pose_of(Origin((1.0, 2.0, 3.0)))
    (1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0)
    """
    return (*origin.xyz, *quaternion_of(origin.rpy))


def joint_pose(joint: Joint, position: float = 0.0) -> Pose:
    """Return the child link's pose in the parent link, with the joint at `position` (rad or m).

    >>> from coursekit.urdf.model import Origin
    >>> slide = Joint("slide", "prismatic", "base", "tip", Origin((0.0, 0.0, 0.5)), axis=(0.0, 0.0, 1.0))
    >>> joint_pose(slide, 0.25)[:3]
    (0.0, 0.0, 0.75)
    """
    return joint_motion(joint)(position)


def joint_motion(joint: Joint) -> Callable[[float], Pose]:
    """Return the function from a joint's position (rad or m) to the child link's pose in the parent link.

    >>> motion = joint_motion(Joint("hinge", "revolute", "base", "door", axis=(0.0, 0.0, 1.0)))
    >>> [round(part, 3) for part in motion(math.pi / 2)[3:]]
    [0.0, 0.0, 0.707, 0.707]
    """
    writer = _Writer()
    pose = ", ".join(map(str, _joint_terms(writer, joint, {joint.name: "position"})))
    names: dict[str, Any] = {"sin": math.sin, "cos": math.cos}
    exec("\n    ".join(["def motion(position):", *writer.lines, f"return {pose}\n"]), names)
    motion: Callable[[float], Pose] = names["motion"]
    return motion


class Kinematics:
    """The link poses of one robot, compiled.

    >>> from coursekit.urdf import parse
    >>> robot = parse('''<robot name="arm"><link name="base"/><link name="tip"/>
    ...   <joint name="slide" type="prismatic"><parent link="base"/><child link="tip"/><axis xyz="0 0 1"/>
    ...   <limit lower="0" upper="1" effort="1" velocity="1"/></joint></robot>''')
    >>> Kinematics(robot).poses({"slide": 0.25})["tip"]
    (0.0, 0.0, 0.25, 0.0, 0.0, 0.0, 1.0)

    In ROS 2: robot_state_publisher together with tf2.
    """

    def __init__(self, robot: Robot) -> None:
        self.robot = robot
        self.links = [link.name for _, link in robot.walk()]
        """The links in the order of the poses: each after its parent."""
        self._known = frozenset(name for name, joint in robot.joints.items() if joint.moves)
        self._run = _compile(robot, self.links)

    def poses(self, positions: Mapping[str, float] | None = None) -> dict[str, Pose]:
        """Return each link's pose in the root link; missing joints are at 0, mimics follow.

        Raises LookupError for a name that is not a movable joint.

        >>> from coursekit.urdf import parse
        >>> robot = parse('<robot name="ball"><link name="base_link"/></robot>')
        >>> Kinematics(robot).poses({"elbow": 0.1})  # doctest: +ELLIPSIS
        Traceback (most recent call last):
        LookupError: ...
        """
        if not positions:
            return self._run({})
        if not positions.keys() <= self._known:
            self._refuse(positions)
        return self._run(positions)

    def _refuse(self, positions: Mapping[str, float]) -> None:
        for name in positions:
            if name in self.robot.joints and name not in self._known:
                type_ = self.robot.joints[name].type
                raise LookupError(f"joint '{name}' is {type_}: no single number is its position.")
            if name not in self._known:
                raise LookupError(f"{self.robot.name} has no joint '{name}'. {close(name, sorted(self._known))}")

    def matrices(self, positions: Mapping[str, float] | None = None) -> np.ndarray:
        """Return the poses as an array of 4x4 matrices (number of links, 4, 4), in the order of `links`.

        >>> from coursekit.urdf import parse
        >>> robot = parse('''<robot name="mast"><link name="base"/><link name="top"/><joint name="pole" type="fixed">
        ...   <parent link="base"/><child link="top"/><origin xyz="0 0 2"/></joint></robot>''')
        >>> Kinematics(robot).matrices()[1][:3, 3].tolist()
        [0.0, 0.0, 2.0]
        """
        import numpy as np

        poses = np.array(list(self.poses(positions).values()))
        turns = poses[:, 3:]
        result: np.ndarray = np.matmul((turns[:, :, None] * turns[:, None, :]).reshape(-1, 16), _rotations())
        result = result.reshape(-1, 4, 4)
        result[:, :3, 3] = poses[:, :3]
        result[:, 3, 3] = 1.0
        return result


@lru_cache(maxsize=1)
def _rotations() -> np.ndarray:
    """Return (16, 16): maps the products of a quaternion's components (xx, xy, ..., ww) to the rotation in a 4x4 matrix."""
    import numpy as np

    tensor = np.zeros((4, 4, 4, 4))
    x, y, z, w = range(4)
    for i, j, k in ((x, y, z), (y, z, x), (z, x, y)):
        tensor[i, i, i, i] = tensor[w, w, i, i] = 1.0
        tensor[j, j, i, i] = tensor[k, k, i, i] = -1.0
        tensor[i, j, i, j] = tensor[i, j, j, i] = 2.0
        tensor[k, w, j, i], tensor[k, w, i, j] = 2.0, -2.0
    return tensor.reshape(16, 16)


# -- writing the function


class _Writer:
    """Lines of arithmetic; constant terms do not become lines."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self._count = 0

    def keep(self, expression: str) -> str:
        """Store an expression in a new variable."""
        self._count += 1
        self.lines.append(f"v{self._count} = {expression}")
        return f"v{self._count}"

    def sum(self, *products: tuple[Term, ...]) -> Term:
        """Return the sum of products, each of numbers and names."""
        constant, words = 0.0, []
        for product in products:
            factor = math.prod(factor for factor in product if not isinstance(factor, str))
            names = [factor for factor in product if isinstance(factor, str)]
            if not names:
                constant += factor
            elif factor:
                words.append((factor, "*".join(names)))
        if not words:
            return constant
        if len(words) == 1 and words[0][0] == 1.0 and not constant and "*" not in words[0][1]:
            return words[0][1]
        text = "".join(_signed(factor, names) for factor, names in words)
        if constant:
            text += f"{'-' if constant < 0 else '+'}{abs(constant)!r}"
        return self.keep(text.removeprefix("+"))


def _signed(factor: float, names: str) -> str:
    if abs(factor) == 1.0:
        return f"{'+' if factor > 0 else '-'}{names}"
    return f"{'+' if factor > 0 else '-'}{abs(factor)!r}*{names}"


def _compile(robot: Robot, links: list[str]) -> Callable[[Mapping[str, float]], dict[str, Any]]:
    """Generate the function from positions to the dict of poses."""
    writer = _Writer()
    names: dict[str, Any] = {"sin": math.sin, "cos": math.cos}
    names |= {f"J{number}": name for number, name in enumerate(robot.joints)}
    poses: dict[str, list[Term]] = {links[0]: [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]}
    variables = _positions(robot, writer)
    for link in links[1:]:
        joint = robot.joint_above(link)
        assert joint is not None
        poses[link] = _compose(writer, poses[joint.parent], _joint_terms(writer, joint, variables))
    for number, link in enumerate(links):
        names[f"L{number}"] = link
    rows = [f"L{number}: ({', '.join(map(str, poses[link]))})" for number, link in enumerate(links)]
    body = "\n    ".join(["get = p.get", *writer.lines, f"return {{{', '.join(rows)}}}"])
    exec(f"def run(p):\n    {body}\n", names)
    run: Callable[[Mapping[str, float]], dict[str, Any]] = names["run"]
    return run


def _positions(robot: Robot, writer: _Writer) -> dict[str, str]:
    """Return the variable of each joint's position: the given one, else that of the mimicked joint, else 0."""
    numbers = {name: number for number, name in enumerate(robot.joints)}
    positions: dict[str, str] = {}

    def of(name: str) -> str:
        if name not in positions:
            mimic, default = robot.joints[name].mimic, "0.0"
            if mimic is not None:
                default = f"{of(mimic.joint)}*{mimic.multiplier!r}+{mimic.offset!r}"
            positions[name] = writer.keep(f"get(J{numbers[name]}, {default})")
        return positions[name]

    for joint in robot.joints.values():
        if joint.moves:
            of(joint.name)
    return positions


def _joint_terms(writer: _Writer, joint: Joint, variables: Mapping[str, str]) -> list[Term]:
    origin: list[Term] = list(pose_of(joint.origin))
    if not joint.moves:
        return origin
    position = variables[joint.name]
    x, y, z = joint.axis
    if joint.type == "prismatic":
        shift: list[Term] = [writer.sum((axis, position)) for axis in (x, y, z)]
        return _compose(writer, origin, [*shift, 0.0, 0.0, 0.0, 1.0])
    half = writer.keep(f"0.5*{position}")
    sin, cos = writer.keep(f"sin({half})"), writer.keep(f"cos({half})")
    turn: list[Term] = [writer.sum((axis, sin)) for axis in (x, y, z)]
    return _compose(writer, origin, [0.0, 0.0, 0.0, *turn, cos])


def _compose(writer: _Writer, a: list[Term], b: list[Term]) -> list[Term]:
    """Generate `compose` as lines."""
    x, y, z, qx, qy, qz, qw = a
    bx, by, bz, rx, ry, rz, rw = b
    add = writer.sum
    tx = add((2.0, qy, bz), (-2.0, qz, by))
    ty = add((2.0, qz, bx), (-2.0, qx, bz))
    tz = add((2.0, qx, by), (-2.0, qy, bx))
    return [
        add((x,), (bx,), (qw, tx), (qy, tz), (-1.0, qz, ty)),
        add((y,), (by,), (qw, ty), (qz, tx), (-1.0, qx, tz)),
        add((z,), (bz,), (qw, tz), (qx, ty), (-1.0, qy, tx)),
        add((qw, rx), (qx, rw), (qy, rz), (-1.0, qz, ry)),
        add((qw, ry), (qy, rw), (qz, rx), (-1.0, qx, rz)),
        add((qw, rz), (qz, rw), (qx, ry), (-1.0, qy, rx)),
        add((qw, rw), (-1.0, qx, rx), (-1.0, qy, ry), (-1.0, qz, rz)),
    ]


__all__ = ["Kinematics", "joint_motion", "joint_pose", "pose_of"]
