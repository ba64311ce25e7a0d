"""The words of a magic: a path of Windows stays as it is written."""

from pathlib import PureWindowsPath

from coursekit.lab import magics
from coursekit.lab.magics import _read
from coursekit.processes.session import Session
from coursekit.systems import operating_system


def test_a_windows_path_keeps_its_backslashes(monkeypatch):
    monkeypatch.setattr(operating_system, "WINDOWS", True)
    options, words, background = _read(r"--workspace C:\Users\vera\ws run demo node C:\Users\vera\new.yaml &")
    assert options == {"workspace": r"C:\Users\vera\ws"}
    assert words == ["run", "demo", "node", r"C:\Users\vera\new.yaml"]
    assert background


def test_the_folder_of_the_course_is_short_also_where_a_path_stands_in_a_repr(monkeypatch):
    course = PureWindowsPath(r"C:\Users\vera\course")
    monkeypatch.setattr(magics, "workspace", lambda: course / "ros2_ws")
    with Session(virtual=True).use():
        said = magics._without_folders(f"{course}\\map.yaml filename={str(course / 'map')!r}\n")
    assert said == "~\\map.yaml filename='~\\\\map'\n"
