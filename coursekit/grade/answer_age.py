"""Whether a name is from the newest run of the cell that set it.

A run that failed, or that no longer sets the name, leaves the older value behind in the kernel. A clean run would not have
it, so a check must not take it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from .verdict import CheckFailed

_COMMENT = re.compile(r"#.*")
_of_kernel: dict[str, AnswerAge] = {}
"""The one of this kernel, under the key 'age'; empty outside of a kernel."""


class AnswerAge:
    """Follows the cells of a kernel: which of them set each name, and in which of its runs."""

    def __init__(self) -> None:
        self._set_by: dict[str, tuple[str, int]] = {}
        """By name: the cell, and the number of its run."""
        self._runs: dict[str, int] = {}
        self._faults: dict[str, str] = {}
        """By cell: the fault of its last run."""
        self._running = ""
        self._before: dict[str, int] = {}
        """The identity of each variable's value before the running cell."""

    def begin(self, cell: str, variables: Mapping[str, Any]) -> None:
        """A cell begins to run."""
        self._running = cell
        self._before = {name: id(value) for name, value in list(variables.items())}

    def end(self, text: str, fault: str, variables: Mapping[str, Any]) -> None:
        """The cell with this text has run; `fault` is empty if nothing stopped it.

        A value that is the same as before may have been set again, as numbers are: then the text names it.
        """
        cell, self._running = self._running, ""
        if not cell:
            return
        self._runs[cell] = run = self._runs.get(cell, 0) + 1
        self._faults[cell] = fault
        named = set() if fault else set(re.findall(r"\w+", _COMMENT.sub("", text)))
        for name in self._set_by.keys() - variables.keys():
            del self._set_by[name]
        for name, value in list(variables.items()):
            is_again = name in named and self._set_by.get(name, ("",))[0] == cell
            if is_again or self._before.get(name) != id(value):
                self._set_by[name] = cell, run

    def told(self, name: str) -> str:
        """Return why a name is older than the newest run of its cell; empty if it is not, or if that is unknown."""
        cell, run = self._set_by.get(name, ("", 0))
        if cell == self._running or self._runs.get(cell, 0) == run:
            return ""
        if fault := self._faults[cell]:
            return f"The cell that sets `{name}` stopped with {fault}. What was judged is older: mend that cell and run it."
        return f"The cell that had set `{name}` does not set it any more, and what was judged is older. Is the name right?"


def install(shell: Any) -> None:
    """Follow the cells of a kernel from now on."""
    age = _of_kernel["age"] = AnswerAge()

    def begin(info: Any) -> None:
        age.begin(getattr(info, "cell_id", None) or "", shell.user_ns)

    def end(result: Any) -> None:
        age.end(result.info.raw_cell or "", fault_of(result), shell.user_ns)

    shell.events.register("pre_run_cell", begin)
    shell.events.register("post_run_cell", end)


def fault_of(result: Any) -> str:
    """Return what stopped a cell; empty if nothing did, or if its check was not solved."""
    error = result.error_before_exec or result.error_in_exec
    if error is None or isinstance(error, CheckFailed):
        return ""
    if hasattr(error, "_render_traceback_"):  # the cell showed its words, without the name of its class
        return f'"{str(error)[:200]}"'
    line = f" in its line {error.lineno}" if isinstance(error, SyntaxError) and error.lineno else ""
    said = f"{type(error).__name__}: {error.msg if isinstance(error, SyntaxError) else error}"
    return said[:200].removesuffix(": ") + line  # a stub's error has no text


def older(names: Iterable[str]) -> str:
    """Return why one of these names is older than its cell's newest run; empty if that is known of none."""
    age = _of_kernel.get("age")
    return next((told for name in names if age is not None and (told := age.told(name))), "")


__all__ = ["AnswerAge", "fault_of", "install", "older"]
