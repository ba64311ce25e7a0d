"""Shell commands that Windows' cmd lacks, and their replacements in a cell."""

from __future__ import annotations

import re
import shutil

from coursekit.words.gettext import gettext

_NOT_NEEDED = "cells know what `%colcon build` has built, so leave it out"
_INSTEAD = {
    "source": _NOT_NEEDED,
    ".": _NOT_NEEDED,
    "export": "type `%env NAME=value`, which holds for all cells that follow",
    "ls": "type `!dir`",
    "cat": "type `!type FILE`",
    "cp": "type `!copy FILE TO`",
    "mv": "type `!move FILE TO`",
    "rm": "type `!del FILE`, or `!rmdir /s /q FOLDER`",
    "touch": "type `%%write FILE`",
    "grep": "type `!findstr WORD FILE`",
    "which": "type `!where PROGRAM`",
    "pwd": "type `%pwd`",
}
_BETWEEN = re.compile(r"&&|\|\||[;|&]")


def hint(line: str) -> str:
    """Suggest a replacement for a bash command in a line that failed; empty when there is none.

    >>> hint("source setup.bash && ros2 node list")
    "`!` runs Windows' cmd, which has no `source`: cells know what `%colcon build` has built, so leave it out."
    >>> hint("ros2 node list")
    ''
    """
    for part in _BETWEEN.split(line):
        word = (part.split() or [""])[0]
        if word in _INSTEAD and (word == "." or shutil.which(word) is None):
            return gettext(f"`!` runs Windows' cmd, which has no `{word}`: {_INSTEAD[word]}.")
    return ""


__all__ = ["hint"]
