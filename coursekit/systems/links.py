"""Symbolic links: on Windows only administrators and developer mode may create them."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path


def can_link(folder: Path) -> bool:
    """Whether this user can create working symbolic links in the folder, or in its nearest existing parent.

    >>> can_link(Path(tempfile.gettempdir()) / "not" / "there")
    True
    """
    while not folder.is_dir() and folder != folder.parent:
        folder = folder.parent
    try:
        with tempfile.TemporaryDirectory(dir=folder, prefix=".link") as trial:
            Path(trial, "file").touch()
            os.symlink(Path(trial, "file"), Path(trial, "link"))
            return Path(trial, "link").is_file()  # some file systems accept links that do not work
    except (OSError, NotImplementedError):
        return False


__all__ = ["can_link"]
