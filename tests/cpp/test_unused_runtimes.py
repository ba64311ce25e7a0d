"""The user's cache keeps the runtimes that are used, and does not grow with every update."""

import os

import pytest

from coursekit.cpp.unused_runtimes import A_DAY, KEPT, mark_used, remove_unused

NOW = 2_000_000_000.0
NAMES = [f"{index}123456789abcdef" for index in range(6)]


@pytest.fixture
def runtimes(tmp_path):
    """Six runtimes, each last used two days before the next one; the newest is a day and a half old."""
    for index in range(6):
        folder = tmp_path / NAMES[index] / "lib"
        folder.mkdir(parents=True)
        (folder / "library").write_text("text")
        last_used = NOW - (1.5 + 2 * index) * A_DAY
        os.utime(folder.parent, (last_used, last_used))
    (tmp_path / "making.lock").touch()
    return tmp_path


def names(folder):
    return sorted(path.name for path in folder.iterdir() if path.name != "making.lock")


def test_the_last_ones_stay_however_old_they_are(runtimes):
    remove_unused(runtimes, NOW)
    assert names(runtimes) == NAMES[:KEPT]
    remove_unused(runtimes, NOW + 1000 * A_DAY)
    assert len(names(runtimes)) == KEPT


def test_what_was_used_today_stays(runtimes):
    for name in NAMES[1:]:
        os.utime(runtimes / name, (NOW - 1, NOW - 1))
    remove_unused(runtimes, NOW)
    assert names(runtimes) == NAMES[1:]


def test_using_an_old_one_keeps_it(runtimes):
    before = (runtimes / NAMES[5]).stat().st_mtime
    mark_used(runtimes / NAMES[5])
    assert (runtimes / NAMES[5]).stat().st_mtime != before
    os.utime(runtimes / NAMES[5], (NOW, NOW))
    remove_unused(runtimes, NOW)
    assert names(runtimes) == [*NAMES[:2], NAMES[5]]


def test_what_interrupted_programs_left_is_removed(runtimes):
    (runtimes / ".making-abc" / "runtime").mkdir(parents=True)
    remove_unused(runtimes, NOW)
    assert ".making-abc" not in names(runtimes)


def test_one_whose_files_are_in_use_stays_whole(runtimes, monkeypatch):
    def refuse(_path, _target):
        raise PermissionError(32, "The process cannot access the file because it is being used by another process")

    monkeypatch.setattr("pathlib.Path.rename", refuse)
    remove_unused(runtimes, NOW)
    assert (runtimes / NAMES[5] / "lib" / "library").read_text() == "text"


def test_marking_one_that_is_gone_or_not_ours_does_nothing(tmp_path):
    mark_used(tmp_path / "gone")
    assert not (tmp_path / "gone").exists()


def test_other_folders_are_none_of_its_business(runtimes):
    (runtimes / "homework").mkdir()
    os.utime(runtimes / "homework", (0, 0))
    remove_unused(runtimes, NOW)
    assert "homework" in names(runtimes)
