"""A cell that the stop button interrupts shows the student's own lines, not those of the course below them."""

from __future__ import annotations

import traceback
from collections.abc import Iterator
from pathlib import Path
from types import TracebackType

import IPython
from IPython.core.interactiveshell import InteractiveShell

from coursekit.systems.library_files import is_library_file
from coursekit.words.gettext import gettext

_OURS = Path(__file__).parents[1]
_BESIDE_IPYTHON = Path(IPython.__file__).parents[1]
_LONGEST = 80
"""Maximum length of the line that is quoted."""


def install(shell: InteractiveShell) -> None:
    """Let the shell show a KeyboardInterrupt in this way."""
    shell.set_custom_exc((KeyboardInterrupt,), _show)


def _show(
    shell: InteractiveShell,
    kind: type[BaseException],
    error: BaseException,
    trace: TracebackType,
    tb_offset: int | None = None,
) -> None:
    """Show the interrupt; what is stored for %tb is the full traceback."""
    kind, error, trace = shell._get_exc_info((kind, error, trace))
    theirs = students_part(trace)
    if theirs is None:
        shell.showtraceback((kind, error, trace), running_compiled_code=True)
        return
    told = KeyboardInterrupt(_what(theirs))
    lines = shell.InteractiveTB.structured_traceback(KeyboardInterrupt, told, theirs, tb_offset=0)
    shell._showtraceback(KeyboardInterrupt, told, lines)


def students_part(trace: TracebackType | None) -> TracebackType | None:
    """Return the traceback with the student's lines only; None if the course or the student has no part in it."""
    entries = list(_entries(trace))
    if not any(_OURS in _file(entry).parents for entry in entries):
        return None
    kept: TracebackType | None = None
    for entry in reversed([entry for entry in entries if not _of_a_library(_file(entry))]):
        kept = TracebackType(kept, entry.tb_frame, entry.tb_lasti, entry.tb_lineno)
    return kept


def _entries(trace: TracebackType | None) -> Iterator[TracebackType]:
    while trace is not None:
        yield trace
        trace = trace.tb_next


def _file(entry: TracebackType) -> Path:
    return Path(entry.tb_frame.f_code.co_filename)


def _of_a_library(file: Path) -> bool:
    return str(file).startswith("<frozen") or is_library_file(str(file)) or _BESIDE_IPYTHON in file.parents


def _what(theirs: TracebackType) -> str:
    line = (traceback.extract_tb(theirs)[-1].line or "").strip()[:_LONGEST]
    return gettext(f"`{line}` was interrupted. To see all of the calls inside: %tb")


__all__ = ["install", "students_part"]
