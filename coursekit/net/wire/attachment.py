"""The attachment of each message: its number, its send time, and its publisher."""

from __future__ import annotations

import struct
from typing import NamedTuple

_LAYOUT = struct.Struct("<qqB16s")
_GID_SIZE = 16
SIZE = _LAYOUT.size
"""Size of an attachment [bytes]."""


class Attachment(NamedTuple):
    """The attachment; `stamp` is the sender's clock [ns]."""

    number: int
    stamp: int
    gid: bytes

    def data(self) -> bytes:
        """Return the bytes to send.

        >>> len(Attachment(1, 2, bytes(16)).data())
        33
        """
        return _LAYOUT.pack(self.number, self.stamp, _GID_SIZE, self.gid)


def read_attachment(data: bytes) -> Attachment:
    """Read the attachment of a message; ValueError for a malformed one.

    >>> read_attachment(Attachment(7, 1000, bytes(16)).data()).number
    7
    """
    if len(data) != SIZE or data[16] != _GID_SIZE:
        raise ValueError(f"{len(data)} bytes that are no attachment")
    number, stamp, _, gid = _LAYOUT.unpack(data)
    return Attachment(number, stamp, gid)
