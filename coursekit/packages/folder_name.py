"""Folder names that a workspace cannot have."""

from __future__ import annotations

import os
from pathlib import Path

_NEVER = {
    ":": "separates folders in PATH, PYTHONPATH and AMENT_PREFIX_PATH",
    ";": "separates words in colcon's files",
    "\n": "ends a line in colcon's files",
    "\r": "ends a line in colcon's files",
}
_SHOWN = {"\n": "a line break", "\r": "a line break"}


def refusal(folder: Path) -> str:
    """Return why a folder cannot contain a workspace, with the remedy; '' if it can.

    >>> refusal(Path("/home/ada/ros2:ws"))
    "No workspace can be in '/home/ada/ros2:ws': ':' separates folders in PATH, ... Rename the folder without it."
    >>> refusal(Path("/home/José Luis/my $(ws)"))
    ''
    """
    name = str(folder.relative_to(folder.anchor))  # without a drive's colon
    for sign, why in _NEVER.items():
        if sign in name and not (os.sep == "\\" and sign == ":"):
            what = _SHOWN.get(sign, repr(sign))
            return f"No workspace can be in {str(folder)!r}: {what} {why}. Rename the folder without it."
    return ""


def cpp_refusal(*folders: Path) -> str:
    """Return why no C++ can be compiled in one of these folders, with the remedy; '' if it can.

    >>> print(cpp_refusal(Path("/home/ada/src"), Path('/home/ada/my "build"')))
    no C++ can be compiled in '/home/ada/my "build"': CMake does not read '"' in the name of a folder, so rename it
    >>> cpp_refusal(Path("/home/José Luis/$(ws) 'x' %d"))
    ''
    """
    for folder in folders:
        for sign in '"\\'.replace(os.sep, ""):
            if sign in str(folder):
                why = f"CMake does not read {sign!r} in the name of a folder, so rename it"
                return f"no C++ can be compiled in {str(folder)!r}: {why}"
    return ""
