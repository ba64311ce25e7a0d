"""`file://` on Windows: a drive's letter has no slash before it, and a computer's name has two."""

import pytest

from coursekit.systems import operating_system
from coursekit.systems.uris import path_of
from coursekit.urdf.resources import find_file


@pytest.mark.parametrize(
    ("uri", "path"),
    [
        ("file:///C:/Users/Jos%C3%A9/arm.stl", "C:/Users/Jos%C3%A9/arm.stl"),
        ("file:///d:/a b.stl", "d:/a b.stl"),
        ("file://server/share/arm.stl", "//server/share/arm.stl"),
        ("file:///no/drive", "/no/drive"),
        ("file://C:/Users/vera/arm.stl", "C:/Users/vera/arm.stl"),
    ],
)
def test_on_windows_a_file_is_where_its_uri_says(monkeypatch, uri, path):
    monkeypatch.setattr(operating_system, "WINDOWS", True)
    assert path_of(uri).as_posix() == path


def test_on_linux_a_colon_is_part_of_a_name(monkeypatch):
    monkeypatch.setattr(operating_system, "WINDOWS", False)
    assert path_of("file:///C:/arm.stl").as_posix() == "/C:/arm.stl"


@pytest.mark.parametrize("name", ["arm.stl", "two words.stl", "half%20done.stl", "ñ #1.stl"])
def test_a_file_is_found_by_the_uri_that_python_gives_it_and_by_its_plain_name(tmp_path, name):
    file = tmp_path / name
    file.touch()
    for uri in (file.as_uri(), f"file://{'/' if operating_system.WINDOWS else ''}{file.as_posix()}"):
        assert find_file(uri).samefile(file)
