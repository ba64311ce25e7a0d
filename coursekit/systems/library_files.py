"""Which files are those of Python, of installed libraries and of this package: all others are a program's."""

from __future__ import annotations

import os
import site
import sysconfig
from pathlib import Path


def _folders() -> list[str]:
    kinds = ("stdlib", "platstdlib", "purelib", "platlib")
    installed = [*site.getsitepackages(), site.getusersitepackages()]
    return [*(sysconfig.get_path(kind) for kind in kinds), *installed, str(Path(__file__).parents[1])]


def _in_one_form(path: str) -> str:
    return os.path.normcase(os.path.join(os.path.realpath(path), ""))


FOLDERS = tuple({_in_one_form(folder) for folder in _folders()})
"""The folders, in one form: with their links followed, and a separator at their ends."""


def is_library_file(file: str) -> bool:
    """Return whether a file belongs to Python, to an installed library or to this package.

    >>> is_library_file(os.__file__), is_library_file("/home/vera/ros2_ws/src/talker/talker.py"), is_library_file("<string>")
    (True, False, False)
    """
    return os.path.isabs(file) and _in_one_form(file).startswith(FOLDERS)
