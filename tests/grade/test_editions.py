"""Chapters in other languages."""

import json

import pytest

from coursekit.cli.coursekit import main
from coursekit.grade.copy import Course
from coursekit.grade.editions import chapters, languages


@pytest.fixture
def notebooks(tmp_path):
    """Two chapters, of which the first is translated."""
    folder = tmp_path / "notebooks"
    for name, text in (("01_a.ipynb", "Hello"), ("02_b.ipynb", "Bye"), ("es/01_a.ipynb", "Hola")):
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        cell = {"cell_type": "markdown", "metadata": {}, "source": [text]}
        path.write_text(json.dumps({"cells": [cell], "metadata": {}, "nbformat": 4, "nbformat_minor": 5}))
    return folder


def texts(folder):
    return ["".join(json.loads(path.read_text())["cells"][0]["source"]) for path in sorted(folder.glob("*.ipynb"))]


def test_a_translated_chapter_stands_for_the_english_one(notebooks, tmp_path):
    assert languages(notebooks) == ["en", "es"]
    assert [path.parent.name for path in chapters(notebooks, "es")] == ["es", "notebooks"]
    Course(tmp_path / "course").update(notebooks, "es")
    assert texts(tmp_path / "course") == ["Hola", "Bye"]
    Course(tmp_path / "english").update(notebooks)
    assert texts(tmp_path / "english") == ["Hello", "Bye"]


def test_pictures_of_the_texts_go_with_the_chapters_and_are_kept_up_to_date(notebooks, tmp_path):
    for content in ("<svg/>", "<svg><title>new</title></svg>"):
        (notebooks / "images").mkdir(exist_ok=True)
        (notebooks / "images" / "node.svg").write_text(content)
        Course(tmp_path / "course").update(notebooks)
        assert (tmp_path / "course" / "images" / "node.svg").read_text() == content
    assert languages(notebooks) == ["en", "es"]


def test_a_language_that_is_not_there_is_said_with_those_that_are(notebooks, tmp_path):
    with pytest.raises(ValueError, match="'fr'. There are: en, es."):
        chapters(notebooks, "fr")
    with pytest.raises(SystemExit, match="There are: en"):
        main(["course", "--language", "fr", "--folder", str(tmp_path / "course")])


def test_a_release_takes_a_language(notebooks, tmp_path):
    out = tmp_path / "week1"
    assert main(["release", "01", "--language", "es", "--notebooks", str(notebooks), "--out", str(out)]) == 0
    assert texts(out) == ["Hola"]
    page = (out / "page.html").read_text(encoding="utf-8")
    assert "Descarga <b>week1.zip</b>" in page and "<th>Puntos</th>" in page and "Download" not in page


def test_a_released_folder_speaks_its_language_until_the_student_wants_another(notebooks, tmp_path):
    for out, language in (("week1", "es"), ("week2", "en")):
        main(["release", "01", "--language", language, "--notebooks", str(notebooks), "--out", str(tmp_path / out)])
        course = Course(tmp_path / out)
        course.update(notebooks)
        assert course.language() == language
    course = Course(tmp_path / "week1")
    course.update(notebooks, "en")
    assert course.language() == "en" and texts(tmp_path / "week1") == ["Hola"]


def test_a_notebook_with_odd_metadata_is_english(notebooks, tmp_path):
    (tmp_path / "own").mkdir()
    for number, odd in enumerate(({"coursekit": []}, {"coursekit": {"language": ""}}, [], None)):
        (tmp_path / "own" / f"{number}.ipynb").write_text(json.dumps({"cells": [], "metadata": odd}))
    (tmp_path / "own" / "none.ipynb").write_bytes(b"\xff")
    assert Course(tmp_path / "own").language() == "en"


def test_the_teacher_s_notebook_is_no_language_and_never_handed_out(notebooks, tmp_path):
    (notebooks / "teacher").mkdir()
    (notebooks / "teacher" / "teacher.ipynb").write_text((notebooks / "01_a.ipynb").read_text())
    assert languages(notebooks) == ["en", "es"]
    Course(tmp_path / "course").update(notebooks)
    assert not list((tmp_path / "course").rglob("teacher*"))
