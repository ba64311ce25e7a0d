"""Has setuptools install every module again: it compares times in whole seconds.

A cell that changes a file may run in the same second as the one before it; bytecode is known by the second, and by the size.
"""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

from coursekit.files import read_text


def outdate(build: Path, install: Path) -> None:
    """Make what the last build of a package installed look old, and take its bytecode away.

    Args:
        build: the package's folder below build/; setuptools has written there what it installed.
        install: the package's folder below install/; what lies elsewhere stays as it is.
    """
    try:
        installed = read_text(build / "install.log").splitlines()
    except (OSError, ValueError):
        return
    root = Path(os.path.abspath(install))
    for path in map(Path, installed):
        if root in path.parents and ".." not in path.parts and not path.is_symlink():
            with contextlib.suppress(OSError):
                path.unlink() if path.suffix == ".pyc" else os.utime(path, (0, 0))


__all__ = ["outdate"]
