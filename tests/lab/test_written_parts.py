"""`edit`, `%%write` and `%%write -a`, run again as a student goes back to them."""

import errno
from collections import Counter
from types import SimpleNamespace

import pytest
from IPython.core.interactiveshell import InteractiveShell

from coursekit.lab import cells as kernel_cells
from coursekit.lab.errors import NotNow, NotThere
from coursekit.lab.magics import CourseMagics, edit

SCRIPTS = "scripts: ["


@pytest.fixture
def desk(tmp_path, monkeypatch):
    """A course whose cells write: desk.cell("A") is the cell that runs."""
    monkeypatch.setenv("COURSEKIT_COURSE", str(tmp_path))
    monkeypatch.setenv("COURSEKIT_WORKSPACE", str(tmp_path / "ros2_ws"))
    cells = SimpleNamespace(cell="", counts=Counter())
    monkeypatch.setitem(kernel_cells._running, "cells", cells)
    magics = CourseMagics(InteractiveShell())

    def cell(name):
        cells.cell = name
        cells.counts.clear()

    file = tmp_path / "ros2_ws" / "src" / "file.py"
    return SimpleNamespace(cell=cell, write=magics.write, file=file, name="src/file.py")


def written(desk, cell, line, text):
    desk.cell(cell)
    desk.write(line, text)
    return desk.file.read_text()


def edits(desk, cell, *pairs):
    desk.cell(cell)
    for old, new in pairs:
        edit(desk.name, old, new)
    return desk.file.read_text()


def test_cells_that_add_can_be_run_again_in_any_order(desk):
    written(desk, "A", desk.name, "class A\n")
    written(desk, "B", f"-a {desk.name}", "main\n")
    written(desk, "C", f"-a {desk.name}", "more\n")
    assert written(desk, "B", f"-a {desk.name}", "main!\n") == "class A\nmain!\nmore\n"
    assert written(desk, "A", desk.name, "class B\n") == "class B\nmain!\nmore\n"
    assert written(desk, "C", f"-a {desk.name}", "more\n") == "class B\nmain!\nmore\n"


def test_without_ids_of_cells_what_is_there_is_not_added_again(desk):
    written(desk, "", desk.name, "class A\n")
    for _ in range(2):
        assert written(desk, "", f"-a {desk.name}", "main\n") == "class A\nmain\n"


def test_another_cell_writes_the_file_anew(desk):
    written(desk, "A", desk.name, "a\n")
    written(desk, "B", f"-a {desk.name}", "b\n")
    assert written(desk, "C", desk.name, "c\n") == "c\n"


def test_a_package_that_was_made_anew_starts_without_the_old_pieces(desk):
    written(desk, "A", desk.name, "a\n")
    written(desk, "B", f"-a {desk.name}", "b\n")
    desk.file.unlink()
    assert written(desk, "A", desk.name, "a\n") == "a\n"


def test_a_corrected_entry_replaces_the_wrong_one(desk):
    written(desk, "W", desk.name, f"{SCRIPTS}\n]\n")
    edits(desk, "E", (SCRIPTS, f"{SCRIPTS}\n wrong = a:b,"))
    edits(desk, "F", (SCRIPTS, f"{SCRIPTS}\n later = c:d,"))
    assert edits(desk, "E", (SCRIPTS, f"{SCRIPTS}\n right = a:b,")).count("= a:b") == 1
    assert "right" in desk.file.read_text() and "later" in desk.file.read_text()


def test_two_entries_of_one_cell_at_one_place_both_stay(desk):
    written(desk, "W", desk.name, f"{SCRIPTS}\n]\n")
    for _ in range(2):
        text = edits(desk, "E", *((SCRIPTS, f"{SCRIPTS}\n {name} = a:b,") for name in ("one", "two")))
    assert sorted(text.split()) == sorted(f"{SCRIPTS} one = a:b, two = a:b, ]".split())


def test_an_edit_whose_lines_went_on_is_left_alone_and_said(desk, capsys):
    written(desk, "W", desk.name, "rate: 1\n")
    edits(desk, "E", ("rate: 1", "rate: 2"))
    edits(desk, "F", ("rate: 2", "rate: 3"))
    assert edits(desk, "E", ("rate: 1", "rate: 2")) == "rate: 3\n"
    assert "They stay as they are" in capsys.readouterr().out


def test_an_edit_that_was_never_possible_says_what_to_type(desk):
    with pytest.raises(NotThere, match="was the cell above run"):
        edit(desk.name, "a", "b")
    written(desk, "W", desk.name, "a\n")
    with pytest.raises(NotThere, match="Print it with: %show src/file.py"):
        edits(desk, "E", ("b", "c"))


def test_a_file_that_does_not_change_keeps_its_time(desk):
    written(desk, "A", desk.name, "a\n")
    before = desk.file.stat().st_mtime_ns
    written(desk, "A", desk.name, "a\n")
    edits(desk, "E", ("a", "a"))
    assert desk.file.stat().st_mtime_ns == before


def test_a_spoilt_memory_is_begun_anew(desk, tmp_path):
    written(desk, "A", desk.name, "a\n")
    (tmp_path / ".coursekit" / "written.json").write_text("{]")
    assert written(desk, "B", f"-a {desk.name}", "b\n") == "a\nb\n"


def test_a_full_disk_leaves_the_file_as_it_was_and_says_what_to_do(desk, monkeypatch):
    written(desk, "A", desk.name, "a\n")

    def full(path, *_args, **_options):
        open(path, "w", encoding="utf-8").write("a half")  # noqa: SIM115
        raise OSError(errno.ENOSPC, "No space left on device", str(path))

    monkeypatch.setattr(type(desk.file), "write_text", full)
    with pytest.raises(NotNow, match="No space left on device. The file is as it was"):
        written(desk, "A", desk.name, "b\n")
    assert [path.name for path in desk.file.parent.iterdir()] == ["file.py"] and desk.file.read_text() == "a\n"


def test_a_folder_that_can_only_be_read_is_no_traceback(desk, monkeypatch):
    def refuse(path, *_args, **_options):
        raise PermissionError(errno.EACCES, "Permission denied", str(path))

    monkeypatch.setattr(type(desk.file), "write_text", refuse)
    with pytest.raises(NotNow, match=r"Permission denied.*coursekit lab --folder ~/course"):
        written(desk, "A", desk.name, "b\n")
