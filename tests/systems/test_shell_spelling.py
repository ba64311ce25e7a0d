"""Messages name what the reader's computer has: its shell's words, and the key beside the space bar."""

import re
from pathlib import Path

import pytest

from coursekit.cli import checks
from coursekit.systems import operating_system, runtime_folder, shell_spelling

ROOT = Path(__file__).resolve().parents[2]
PLACES = ("coursekit/systems/shell_spelling.py", "coursekit/systems/rights.py")
_ONLY_ONE_SYSTEM = re.compile(r"press Ctrl[+-]|[\"']export [A-Z_]+=|source install/|pip install '")


@pytest.fixture(params=["linux", "mac", "windows"])
def system(request, monkeypatch):
    """One of the three, as the room for systems sees it."""
    monkeypatch.setattr(operating_system, "WINDOWS", request.param == "windows")
    monkeypatch.setattr(operating_system, "MAC", request.param == "mac")
    return request.param


def test_each_system_is_told_its_own_words(system):
    assert shell_spelling.shortcut("S") == ("Cmd+S" if system == "mac" else "Ctrl+S")
    assert shell_spelling.set_variable("A", "b") == ('$env:A = "b"' if system == "windows" else "export A=b")
    assert shell_spelling.line_here("printenv A") == ("cmd /c set A" if system == "windows" else "printenv A")
    assert shell_spelling.line_here("ros2 node list") == "ros2 node list"


def test_where_no_runtime_folder_is_safe_the_cure_is_this_system_s(system, monkeypatch):
    monkeypatch.setattr(runtime_folder, "_fault", lambda path: "it is taken")
    cure = shell_spelling.set_variable("COURSEKIT_RUNTIME_DIR", "~/coursekit-run")
    with pytest.raises(PermissionError, match=re.escape(cure)):
        runtime_folder.choose()


def test_a_version_is_asked_for_in_marks_that_every_shell_knows(monkeypatch):
    monkeypatch.setattr(checks, "_installed", lambda name: "99.0")
    assert checks.kernel_version().cure.endswith('pip install "ipykernel>=7.0,<7.4"')


def test_no_message_has_words_of_one_system_only():
    files = [path for path in sorted((ROOT / "coursekit").rglob("*.py")) if path.relative_to(ROOT).as_posix() not in PLACES]
    places = [
        f"{file.relative_to(ROOT)}:{number}: {line.strip()}"
        for file in files
        if "share" not in file.parts and "chapters" not in file.parts
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1)
        if _ONLY_ONE_SYSTEM.search(line) and '"""' not in line
    ]
    assert not places, "ask coursekit.systems.shell_spelling in:\n" + "\n".join(places)
