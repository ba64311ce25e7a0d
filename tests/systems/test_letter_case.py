"""Where a file system ignores case, a name that differs from another one in case only is told instead of taken for it."""

import os
from pathlib import Path

import pytest

from coursekit.lab import magics
from coursekit.packages.create import _refusal
from coursekit.packages.package_settings import PackageSettings
from coursekit.systems.letter_case import other_spelling


@pytest.fixture
def ignores_case(monkeypatch):
    """A file system on which a name is found in any case, as macOS' and Windows' are."""
    real = os.stat

    def stat(path, *words, **named):
        try:
            return real(path, *words, **named)
        except FileNotFoundError:
            folder, name = os.path.split(os.fspath(path))
            for entry in os.listdir(folder or "."):
                if entry.casefold() == name.casefold():
                    return real(os.path.join(folder, entry), *words, **named)
            raise

    def exists(path):
        try:
            return bool(stat(path))
        except FileNotFoundError:
            return False

    monkeypatch.setattr(os, "stat", stat)
    monkeypatch.setattr(os.path, "exists", exists)
    monkeypatch.setattr(Path, "exists", exists)  # each Python has its own way to either of the two


def test_another_spelling_is_one_only_where_case_is_ignored(tmp_path, ignores_case):
    (tmp_path / "Foo.py").touch()
    assert other_spelling(tmp_path / "foo.py") == "Foo.py"
    assert other_spelling(tmp_path / "Foo.py") == other_spelling(tmp_path / "bar.py") == ""


def test_where_case_counts_two_spellings_are_two_files(tmp_path):
    (tmp_path / "Foo.py").touch()
    if (tmp_path / "foo.py").exists():
        pytest.skip("this file system ignores case")
    assert other_spelling(tmp_path / "foo.py") == ""


def test_a_package_whose_name_differs_in_case_only_is_refused_with_the_reason(tmp_path, ignores_case):
    (tmp_path / "Talks").mkdir()
    said = str(_refusal(PackageSettings("talks", "", "", "", "", "ament_python"), str(tmp_path)))
    assert "Aborted!" in said and "'Talks'" in said and "one folder" in said


def test_a_cell_does_not_write_over_a_file_whose_name_differs_in_case_only(tmp_path, monkeypatch, capsys, ignores_case):
    monkeypatch.setattr(magics, "workspace", lambda: tmp_path)
    (tmp_path / "Talk.py").write_text("mine\n", encoding="utf-8")
    magics.CourseMagics.write(None, "talk.py", "new\n")
    assert (tmp_path / "Talk.py").read_text(encoding="utf-8") == "mine\n" and not (tmp_path / "talk.py").is_symlink()
    said = capsys.readouterr().out
    assert "Not written" in said and "Talk.py" in said and "%%write Talk.py" in said
