"""`coursekit lab` is JupyterLab itself."""

import subprocess
import sys

import pytest

from coursekit.cli.coursekit import main

BECOMES = """
import os, sys
from coursekit.cli.lab import become
print(os.getpid())
become([sys.executable, "-c", "import os; print(os.getpid())"], dict(os.environ))
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
    assert str(ended.value).startswith(f"The course cannot be written to '{tmp_path / 'file' / 'course'}': ")
    assert "coursekit lab --folder ~/course" in str(ended.value)


@pytest.fixture
def opened(monkeypatch):
    """Runs `coursekit lab --folder FOLDER`; the address that JupyterLab would open, and the folder's notebooks."""
    commands: list[list[str]] = []
    monkeypatch.setattr("coursekit.cli.lab.become", lambda command, env: commands.append(command) or 0)
    monkeypatch.setattr("coursekit.cli.compile_ahead.start_in_background", lambda env: None)

    def run(folder):
        assert main(["lab", "--no-browser", "--folder", str(folder)]) == 0
        (address,) = [word.partition("=")[2] for word in commands[-1] if word.startswith("--LabApp.default_url=")]
        return address, sorted(path.name for path in folder.glob("*.ipynb"))

    return run


def test_a_new_folder_becomes_the_course_and_opens_with_its_beginning(tmp_path, opened) -> None:
    for _ in range(2):
        address, there = opened(tmp_path / "course")
        assert address == "/lab/tree/00_start_here.ipynb" and len(there) > 10


def test_what_was_released_is_opened_and_nothing_is_added_to_it(tmp_path, opened, capsys) -> None:
    assert main(["release", "02", "03", "--out", str(tmp_path / "week2")]) == 0
    before = (tmp_path / "week2" / "02_topics.ipynb").read_bytes()
    for _ in range(2):
        address, there = opened(tmp_path / "week2")
        assert address == "/lab/tree/02_topics.ipynb" and there == ["02_topics.ipynb", "03_services.ipynb"]
    assert (tmp_path / "week2" / "02_topics.ipynb").read_bytes() == before
    assert "Here already: 02_topics.ipynb, 03_services.ipynb. No chapters of the course" in capsys.readouterr().out


def test_a_teacher_s_own_chapter_is_opened_and_nothing_is_added_to_it(tmp_path, opened) -> None:
    assert main(["new", "gripper", "--folder", str(tmp_path / "my course")]) == 0
    assert opened(tmp_path / "my course") == ("/lab/tree/gripper.ipynb", ["gripper.ipynb"])


def test_a_released_chapter_in_the_course_s_folder_does_not_stop_its_updates(tmp_path, opened) -> None:
    opened(tmp_path / "course")
    assert main(["release", "02", "--out", str(tmp_path / "week2")]) == 0
    (tmp_path / "week2" / "02_topics.ipynb").replace(tmp_path / "course" / "02_topics.ipynb")
    (tmp_path / "course" / "03_services.ipynb").unlink()
    address, there = opened(tmp_path / "course")
    assert address.endswith("00_start_here.ipynb") and "03_services.ipynb" in there
    assert "02_topics.new.ipynb" not in there


def test_a_tilde_is_home_where_no_shell_has_made_it_so(tmp_path, monkeypatch, capsys) -> None:
    for name in ("HOME", "USERPROFILE"):
        monkeypatch.setenv(name, str(tmp_path))
    monkeypatch.chdir(tmp_path)
    assert main(["course", "--folder", "~/course"]) == 0
    assert (tmp_path / "course" / "00_start_here.ipynb").is_file()
    assert not (tmp_path / "~").exists()


def test_the_server_says_no_more_than_its_address_unless_it_is_asked_to(tmp_path, monkeypatch) -> None:
    commands: list[list[str]] = []
    monkeypatch.setattr("coursekit.cli.lab.become", lambda command, env: commands.append(command) or 0)
    monkeypatch.setattr("coursekit.cli.compile_ahead.start_in_background", lambda env: None)
    for more in ([], ["--ServerApp.certfile=/etc/login.pem"], ["--log-level=INFO"], ["--debug"]):
        assert main(["lab", "--no-browser", "--folder", str(tmp_path / "course"), "--", *more]) == 0
    quiet, also, told, debug = ([word for word in command if "log" in word.partition("=")[0]] for command in commands)
    assert quiet == also == ["--ServerApp.log_level=ERROR", "--LabApp.log_level=ERROR"] and told == ["--log-level=INFO"]
    assert not debug and commands[-1][-1] == "--debug"
