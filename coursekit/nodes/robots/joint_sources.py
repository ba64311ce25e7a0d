"""The joints of a description for joint_state_publisher: URDF and, as in ROS 2, SDF and COLLADA."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator

from coursekit.urdf import Joint, parse
from coursekit.urdf.joints import read_joint
from coursekit.urdf.model import Limit
from coursekit.urdf.xml_tree import Element, read

_ENDED = ("revolute", "prismatic")
"""Types of URDF joints that need limits."""
_SKIPPED = ("gearbox", "revolute2", "ball", "screw", "universal", "fixed")
"""Types of SDF joints that a single number does not describe."""
_CURE = "Give both limits as numbers."
_OLDEST_COLLADA = [1, 5, 0]

_Text = Callable[[str], str | None]
"""The value of a description for 'lower' or 'upper'; None if it has none."""


def joints_of(description: str) -> list[Joint]:
    """The joints of a description, in its order; raises UrdfError if they cannot be read.

    >>> joints_of('<robot name="ball"><link name="base_link"/></robot>')
    []
    """
    root = read(description, "robot_description")
    if root.tag == "sdf":
        return list(_of_sdf(root))
    if root.tag == "COLLADA":
        return list(_of_collada(root))
    return _of_urdf(root, description)


def _of_urdf(root: Element, description: str) -> list[Joint]:
    robot = _needed(root, "robot", "URDF")
    for element in robot.all("joint"):
        if element.get("type") in _ENDED:
            limit = element.first("limit")
            _limit(element, str(element.get("type")), ("lower", "upper"), None if limit is None else limit.get)
    if robot is not root:  # joint_state_publisher searches for the element; urdfdom would reject it
        return [read_joint(element) for element in robot.all("joint")]
    return list(parse(description, "robot_description").joints.values())


def _of_sdf(root: Element) -> Iterator[Joint]:
    for element in _needed(root, "model", "SDF").all("joint"):
        kind, name = element.get("type") or "", element.get("name") or ""
        if kind in _SKIPPED:
            continue
        reach = None if kind == "continuous" else _limit(element, kind, ("lower", "upper"), _below(element, "limit"))
        yield Joint(name, kind, "", "", limit=reach and _ended(reach))


def _of_collada(root: Element) -> Iterator[Joint]:
    _check_version(root)
    model = _needed(root, "kinematics_model", "COLLADA")
    for element in _needed(model, "technique_common", "COLLADA").all("joint"):
        revolute = element.first("revolute")
        if revolute is None:
            continue
        limit = _limit(element, "revolute", ("min", "max"), _below(revolute, "limits"))
        if limit.lower != limit.upper:  # else it is fixed
            reach = Limit(math.radians(limit.lower), math.radians(limit.upper))
            yield Joint(element.get("name") or "", "revolute", "", "", limit=reach)


def _check_version(root: Element) -> None:
    version = root.get("version")
    if version is None:
        raise root.error("COLLADA must have a version tag", 'Write <COLLADA version="1.5.0">.')
    if [int(number) for number in re.findall(r"\d{1,9}", version)] < _OLDEST_COLLADA:
        raise root.error("COLLADA must be at least version 1.5.0", f"This file says {version!r}, which has no joints.")


def _needed(element: Element, tag: str, form: str) -> Element:
    """The element, or the first element below it, with that tag."""
    needed = next(_all_below(element, tag), None)
    if needed is None:
        raise element.error(f'{form} must have a "{tag}" tag', f"There is no <{tag}> in it.")
    return needed


def _all_below(element: Element, tag: str) -> Iterator[Element]:
    waiting = [element]
    while waiting:
        current = waiting.pop(0)
        if current.tag == tag:
            yield current
        waiting = [*current.children, *waiting]


def _below(element: Element, tag: str) -> _Text | None:
    """The texts of the children of the first element with that tag, by tag; None if there is none."""
    limits = next(_all_below(element, tag), None)
    if limits is None:
        return None
    return lambda name: None if (limit := limits.first(name)) is None else limit.text


def _limit(joint: Element, kind: str, tags: tuple[str, str], said: _Text | None) -> Limit:
    if said is None:
        raise joint.error(f'Limits must be specified for joint "{joint.get("name")}" of type "{kind}"', _CURE)
    return Limit(*(_number(joint, kind, tag, said(tag)) for tag in tags))


def _number(joint: Element, kind: str, tag: str, text: str | None) -> float:
    which = f'for joint "{joint.get("name")}" of type "{kind}"'
    if text is None:
        raise joint.error(f'"{tag}" limit must be specified {which}', _CURE)
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if math.isnan(value):
        raise joint.error(f'"{tag}" limit must be a float {which}', _CURE)
    return value


def _ended(limit: Limit) -> Limit:
    """Clamp limits to half a turn in each direction if one is infinite, as SDF writes for a joint without end stops."""
    return Limit(max(limit.lower, -math.pi), min(limit.upper, math.pi)) if math.inf in (-limit.lower, limit.upper) else limit
