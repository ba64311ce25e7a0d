"""Update the catalogues of a language from the English texts: `python -m coursekit.building.catalogues es`."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from coursekit.building.spoken import update_words
from coursekit.grade.catalogue import brought_up_to_date
from coursekit.grade.editions import catalogue_of, chapters, notebooks_folder, read


def update(notebooks: Path, language: str) -> list[str]:
    """Write the catalogue of every chapter; return a line for each with the number of untranslated entries."""
    said = []
    for chapter in chapters(notebooks):
        file = catalogue_of(chapter, language)
        catalogue = brought_up_to_date(read(chapter), file)
        file.parent.mkdir(exist_ok=True)
        catalogue.save(str(file))
        left = len(catalogue) - len(catalogue.translated_entries())
        said.append(f"{file.name}: {left} of {len(catalogue)} cells to translate")
    return said


def main(words: Sequence[str] | None = None) -> int:
    """Update the languages given; return 2 if there are none."""
    languages = list(sys.argv[1:] if words is None else words)
    if not languages:
        print("Name a language by its code: python -m coursekit.building.catalogues es", file=sys.stderr)
        return 2
    for language in languages:
        print(*update(notebooks_folder(), language), update_words(language), sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
