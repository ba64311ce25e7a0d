"""What the cells run before a check explain: the answer's cell failed, or its function has another name there."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import Any

from coursekit.suggestions import similar

from .verdict import CheckFailed, Verdict

_DEFINED = re.compile(r"^(?:async )?def (\w+)", re.MULTILINE)
_SET = re.compile(r"^(\w+)(?:: *\w+)? *=(?!=)", re.MULTILINE)
_ALIKE = 0.8
"""The minimum similarity of a misspelt name: `full_nam` has 0.94 of `full_name`, another name of three words has less."""


def explained(verdict: Verdict, asked: Collection[str], shell: Any) -> Verdict:
    """Return the verdict with such an explanation as its likely cause; `asked` are the names that the judge looked for."""
    if verdict.passed or verdict.fault or shell is None:
        return verdict
    before = shell.last_execution_result
    cause = _failed(before, asked) if before else ""
    cause = cause or (_set_under_another_name(before, asked) if before else "")
    cause = cause or _misspelt(shell.user_ns.get("In", ()), asked)
    return replace(verdict, cause=cause, hint="") if cause else verdict


def _failed(before: Any, asked: Collection[str]) -> str:
    """Return what to say if the cell before the check failed and has to do with the exercise."""
    fault = _fault(before.error_before_exec or before.error_in_exec)
    if not fault or not _is_about(before, asked):
        return ""
    return f"The cell before this check stopped with {fault}. What was judged is older: mend that cell and run it."


def _fault(error: BaseException | None) -> str:
    """Return the text of an error; empty if there is none, or the cell was a check."""
    if not isinstance(error, Exception) or isinstance(error, CheckFailed):
        return ""
    if hasattr(error, "_render_traceback_"):  # the cell showed its words, without the name of its class
        return f'"{str(error)[:200]}"'
    line = f" in its line {error.lineno}" if isinstance(error, SyntaxError) and error.lineno else ""
    said = f"{type(error).__name__}: {error.msg if isinstance(error, SyntaxError) else error}"
    return said[:200].removesuffix(": ") + line  # a stub's error has no text


def _is_about(before: Any, asked: Collection[str]) -> bool:
    """Whether a failed cell mentions what the judge looked for; a stub is always part of an exercise."""
    if not asked or isinstance(before.error_in_exec, NotImplementedError):
        return True
    words = set(re.findall(r"\w+", before.info.raw_cell or ""))
    return not words.isdisjoint(asked)


def _set_under_another_name(before: Any, asked: Collection[str]) -> str:
    """Return what to say if the cell before the check set a variable with a name like the one that is judged."""
    if before.error_before_exec or before.error_in_exec:
        return ""
    there = _SET.findall(before.info.raw_cell or "")
    names = {name.lower(): name for name in there}
    for name in asked:
        if name not in there and (alike := similar(name.lower(), names, cutoff=_ALIKE)):
            slip = f"The cell before this check sets `{names[alike[0]]}`, and `{name}` is judged, which is older."
            return f"{slip} Is the name a slip?"
    return ""


def _misspelt(cells: Sequence[str], asked: Collection[str]) -> str:
    """Return what to say if a function was last defined under a name like the one that the judge looked for."""
    for name in asked:
        last = max((place for place, cell in enumerate(cells) if name in _DEFINED.findall(cell)), default=None)
        if last is None:
            continue
        older = set(_DEFINED.findall("\n".join(cells[: last + 1])))
        newer = set(_DEFINED.findall("\n".join(cells[last + 1 :]))) - older
        if alike := similar(name, newer, cutoff=_ALIKE):
            slip = f"A newer cell defines `{alike[0]}`. What was judged is `{name}`, which is older. Is the name a slip?"
            return f"{slip} Mend it in that cell and run it."
    return ""


__all__ = ["explained"]
