r"""Outputs of a chapter as they are on Linux: for the comparison only, students see what their system says.

>>> alike("~\\ros2_ws\\src\\talker.exe\r\n")
'~/ros2_ws/src/talker\n'
"""

from __future__ import annotations

import re
from typing import Any

RULES = (
    (re.compile(r"\r\n"), "\n"),
    (re.compile(r"\\+"), "/"),  # two of them in a repr
    (re.compile(r"\b[A-Za-z]:(?=/)"), ""),
    (re.compile(r"(?<=\w)\.exe\b"), ""),
    (re.compile(r"\b[Ll]ib/(python3\.\d+/)?site-packages\b"), "lib/site-packages"),
    (re.compile(r"\bScripts\b"), "bin"),
)
"""What Windows writes otherwise, and what stands for it in both texts that are compared."""


def alike(text: str) -> str:
    """A text in which the names of files are spelled as on Linux."""
    for pattern, instead in RULES:
        text = pattern.sub(instead, text)
    return text


def compare_alike() -> None:
    """Have nbval compare outputs so, where chapters run on Windows."""
    from nbval.plugin import IPyNbCell

    own = IPyNbCell.sanitize

    def sanitize(self: Any, text: Any) -> Any:
        made = own(self, text)
        return alike(made) if isinstance(made, str) else made

    IPyNbCell.sanitize = sanitize


__all__ = ["alike", "compare_alike"]
