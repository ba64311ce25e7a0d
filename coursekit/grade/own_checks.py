"""A teacher's own exercises: Python files in a folder `checks` beside the notebooks, for `release`, `check` and `grade`."""

from __future__ import annotations

import hashlib
import sys
import traceback
import types
from collections.abc import Iterable
from pathlib import Path

from . import chapters
from .exercise import Exercise

OWN = "checks"
"""The folder's name."""
_read: dict[Path, int] = {}
"""The files read, with their modification times."""


class BadChecks(Exception):
    """A file of checks cannot be read; the message gives position and reason."""

    def _render_traceback_(self) -> list[str]:
        """Return the text that IPython shows instead of a traceback."""
        return [str(self)]


def read_checks(folder: Path) -> None:
    """Load the exercises of the files in a folder, if it exists; a changed file is loaded again.

    Raises:
        BadChecks: when one of them cannot be run.
    """
    for file in sorted(folder.resolve().glob("*.py")):
        changed = file.stat().st_mtime_ns
        if _read.get(file) != changed:
            _run(file)
            _read[file] = changed


def fault_of(error: BaseException) -> str:
    """Describe an exception of a check, with the line of the check where it stopped."""
    frames = [frame for frame in traceback.extract_tb(error.__traceback__) if _is_check(frame.filename)]
    where = f" ({Path(frames[-1].filename).name}, line {frames[-1].lineno})" if frames else ""
    return f"{type(error).__name__}: {error}"[:300] + where


def is_own(filename: str) -> bool:
    """Whether a file is one of the loaded check files."""
    return Path(filename) in _read


def _is_check(filename: str) -> bool:
    return is_own(filename) or Path(filename).parent == Path(chapters.__path__[0])


def own_files(exercises: Iterable[Exercise]) -> list[Path]:
    """Return the check files of these exercises; empty for the course's own."""
    written = {Path(exercise.judge.__code__.co_filename) for exercise in exercises if hasattr(exercise.judge, "__code__")}
    return sorted(file for file in _read if file in written)


def digest_of_checks(exercises: Iterable[Exercise]) -> str:
    """Return a digest that changes with the check files of these exercises; empty if there are none."""
    digest, files = hashlib.sha256(), own_files(exercises)
    for file in files:
        digest.update(file.name.encode() + b"\0" + file.read_bytes())
    return digest.hexdigest() if files else ""


def _run(file: Path) -> None:
    module = types.ModuleType(f"coursekit_checks_{file.stem}")
    module.__file__ = str(file)
    sys.modules[module.__name__] = module  # required by dataclasses in the module
    try:
        exec(compile(file.read_text(encoding="utf-8"), str(file), "exec"), module.__dict__)
    except Exception as error:
        own = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == str(file)]
        line = own[-1] if own else getattr(error, "lineno", None)
        place = f"{file.name}:{line}" if line else file.name
        raise BadChecks(f"{OWN}/{place} cannot be run: {type(error).__name__}: {error}") from None


__all__ = ["OWN", "BadChecks", "digest_of_checks", "fault_of", "is_own", "own_files", "read_checks"]
