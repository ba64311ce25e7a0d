"""Frames of the connection between the session and a compiled program; `cpp/src/link.cpp` describes them."""

from __future__ import annotations

import struct
from typing import Any

from coursekit.interfaces.cdr import deserialize, serialize


class FrameError(ValueError):
    """A frame is shorter than its content requires."""


class Unpacker:
    """Reads data packed by the C++ Packer.

    >>> frame = Unpacker(packed(7, "seven"))
    >>> frame.integer(), frame.text()
    (7, 'seven')
    """

    def __init__(self, data: bytes, at: int = 0) -> None:
        self._data = data
        self.at = at
        """The number of bytes read so far."""

    def integer(self) -> int:
        """Read the next eight bytes."""
        value: int = struct.unpack("<q", self._take(8))[0]
        return value

    def real(self) -> float:
        """Read the next eight bytes as a float."""
        value: float = struct.unpack("<d", self._take(8))[0]
        return value

    def blob(self) -> bytes:
        """Read the next bytes with their length."""
        return self._take(self.integer())

    def text(self) -> str:
        """Read the next text; invalid UTF-8 is replaced."""
        return self.blob().decode(errors="replace")

    def message(self, cls: type[Any]) -> Any:
        """Read the next message."""
        return deserialize(self.blob(), cls)

    def rest(self) -> bytes:
        """Return all unread data."""
        return self._data[self.at :]

    def _take(self, size: int) -> bytes:
        if size < 0 or self.at + size > len(self._data):
            raise FrameError(f"A frame of {len(self._data)} bytes ends {size} bytes after its byte {self.at}.")
        self.at += size
        return self._data[self.at - size : self.at]


def packed(*values: Any) -> bytes:
    """Pack integers, texts, bytes and messages for the C++ Unpacker."""
    parts = []
    for value in values:
        if isinstance(value, int):
            parts.append(struct.pack("<q", value))
            continue
        data = value.encode() if isinstance(value, str) else value if isinstance(value, bytes) else serialize(value)
        parts.append(struct.pack("<q", len(data)) + data)
    return b"".join(parts)
