"""Parsing numbers in attributes, with urdfdom's error texts."""

from __future__ import annotations

import math
import re

from .errors import expanded
from .model import Colour, Origin, Vector
from .xml_tree import Element

_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?", re.ASCII)
_SPACES = " \t\n\r"


def plain(text: str) -> float | None:
    """Return the number in a text, or None: no nan, no inf, no hexadecimal, as in C++.

    >>> plain(" 1e-3 "), plain("nan"), plain("0x10")
    (0.001, None, None)
    """
    stripped = text.strip(_SPACES)
    if _NUMBER.fullmatch(stripped) is None:
        return None
    value = float(stripped)
    return value if math.isfinite(value) else None


def number(element: Element, name: str, default: float, what: str = "{name} value ({text}) is not a valid float") -> float:
    """Return an attribute as a number, or the default if it is missing.

    >>> from coursekit.urdf.xml_tree import read
    >>> limit = read('<limit lower="-1.5"/>')
    >>> number(limit, "lower", 0.0), number(limit, "upper", 0.0)
    (-1.5, 0.0)
    """
    text = element.get(name)
    if text is None:
        return default
    value = plain(text)
    if value is None:
        cure = expanded(text, f'Write a number: {name}="{default}".')
        raise element.error(what.format(name=name, text=text), cure)
    return value


def vector(element: Element, name: str, default: Vector, prefix: str = "") -> Vector:
    """Return an attribute of three numbers.

    >>> from coursekit.urdf.xml_tree import read
    >>> vector(read('<origin xyz="1 2 0.5"/>'), "xyz", (0.0, 0.0, 0.0))
    (1.0, 2.0, 0.5)
    """
    text = element.get(name)
    if text is None:
        return default
    values = _several(element, name, text, 3, "vector", prefix)
    return (values[0], values[1], values[2])


def _several(element: Element, name: str, text: str, count: int, kind: str, prefix: str) -> list[float]:
    words = re.split(f"[{_SPACES}]+", text.strip(_SPACES))
    words = [] if words == [""] else words
    values = []
    cure = expanded(text, f'Write {count} numbers with blanks between them: {name}="{" ".join(["0"] * count)}".')
    for word in words:
        value = plain(word)
        if value is None:
            what = f"Unable to parse component [{word}] to a double (while parsing a {kind} value)"
            raise element.error(prefix + what, cure)
        values.append(value)
    if len(values) != count:
        what = f"Parser found {len(values)} elements but {count} expected while parsing {kind} [{text}]"
        raise element.error(prefix + what, cure)
    return values


def origin(element: Element) -> Origin:
    """Return the `<origin>` of an element; the identity if it is missing."""
    child = element.first("origin")
    if child is None:
        return Origin()
    return Origin(vector(child, "xyz", (0.0, 0.0, 0.0)), vector(child, "rpy", (0.0, 0.0, 0.0)))


def colour(element: Element, material: str) -> Colour:
    """Return the `rgba` of a `<color>`.

    >>> from coursekit.urdf.xml_tree import read
    >>> colour(read('<color rgba="1 0.5 0 1"/>'), "orange")
    (1.0, 0.5, 0.0, 1.0)
    """
    text = element.get("rgba")
    if text is None:
        raise element.error(f"Material [{material}] color has no rgba", 'Write rgba="0.2 0.4 0.8 1".')
    values = _several(element, "rgba", text, 4, "color", f"Material [{material}] has malformed color rgba values: ")
    if not all(0.0 <= value <= 1.0 for value in values):
        what = f"Material [{material}] has malformed color rgba values: [{text}]"
        raise element.error(what, "Each of the four numbers is from 0 to 1: divide values out of 255 by 255.")
    return (values[0], values[1], values[2], values[3])


__all__ = ["colour", "number", "origin", "plain", "vector"]
