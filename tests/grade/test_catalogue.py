"""Catalogues: each text cell in another language, found by its English text; a changed one is read in English."""

import json
import re

import polib
import pytest

from coursekit.building.catalogues import main, update
from coursekit.grade.catalogue import UNTRANSLATED, brought_up_to_date, text_cells
from coursekit.grade.copy import Course
from coursekit.grade.editions import catalogue_of, chapters, languages, notebooks_folder, read

NOTEBOOKS = notebooks_folder()
TRANSLATED = [(chapter, language) for language in languages(NOTEBOOKS)[1:] for chapter in chapters(NOTEBOOKS)]
EACH = pytest.mark.parametrize(
    ("chapter", "language"), TRANSLATED, ids=[f"{language}-{chapter.stem}" for chapter, language in TRANSLATED]
)


def entries(chapter, language):
    return list(polib.pofile(str(catalogue_of(chapter, language)), wrapwidth=0))


@EACH
def test_a_catalogue_has_the_cells_of_its_chapter(chapter, language):
    catalogue = brought_up_to_date(read(chapter), catalogue_of(chapter, language))
    cure = f"run: python -m coursekit.building.catalogues {language}"
    assert [entry.msgid for entry in catalogue] == [entry.msgid for entry in entries(chapter, language)], cure


@EACH
def test_a_translation_keeps_code_headings_tables_and_formulas(chapter, language):
    for entry in entries(chapter, language):
        if entry.msgstr and not entry.fuzzy:
            assert kept_in(entry.msgstr) == kept_in(entry.msgid), entry.comment


def kept_in(text):
    """What no translation changes: blocks and words of code, the levels of headings, rows, formulas, lists' lengths."""
    code = re.findall(r"```.*?```", text, re.S)
    rest = re.sub(r"```.*?```", "", text, flags=re.S)
    flowing = re.sub(r"\s+", " ", rest)
    words = sorted(re.sub(r"\s+", " ", code_span) for code_span in re.findall(r"`[^`]+`", rest))
    return (
        code, words, re.findall(r"(?m)^#+(?= )", rest), re.findall(r"\$\$.*?\$\$", flowing),
        len(re.findall(r"(?m)^\|", rest)), len(re.findall(r"(?m)^\* ", rest)),
    )  # fmt: skip


def test_spanish_is_whole():
    left = [(chapter.stem, entry.comment) for chapter in chapters(NOTEBOOKS) for entry in entries(chapter, "es")
            if not entry.translated()]  # fmt: skip
    assert left == []


def test_a_course_in_spanish_has_the_same_code_and_exercises(tmp_path):
    Course(tmp_path / "en").update(NOTEBOOKS)
    Course(tmp_path / "es").update(NOTEBOOKS, "es")
    for file in sorted((tmp_path / "en").glob("*.ipynb")):
        english, spanish = (json.loads((tmp_path / language / file.name).read_text())["cells"] for language in ("en", "es"))
        assert [cell["metadata"] for cell in english] == [cell["metadata"] for cell in spanish]
        both = list(zip(english, spanish, strict=True))
        assert [cell["source"] for cell in english if cell["cell_type"] == "code"] == [
            other["source"] for other in spanish if other["cell_type"] == "code"
        ], file.name
        assert sum(one["source"] == other["source"] for one, other in both if one["cell_type"] == "markdown") <= 1, file.name


@pytest.fixture
def notebooks(tmp_path):
    """A chapter of three text cells, of which the first is translated."""
    cells = [
        {"cell_type": "markdown", "id": f"c{n}", "metadata": {}, "source": [text]}
        for n, text in enumerate(("One", "Two", " "))
    ]
    notebook = {"cells": cells, "metadata": {}, "nbformat": 4, "nbformat_minor": 5}
    (tmp_path / "01_a.ipynb").write_text(json.dumps(notebook))
    assert update(tmp_path, "es") == ["01_a.po: 2 of 2 cells to translate"]
    file = polib.pofile(str(tmp_path / "es/01_a.po"))
    file.metadata[UNTRANSLATED] = "sin traducir"
    file[0].msgstr = "Uno"
    file.save()
    return tmp_path


def texts(notebook):
    return ["".join(cell["source"]) for cell in text_cells(notebook)]


def change(notebooks, old, new):
    file = notebooks / "01_a.ipynb"
    file.write_text(file.read_text().replace(f'"{old}"', f'"{new}"'))


def test_what_is_not_translated_is_read_in_english_with_a_line_that_says_so(notebooks):
    assert texts(read(notebooks / "01_a.ipynb", "es")) == ["Uno", "*sin traducir*\n\nTwo"]
    assert texts(read(notebooks / "01_a.ipynb")) == ["One", "Two"]


def test_a_cell_that_changed_is_untranslated_until_somebody_has_looked_at_it(notebooks):
    change(notebooks, "One", "One and a half")
    assert texts(read(notebooks / "01_a.ipynb", "es"))[0] == "*sin traducir*\n\nOne and a half"
    assert update(notebooks, "es") == ["01_a.po: 2 of 2 cells to translate"]
    first = polib.pofile(str(notebooks / "es/01_a.po"))[0]
    assert (first.msgstr, first.previous_msgid, first.fuzzy) == ("Uno", "One", True)
    assert texts(read(notebooks / "01_a.ipynb", "es"))[0] == "*sin traducir*\n\nOne and a half"
    change(notebooks, "One and a half", "One")
    assert update(notebooks, "es") == ["01_a.po: 2 of 2 cells to translate"]


def test_cells_may_move_and_a_catalogue_may_be_broken(notebooks):
    data = json.loads((notebooks / "01_a.ipynb").read_text())
    data["cells"].reverse()
    (notebooks / "01_a.ipynb").write_text(json.dumps(data))
    assert update(notebooks, "es") == ["01_a.po: 1 of 2 cells to translate"]
    assert texts(read(notebooks / "01_a.ipynb", "es")) == ["*sin traducir*\n\nTwo", "Uno"]
    (notebooks / "es/01_a.po").write_text('msgid "One"\nUno')
    with pytest.raises(ValueError, match="01_a.po is no catalogue"):
        read(notebooks / "01_a.ipynb", "es")


def test_the_command_wants_a_language(capsys):
    assert main([]) == 2
    assert "coursekit.building.catalogues es" in capsys.readouterr().err
