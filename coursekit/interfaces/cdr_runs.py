"""Runs of values of fixed size: one `struct` call for many fields.

CDR aligns each number to its size, so the padding of a run depends on its start position: a run consists of
eight `struct.Struct`, one for each start modulo 8.
"""

from __future__ import annotations

import struct
from array import array
from collections.abc import Sized
from typing import NamedTuple

from coursekit.interfaces.errors import CdrError

FORMATS = {
    "bool": "?",
    "byte": "c",
    "char": "B",
    "int8": "b",
    "uint8": "B",
    "int16": "h",
    "uint16": "H",
    "int32": "i",
    "uint32": "I",
    "int64": "q",
    "uint64": "Q",
    "float32": "f",
    "float64": "d",
}
SIZES = {base: struct.calcsize("<" + code) for base, code in FORMATS.items()}
PAD = tuple(b"\0" * (-start % 8) for start in range(8))


class Item(NamedTuple):
    """One value of a run; `code` is its struct format, `name` the Python expression that it is read from or assigned to."""

    align: int
    code: str
    name: str


def run(*items: tuple[int, str]) -> tuple[struct.Struct, ...]:
    """Return the eight layouts of a run of (alignment, format) items.

    >>> [layout.size for layout in run((1, 'B'), (4, 'I'))]
    [8, 7, 6, 5, 8, 7, 6, 5]
    """
    return tuple(_layout(start, items) for start in range(8))


def _layout(start: int, items: tuple[tuple[int, str], ...]) -> struct.Struct:
    form, position = "<", start
    for align, code in items:
        pad = -position % align
        form += f"{pad}x{code}" if pad else code
        position += pad + struct.calcsize("<" + code)
    return struct.Struct(form)


def at_most(values: Sized, bound: int, name: str) -> None:
    """Raise CdrError when a sequence has grown beyond its bound.

    >>> at_most([1, 2, 3], 2, "data")
    Traceback (most recent call last):
    coursekit.interfaces.errors.CdrError: 'data' has 3 elements; at most 2 are allowed
    """
    if len(values) > bound:
        raise CdrError(f"'{name}' has {len(values)} elements; at most {bound} are allowed")


def exactly(values: Sized, size: int, name: str) -> None:
    """Raise CdrError when an array does not have its fixed number of elements."""
    if len(values) != size:
        raise CdrError(f"'{name}' has {len(values)} elements; exactly {size} are needed")


def encode_wide(text: str) -> bytes:
    """Return UTF-16 units in four bytes each, as Humble's Fast DDS writes a wstring.

    >>> encode_wide("Ñ").hex()
    'd1000000'
    """
    units = array("H", text.encode("utf-16-le", "surrogatepass"))
    return struct.pack(f"<{len(units)}I", *units)


def decode_wide(data: bytes) -> str:
    """Return the text of UTF-16 units in four bytes each.

    >>> decode_wide(encode_wide("Año"))
    'Año'
    """
    units = struct.unpack(f"<{len(data) // 4}I", data)
    return b"".join((unit & 0xFFFF).to_bytes(2, "little") for unit in units).decode("utf-16-le", "replace")


def read_string(body: memoryview, position: int, bound: int = 0) -> tuple[str, int]:
    r"""Return the string at a position and the position after it.

    >>> read_string(memoryview(b"\x03\0\0\0hi\0"), 0)
    ('hi', 7)
    """
    position += -position % 4
    (length,) = struct.unpack_from("<I", body, position)
    data = take(body, position + 4, length)
    if bound and length - 1 > 4 * bound:
        raise CdrError(f"a string of {length - 1} bytes where {bound} characters are allowed")
    return str(data[:-1], "utf-8", "replace"), position + 4 + length


def read_wide(body: memoryview, position: int) -> tuple[str, int]:
    """Return the wstring at a position and the position after it.

    >>> out = bytearray()
    >>> write_wide(out, "größer")
    >>> read_wide(memoryview(out), 0)  # four bytes for the length, four for each character
    ('größer', 28)
    """
    position += -position % 4
    (length,) = struct.unpack_from("<I", body, position)
    return decode_wide(bytes(take(body, position + 4, 4 * length))), position + 4 + 4 * length


def write_string(out: bytearray, text: str) -> None:
    r"""Append a string to a body that starts at byte 4 of `out`.

    >>> out = bytearray()
    >>> write_string(out, "hi")
    >>> bytes(out)
    b'\x03\x00\x00\x00hi\x00'
    """
    data = text.encode()
    out += PAD4[len(out) & 3] + (len(data) + 1).to_bytes(4, "little") + data + b"\0"


def write_wide(out: bytearray, text: str) -> None:
    """Append a wstring."""
    data = encode_wide(text)
    out += PAD4[len(out) & 3] + (len(data) // 4).to_bytes(4, "little") + data


PAD4 = tuple(b"\0" * (-start % 4) for start in range(4))


def take(body: memoryview, position: int, count: int) -> memoryview:
    """Return `count` bytes; raise CdrError when there are fewer.

    >>> bytes(take(memoryview(b"abcdef"), 2, 3))
    b'cde'
    """
    if position + count > len(body):
        raise CdrError(f"{count} bytes expected at byte {position}, but the data ends at byte {len(body)}")
    return body[position : position + count]


def read_block(body: memoryview, position: int, code: str, count: int) -> tuple[array[int], int]:
    r"""Return `count` numbers as an array.array, and the position after them.

    >>> values, end = read_block(memoryview(b"\x00\x00\x00\x00\x01\x00\x02\x00"), 3, "h", 2)  # aligned to two bytes
    >>> list(values), end
    ([1, 2], 8)
    """
    values: array[int] = array(code)
    if not count:
        return values, position
    position += -position % values.itemsize
    size = count * values.itemsize
    values.frombytes(take(body, position, size))
    return values, position + size
