"""Errors of the lab's functions: a student sees the line and the cure, not the inside of coursekit."""

from __future__ import annotations

import traceback
from pathlib import Path

from coursekit.words.gettext import gettext

_OURS = Path(__file__).parents[1]


class Plain(Exception):
    """Shown in two lines by notebooks, the call and what is wrong with it; a program gets an exception like any other."""

    def _render_traceback_(self) -> list[str]:
        """IPython shows this instead of a traceback."""
        theirs = [one for one in traceback.extract_tb(self.__traceback__) if _OURS not in Path(one.filename).parents]
        called = theirs[-1].line if theirs else ""
        said = gettext(str(self))
        return [f"{called}\n{said}" if called else said]


class BadArgument(Plain, ValueError):
    """An argument that cannot be meant."""


class NotThere(Plain, LookupError):
    """A thing that does not exist, or not yet."""


class NotNow(Plain, RuntimeError):
    """It cannot be done in this moment."""


class TooLate(Plain, TimeoutError):
    """It did not happen in its time."""


__all__ = ["BadArgument", "NotNow", "NotThere", "Plain", "TooLate"]
