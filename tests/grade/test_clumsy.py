"""Clumsy ways of handing in: names that browsers and clouds make, encodings of other editors, folders one too high."""

import json
import os
import warnings
import zipfile
from io import BytesIO

import pytest

from tests.needs import posix

from .handed import (
    NOON,
    SERVICES,
    TOPICS,
    answer,
    cheap_mark,
    grade,
    notebook,
    text,
    write,
    zipped,
)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A class in which Ann did everything right."""
    monkeypatch.setattr("coursekit.grade.batch.mark", cheap_mark)
    monkeypatch.setattr("coursekit.grade.sandbox.tier", lambda: "bubblewrap")
    write(tmp_path / "class" / "Ann Lee" / TOPICS, text("q1", "q2", "q3", "q4"))
    return tmp_path / "class"


def with_windows_lines(*done):
    nb = notebook(*done)
    for cell in nb["cells"]:
        cell["source"] = "".join(cell["source"]).replace("\n", "\r\n")
    return json.dumps(nb, indent=1).replace("\n", "\r\n")


def without_names(*done):
    """As copied cell by cell into a new notebook."""
    nb = notebook(*done)
    for cell in nb["cells"]:
        cell["metadata"] = {}
    return json.dumps(nb)


def of_another_kernel():
    nb = notebook("q1")
    nb["metadata"] |= {"kernelspec": {"name": "julia-1.9", "language": "julia"}, "language_info": {"name": "julia"}}
    for cell in nb["cells"]:
        cell["id"] = "the-same"
    return json.dumps(nb)


def twice_said(text):
    """A key twice, as merges by hand leave it: the last one counts, as it does in the lab."""
    return '{"cells": [], "metadata": 3, ' + text.lstrip()[1:]


READ = {
    "UTF-16 of Notepad": ("02_topics.ipynb", text("q1").encode("utf-16")),
    "UTF-16 without a mark": ("02_topics.ipynb", text("q1").encode("utf-16-le")),
    "lines of Windows": ("02_topics.ipynb", with_windows_lines("q1")),
    "another kernel and doubled ids": ("02_topics.ipynb", of_another_kernel()),
    "a doubled key": ("02_topics.ipynb", twice_said(text("q1"))),
    "cells without names": ("new notebook.ipynb", without_names("q1")),
    "what Safari adds": ("02_topics.ipynb.txt", text("q1")),
    "what Chrome adds": ("02_topics.json", text("q1")),
    "a text": ("my work.txt", text("q1")),
    "no ending": ("Untitled", text("q1")),
    "a backup of Emacs": ("02_topics.ipynb~", text("q1")),
    "an unfinished download": ("02_topics.ipynb.crdownload", text("q1")),
    "a notebook called zip": ("02_topics.zip", text("q1")),
    "a zip called notebook": ("02_topics.ipynb", zipped({TOPICS: text("q1")})),
    "a zip in a zip": ("work.zip", zipped({"inner.zip": zipped({TOPICS: text("q1")})})),
    "in the workspace": ("ros2_ws/02_topics.ipynb", text("q1")),
    "a copy by OneDrive": ("02_topics-LAPTOP-ABC.ipynb", text("q1")),
    "a copy by Windows": ("Copia de 02_topics - Kopie (3).IPYNB", text("q1")),
}


@pytest.mark.parametrize("what", READ)
def test_work_counts_however_it_was_saved(folder, what):
    name, content = READ[what]
    write(folder / "Ben Ito" / name, content)
    row = grade(folder)[1]["Ben Ito"]
    assert (row["status"], row["total"], row["ch02.q1"]) == ("graded", "1", "1"), row["notes"]


UNREAD = {
    "a link to Drive": (TOPICS, '{"url": "https://a.example/1", "doc_id": "1"}', "only a link to a file in Google Drive"),
    "both sides of a merge": (TOPICS, text("q1").replace('\n "cells"', '\n<<<<<<< HEAD\n "cells"'), "a conflict of git's"),
    "packed by gzip": ("02_topics.ipynb.gz", b"\x1f\x8b\x08\0\0abc", "it is not text in UTF-8"),
    "Latin letters of Windows": (TOPICS, b'{"cells": [], "a": "\xe9"}', "it is not text in UTF-8"),
    "a page": ("02_topics.html", "<html>", "no notebook was handed in, only 02_topics.html"),
    "a script": ("02_topics.py", "a = 1", "no notebook was handed in, only 02_topics.py"),
    "a workspace alone": ("ros2_ws/src/a/package.xml", "<package/>", "no notebook was handed in"),
    "some other JSON": ("settings.json", '{"a": 1}', "no notebook was handed in, only settings.json"),
}


@pytest.mark.parametrize("what", UNREAD)
def test_what_is_no_work_is_told_in_words_for_its_student(folder, what):
    name, content, told = UNREAD[what]
    write(folder / "Ben Ito" / name, content)
    row = grade(folder)[1]["Ben Ito"]
    assert row["status"] in ("unreadable", "empty") and row["total"] == "0" and told in row["notes"]


def test_an_untouched_copy_with_other_ends_of_lines_is_no_newer_work(folder):
    write(folder / "Ben Ito" / TOPICS, text("q1"))
    write(folder / "Ben Ito" / "again.ipynb", with_windows_lines(), NOON + 60)
    row = grade(folder)[1]["Ben Ito"]
    assert row["total"] == "1" and "again.ipynb (nothing was written in it)" in row["notes"]


def test_newer_work_in_nameless_cells_counts_before_older_work_in_named_ones(folder):
    write(folder / "Ben Ito" / TOPICS, text("q1"))
    write(folder / "Ben Ito" / "new.ipynb", without_names("q1", "q2"), NOON + 60)
    row = grade(folder)[1]["Ben Ito"]
    assert row["total"] == "3"
    page = (folder.parent / "grades" / f"{row['key']}.html").read_text()
    assert "# ch02-q2 was done" in page, "their code stands beside the verdict"


def doubled(*contents):
    buffer = BytesIO()
    with warnings.catch_warnings(), zipfile.ZipFile(buffer, "w") as packed:
        warnings.simplefilter("ignore")
        for content in contents:
            packed.writestr(zipfile.ZipInfo(TOPICS, (2026, 11, 23, 12, 0, 0)), content)
    return buffer.getvalue()


@pytest.mark.parametrize("place", ["1", "2"])
def test_two_files_of_one_name_in_a_zip_are_told_apart_by_their_place(folder, place):
    write(folder / "Ben Ito.zip", doubled(text("q1"), text("q2")))
    assert grade(folder)[1]["Ben Ito"]["status"] == "question"
    answer(folder.parent / "questions.csv", topics=place)
    row = grade(folder)[1]["Ben Ito"]
    assert (row["ch02.q1"], row["ch02.q2"]) == (("1", "0") if place == "1" else ("0", "2"))


def of_two_chapters():
    nb = notebook("q1", "q2")
    nb["cells"] += notebook("q1", chapter=SERVICES)["cells"]
    return json.dumps(nb)


def test_a_notebook_of_two_chapters_counts_for_both_unless_one_has_its_own(folder):
    write(folder / "Ben Ito" / "all.ipynb", of_two_chapters())
    write(folder / "Cem Ada" / "all.ipynb", of_two_chapters())
    write(folder / "Cem Ada" / SERVICES, text("q2", chapter=SERVICES), NOON - 60)
    rows_by_name = grade(folder, "--chapters", "02", "03")[1]
    assert [rows_by_name["Ben Ito"][name] for name in ("ch02.q1", "ch02.q2", "ch03.q1", "ch03.q2")] == ["1", "2", "1", "0"]
    assert (
        [rows_by_name["Cem Ada"][name] for name in ("ch02.q2", "ch03.q1")]
        == ["2", "0"]
        != rows_by_name["Cem Ada"]["ch03.q2"]
    )
    assert "exercises of 03_services are in it, too: they count as that chapter" in rows_by_name["Ben Ito"]["notes"]
    assert "they do not count beside a notebook of that chapter" in rows_by_name["Cem Ada"]["notes"]


def test_a_cell_of_an_earlier_chapter_in_ones_notes_does_not_go_before_that_chapter_s_notebook(folder):
    pasted = notebook("q1", chapter=SERVICES)
    pasted["cells"] += [cell for cell in notebook("q1")["cells"] if "# ch02-q1 was done" in cell["source"]]
    write(folder / "Ben Ito" / SERVICES, json.dumps(pasted), NOON + 60)
    write(folder / "Ben Ito" / TOPICS, text("q1", "q2"))
    assert grade(folder, "--chapters", "02")[1]["Ben Ito"]["total"] == "3"


@pytest.mark.parametrize("name", ["Ben Ito.ipynb.txt", "Ben Ito.json", "Ben Ito.txt"])
@pytest.mark.parametrize("listed", [True, False])
def test_a_loose_file_that_a_browser_renamed_is_its_student_s(folder, name, listed):
    write(folder / name, text("q1"))
    words = ("--roster", write(folder.parent / "list.txt", "Ann Lee\nBen Ito\n")) if listed else ()
    assert grade(folder, *words)[1]["Ben Ito"]["total"] == "1"


def test_a_loose_file_with_the_name_of_a_chapter_is_asked_about_whatever_its_ending(folder):
    write(folder / "02_topics.ipynb.txt", text("q1"))
    assert grade(folder)[0] == 1
    answer(folder.parent / "questions.csv", topics="Ben Ito")
    assert grade(folder)[1]["Ben Ito"]["total"] == "1"


@pytest.mark.parametrize("packed", [True, False])
def test_the_folder_above_the_class_is_told_as_a_likely_slip(tmp_path, folder, packed, capsys):
    files = {f"week2/{name}/{TOPICS}": text("q1") for name in ("Ann Lee", "Ben Ito")}
    place = tmp_path / "downloads"
    if packed:
        place = write(tmp_path / "all.zip", zipped(files))
    else:
        for name, content in files.items():
            write(place / name, content)
    grade(place)
    said = capsys.readouterr().out
    assert "! 'week2' is taken as one student, and 02_topics lies in 2 folders of it. If these are students, give" in said
    grade(folder)
    assert "taken as one student" not in capsys.readouterr().out


def test_marking_where_the_work_lies_never_takes_its_own_results_for_work(folder, monkeypatch, capsys):
    monkeypatch.chdir(folder)
    people = write(folder.parent / "sheet.csv", "Identifier,Full name\nParticipant 1,Ann Lee\nParticipant 2,Ben Ito\n")
    words = ("--roster", people, "--for", "moodle")
    for _ in range(2):
        capsys.readouterr()
        status, rows_by_name = grade(folder, *words, out=folder / "grades.csv")
        assert status == 0 and set(rows_by_name) == {"Ann Lee", "Ben Ito"}
    assert "left out" not in capsys.readouterr().out and (folder / "grades.feedback.zip").is_file()


@posix("folders are not opened there, and what is refused has other names")
@pytest.mark.parametrize("closed", ["Ben Ito", "week 2", TOPICS])
def test_what_this_user_may_not_read_is_told_and_never_just_missing(folder, monkeypatch, closed):
    write(folder / "Ben Ito" / "week 2" / TOPICS, text("q1"))
    write(folder / "Ann Lee" / TOPICS, text("q1", "q2"))
    usual = os.open

    def refuse(path, *more, **kept):
        """What the system says to everybody but root."""
        if os.path.basename(path) == closed and (closed != TOPICS or more[0] & os.O_DIRECTORY == 0):
            raise PermissionError(13, "Permission denied")
        return usual(path, *more, **kept)

    monkeypatch.setattr(os, "open", refuse)
    row = grade(folder)[1]["Ben Ito"]
    assert row["status"] == "unreadable" and "Permission denied" in row["notes"]
