"""Errors of the lab's functions: a student sees the line and the remedy, not coursekit's internals."""

from __future__ import annotations

import traceback
from pathlib import Path

from coursekit.words.gettext import gettext

_OURS = Path(__file__).parents[1]


class Plain(Exception):
    """Shown by notebooks in two lines: the call and its problem. A program gets an ordinary exception."""

    def _render_traceback_(self) -> list[str]:
        """Return the two lines that IPython shows instead of a traceback."""
        theirs = [frame for frame in traceback.extract_tb(self.__traceback__) if _OURS not in Path(frame.filename).parents]
        called = theirs[-1].line if theirs else ""
        said = gettext(str(self))
        return [f"{called}\n{said}" if called else said]


class BadArgument(Plain, ValueError):
    """An argument without a valid meaning."""


class NotThere(Plain, LookupError):
    """An object that does not exist, or does not exist yet."""


class NotNow(Plain, RuntimeError):
    """An operation that is impossible at the moment."""


class TooLate(Plain, TimeoutError):
    """An event that did not happen within its timeout."""


__all__ = ["BadArgument", "NotNow", "NotThere", "Plain", "TooLate"]
