"""The course's notebooks, in English and in the languages that somebody has translated them into.

A translated chapter has the name of the English one and lies in a folder with the language's code: `es/02_topics.ipynb`.
"""

from __future__ import annotations

from pathlib import Path

ENGLISH = "en"


def notebooks_folder() -> Path:
    """Where the chapters are: beside the package in a checkout, inside it in an installed wheel."""
    package = Path(__file__).resolve().parents[1]
    for candidate in (package.parent / "notebooks", package / "notebooks"):
        if candidate.is_dir():
            return candidate
    raise SystemExit("The chapters are not here. Reinstall with: pip install --force-reinstall coursekit")


def languages(notebooks: Path) -> list[str]:
    """The languages that there is at least one chapter in."""
    return [ENGLISH, *sorted(path.name for path in notebooks.iterdir() if _is_language(path) and any(path.glob("*.ipynb")))]


def _is_language(folder: Path) -> bool:
    """`es` or `pt_BR` is one; `teacher` holds what students do not get."""
    return len(folder.name.partition("_")[0]) in (2, 3)


def chapters(notebooks: Path, language: str = ENGLISH) -> list[Path]:
    """The file of every chapter: in that language where it is translated, else in English.

    Raises:
        ValueError: when there is no chapter in that language; it names those that there are.
    """
    known = languages(notebooks)
    if language not in known:
        raise ValueError(f"No chapter is translated into '{language}'. There are: {', '.join(known)}.")
    found = sorted(notebooks.glob("*.ipynb"))
    if language == ENGLISH:
        return found
    return [other if (other := notebooks / language / one.name).exists() else one for one in found]
