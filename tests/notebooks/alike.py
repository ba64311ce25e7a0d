r"""Outputs of a chapter, compared as every system and every processor writes them; students see their own.

>>> alike("~\\ros2_ws\\src\\talker.exe\r\n")
'~/ros2_ws/src/talker\n'
>>> Output("x: 0.14222430938558392") == Output("x: 0.1422243093855839")
True
"""

from __future__ import annotations

import math
import re
from typing import Any

from coursekit.interfaces.find import UNDERLAY

_UNDERLAY = re.sub(r"^[A-Za-z]:", "", UNDERLAY.as_posix())
RULES = (
    (re.compile(r"\r\n"), "\n"),
    (re.compile(r"\\+"), "/"),  # two of them in a repr
    (re.compile(r"\b[A-Za-z]:(?=/)"), ""),
    (re.compile(r"(?<=\w)\.exe\b"), ""),
    (re.compile(r"\b[Ll]ib/(python3\.\d+/)?site-packages\b"), "lib/site-packages"),
    (re.compile(r"\bScripts\b"), "bin"),
    (re.compile(re.escape(_UNDERLAY)), "<underlay>"),  # chapters replace it themselves, but not in the repr of a path
    (re.compile(r"(?<=no file )/\w+(/[\w.]+)/(?!\w)"), r"\1"),  # file://HOST/NAME is a folder of another computer there
)
"""What Windows writes otherwise, and what stands for it in both texts that are compared."""


def alike(text: str) -> str:
    """A text in which the names of files are spelled as on Linux."""
    for pattern, instead in RULES:
        text = pattern.sub(instead, text)
    return text


PICTURE = re.compile(r'<figure class="ck-drawn">.*?</figure>', re.S)
"""Beside a verdict: its lines end at pixels that another processor rounds otherwise. tests/grade tests what it shows."""

NUMBER = re.compile(r"(-?\d+\.\d+(?:e[-+]\d+)?)")


class Output(str):
    """A text that equals another one if they differ by the rounding of long numbers only.

    Linear algebra adds in another order on another processor, which shows from the fifteenth digit on.
    """

    __hash__ = str.__hash__

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Output):
            return NotImplemented
        own, theirs = NUMBER.split(self), NUMBER.split(other)  # every second piece is a number
        return own[::2] == theirs[::2] and all(map(_rounded_alike, own[1::2], theirs[1::2]))

    def __ne__(self, other: object) -> bool:
        return not self == other


def _rounded_alike(one: str, other: str) -> bool:
    if one == other:
        return True
    return max(map(_digits, (one, other))) >= 15 and math.isclose(float(one), float(other), rel_tol=1e-12, abs_tol=1e-15)


def _digits(number: str) -> int:
    return len(re.sub(r"e.*|[-.]", "", number).lstrip("0"))


def compare_alike(on_windows: bool) -> None:
    """Have nbval compare outputs so; names of files as on Linux, where chapters run `on_windows`."""
    from nbval.plugin import IPyNbCell

    own = IPyNbCell.sanitize

    def sanitize(self: Any, text: Any) -> Any:
        sanitized = own(self, text)
        if not isinstance(sanitized, str):
            return sanitized
        without_pictures = PICTURE.sub("", sanitized)
        return Output(alike(without_pictures) if on_windows else without_pictures)

    IPyNbCell.sanitize = sanitize


__all__ = ["Output", "alike", "compare_alike"]
