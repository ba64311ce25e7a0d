"""A compiled program's requests to OpenCV on a computer without OpenCV for C++, carried out by Python's cv2.

`cpp/include/coursekit/opencv/remote.hpp` is the other end: arguments and results are sent as a kind followed by the value.
"""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Any

import numpy as np

from coursekit.nodes.compiled.frames import FrameError, Unpacker, packed
from coursekit.nodes.compiled.vision_faces import FACES

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host

NONE, INTEGER, REAL, TEXT, MAT, LIST, TUPLE, KEYWORD = range(8)
_DTYPES = ("uint8", "int8", "uint16", "int16", "int32", "float32", "float64")
"""By OpenCV's depth numbers."""
_OTHERS = {"bool": "uint8", "int64": "int32", "uint32": "int32", "float16": "float32"}
"""Replacements of types that a Mat of Humble's OpenCV lacks."""


def _argument(frame: Unpacker) -> Any:
    """Read the next argument, without its name."""
    kind = frame.integer()
    if kind == INTEGER:
        return frame.integer()
    if kind == REAL:
        return frame.real()
    if kind == TEXT:
        return frame.text()
    if kind == MAT:
        return _array(frame)
    if kind in (LIST, TUPLE):
        items = [_argument(frame) for _ in range(frame.integer())]
        return tuple(items) if kind == TUPLE else items
    if kind == NONE:
        return None
    raise FrameError(f"A frame has an argument of kind {kind}, which there is not.")


def _array(frame: Unpacker) -> Any:
    rows, cols, depth, channels = (frame.integer() for _ in range(4))
    if depth not in range(len(_DTYPES)):
        raise FrameError(f"A frame has a matrix of depth {depth}, which there is not.")
    shape = (rows, cols) if channels == 1 else (rows, cols, channels)
    return np.frombuffer(frame.blob(), _DTYPES[depth]).reshape(shape).copy()  # cv2 draws into it


def arguments(frame: Unpacker) -> tuple[list[Any], dict[str, Any]]:
    """Read positional and named arguments.

    >>> arguments(Unpacker(packed(2, INTEGER, 5, KEYWORD, "fx", NONE)))
    ([5], {'fx': None})
    """
    by_place: list[Any] = []
    by_name: dict[str, Any] = {}
    for _ in range(frame.integer()):
        mark = frame.at
        if frame.integer() == KEYWORD:
            name = frame.text()
            by_name[name] = _argument(frame)
        else:
            frame.at = mark
            by_place.append(_argument(frame))
    return by_place, by_name


def answer(value: Any) -> bytes:
    """Pack a result for C++.

    >>> answer(7) == packed(INTEGER, 7)
    True
    """
    if value is None:
        return packed(NONE)
    if isinstance(value, np.ndarray):
        return _matrix(value)
    if isinstance(value, (bool, int, np.integer, np.bool_)):
        return packed(INTEGER, int(value))
    if isinstance(value, (float, np.floating)):
        return packed(REAL) + struct.pack("<d", value)
    if isinstance(value, str):
        return packed(TEXT, value)
    items = list(value.values()) if isinstance(value, dict) else list(value)
    return packed(TUPLE, len(items)) + b"".join(map(answer, items))


def _matrix(array: np.ndarray) -> bytes:
    name = _OTHERS.get(array.dtype.name, array.dtype.name)
    array = np.ascontiguousarray(array, name)
    rows, cols, channels = (*array.shape, 1, 1)[:3] if array.ndim < 4 else (array.shape[0], array[0].size, 1)
    return packed(MAT, rows, cols, _DTYPES.index(name), channels, array.tobytes())


def _named(name: str) -> Any:
    import cv2  # only if a program needs it

    return FACES.get(name) or getattr(cv2, name)


def do_cv_call(_host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Call a function of cv2."""
    function = _named(frame.text())
    by_place, by_name = arguments(frame)
    return answer(function(*by_place, **by_name))


def do_cv_make(host: Host, channel: Channel, frame: Unpacker) -> bytes:
    """Make a cv2 object. Returns its number."""
    kind = _named(frame.text())
    by_place, by_name = arguments(frame)
    return packed(INTEGER, host.keep(kind(*by_place, **by_name)))


def do_cv_method(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Call a method of such an object."""
    method = getattr(host.things[frame.integer()], frame.text())
    by_place, by_name = arguments(frame)
    return answer(method(*by_place, **by_name))


def do_cv_slider(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Add a slider to a window; its movements are kept for the program."""
    import cv2

    name, window, value, count = frame.text(), frame.text(), frame.integer(), frame.integer()
    cv2.createTrackbar(name, window, value, count, lambda moved: host.seen.append((window, name, moved)))
    return answer(None)


def do_cv_mouse(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Keep the events of the mouse in a window for the program."""
    import cv2

    window = frame.text()
    cv2.setMouseCallback(window, lambda *event: host.seen.append((window, *event[:4])))
    return answer(None)


def do_cv_heard(host: Host, _channel: Channel, _frame: Unpacker) -> bytes:
    """Return what moved since the last call: (window, name, value) of a slider, (window, event, x, y, flags) of a mouse."""
    events, host.seen = host.seen, []
    return answer(events)
