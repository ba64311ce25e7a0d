r"""Keys of Windows' console: the codes of msvcrt, and the characters that a Linux terminal sends for the same keys.

>>> codes_of("\x1b[A"), sent_for("\xe0", "H") == "\x1b[A"
(['à', 'H'], True)
"""

from __future__ import annotations

import importlib
import os
from typing import Any

from . import operating_system

SPECIAL = ("\0", "\xe0")
"""The first codes of keys that are not characters; the second one is also a letter."""
SENT = {
    "H": "\x1b[A",
    "P": "\x1b[B",
    "M": "\x1b[C",
    "K": "\x1b[D",
    "G": "\x1b[H",
    "O": "\x1b[F",
    "R": "\x1b[2~",
    "S": "\x1b[3~",
    "I": "\x1b[5~",
    "Q": "\x1b[6~",
}
"""The characters sent for arrows, Home, End, Insert, Delete and the two Page keys."""
_CODES = {sent: code for code, sent in SENT.items()}


def is_there(number: int) -> bool:
    """Whether a file descriptor is Windows' console."""
    return operating_system.WINDOWS and os.isatty(number)


def has_key() -> bool:
    """Whether an unread key press is available."""
    return bool(_msvcrt().kbhit())


def key() -> str:
    """Return the next key as a Linux terminal sends it; empty for a key that it does not have."""
    first: str = _msvcrt().getwch()
    if first in SPECIAL and (first == "\0" or has_key()):
        return sent_for(first, _msvcrt().getwch())
    return "\n" if first == "\r" else first


def sent_for(special: str, code: str) -> str:
    """Return the characters that a terminal sends for a key with these two msvcrt codes."""
    return SENT.get(code, "") if special in SPECIAL else special + code


def codes_of(typed: str) -> list[str]:
    r"""Convert a terminal's characters to msvcrt's codes: character by character, or two codes for one of the keys above.

    >>> codes_of("w\n")
    ['w', '\r']
    """
    if typed in _CODES:
        return [SPECIAL[1], _CODES[typed]]
    return ["\r" if sign == "\n" else sign for sign in typed]


def begins_key(typed: str) -> bool:
    """Whether the characters may be the beginning of a key's sequence."""
    return any(sent.startswith(typed) and sent != typed for sent in _CODES)


def _msvcrt() -> Any:
    return importlib.import_module("msvcrt")
