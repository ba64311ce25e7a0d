"""Translation catalogues: for each chapter a gettext file with its text cells, `notebooks/es/02_topics.po`.

A cell is identified by its whole English text. A cell that changes in English is therefore untranslated until it is
reviewed; students read it in English, with a line that says so.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import polib

UNTRANSLATED = "X-Untranslated"
"""The catalogue header with the line above untranslated cells, in the catalogue's language."""


def translated(notebook: dict[str, Any], catalogue: Path) -> dict[str, Any]:
    """Return the notebook with its text cells in the catalogue's language. ValueError for an invalid catalogue."""
    read = _read(catalogue)
    words = {entry.msgid: entry.msgstr for entry in read.translated_entries()}
    warning = read.metadata.get(UNTRANSLATED, "")
    translated: dict[str, Any] = json.loads(json.dumps(notebook))
    for cell in text_cells(translated):
        text = "".join(cell["source"])
        other = words.get(text) or (f"*{warning}*\n\n{text}" if warning else text)
        cell["source"] = other.splitlines(keepends=True)
    return translated


def text_cells(notebook: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the cells to translate: texts that are not empty."""
    return [cell for cell in notebook["cells"] if cell["cell_type"] == "markdown" and "".join(cell["source"]).strip()]


def brought_up_to_date(notebook: dict[str, Any], catalogue: Path) -> polib.POFile:
    """Update the catalogue to the notebook's cells in their order: new ones untranslated, changed ones marked fuzzy.

    A changed cell is found by its name. Entries without a cell are dropped.
    """
    old = _read(catalogue) if catalogue.exists() else polib.POFile(wrapwidth=0)
    by_text, by_name = {entry.msgid: entry for entry in old}, {entry.comment: entry for entry in old}
    new = polib.POFile(wrapwidth=0)
    new.metadata = old.metadata or {"Content-Type": "text/plain; charset=utf-8", "Content-Transfer-Encoding": "8bit"}
    seen: set[str] = set()
    for cell in text_cells(notebook):
        text, name = "".join(cell["source"]), f"cell {cell['id']}"
        if text in seen:
            continue
        seen.add(text)
        new.append(_entry(text, name, by_text.get(text), by_name.get(name)))
    return new


def _entry(text: str, name: str, same: polib.POEntry | None, before: polib.POEntry | None) -> polib.POEntry:
    if same is not None:
        same.comment = name
        return same
    if before is not None and before.msgstr:
        return polib.POEntry(msgid=text, msgstr=before.msgstr, comment=name, flags=["fuzzy"], previous_msgid=before.msgid)
    return polib.POEntry(msgid=text, msgstr="", comment=name)


def _read(catalogue: Path) -> polib.POFile:
    try:
        return polib.pofile(str(catalogue), encoding="utf-8", wrapwidth=0)
    except (OSError, UnicodeDecodeError) as error:
        raise ValueError(f"{catalogue} is no catalogue: {error}") from None


__all__ = ["brought_up_to_date", "text_cells", "translated"]
