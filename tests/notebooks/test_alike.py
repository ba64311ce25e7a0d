"""Outputs are compared as they are on Linux, and a wrong one stays wrong."""

import pytest

from .alike import alike


@pytest.mark.parametrize(
    ("here", "there"),
    [
        ("creating folder .\\p\\src", "creating folder ./p/src"),
        ("WindowsPath('C:\\\\Users\\\\vera\\\\map.yaml')", "WindowsPath('/Users/vera/map.yaml')"),
        ("[camera_exe.exe-1]: process started", "[camera_exe-1]: process started"),
        ("install\\s2\\Lib\\site-packages\\s2", "install/s2/lib/python3.11/site-packages/s2"),
        ("ros2 lies in the folder Scripts", "ros2 lies in the folder bin"),
        ("a\r\nb", "a\nb"),
    ],
)
def test_what_differs_by_system_only_is_alike(here, there):
    assert alike(here) == alike(there)


@pytest.mark.parametrize(("one", "other"), [("points 340", "points 343"), ("a/b", "a/c"), ("x.exec", "x"), ("/a: 1", "/b: 1")])
def test_what_differs_otherwise_is_not(one, other):
    assert alike(one) != alike(other)
