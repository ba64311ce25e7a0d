"""Values as JSON between a sandbox and the judge: plain types exactly, messages as bytes, other objects as descriptions.

A distance field of walls is sent as its points. Nothing is ever unpickled: the judge sees only the type name of a
student's object.
"""

from __future__ import annotations

import base64
import re
from typing import Any

DEPTH = 30
LENGTH = 200_000
"""The maximum number of list elements, and of characters in a text."""
KEYS = 5_000
"""The maximum number of elements of a set or dictionary: keys that all collide cost quadratic time."""
DIGITS = 4_000
"""The maximum number of digits of an integer."""
LETTERS = 1_000
"""The maximum length of each text in an array [characters]."""
_NUMBERS = ("bool", "int8", "int16", "int32", "int64", "uint8", "uint16", "uint32", "uint64",
            "float16", "float32", "float64")  # fmt: skip
_TEXTS = re.compile(r"[<>|=]?U\d{1,4}")
_TYPE_NAME = re.compile(r"[a-z][a-z0-9_]*/(msg|srv|action)/[A-Z][A-Za-z0-9_]*")


class Described:
    """A placeholder for an object that cannot be sent: equal to nothing, with a description."""

    def __init__(self, kind: str, text: str) -> None:
        self.kind = kind
        self.text = text

    def __eq__(self, other: object) -> bool:
        return False

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return self.text


def pack(value: Any, depth: int = 0) -> Any:
    """Convert a value to JSON.

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
        return [pack(item, depth + 1) for item in value]
    if kind in (tuple, set, frozenset) and len(value) <= (LENGTH if kind is tuple else KEYS):
        return {kind.__name__: [pack(item, depth + 1) for item in value]}
    if kind is dict and len(value) <= KEYS:
        return {"dict": [[pack(key, depth + 1), pack(item, depth + 1)] for key, item in value.items()]}
    if kind is bytes:
        return {"bytes": base64.b64encode(value[:LENGTH]).decode()}
    return _pack_object(value, kind)


def _pack_object(value: Any, kind: type) -> Any:
    if kind.__module__ == "numpy" and hasattr(value, "dtype") and value.dtype.kind in "biufU" and value.size <= LENGTH:
        return {"array": [str(value.dtype), list(value.shape), pack(value.ravel().tolist())]}
    if (kind.__module__, kind.__name__) == ("coursekit.slam.wall_field", "WallField"):
        return {"gaps": [pack(part, DEPTH - 5) for part in (value.points, value.cell, value.reach)]}
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
    """Convert untrusted JSON of `pack` back to a value; ValueError for anything that `pack` never makes.

    Values that would take more memory than their JSON are refused in advance.

    >>> unpack({"array": ["<U250000000", [1], ["x"]]})
    Traceback (most recent call last):
    ValueError: there is no array of '<U250000000'
    """
    if isinstance(tree, list):
        return [unpack(item) for item in tree]
    if not isinstance(tree, dict):
        return tree
    tag, inner = _tagged(tree)
    if tag not in _READERS:
        raise ValueError(f"there is no tag {tag!r}")
    return _READERS[tag](inner)


def unpack_of_judge(tree: Any) -> Any:
    """Convert a value sent by a judge, including a distance field, which a student never sends."""
    if isinstance(tree, dict) and "gaps" in tree:
        return _gaps(_tagged(tree)[1])
    return unpack(tree)


def _tagged(tree: dict[str, Any]) -> tuple[str, Any]:
    if len(tree) != 1:
        raise ValueError("a packed value has one tag")
    return next(iter(tree.items()))


def _integer(inner: Any) -> int:
    if type(inner) is not str or len(inner) > DIGITS:
        raise ValueError("an integer has too many digits")
    return int(inner)


def _keys(inner: Any) -> list[Any]:
    if type(inner) is not list or len(inner) > KEYS:
        raise ValueError(f"more than {KEYS} elements")
    return inner


def _array(inner: Any) -> Any:
    import numpy as np

    name, shape, values = inner
    texts = type(name) is str and _TEXTS.fullmatch(name) and int(name.rpartition("U")[2]) <= LETTERS
    if name not in _NUMBERS and not texts:
        raise ValueError(f"there is no array of {name!r}")
    if type(values) is not list or len(values) > LENGTH or any(type(size) is not int or size < 0 for size in shape):
        raise ValueError("an array of another form")
    array = np.array(unpack(values), dtype=np.dtype(name)).reshape(shape)
    return array if shape else array[()]


def _message(inner: Any) -> Any:
    from coursekit.interfaces import cdr, load

    name, data = inner
    if type(name) is not str or not _TYPE_NAME.fullmatch(name):
        raise ValueError("there is no such interface")
    return cdr.deserialize(base64.b64decode(str(data)), load(name))


def _gaps(inner: Any) -> Any:
    from coursekit.slam.wall_field import WallField

    points, cell, reach = (unpack(item) for item in inner)
    return WallField(points, cell, reach)


def refresh(old: Any, new: Any) -> bool:
    """Copy the content of `new` into the mutable `old`, in place. Returns whether that was possible.

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
    "int": _integer,
    "float": lambda inner: float(str(inner)),
    "tuple": lambda inner: tuple(unpack(item) for item in inner),
    "set": lambda inner: {unpack(key) for key in _keys(inner)},
    "frozenset": lambda inner: frozenset(unpack(key) for key in _keys(inner)),
    "dict": lambda inner: {unpack(key): unpack(item) for key, item in _keys(inner)},
    "bytes": lambda inner: base64.b64decode(str(inner)),
    "array": _array,
    "message": _message,
    "other": lambda inner: Described(str(inner[0]), str(inner[1])),
}
