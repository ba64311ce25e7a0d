"""A file is replaced although another program reads the old one for a moment; who reads on is told of."""

import os

import pytest

from coursekit import files
from coursekit.files import write_whole


@pytest.fixture
def open_elsewhere(monkeypatch):
    """open_elsewhere(n): the next n times Windows refuses to replace a file, and waiting takes no time."""

    def refuse(times, real=os.replace):
        left = [times]

        def replace(fresh, target):
            left[0] -= 1
            if left[0] >= 0:
                raise PermissionError(13, "Access is denied", os.fspath(target))
            real(fresh, target)

        monkeypatch.setattr(os, "replace", replace)

    monkeypatch.setattr(files, "WINDOWS", True)
    monkeypatch.setattr(files.time, "sleep", lambda seconds: None)
    return refuse


def test_who_reads_for_a_moment_is_waited_for(tmp_path, open_elsewhere):
    (tmp_path / "room.yaml").write_text("old")
    open_elsewhere(3)
    write_whole(tmp_path / "room.yaml", "new")
    assert (tmp_path / "room.yaml").read_text() == "new"


def test_who_reads_on_is_told_of_and_the_old_file_stays_whole(tmp_path, open_elsewhere):
    (tmp_path / "room.yaml").write_text("old")
    open_elsewhere(1000)
    with pytest.raises(PermissionError, match="Another program has the file open: close it, and try again"):
        write_whole(tmp_path / "room.yaml", "new")
    assert [(path.name, path.read_text()) for path in tmp_path.iterdir()] == [("room.yaml", "old")]


def test_elsewhere_a_refusal_is_told_at_once_as_the_system_tells_it(tmp_path, open_elsewhere, monkeypatch):
    monkeypatch.setattr(files, "WINDOWS", False)
    monkeypatch.setattr(files.time, "sleep", lambda seconds: pytest.fail("it waits"))
    open_elsewhere(1)
    with pytest.raises(PermissionError, match="Access is denied"):
        write_whole(tmp_path / "room.yaml", "new")


@pytest.mark.skipif(not files.WINDOWS, reason="only Windows refuses")
def test_on_windows_a_file_that_is_read_is_told_of(tmp_path, monkeypatch):
    monkeypatch.setattr(files.time, "sleep", lambda seconds: None)
    (tmp_path / "room.yaml").write_text("old")
    with open(tmp_path / "room.yaml", encoding="utf-8"), pytest.raises(PermissionError, match="has the file open"):
        write_whole(tmp_path / "room.yaml", "new")
    write_whole(tmp_path / "room.yaml", "new")
    assert (tmp_path / "room.yaml").read_text() == "new"
