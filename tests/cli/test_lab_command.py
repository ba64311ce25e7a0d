"""`coursekit lab` is JupyterLab itself."""

import subprocess
import sys

import pytest

from coursekit.cli.coursekit import main

BECOMES = """
import os, sys
from coursekit.cli.coursekit import _become
print(os.getpid())
_become([sys.executable, "-c", "import os; print(os.getpid())"], dict(os.environ))
"""


@pytest.mark.skipif(sys.platform == "win32", reason="there it stays a parent")
def test_who_ends_the_command_ends_the_server() -> None:
    done = subprocess.run([sys.executable, "-c", BECOMES], capture_output=True, encoding="utf-8", check=True)
    before, after = done.stdout.split()
    assert before == after


def test_where_the_course_cannot_be_written_it_says_so_in_a_sentence(tmp_path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(SystemExit) as ended:
        main(["course", "--folder", str(tmp_path / "file" / "course")])
    assert str(ended.value).startswith(f"The course cannot be written to '{tmp_path}/file/course': Not a directory")
    assert "coursekit lab --folder ~/course" in str(ended.value)


def test_a_tilde_is_home_where_no_shell_has_made_it_so(tmp_path, monkeypatch, capsys) -> None:
    for name in ("HOME", "USERPROFILE"):
        monkeypatch.setenv(name, str(tmp_path))
    monkeypatch.chdir(tmp_path)
    assert main(["course", "--folder", "~/course"]) == 0
    assert (tmp_path / "course" / "00_start_here.ipynb").is_file()
    assert not (tmp_path / "~").exists()
