"""The parts of files that cells wrote, stored across restarts: a cell that runs again replaces its own part."""

from __future__ import annotations

import contextlib
import errno
import json
import os
from pathlib import Path
from typing import Any

from coursekit.words.gettext import gettext

from .cells import run_number, this_cell
from .errors import NotNow, NotThere
from .text_edits import appended, edited, undone


class WrittenParts:
    """The parts of one file of the workspace that cells wrote.

    `pieces` are [cell, text] of `%%write`; `edits` are [cell, number, old, new], the newest last.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._file = Path(os.environ.get("COURSEKIT_COURSE", ".")) / ".coursekit" / "written.json"
        self._all = self._read()
        mine = self._all.setdefault(str(path), {})
        self.pieces: list[list[str]] = mine.setdefault("pieces", [])
        self.edits: list[list[Any]] = mine.setdefault("edits", [])

    def forget(self) -> None:
        """Forget the parts of all files below this path, which was moved away: files made there later are new."""
        gone = [file for file in self._all if Path(file).is_relative_to(self.path)]
        for file in gone:
            del self._all[file]
        if self._file.exists():
            _write(self._file, json.dumps(self._all, indent=1))

    def _read(self) -> dict[str, dict[str, Any]]:
        with contextlib.suppress(OSError, ValueError, TypeError):
            stored = json.loads(self._file.read_text(encoding="utf-8"))
            return {str(path): dict(parts) for path, parts in stored.items()}
        return {}

    def write(self, text: str) -> str:
        """Write this text of the running cell to the file, followed by later additions of other cells if this cell wrote
        it before.
        """
        cell = this_cell()
        mine = bool(cell and self.pieces and self.pieces[0][0] == cell and self.path.exists())
        self.pieces[:] = [[cell, text], *(self.pieces[1:] if mine else [])]
        self.edits.clear()
        return self._finish("".join(text for _, text in self.pieces))

    def append(self, text: str) -> str:
        """Append this text to the file; it replaces the running cell's former text."""
        cell = this_cell()
        former = next((piece for piece in self.pieces if cell and piece[0] == cell), None)
        there = self.path.read_text(encoding="utf-8") if self.path.exists() else ""
        whole = appended(there, text, former[1] if former else None)
        if former:
            former[1] = text
        elif all(known != text for _, known in self.pieces):
            self.pieces.append([cell, text])
        return self._finish(whole)

    def edit(self, old: str, new: str) -> bool:
        """Make an edit. Returns False if it was made before and the file has changed since. NotThere: it cannot be
        made.
        """
        text = self.path.read_text(encoding="utf-8")
        place = [this_cell(), run_number(f"{self.path} {old}"), old]
        former = next((change for change in self.edits if place[0] and change[:3] == place), None)
        if former and former[3] != new:
            text = undone(text, old, former[3])
        changed = edited(text, old, new)
        if changed is None and not any(change[2:] == [old, new] for change in self.edits):
            missing = gettext(f"{self.path.name} does not contain {old!r}.")
            raise NotThere(f"{missing} Were the cells above run? Print it with: %show {self._shown()}")
        if former:
            self.edits.remove(former)
        self.edits.append([*place, new])
        self._finish(text if changed is None else changed)
        return changed is not None

    def _shown(self) -> str:
        workspace = Path(os.environ.get("COURSEKIT_WORKSPACE", "ros2_ws")).resolve()
        return self.path.relative_to(workspace).as_posix() if self.path.is_relative_to(workspace) else str(self.path)

    def _finish(self, text: str) -> str:
        """Write the file unless it has that text already: an unchanged file needs no new build."""
        try:
            if not self.path.exists() or self.path.read_text(encoding="utf-8") != text:
                self.path.parent.mkdir(parents=True, exist_ok=True)
                _write(self.path, text)
            self._file.parent.mkdir(parents=True, exist_ok=True)
            _write(self._file, json.dumps(self._all, indent=1))
        except OSError as error:
            raise NotNow(f"'{self.path}' was not written: {error.strerror}. {_cure(error)}") from None
        return text


def _cure(error: OSError) -> str:
    if error.errno in (errno.ENOSPC, errno.EDQUOT):
        return gettext(
            "The file is as it was. Make room (build/ and log/ of a workspace can be deleted), then run the cell again."
        )
    return gettext(
        "Is the folder yours to write in? `coursekit lab --folder ~/course` makes a copy of the course elsewhere."
    )


def _write(path: Path, text: str) -> None:
    """Write atomically: a full disk leaves the file as it was."""
    path = path.resolve()  # a link stays a link
    fresh = path.with_name(f".{path.name}.new")
    try:
        fresh.write_text(text, encoding="utf-8")
        if path.exists():
            fresh.chmod(path.stat().st_mode)
        fresh.replace(path)
    except OSError:
        fresh.unlink(missing_ok=True)
        raise


__all__ = ["WrittenParts"]
