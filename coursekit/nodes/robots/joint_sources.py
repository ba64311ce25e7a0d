"""The joints of a description for joint_state_publisher: URDF, and, as on a robot, SDF and COLLADA."""

from __future__ import annotations

import math
from collections.abc import Iterator

from coursekit.urdf import Joint, parse
from coursekit.urdf.model import Limit
from coursekit.urdf.xml_tree import Element, read

_STILL = ("fixed", "ball", "floating", "planar", "universal")
"""Types of SDF joints that no single number describes."""
_CURE = "Give both limits as numbers."


def joints_of(description: str) -> list[Joint]:
    """The joints of a description, in its order; UrdfError when they cannot be read.

    >>> joints_of('<robot name="ball"><link name="base_link"/></robot>')
    []
    """
    root = read(description, "robot_description")
    if root.tag == "sdf":
        return list(_of_sdf(root))
    if root.tag == "COLLADA":
        return list(_of_collada(root))
    return list(parse(description, "robot_description").joints.values())


def _of_sdf(root: Element) -> Iterator[Joint]:
    for element in _below(root, "joint"):
        kind, name = element.get("type") or "", element.get("name") or ""
        if kind in _STILL:
            continue
        axis = element.first("axis")
        limit = None if axis is None else axis.first("limit")
        unlimited = kind == "continuous" or (kind == "revolute" and limit is None)
        reach = None if unlimited else _limit(limit or element, "lower", "upper", name)
        yield Joint(name, "continuous" if unlimited else kind, "", "", limit=reach)


def _of_collada(root: Element) -> Iterator[Joint]:
    for model in list(_below(root, "kinematics_model"))[:1]:
        common = model.first("technique_common")
        for element in common.all("joint") if common is not None else ():
            revolute, name = element.first("revolute"), element.get("name") or ""
            if revolute is None:
                continue
            limit = _limit(revolute.first("limits") or revolute, "min", "max", name)
            if limit.lower != limit.upper:  # else it is fixed
                yield Joint(name, "revolute", "", "", limit=Limit(math.radians(limit.lower), math.radians(limit.upper)))


def _below(element: Element, tag: str) -> Iterator[Element]:
    waiting = [element]
    while waiting:
        one = waiting.pop(0)
        if one.tag == tag:
            yield one
        waiting = [*one.children, *waiting]


def _limit(element: Element, least: str, greatest: str, joint: str) -> Limit:
    return Limit(*(_number(element, tag, joint) for tag in (least, greatest)))


def _number(element: Element, tag: str, joint: str) -> float:
    found = element.first(tag)
    if found is None:
        raise element.error(f'"{tag}" limit must be specified for joint "{joint}"', _CURE)
    try:
        value = float(found.text)
    except ValueError:
        value = math.nan
    if math.isnan(value):
        raise found.error(f'"{tag}" limit must be a float for joint "{joint}"', _CURE)
    return value
