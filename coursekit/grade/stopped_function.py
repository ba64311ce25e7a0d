"""How a student's function stopped: the exception in a verdict's words, the student's line, the likely cause."""

from __future__ import annotations

import linecache
import os
import re
import sys
import traceback
from pathlib import Path

from .own_checks import is_own

_OURS = str(Path(__file__).resolve().parents[1]) + os.sep
_MADE = "<coursekit "
"""The prefix of the file names of generated message classes."""
_IMPORTED = {name: f"import {name}" for name in ("math", "random", "re", "os", "sys", "time", "json", "itertools", "numpy")}
_IMPORTED["np"] = "import numpy as np"
"""Modules that functions of exercises use, by the names that they have there."""


def why_it_stopped(error: Exception) -> str:
    """Return the likely cause of an exception in a student's function."""
    if isinstance(error, UnboundLocalError):
        return (
            "A function that assigns a name has a name of its own: it needs a value before this line in every case. "
            "To change one outside, change what is in it, or say `global`."
        )
    if isinstance(error, NameError):
        if error.name in _IMPORTED:
            return f"`{error.name}` is a module: this notebook has no `{_IMPORTED[error.name]}` yet."
        return "Is it spelled so? After a restart, the cells above that make it have to be run again."
    if isinstance(error, AttributeError) and (of := re.match(r"'\w+_(Request|Response)' .*'(\w+)'$", str(error))):
        filled_in = re.search(rf"\.{of[2]} *=(?!=)", error_of(error)) is not None
        if (of[1] == "Request") == filled_in:
            return "The request comes first, then the response: does the function take them in this order?"
        if filled_in:
            return "The response has no field of this name: `ros2 interface show TYPE` lists them, below the three dashes."
    if isinstance(error, AssertionError) and (of := re.match(r"The '(\w+)' field must be (?:of type '(\w+)')?", str(error))):
        if of[2]:
            return f"`{of[1]}` is a field of type {of[2]}, and takes exactly this type: the line gives it another one."
        return f"The field `{of[1]}` does not take this value: the error says what it takes."
    return "Your function stopped there."


def error_of(error: BaseException) -> str:
    """Format an exception for a verdict: its type, its message, and the student's own line, if it passed one."""
    try:
        said = f"{type(error).__name__}: {error}"[:300].removesuffix(": ")
    except Exception:
        said = type(error).__name__[:80]
    own = _frames(error)
    if not own or own[-1].lineno is None:
        return said
    where = own[-1]
    line = (where.line or linecache.getline(where.filename, where.lineno or 0)).strip()
    return f"{said} (line {where.lineno}{': ' + line[:100] if line else ''})"


def of_student(error: BaseException) -> bool:
    """Whether an exception passed through a student's code, not only through a check and installed code."""
    return bool(_frames(error))


def _frames(error: BaseException) -> list[traceback.FrameSummary]:
    """Return the student's lines in an exception's traceback."""
    frames = [frame for frame in traceback.extract_tb(error.__traceback__) if not frame.filename.startswith((_OURS, _MADE))]
    frames = [frame for frame in frames if "site-packages" not in frame.filename and not is_own(frame.filename)]
    return [frame for frame in frames if not frame.filename.startswith(sys.base_prefix)]
