"""Frames of the link between the session and a compiled program; `cpp/src/link.cpp` describes them."""

from __future__ import annotations

import struct
from typing import Any

from coursekit.interfaces.cdr import deserialize, serialize


class FrameError(ValueError):
    """A frame ends before what it says it holds."""


class Unpacker:
    """Reads what C++'s Packer has packed.

    >>> frame = Unpacker(packed(7, "seven"))
    >>> frame.integer(), frame.text()
    (7, 'seven')
    """

    def __init__(self, data: bytes, at: int = 0) -> None:
        self._data = data
        self.at = at
        """How much has been read."""

    def integer(self) -> int:
        """The next eight bytes."""
        value: int = struct.unpack("<q", self._take(8))[0]
        return value

    def real(self) -> float:
        """The next eight bytes, as a number with a fraction."""
        value: float = struct.unpack("<d", self._take(8))[0]
        return value

    def blob(self) -> bytes:
        """The next bytes, after their length."""
        return self._take(self.integer())

    def text(self) -> str:
        """The next text; bytes that are no UTF-8 are replaced."""
        return self.blob().decode(errors="replace")

    def message(self, cls: Any) -> Any:
        """The next message."""
        return deserialize(self.blob(), cls)

    def rest(self) -> bytes:
        """All that has not been read."""
        return self._data[self.at :]

    def _take(self, size: int) -> bytes:
        if size < 0 or self.at + size > len(self._data):
            raise FrameError(f"A frame of {len(self._data)} bytes ends {size} bytes after its byte {self.at}.")
        self.at += size
        return self._data[self.at - size : self.at]


def packed(*values: Any) -> bytes:
    """Pack integers, texts, bytes and messages as C++'s Unpacker reads them."""
    parts = []
    for value in values:
        if isinstance(value, int):
            parts.append(struct.pack("<q", value))
            continue
        data = value.encode() if isinstance(value, str) else value if isinstance(value, bytes) else serialize(value)
        parts.append(struct.pack("<q", len(data)) + data)
    return b"".join(parts)
