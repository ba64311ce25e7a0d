"""The course's notebooks, in English and in their translations.

A language has a folder named by its code. For each translated chapter it holds a catalogue, `es/02_topics.po`, or a
notebook with the English name.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from coursekit.words.gettext import ENGLISH

IMAGES = "images"
"""The folder beside the chapters with the pictures of their texts, for all languages."""
_SHOWN = re.compile(rf"!\[[^\]]*\]\({IMAGES}/([\w.-]+)\)")


def notebooks_folder() -> Path:
    """Return the folder of the chapters: beside the package in a checkout, inside it in an installed wheel."""
    package = Path(__file__).resolve().parents[1]
    for candidate in (package.parent / "notebooks", package / "notebooks"):
        if candidate.is_dir():
            return candidate
    raise SystemExit("The chapters are not here. Reinstall with: pip install --force-reinstall coursekit")


def languages(notebooks: Path) -> list[str]:
    """Return the languages with at least one chapter."""
    return [ENGLISH, *sorted(path.name for path in notebooks.iterdir() if _is_language(path) and any(_chapters_in(path)))]


def _chapters_in(folder: Path) -> list[Path]:
    return [*folder.glob("*.ipynb"), *folder.glob("*.po")]


def _is_language(folder: Path) -> bool:
    """Whether a folder is a language such as `es` or `pt_BR`; `teacher` holds files that students do not get."""
    return len(folder.name.partition("_")[0]) in (2, 3)


def chapters(notebooks: Path, language: str = ENGLISH) -> list[Path]:
    """Return every chapter's file: the notebook in that language, else the English one (see `read`).

    Raises:
        ValueError: when there is no chapter in that language; the message lists the available languages.
    """
    known = languages(notebooks)
    if language not in known:
        raise ValueError(f"No chapter is translated into '{language}'. There are: {', '.join(known)}.")
    paths = sorted(notebooks.glob("*.ipynb"))
    if language == ENGLISH:
        return paths
    return [other if (other := notebooks / language / file.name).exists() else file for file in paths]


def read(chapter: Path, language: str = ENGLISH) -> dict[str, Any]:
    """Return a chapter's notebook, translated if it has a catalogue in that language. ValueError for broken files."""
    notebook: dict[str, Any] = json.loads(chapter.read_text(encoding="utf-8"))
    catalogue = catalogue_of(chapter, language)
    if not catalogue.exists():
        return notebook
    from .catalogue import translated  # not at the top: wheels are built with the standard library alone

    return translated(notebook, catalogue)


def pictures_of(notebook: Mapping[str, Any], folder: Path) -> list[Path]:
    """Return the picture files in a notebook's texts, beside it or, for a translation, one folder up."""
    texts = ("".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "markdown")
    names = sorted({name for text in texts for name in _SHOWN.findall(text)})
    return [file for name in names if (file := _first_file(folder / IMAGES / name, folder.parent / IMAGES / name))]


def _first_file(*files: Path) -> Path | None:
    return next((file for file in files if file.is_file()), None)


def catalogue_of(chapter: Path, language: str) -> Path:
    """Return the path of an English chapter's catalogue, which may not exist.

    >>> catalogue_of(Path("notebooks/02_topics.ipynb"), "es").as_posix()
    'notebooks/es/02_topics.po'
    """
    return chapter.parent / language / f"{chapter.stem}.po"
