"""Folders, zips and names that are made to break things end in a status with a reason, and the others get their marks."""

import io
import json
import os
import struct
import time
import tracemalloc
import zipfile

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as some

from coursekit.grade import folders
from coursekit.grade.archives import Archive, BadArchive, Bounds, parts_of
from coursekit.grade.harmless import cell, lines, name_of_files, shown
from coursekit.grade.recognising import Recogniser, parse_notebook
from coursekit.grade.walking import walk
from tests.needs import posix

from .handed import SOURCES, TOPICS, cheap_mark, collected, grade, notebook, text, write, zipped


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A class in which Ann did everything right."""
    monkeypatch.setattr("coursekit.grade.batch.mark", cheap_mark)
    monkeypatch.setattr("coursekit.grade.sandbox.tier", lambda: "bubblewrap")
    write(tmp_path / "class" / "Ann Lee" / TOPICS, text("q1", "q2", "q3", "q4"))
    return tmp_path / "class"


def zipped_as(kind):
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", kind) as packed:
        packed.writestr(TOPICS, text("q1"))
    return made.getvalue()


def corrupt_stream():
    data = bytearray(zipped({TOPICS: text("q1")}))
    data[60:400] = os.urandom(340)
    return bytes(data)


def encrypted():
    data = bytearray(zipped({TOPICS: text("q1")}))
    for mark, at in ((b"PK\3\4", 6), (b"PK\1\2", 8)):
        place = data.index(mark) + at
        data[place] |= 1
    return bytes(data)


def says_small(real=60 << 20):
    """A member that unpacks to more than its header says."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as packed:
        packed.writestr(TOPICS, b" " * real)
    return made.getvalue().replace(struct.pack("<I", real), struct.pack("<I", 1000))


def many(count=70_000):
    one = b"PK\1\2" + b"\0" * 24 + struct.pack("<H", 1) + b"\0" * 16 + b"a"
    return one * count + b"PK\5\6\0\0\0\0" + struct.pack("<HHIIH", count & 0xFFFF, count & 0xFFFF, len(one) * count, 0, 0)


ZIPS = {
    "a name that is no UTF-8": lambda: _bad_name(),
    "a broken stream": corrupt_stream,
    "encrypted": encrypted,
    "bz2": lambda: zipped_as(zipfile.ZIP_BZIP2),
    "lzma": lambda: zipped_as(zipfile.ZIP_LZMA),
    "nothing": lambda: b"",
    "half": lambda: zipped({TOPICS: text("q1")})[:900],
    "a bomb that says so": lambda: zipped({TOPICS: b" " * (90 << 20)}),
    "a bomb that does not": says_small,
    "more members than may be": many,
    "three deep": lambda: zipped({"a.zip": zipped({"b.zip": zipped({TOPICS: text("q1")})})}),
    "text": lambda: b"<html>Please log in</html>",
    "a link": lambda: _link(),
}


def _bad_name():
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w") as packed:
        packed.writestr("ñ02_topics.ipynb", text("q1"))
    return made.getvalue().replace("ñ".encode(), b"\xff\xff")


def _link():
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w") as packed:
        info = zipfile.ZipInfo(TOPICS)
        info.external_attr = 0o120777 << 16
        packed.writestr(info, "/etc/passwd")
    return made.getvalue()


@pytest.mark.parametrize("what", ZIPS)
def test_a_bad_zip_has_a_reason_and_the_others_their_marks(folder, what):
    write(folder / "Ben.zip", ZIPS[what]())
    found = grade(folder)[1]
    assert found["Ann Lee"]["total"] == "7" and found["Ben"]["total"] == "0"
    assert found["Ben"]["status"] == ("empty" if what == "a link" else "unreadable")
    assert what == "a link" or "Ben.zip" in found["Ben"]["notes"]


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
    found = grade(folder)[1]
    assert found["Ann Lee"]["total"] == "7" and found["Ben"]["total"] in ("0", "")
    assert found["Ben"]["status"] in ("unreadable", "graded", "question")


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
    found = grade(folder)[1]
    os.close(place)
    said = {row["student"]: (row["status"], row["total"]) for row in found.values()}
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
    monkeypatch.setattr("coursekit.grade.walking.MOST", 20)
    for number in range(40):
        write(folder / "Ben" / f"{number}.txt", "")
    found = grade(folder)[1]
    assert "more than 20 files" in found["Ben"]["notes"]


def test_a_fault_of_ours_in_one_submission_leaves_the_others_alone(folder, monkeypatch):
    from coursekit.grade.pieces import Gatherer

    usual = Gatherer.entry
    monkeypatch.setattr(Gatherer, "entry", lambda self, name, files: 1 / 0 if name == "Ben" else usual(self, name, files))
    write(folder / "Ben" / TOPICS, text("q1"))
    found = grade(folder)[1]
    assert found["Ann Lee"]["total"] == "7" and found["Ben"]["status"] == "unreadable"


def test_a_file_that_is_exchanged_for_a_link_is_not_followed(tmp_path):
    write(tmp_path / "secret.ipynb", "secret")
    write(tmp_path / "class" / TOPICS, "mine")
    (one,) = walk(tmp_path / "class")
    (tmp_path / "class" / TOPICS).unlink()
    os.symlink(tmp_path / "secret.ipynb", tmp_path / "class" / TOPICS)
    with pytest.raises(OSError):
        one.open()


