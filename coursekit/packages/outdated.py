"""Makes setuptools install every module again, since it compares times in whole seconds.

A cell that changes a file may run in the same second as the one before; bytecode is identified by second and size.
"""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

from coursekit.files import read_text


def outdate(build: Path, install: Path) -> None:
    """Make the files installed by the last build of a package look old, and remove their bytecode.

    Args:
        build: the package's folder below build/, with setuptools' list of installed files.
        install: the package's folder below install/; files elsewhere are not changed.
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
