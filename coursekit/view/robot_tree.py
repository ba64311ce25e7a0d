"""A robot's tree of links and joints as a picture and as text."""

from __future__ import annotations

import math

from coursekit.urdf import Joint, Robot
from coursekit.words.counting import counted

from .drawing import Curve, Drawing, Rect, Text, text_width
from .drawn import Drawn
from .layers import Box, arrange

LINK = ("#e8f5ec", "#4d9a6a", "#1d5233")
JOINTS = {
    "fixed": ("#eef1f4", "#8795a1", "#3d4a55"),
    "continuous": ("#e4effb", "#3173b5", "#16385c"),
    "revolute": ("#e4effb", "#3173b5", "#16385c"),
    "prismatic": ("#f2ecfb", "#8b66c2", "#42286b"),
}
"""Fill, outline and text colour by joint type."""
NAME_SIZE, NOTE_SIZE = 13.0, 10.5
GREY = "#8795a1"


def motion(joint: Joint) -> str:
    """Describe a joint's motion.

    >>> motion(Joint("j", "continuous", "a", "b", axis=(0.0, 1.0, 0.0)))
    'continuous about y'
    """
    if joint.type in ("fixed", "floating"):
        return joint.type
    preposition = "along" if joint.type == "prismatic" else "normal to" if joint.type == "planar" else "about"
    text = f"{joint.type} {preposition} {_axis(joint.axis)}"
    if joint.limit is not None and joint.type in ("revolute", "prismatic"):
        unit, factor = ("m", 1.0) if joint.type == "prismatic" else ("°", 180.0 / math.pi)
        text += f", {joint.limit.lower * factor:.4g} .. {joint.limit.upper * factor:.4g} {unit}"
    if joint.mimic is not None:
        text += f", mimics {joint.mimic.joint}"
    return text


def _axis(axis: tuple[float, float, float]) -> str:
    for place, name in enumerate("xyz"):
        if abs(abs(axis[place]) - 1.0) < 1e-9:
            return name if axis[place] > 0 else f"-{name}"
    return "(" + " ".join(f"{part:.3g}" for part in axis) + ")"


class RobotTree(Drawn):
    """The tree of a robot: links in green, joints coloured by type.

    >>> from coursekit.urdf import parse
    >>> RobotTree(parse('<robot name="ball"><link name="base_link"/></robot>'))
    ball: 1 link, 0 joints
    base_link

    In ROS 2: `urdf_to_graphviz`.
    """

    def __init__(self, robot: Robot) -> None:
        self.robot = robot
        self.title = f"links and joints of {robot.name}"

    def text(self) -> str:
        """Return the tree as text."""
        robot = self.robot
        links, joints = counted(len(robot.links), "link"), counted(len(robot.joints), "joint")
        lines = [f"{robot.name}: {links}, {joints}", robot.root]
        waiting = [(joint, "") for joint in reversed(robot.joints_below(robot.root))]
        while waiting:
            joint, indent = waiting.pop()
            last = robot.joints_below(joint.parent)[-1] is joint
            branch, more = ("└─ ", "   ") if last else ("├─ ", "│  ")
            lines.append(f"{indent}{branch}{joint.child}  ({joint.name}: {motion(joint)})")
            waiting += [(child, indent + more) for child in reversed(robot.joints_below(joint.child))]
        return "\n".join(lines)

    def drawing(self) -> Drawing:
        """Return the picture's shapes, from left to right."""
        boxes, notes, edges = self._boxes()
        layout = arrange(boxes, edges, gap=34.0, between=12.0)
        drawing = Drawing(max(layout.width, 120.0), max(layout.height, 50.0))
        for (start, end), route in zip(edges, layout.routes, strict=True):
            heads = "end" if end.startswith("link ") else ""
            drawing.add(Curve(tuple(route), GREY, heads, kind="ck-link", ends=(start[5:], end[5:])))
        for box in boxes:
            self._draw(drawing, box, notes[box.key], layout.centres[box.key])
        return drawing

    def _boxes(self) -> tuple[list[Box], dict[str, tuple[str, str]], list[tuple[str, str]]]:
        boxes, notes, edges = [], {}, []
        for _, link in self.robot.walk():
            joint = self.robot.joint_above(link.name)
            if joint is not None:
                key = f"join {joint.name}"
                notes[key] = (joint.name, motion(joint))
                width = max(text_width(joint.name, NAME_SIZE), text_width(notes[key][1], NOTE_SIZE)) + 30.0
                boxes.append(Box(key, width, 42.0))
                edges += [(f"link {joint.parent}", key), (key, f"link {link.name}")]
            notes[f"link {link.name}"] = (link.name, "")
            boxes.append(Box(f"link {link.name}", text_width(link.name, NAME_SIZE) + 26.0, 32.0))
        return boxes, notes, edges

    def _draw(self, drawing: Drawing, box: Box, note: tuple[str, str], centre: tuple[float, float]) -> None:
        name, about = note
        link = box.key.startswith("link ")
        type_ = "" if link else self.robot.joints[name].type
        fill, line, ink = LINK if link else JOINTS.get(type_, JOINTS["fixed"])
        (x, y), radius = centre, 6.0 if link else box.height / 2
        left, top = x - box.width / 2, y - box.height / 2
        shapes: list[Rect | Text | Curve] = [
            Rect(left, top, box.width, box.height, radius, fill, line, 1.4, type_ == "fixed", kind="ck-node"),
            Text(x, y + (4.5 if link else -2), name, NAME_SIZE, ink, "middle", link, "ck-name"),
        ]
        if about:
            shapes.append(Text(x, y + 13, about, NOTE_SIZE, ink, "middle", kind="ck-type"))
        drawing.add(*shapes, name=name, tip=f"{'link' if link else 'joint'} {name}")


__all__ = ["RobotTree", "motion"]