def test_a_submission_crosses_to_another_process_as_plain_values(folder):
    from coursekit.grade.submissions import Submission

    (one,) = collected(folder, folder.parent / "s").handed
    made = one.submission(TOPICS)
    again = Submission.of_json(json.loads(json.dumps(made.as_json())))
    assert again == made and again.digest() == made.digest()
    (copy,) = again.notebooks(folder.parent / "unpacked")
    assert copy.name == TOPICS and copy.read_bytes() == made.chosen[TOPICS].read_bytes()


PATHS = [
    "/etc/passwd",
    "../../x",
    "C:\\Windows\\x.ipynb",
    "a/../../b",
    "\\\\host\\share\\x",
    "./././x",
    "a//b",
    "..",
    "",
    "C:",
    "C:/",
]


@pytest.mark.parametrize("path", PATHS)
def test_paths_in_zips_lead_nowhere(path):
    parts = parts_of(path)
    assert parts and not {"", ".", ".."} & set(parts) and not any("/" in one or "\\" in one for one in parts)


def test_only_what_may_be_is_read_of_a_zip():
    data = zipped({"a": b"x" * 1000, "b": b"y" * 1000})
    for bounds in (Bounds(members=1), Bounds(directory=10)):
        with pytest.raises(BadArchive, match="holds more than"):
            Archive(io.BytesIO(data), bounds)
    with Archive(io.BytesIO(data), Bounds(file=1200, total=1500)) as opened:
        first, second = opened.members()
        assert len(opened.read(first)) == 1000
        with pytest.raises(BadArchive, match="unpacks to more than"):
            opened.read(second)


@settings(max_examples=150)
@given(some.text(max_size=60))
def test_no_text_of_a_student_s_is_a_formula_or_moves_a_terminal(said):
    for made in (shown(said), cell(said), lines(said)):
        assert not [
            one for one in made if (ord(one) < 32 and one != "\n") or one in "\x7f\u202a\u202b\u202e\u2066\u2069\u200f"
        ]
        made.encode("utf-8")
    for separator in ';,"|\t':
        for part in cell(said).split(separator):
            assert not part.lstrip(" '\u00a0").startswith(("=", "+", "-", "@")) or part.lstrip(" \u00a0").startswith("'"), (
                part
            )


@settings(max_examples=150)
@given(some.text(max_size=40), some.text(max_size=40))
def test_names_of_files_are_plain_and_differ(one, other):
    made = name_of_files(one)
    assert made.isascii() and len(made) < 60 and made == made.casefold() and not set('/\\:*?"<>|. ') & set(made)
    assert (made == name_of_files(other)) == (one == other)


@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(some.binary(max_size=3000), some.integers(0, 3000), some.integers(0, 255))
@example(b"", 609, 0)  # a file without a name
def test_bytes_that_are_no_zip_are_a_bad_archive(noise, place, value):
    data = bytearray(zipped({TOPICS: b"{}" * 50, "b/c.txt": b"x"}))
    data[place % len(data)] = value
    for made in (noise, bytes(data), bytes(data) + noise[:40], noise[:40] + bytes(data)):
        try:
            with Archive(io.BytesIO(made)) as opened:
                for member in opened.members():
                    assert member.when >= 0 and len(opened.read(member)) == member.size
        except BadArchive as error:
            assert str(error)


words = some.sampled_from(["cell_type", "source", "metadata", "nbgrader", "grade_id", "coursekit", "given", "copy"])
values = some.recursive(
    some.none() | some.booleans() | some.integers() | some.floats() | some.text(max_size=8),
    lambda inner: some.lists(inner, max_size=3) | some.dictionaries(words, inner, max_size=4),
    max_leaves=12,
)


@settings(max_examples=150)
@given(some.lists(values, max_size=5), values)
def test_any_json_with_cells_can_be_recognised(cells, metadata):
    data = json.dumps({"cells": cells, "metadata": metadata}).encode()
    Recogniser(SOURCES).recognise(parse_notebook(data, "x.ipynb"))
    known = notebook("q1")
    known["cells"] += cells
    known["metadata"] = metadata
    found = Recogniser(SOURCES).recognise(parse_notebook(json.dumps(known).encode(), "x.ipynb"))
    assert found.chapter == TOPICS and "ch02.q1" in found.begun


@posix("most of these are no names there")
@settings(max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(some.lists(some.text(some.characters(exclude_characters="\0/", exclude_categories=["Cs"]), min_size=1, max_size=30),
                  min_size=1, max_size=6))  # fmt: skip
def test_whatever_students_call_their_files_each_gets_a_row(tmp_path_factory, names):
    base = tmp_path_factory.mktemp("names")
    written = 0
    for name in names:
        try:
            write(base / "class" / name / f"{name}.ipynb", text("q1"))
            written += not name.startswith(".") and name not in ("__MACOSX",)
        except (OSError, ValueError):  # a name that this file system does not take
            continue
    if written:
        found = collected(base / "class", base / "s")
        assert 1 <= len(found.handed) + len(found.whose) <= written
        assert len({one.key for one in found.handed}) == len(found.handed)


def test_a_zip_s_times_may_be_nonsense():
    data = zipped({TOPICS: b"{}"})
    for stamp in (b"\xff\xff\xff\xff", b"\0\0\0\0"):
        place = data.index(b"PK\1\2") + 12
        with Archive(io.BytesIO(data[:place] + stamp + data[place + 4 :])) as opened:
            (member,) = opened.members()
            assert 0 <= member.when < time.time() + 10**11
