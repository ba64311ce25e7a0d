"""Removal of a terminal's colours from text."""

from __future__ import annotations

import re

_SEQUENCE = re.compile(r"\x1b(?:\[[0-?]*[ -/]*[@-~]|[@-Z\\-_])")

__all__ = ["remove_ansi_escape_senquences", "remove_ansi_escape_sequences"]


def remove_ansi_escape_sequences(string: str) -> str:
    r"""Return text without a terminal's escape sequences for colours and cursor movements.

    >>> remove_ansi_escape_sequences("\x1b[31mred\x1b[0m")
    'red'
    """
    return _SEQUENCE.sub("", string)


remove_ansi_escape_senquences = remove_ansi_escape_sequences
