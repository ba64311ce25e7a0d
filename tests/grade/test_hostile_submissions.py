"""Folders, zips and names that are made to break things end in a status with a reason, and the others get their marks."""

import json
import os
import tracemalloc

import pytest

from coursekit.grade import folders
from coursekit.grade.safe_walk import walk
from tests.needs import posix

from .bad_zips import ZIPS, says_small
from .handed import TOPICS, cheap_mark, collected, grade, text, write, zipped


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A class in which Ann did everything right."""
    monkeypatch.setattr("coursekit.grade.batch.mark", cheap_mark)
    monkeypatch.setattr("coursekit.grade.sandbox.tier", lambda: "bubblewrap")
    write(tmp_path / "class" / "Ann Lee" / TOPICS, text("q1", "q2", "q3", "q4"))
    return tmp_path / "class"


@pytest.mark.parametrize("what", ZIPS)
def test_a_bad_zip_has_a_reason_and_the_others_their_marks(folder, what):
    write(folder / "Ben.zip", ZIPS[what]())
    rows_by_name = grade(folder)[1]
    assert rows_by_name["Ann Lee"]["total"] == "7" and rows_by_name["Ben"]["total"] == "0"
    assert rows_by_name["Ben"]["status"] == ("empty" if what == "a link" else "unreadable")
    assert what == "a link" or "Ben.zip" in rows_by_name["Ben"]["notes"]


def test_a_bomb_costs_little_memory(folder):
    write(folder / "Ben.zip", zipped({TOPICS: b" " * (90 << 20)}))
    write(folder / "Cem.zip", says_small())
    tracemalloc.start()
    collected(folder, folder.parent / "s")
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 40 << 20, f"{peak >> 20} MB"


MANY = {
    "brackets": '{"cells": ' + "[" * 200_000 + "]" * 200_000 + "}",
    "empty lists": '{"cells": [' + "[]," * 2_000_000 + "[]]}",
    "a number without end": '{"cells": [' + "9" * 100_000 + "]}",
    "no cells": "{}",
    "cells that are none": '{"cells": [1, null, "a", {"source": 7, "metadata": 3}, {"metadata": {"nbgrader": []}}]}',
    "lone surrogates": json.dumps({"cells": [{"cell_type": "\ud800", "source": "\udfff", "metadata": {}}]}),
    "not UTF-8": b"\xff\xfe\xfa",
    "facts that are none": '{"cells": [], "metadata": {"coursekit": {"copy": [1], "given": 3, "chapter": {}}}}',
}


@pytest.mark.parametrize("what", MANY)
def test_a_bad_notebook_has_a_reason_and_the_others_their_marks(folder, what):
    write(folder / "Ben" / TOPICS, MANY[what])
    rows_by_name = grade(folder)[1]
    assert rows_by_name["Ann Lee"]["total"] == "7" and rows_by_name["Ben"]["total"] in ("0", "")
    assert rows_by_name["Ben"]["status"] in ("unreadable", "graded", "question")


@posix("there are no such pipes, and folders are not opened")
def test_folders_in_folders_links_pipes_and_names_that_are_no_text(folder, tmp_path, request):
    request.addfinalizer(lambda: folders.remove(folder / "Ben"))  # too deep for whoever clears up after the tests
    place = os.open(folder, os.O_RDONLY)
    os.mkdir("Ben", dir_fd=place)
    deep = os.open("Ben", os.O_RDONLY, dir_fd=place)
    for _ in range(1500):
        os.mkdir("d", dir_fd=deep)
        below = os.open("d", os.O_RDONLY, dir_fd=deep)
        os.close(deep)
        deep = below
    os.close(deep)
    (folder / "Cem").mkdir()
    os.mkfifo(folder / "Cem" / TOPICS)
    os.symlink("/dev/zero", folder / "Cem" / "02_topics (1).ipynb")
    write(tmp_path / "elsewhere" / TOPICS, text("q1"))
    os.symlink(tmp_path / "elsewhere", folder / "Dai")
    os.makedirs(os.path.join(os.fsencode(folder), b"E\xffva"))
    write(folder / "Fay" / "x", b"")
    os.rename(folder / "Fay" / "x", os.path.join(os.fsencode(folder), b"Fay", b"\xff\xfe.ipynb"))
    write(folder / ("G" * 250) / (f"{'h' * 200}.ipynb"), text("q1"))
    write(folder / "Hal" / f"a\n\x1b[2J\u202e{TOPICS}", text("q1"))
    rows_by_name = grade(folder)[1]
    os.close(place)
    said = {row["student"]: (row["status"], row["total"]) for row in rows_by_name.values()}
    assert said.pop("Ann Lee") == ("graded", "7") and said.pop("Hal") == ("graded", "1")
    assert said.pop("G" * 199 + "…") == ("graded", "1")
    assert said == dict.fromkeys(("Ben", "Cem", "Dai", "Fay"), ("unreadable", "0")) | {"E\ufffdva": ("empty", "0")}
    table = (folder.parent / "grades.csv").read_text(encoding="utf-8-sig")
    assert not set("\x1b\u202e\0") & set(table)


def test_a_download_that_is_broken_is_said(tmp_path):
    place = write(tmp_path / "moodle.zip", zipped({f"Ann/{TOPICS}": text("q1")})[:500])
    with pytest.raises(SystemExit, match=r"moodle.zip' cannot be opened: it is no zip, or only a part of one"):
        grade(place)


def test_more_files_than_may_be_are_told(folder, monkeypatch):
    monkeypatch.setattr("coursekit.grade.safe_walk.MOST", 20)
    for number in range(40):
        write(folder / "Ben" / f"{number}.txt", "")
    rows_by_name = grade(folder)[1]
    assert "more than 20 files" in rows_by_name["Ben"]["notes"]


def test_a_fault_of_ours_in_one_submission_leaves_the_others_alone(folder, monkeypatch):
    from coursekit.grade.submission_parts import Gatherer

    usual = Gatherer.entry
    monkeypatch.setattr(Gatherer, "entry", lambda self, name, files: 1 / 0 if name == "Ben" else usual(self, name, files))
    write(folder / "Ben" / TOPICS, text("q1"))
    rows_by_name = grade(folder)[1]
    assert rows_by_name["Ann Lee"]["total"] == "7" and rows_by_name["Ben"]["status"] == "unreadable"


def test_a_file_that_is_exchanged_for_a_link_is_not_followed(tmp_path):
    write(tmp_path / "secret.ipynb", "secret")
    write(tmp_path / "class" / TOPICS, "mine")
    (walked,) = walk(tmp_path / "class")
    (tmp_path / "class" / TOPICS).unlink()
    os.symlink(tmp_path / "secret.ipynb", tmp_path / "class" / TOPICS)
    with pytest.raises(OSError):
        walked.open()


def test_a_submission_crosses_to_another_process_as_plain_values(folder):
    from coursekit.grade.submissions import Submission

    (handed,) = collected(folder, folder.parent / "s").handed
    submission = handed.submission(TOPICS)
    again = Submission.of_json(json.loads(json.dumps(submission.as_json())))
    assert again == submission and again.digest() == submission.digest()
    (copy,) = again.notebooks(folder.parent / "unpacked")
    assert copy.name == TOPICS and copy.read_bytes() == submission.chosen[TOPICS].read_bytes()
