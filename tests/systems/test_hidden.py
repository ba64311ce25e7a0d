"""Files that are written whole can be seen: JupyterLab finds no file that Windows marks as hidden."""

import os
import stat
import tempfile

import pytest

from coursekit import files
from coursekit.files import write_whole


@pytest.mark.parametrize(("windows", "first"), [(True, "~"), (False, ".")])
def test_on_windows_no_dot_hides_a_file_that_is_being_written(tmp_path, monkeypatch, windows, first):
    names = []

    def made(real=tempfile.mkstemp, **how):
        number, name = real(**how)
        names.append(os.path.basename(name))
        return number, name

    monkeypatch.setattr(files, "WINDOWS", windows)
    monkeypatch.setattr(tempfile, "mkstemp", made)
    write_whole(tmp_path / "room.yaml", "image: room.pgm\n")
    assert [name[0] for name in names] == [first] and [path.name for path in tmp_path.iterdir()] == ["room.yaml"]


@pytest.mark.skipif(not files.WINDOWS, reason="only Windows marks files as hidden")
def test_a_file_that_was_written_is_not_marked_as_hidden(tmp_path):
    write_whole(tmp_path / "room.yaml", "image: room.pgm\n")
    assert not os.stat(tmp_path / "room.yaml").st_file_attributes & stat.FILE_ATTRIBUTE_HIDDEN
