"""Values as JSON between a sandbox and the judge: plain types exactly, ROS messages as bytes, a field of gaps to walls by
its points, the rest as a description.

Nothing is ever unpickled: what a student's object is, the judge learns from its type's name only.
"""

from __future__ import annotations

import base64
from typing import Any

DEPTH = 30
LENGTH = 200_000


class Described:
    """Stands for an object that cannot cross: equal to nothing, known by its description."""

    def __init__(self, kind: str, text: str) -> None:
        self.kind = kind
        self.text = text

    def __eq__(self, other: object) -> bool:
        return False

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return self.text


def pack(value: Any, depth: int = 0) -> Any:
    """A value as JSON.

    >>> pack((1, 2.5))
    {'tuple': [1, {'float': '2.5'}]}
    """
    kind = type(value)
    if depth > DEPTH:
        return {"other": ["too deep", "..."]}
    if value is None or kind in (bool, int) or (kind is str and len(value) <= LENGTH):
        return value if kind is not int or abs(value) < 2**53 else {"int": str(value)}
    if kind is float:
        return {"float": repr(value)}
    if kind is list and len(value) <= LENGTH:
        return [pack(one, depth + 1) for one in value]
    if kind in (tuple, set, frozenset) and len(value) <= LENGTH:
        return {kind.__name__: [pack(one, depth + 1) for one in value]}
    if kind is dict and len(value) <= LENGTH:
        return {"dict": [[pack(key, depth + 1), pack(one, depth + 1)] for key, one in value.items()]}
    if kind is bytes:
        return {"bytes": base64.b64encode(value[:LENGTH]).decode()}
    return _pack_object(value, kind)


def _pack_object(value: Any, kind: type) -> Any:
    if kind.__module__ == "numpy" and hasattr(value, "dtype") and value.dtype.kind in "biufU" and value.size <= LENGTH:
        return {"array": [str(value.dtype), list(value.shape), pack(value.ravel().tolist())]}
    if (kind.__module__, kind.__name__) == ("coursekit.slam.wall_field", "WallField"):
        return {"gaps": [pack(one, DEPTH - 5) for one in (value.points, value.cell, value.reach)]}
    name = getattr(kind, "_TYPE_NAME", None)
    if isinstance(name, str):
        from coursekit.interfaces import cdr

        return {"message": [name, base64.b64encode(cdr.serialize(value)).decode()]}
    try:
        text = repr(value)[:200]
    except Exception as error:
        text = f"an object whose repr raises {type(error).__name__}"
    return {"other": [kind.__name__[:80], str(text)]}


def unpack(tree: Any) -> Any:
    """The value that `pack` made JSON of; ValueError for JSON that it never makes."""
    if isinstance(tree, list):
        return [unpack(one) for one in tree]
    if not isinstance(tree, dict):
        return tree
    if len(tree) != 1:
        raise ValueError("a packed value has one tag")
    ((tag, inner),) = tree.items()
    if tag not in _READERS:
        raise ValueError(f"there is no tag {tag!r}")
    return _READERS[tag](inner)


def _array(inner: Any) -> Any:
    import numpy as np

    kind, shape, values = inner
    made = np.array(unpack(values), dtype=np.dtype(str(kind))).reshape([int(one) for one in shape])
    return made if shape else made[()]


def _message(inner: Any) -> Any:
    from coursekit.interfaces import cdr, load

    name, data = inner
    return cdr.deserialize(base64.b64decode(data), load(str(name)))


def _gaps(inner: Any) -> Any:
    from coursekit.slam.wall_field import WallField

    points, cell, reach = (unpack(one) for one in inner)
    return WallField(points, cell, reach)


def refresh(old: Any, new: Any) -> bool:
    """Make the mutable `old` hold what `new` holds, in place; whether it could.

    >>> mine = {"holding": False}
    >>> refresh(mine, {"holding": True}), mine
    (True, {'holding': True})
    """
    if type(old) is not type(new):
        return False
    if type(old) in (dict, set):
        old.clear()
        old.update(new)
    elif type(old) is list:
        old[:] = new
    elif hasattr(type(old), "_TYPE_NAME"):
        for name in old.get_fields_and_field_types():
            setattr(old, name, getattr(new, name))
    elif type(old).__module__ == "numpy" and getattr(old, "shape", ()) == getattr(new, "shape", None) != ():
        old[...] = new
    else:
        return False
    return True


_READERS: dict[str, Any] = {
    "int": lambda inner: int(str(inner)),
    "float": lambda inner: float(str(inner)),
    "tuple": lambda inner: tuple(unpack(one) for one in inner),
    "set": lambda inner: {unpack(one) for one in inner},
    "frozenset": lambda inner: frozenset(unpack(one) for one in inner),
    "dict": lambda inner: {unpack(key): unpack(one) for key, one in inner},
    "bytes": lambda inner: base64.b64decode(str(inner)),
    "array": _array,
    "message": _message,
    "gaps": _gaps,
    "other": lambda inner: Described(str(inner[0]), str(inner[1])),
}
