"""The words of a magic: a path of Windows stays as it is written."""

from coursekit.lab.magics import _read
from coursekit.systems import which


def test_a_windows_path_keeps_its_backslashes(monkeypatch):
    monkeypatch.setattr(which, "WINDOWS", True)
    options, words, background = _read(r"--workspace C:\Users\vera\ws run demo node C:\Users\vera\new.yaml &")
    assert options == {"workspace": r"C:\Users\vera\ws"}
    assert words == ["run", "demo", "node", r"C:\Users\vera\new.yaml"]
    assert background
