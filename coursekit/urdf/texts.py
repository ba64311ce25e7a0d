"""A robot as text: the output of `check_urdf`, and Graphviz text in the format of `urdf_to_graphviz`."""

from __future__ import annotations

from collections.abc import Iterator

from .errors import UrdfError
from .model import Joint, Robot


def branches(robot: Robot) -> Iterator[tuple[int, int, Joint]]:
    """Yield (depth, number among its siblings, joint) from the root on; siblings by their joints' names, as in urdfdom."""

    def below(link: str, depth: int) -> list[tuple[int, int, Joint]]:
        joints = sorted(robot.joints_below(link), key=lambda joint: joint.name)
        return [(depth, number, joint) for number, joint in enumerate(joints, 1)][::-1]

    waiting = below(robot.root, 1)
    while waiting:
        depth, number, joint = waiting.pop()
        yield depth, number, joint
        waiting += below(joint.child, depth + 1)


def check_text(robot: Robot) -> str:
    """Return the output of `check_urdf` for a valid robot.

    >>> from coursekit.urdf import parse
    >>> robot = parse('''<robot name="mast"><link name="base"/><link name="top"/><joint name="pole" type="fixed">
    ...   <parent link="base"/><child link="top"/></joint></robot>''')
    >>> print(check_text(robot), end="")
    robot name is: mast
    ---------- Successfully Parsed XML ---------------
    root Link: base has 1 child(ren)
        child(1):  top
    """
    lines = [
        f"robot name is: {robot.name}",
        "---------- Successfully Parsed XML ---------------",
        f"root Link: {robot.root} has {len(robot.joints_below(robot.root))} child(ren)",
    ]
    lines += [f"{'    ' * depth}child({number}):  {joint.child}" for depth, number, joint in branches(robot)]
    return "\n".join(lines) + "\n"


def error_text(error: UrdfError) -> str:
    """Return the output of `check_urdf` for a fault: urdfdom's lines, then the location and the remedy.

    >>> error = UrdfError("No link elements found in urdf file", file="arm.urdf", line=1, cure="Add a link.")
    >>> print(error_text(error), end="")
    Error:   No link elements found in urdf file
             at arm.urdf:1
             Add a link.
    """
    lines = [f"Error:   {line}" for line in (error.what, *error.chain)]
    place = f"{error.file}:{error.line}" if error.line else error.file
    lines.append(f"         at {place}{f' in {error.element}' if error.element else ''}")
    return "\n".join([*lines, *(f"         {line}" for line in error.cure.splitlines())]) + "\n"


def graphviz_text(robot: Robot) -> str:
    """Return the tree in Graphviz's language: links as boxes, joints as blue ellipses, origins beside the arrows.

    >>> from coursekit.urdf import parse
    >>> print(graphviz_text(parse('<robot name="ball"><link name="base_link"/></robot>')), end="")
    digraph G {
    node [shape=box];
    "base_link" [label="base_link"];
    node [shape=ellipse, color=blue, fontcolor=blue];
    }
    """
    joints = [joint for _, _, joint in branches(robot)]
    links = [robot.root, *(joint.child for joint in joints)]
    lines = ["digraph G {", "node [shape=box];", *(f"{_quoted(name)} [label={_quoted(name)}];" for name in links)]
    lines.append("node [shape=ellipse, color=blue, fontcolor=blue];")
    for joint in joints:
        xyz = " ".join(f"{value:g}" for value in joint.origin.xyz)
        rpy = " ".join(f"{value:g}" for value in joint.origin.rpy)
        lines.append(f'{_quoted(joint.parent)} -> {_quoted(joint.name)} [label="xyz: {xyz} \\nrpy: {rpy}"]')
        lines.append(f"{_quoted(joint.name)} -> {_quoted(joint.child)}")
    return "\n".join([*lines, "}"]) + "\n"


def _quoted(name: str) -> str:
    escaped = name.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


__all__ = ["branches", "check_text", "error_text", "graphviz_text"]
