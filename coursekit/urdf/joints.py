"""Reading `<joint>`."""

from __future__ import annotations

import math

from .errors import UrdfError, close
from .model import JOINT_TYPES, Joint, Limit, Mimic, Origin, Safety, Vector
from .values import number, origin, vector
from .xml_tree import Element

_AXIS = 'Write for example <axis xyz="0 0 1"/>.'
_LIMIT = 'Add <limit lower="-1.57" upper="1.57" effort="10" velocity="1"/> (rad or m).'


def read_joint(element: Element) -> Joint:
    """Read a joint whose links need not exist yet; raises UrdfError."""
    name = element.get("name")
    if not name:
        raise element.error("unnamed joint found", 'Write <joint name="..." type="fixed">.', (_OUTER,))
    try:
        return _joint(element, name)
    except UrdfError as error:
        raise error.within(_OUTER) from None


_OUTER = "joint xml is not initialized correctly"


def _joint(element: Element, name: str) -> Joint:
    place = _origin(element, name)
    parent, child = element.first("parent"), element.first("child")
    type_ = _type(element, name)
    damping, friction = _dynamics(element, name)
    _check_calibration(element, name)
    return Joint(
        name,
        type_,
        (parent.get("link") or "") if parent is not None else "",
        (child.get("link") or "") if child is not None else "",
        place,
        (1.0, 0.0, 0.0) if type_ in ("fixed", "floating") else _axis(element, name),
        _limit(element, name, type_),
        _mimic(element, name),
        _safety(element, name),
        damping,
        friction,
        element.line,
    )


def _origin(element: Element, name: str) -> Origin:
    try:
        return origin(element)
    except UrdfError as error:
        raise error.within(f"Malformed parent origin element for joint [{name}]") from None


def _type(element: Element, name: str) -> str:
    type_ = element.get("type")
    types = f"The types are: {', '.join(JOINT_TYPES)}."
    if type_ is None:
        raise element.error(f"joint [{name}] has no type, check to see if it's a reference.", types)
    if type_ not in JOINT_TYPES:
        hint = close(type_, JOINT_TYPES)
        raise element.error(f"Joint [{name}] has no known type [{type_}]", hint if "Did" in hint else types)
    return type_


def _axis(element: Element, name: str) -> Vector:
    axis = element.first("axis")
    if axis is None:
        return (1.0, 0.0, 0.0)
    prefix = f"Malformed axis element for joint [{name}]: "
    if axis.get("xyz") is None:
        raise axis.error(prefix + "no xyz attribute", _AXIS)
    x, y, z = vector(axis, "xyz", (1.0, 0.0, 0.0), prefix)
    length = math.hypot(x, y, z)
    if not 1e-9 < length < 1e150:
        raise axis.error(f"{prefix}the axis [{axis.get('xyz')}] has no direction", _AXIS)
    return (x, y, z) if abs(length - 1.0) < 1e-15 else (x / length, y / length, z / length)


def _limit(element: Element, name: str, type_: str) -> Limit | None:
    limit = element.first("limit")
    if limit is None:
        if type_ == "revolute":
            cure = f'{_LIMIT[:-1]}, or make it type="continuous".'
            raise element.error(f"Joint [{name}] is of type REVOLUTE but it does not specify limits", cure)
        if type_ == "prismatic":
            raise element.error(f"Joint [{name}] is of type PRISMATIC without limits", _LIMIT)
        return None
    try:
        return _read_limit(limit, name)
    except UrdfError as error:
        raise error.within(f"Could not parse limit element for joint [{name}]") from None


def _read_limit(limit: Element, name: str) -> Limit:
    what = f"joint [{name}]: {{name}} value ({{text}}) is not a valid float"
    lower, upper = number(limit, "lower", 0.0, what), number(limit, "upper", 0.0, what)
    for needed in ("effort", "velocity"):
        if limit.get(needed) is None:
            cure = f'Add {needed}="{10 if needed == "effort" else 1}" to <limit>: both effort and velocity are needed.'
            raise limit.error(f"joint [{name}]: limit has no {needed}", cure)
    return Limit(lower, upper, number(limit, "effort", 0.0, what), number(limit, "velocity", 0.0, what))


def _mimic(element: Element, name: str) -> Mimic | None:
    mimic = element.first("mimic")
    if mimic is None:
        return None
    outer = f"Could not parse mimic element for joint  [{name}]"
    joint = mimic.get("joint")
    if not joint:
        cure = 'Name the joint that it follows: <mimic joint="..."/>.'
        raise mimic.error("joint mimic: no mimic joint specified", cure, (outer,))
    try:
        return Mimic(joint, number(mimic, "multiplier", 1.0), number(mimic, "offset", 0.0))
    except UrdfError as error:
        raise error.within(outer) from None


def _safety(element: Element, name: str) -> Safety | None:
    safety = element.first("safety_controller")
    if safety is None:
        return None
    outer = f"Could not parse safety element for joint [{name}]"
    if safety.get("k_velocity") is None:
        raise safety.error("joint safety: no k_velocity", 'Add k_velocity="10".', (outer,))
    try:
        return Safety(
            number(safety, "k_velocity", 0.0),
            number(safety, "k_position", 0.0),
            number(safety, "soft_lower_limit", 0.0),
            number(safety, "soft_upper_limit", 0.0),
        )
    except UrdfError as error:
        raise error.within(outer) from None


def _dynamics(element: Element, name: str) -> tuple[float, float]:
    dynamics = element.first("dynamics")
    if dynamics is None:
        return 0.0, 0.0
    outer = f"Could not parse joint_dynamics element for joint [{name}]"
    if dynamics.get("damping") is None and dynamics.get("friction") is None:
        what = "joint dynamics element specified with no damping and no friction"
        raise dynamics.error(what, 'Write <dynamics damping="0.1" friction="0.0"/>, or leave it out.', (outer,))
    try:
        return number(dynamics, "damping", 0.0), number(dynamics, "friction", 0.0)
    except UrdfError as error:
        raise error.within(outer) from None


def _check_calibration(element: Element, name: str) -> None:
    calibration = element.first("calibration")
    if calibration is None:
        return
    try:
        for edge in ("rising", "falling"):
            number(calibration, edge, 0.0)
    except UrdfError as error:
        raise error.within(f"Could not parse calibration element for joint  [{name}]") from None


__all__ = ["read_joint"]
