"""Symbolic links: Windows gives them to administrators and in its developer mode only."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path


def can_link(folder: Path) -> bool:
    """Whether this user may make symbolic links that work, in the folder or in the nearest one above it that exists.

    >>> can_link(Path(tempfile.gettempdir()) / "not" / "there")
    True
    """
    while not folder.is_dir() and folder != folder.parent:
        folder = folder.parent
    try:
        with tempfile.TemporaryDirectory(dir=folder, prefix=".link") as trial:
            Path(trial, "file").touch()
            os.symlink(Path(trial, "file"), Path(trial, "link"))
            return Path(trial, "link").is_file()  # some file systems take links that lead nowhere
    except (OSError, NotImplementedError):
        return False


__all__ = ["can_link"]
