"""Outputs are compared as they are on Linux, and a wrong one stays wrong."""

import nbformat
import pytest

from coursekit.interfaces.find import UNDERLAY

from .alike import Output, alike
from .store import WIDGET, number_widgets


@pytest.mark.parametrize(
    ("here", "there"),
    [
        ("creating folder .\\p\\src", "creating folder ./p/src"),
        ("WindowsPath('C:\\\\Users\\\\vera\\\\map.yaml')", "WindowsPath('/Users/vera/map.yaml')"),
        ("[camera_exe.exe-1]: process started", "[camera_exe-1]: process started"),
        ("install\\s2\\Lib\\site-packages\\s2", "install/s2/lib/python3.11/site-packages/s2"),
        ("ros2 lies in the folder Scripts", "ros2 lies in the folder bin"),
        ("a\r\nb", "a\nb"),
        (f"searching: {[str(UNDERLAY)]}", "searching: ['<underlay>']"),
        ("there is no file \\\\meshes\\cone.stl\\", "there is no file /cone.stl"),
    ],
)
def test_what_differs_by_system_only_is_alike(here, there):
    assert alike(here) == alike(there)


@pytest.mark.parametrize(
    ("one", "other"), [("points 340", "points 343"), ("a/b", "a/c"), ("x.exec", "x"), ("/a: 1", "/b: 1")]
)
def test_what_differs_otherwise_is_not(one, other):
    assert alike(one) != alike(other)


@pytest.mark.parametrize(
    ("here", "there"),
    [
        ("x: 0.14222430938558392\ny: 1.0", "x: 0.1422243093855839\ny: 1.0"),
        ("[-1.4142135623730951e-05]", "[-1.414213562373095e-05]"),
        ("1.1102230246251565e-16", "0.0"),
    ],
)
def test_long_numbers_may_be_rounded_otherwise(here, there):
    assert Output(here) == Output(there)


@pytest.mark.parametrize(
    ("one", "other"),
    [("1.25", "1.26"), ("0.14222430938558392", "0.14222430948558392"), ("x: 1.0", "y: 1.0"), ("1.0 2.0", "1.0"), ("3", "4")],
)
def test_what_a_reader_would_see_is_a_difference(one, other):
    assert Output(one) != Output(other)


def test_widgets_of_stored_outputs_are_the_same_every_time():
    def stored(model_id):
        output = nbformat.v4.new_output("display_data", {WIDGET: {"model_id": model_id}})
        cell = nbformat.v4.new_code_cell(id="abc", outputs=[output])
        notebook = nbformat.v4.new_notebook(cells=[cell])
        number_widgets(notebook)
        return notebook

    assert stored("one") == stored("another")
