"""The working folder, also where somebody removed it while a program runs in it."""

from __future__ import annotations

import os


def working_folder() -> str:
    """The working folder; where it was removed its name, under which it may be made again.

    >>> working_folder() == os.getcwd()
    True
    """
    try:
        return os.getcwd()
    except FileNotFoundError:
        name = os.environ.get("PWD", "")
        return name if os.path.isabs(name) else os.path.abspath(os.sep)
