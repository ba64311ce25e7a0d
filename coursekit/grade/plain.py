"""Validation of a student's values as exactly plain: finite numbers, texts, lists and tuples; anything else is Wrong.

Judges compare only results of these functions. NaN, infinities, bool in place of int and objects with a false __eq__
never reach a comparison, so a check passes only when something was positively found correct.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar

from .interruptions import Gone, TimeOver
from .sandbox_json import Described
from .stopped_function import error_of, why_it_stopped
from .verdict import NO_HINT, Wrong

T = TypeVar("T")
_UNFINISHED = ("coroutine", "generator", "async_generator")
MOST = 100
"""The maximum length of a value in a verdict [characters]."""


def shown(value: Any, most: int = MOST) -> str:
    """Format a value for a verdict by its truncated repr, even if the repr fails.

    >>> shown([1, 2]), shown("long" * 9, 8), shown(10**9999)
    ('[1, 2]', "'longlo…", 'an int that cannot be shown')
    """
    try:
        text = str.__getitem__(repr(value), slice(0, most + 1))
        return text if len(text) <= most else text[: most - 1] + "…"
    except Exception:
        return f"an {type(value).__name__[:40]} that cannot be shown"


def is_number(value: Any) -> bool:
    """Whether a value is exactly an int, a float or a numpy scalar of these, and finite; not a bool.

    >>> [is_number(one) for one in (1, 2.5, True, math.nan, math.inf, "1", 10**400)]
    [True, True, False, False, False, False, False]
    """
    numpy = sys.modules.get("numpy")
    kinds = (int, float)
    if type(value) not in kinds and (numpy is None or type(value) not in _scalars(numpy)):
        return False
    try:
        return math.isfinite(float(value))
    except OverflowError:
        return False


def is_infinite(value: Any) -> bool:
    """Whether a value is exactly positive infinity, as a float or a numpy scalar.

    >>> [is_infinite(one) for one in (math.inf, -math.inf, math.nan, 1.0, "inf")]
    [True, False, False, False, False]
    """
    numpy = sys.modules.get("numpy")
    return type(value) in (float, *(_scalars(numpy)[:3] if numpy else ())) and bool(value == math.inf)


def _scalars(numpy: Any) -> tuple[Any, ...]:
    floats: tuple[Any, ...] = numpy.float64, numpy.float32, numpy.float16
    return floats + tuple(getattr(numpy, f"{sign}int{bits}") for sign in ("", "u") for bits in (8, 16, 32, 64))


def near(got: Any, need: float, tolerance: float) -> bool:
    """Whether `got` is a plain finite number within `tolerance` of `need`.

    >>> near(1.0, 1, 1e-6), near(math.nan, 1, 1e-6), near(True, 1, 1)
    (True, False, False)
    """
    return is_number(got) and abs(float(got) - need) <= tolerance


def close(got: Sequence[Any], need: Sequence[float], tolerance: float) -> bool:
    """Whether `got` has the same number of plain finite numbers, at a distance within `tolerance` of `need`.

    >>> close((0.0, 1.0), (0, 1), 0.1), close((0.0, math.nan), (0, 1), 0.1), close((0.0,), (0, 1), 2)
    (True, False, False)
    """
    if len(got) != len(need) or not all(is_number(value) for value in got):
        return False
    return math.dist([float(value) for value in got], need) <= tolerance


def number(value: Any, expected: str, cause: str = "", *, share: float = 0.0) -> float:
    """Return the value as a float; Wrong with `expected` when it is not a plain finite number.

    >>> try:
    ...     number("0.5", "a distance")
    ... except Wrong as wrong:
    ...     print(wrong.expected, wrong.cause, sep=": ")
    a distance: That is a text: leave the quotes, `str` or the f-string out.
    """
    value = _single(value)
    if not is_number(value):
        raise Wrong(expected, gave=shown(value), cause=cause or _why_no_number(value), share=share, hint=NO_HINT)
    return float(value)


def _why_no_number(value: Any) -> str:
    if value is None:
        return "Is there a `return` in every case?"
    if type(value) in (list, tuple, dict, set) or _array(value) is not None:
        return "One number is asked for, these are several."
    if type(value) is str:
        return "That is a text: leave the quotes, `str` or the f-string out."
    if type(value) is float and not math.isfinite(value):
        return "Is something divided by zero, or is it beyond what a float holds?"
    if (value.kind if type(value) is Described else type(value).__name__) in _UNFINISHED:
        return "Such a function gives no value: is there an `async` or a `yield` too many?"
    return ""


def whole(value: Any, expected: str, cause: str = "", *, share: float = 0.0) -> int:
    """Return the value as an int; Wrong for anything else, including bool and 2.0.

    >>> try:
    ...     whole(2.0, "the number of robots")
    ... except Wrong as wrong:
    ...     print(wrong.cause)
    That is a float: `int(...)` makes an integer of it.
    """
    value = _single(value)
    if not is_number(value) or type(value) is float or float(value) != int(value):
        if type(value) is str:
            cause = _why_no_number(value)
        if is_number(value):
            cut = float(value) == int(value)
            cause = "That is a float: `int(...)` makes an integer of it." if cut else cause or "An integer is asked for."
        raise Wrong(expected, gave=shown(value), cause=cause or _why_no_number(value), share=share, hint=NO_HINT)
    return int(value)


def numbers(value: Any, count: int, expected: str, cause: str = "") -> tuple[float, ...]:
    """Return `count` finite numbers of a tuple, list or array; Wrong for anything else.

    >>> import numpy as np
    >>> numbers(np.array([[1, 2]]), 2, "x and y")
    (1.0, 2.0)
    """
    array = _array(value)
    parts = items(value, expected, cause) if array is None else array.ravel().tolist()
    if len(parts) != count:
        why = f"{count} values are asked for, these are {len(parts)}."
        raise Wrong(expected, gave=shown(value), cause=cause or why, hint=NO_HINT)
    return tuple(number(part, expected, cause) for part in parts)


def items(value: Any, expected: str, cause: str = "") -> list[Any]:
    """Return the items of a tuple or list, or the rows of an array of numbers; Wrong for anything else.

    >>> items((1, 2), "a list of numbers")
    [1, 2]
    """
    if type(value) in (tuple, list):
        return list(value)
    if (array := _array(value)) is not None and array.ndim:
        return list(array.tolist())
    several = "One number came where several are asked for."
    several = several if is_number(value) else "They belong in a tuple or a list: `a, b`."
    why = several if type(value) in (dict, set) else _why_no_number(value) or several
    raise Wrong(expected, gave=shown(value), cause=cause or why, hint=NO_HINT)


def _single(value: Any) -> Any:
    """Return the number of an array that is one number, as numpy's functions return them; else the value itself."""
    array = _array(value)
    return value if array is None or array.ndim else array.item()


