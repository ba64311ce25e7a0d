"""What is lent to libraries at their import."""

import subprocess
import sys

import pytest

FIRST = """
from coursekit.processes.session import Session
with Session(virtual=True).use():
    import {helper}
    import {library} as library
    print(library.{function}.__module__)
"""


@pytest.mark.parametrize(
    ("helper", "library", "function"),
    [
        ("coursekit.view.plots", "matplotlib.pyplot", "show"),
        ("coursekit.view.highgui", "cv2", "VideoCapture"),
        ("os", "matplotlib.pyplot", "show"),
    ],
)
def test_a_hand_is_lent_whichever_comes_first(helper: str, library: str, function: str) -> None:
    code = FIRST.format(helper=helper, library=library, function=function)
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, encoding="utf-8")
    assert done.stdout.startswith("coursekit.view."), done.stderr


NESTED = """
import rclpy
import cv2
from coursekit.view import region_selection
print(region_selection.cv2 is cv2)
"""


def test_a_library_that_imports_a_part_under_its_own_name_is_helped_once_it_is_whole():
    done = subprocess.run([sys.executable, "-c", NESTED], capture_output=True, encoding="utf-8")
    assert done.stdout.split() == ["True"], done.stderr
