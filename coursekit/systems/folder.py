"""The working folder, even if it was removed while a program runs in it."""

from __future__ import annotations

import os


def working_folder() -> str:
    """Return the working folder; if it was removed, its former path, where it may be created again.

    >>> working_folder() == os.getcwd()
    True
    """
    try:
        return os.getcwd()
    except FileNotFoundError:
        name = os.environ.get("PWD", "")
        return name if os.path.isabs(name) else os.path.abspath(os.sep)