def _array(value: Any) -> Any:
    """Return the value if it is an array of plain numbers of acceptable size, else None."""
    numpy = sys.modules.get("numpy")
    if numpy is None or type(value) is not numpy.ndarray or value.dtype.kind not in "iuf" or value.size > 10**6:
        return None
    return value


def text(value: Any, expected: str, cause: str = "") -> str:
    """Return the value as a str; Wrong when it is not one."""
    if type(value) is not str:
        if (value.kind if type(value) is Described else type(value).__name__).endswith("Path"):
            cause = cause or "That is a path object: `str(...)` makes a text of it."
        raise Wrong(expected, gave=shown(value), cause=cause or _why_no_number(value), hint=NO_HINT)
    return value


def texts(value: Any, expected: str, cause: str = "") -> list[str]:
    """Return the texts in a list or a tuple; Wrong when it contains anything else."""
    if type(value) not in (list, tuple):
        raise Wrong(expected, gave=shown(value), cause=cause, hint=NO_HINT)
    return [text(item, expected, cause) for item in value]


def field(message: Any, path: str, kind: type[T], where: str = "a message") -> T:
    """Return a field of a recorded message, of exactly that type; floats must be finite, and may be ints.

    >>> field({"pose": {"x": 1.5}}, "pose.x", float)
    1.5
    """
    value = message
    for name in path.split("."):
        if not isinstance(value, Mapping) or name not in value:
            raise Wrong(f"{where} with the field {path}", "it has none", "Is the message's type the right one?")
        value = value[name]
    if kind is float:
        return number(value, f"{where} whose {path} is a finite number")  # type: ignore[return-value]
    if type(value) is not kind:
        name = {str: "a text", bool: "true or false", int: "an integer", list: "a list"}.get(kind, kind.__name__)
        raise Wrong(f"{where} whose {path} is {name}", shown(value), "Is the message's type the right one?")
    return value


def fields(message: Any, paths: Sequence[str], where: str = "a message") -> tuple[float, ...]:
    """Return several finite numbers of a recorded message.

    >>> fields({"pose": {"x": 1, "y": 2.5}}, ("pose.x", "pose.y"))
    (1.0, 2.5)
    """
    return tuple(field(message, path, float, where) for path in paths)


def called(function: Callable[..., Any], *given: Any, told: str) -> Any:
    """Return the result of a student's function; Wrong with its exception and line when it raises one.

    >>> try:
    ...     called(lambda x: 1 / x, 0, told="inverse(0)")
    ... except Wrong as wrong:
    ...     print(wrong.got.partition(" (")[0])
    ZeroDivisionError: division by zero
    """
    try:
        return function(*given)
    except (NotImplementedError, Gone):
        raise
    except TimeOver as late:
        cause = "Is there a loop that never ends?"
        raise Wrong(f"an answer from {told}", f"{late}", cause, timed_out=True) from None
    except Exception as error:
        raise Wrong(f"an answer from {told}", error_of(error), why_it_stopped(error)) from None
