"""Commands with a prefix before an executable of a package: `nice -n 5 PATH`, `gdb --args PATH`."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from pathlib import Path

from coursekit.interfaces.find import UNDERLAY

from .executables import is_python
from .script import names_python

_OUT_OF_REACH = ("chrt", "ionice", "nice", "stdbuf", "taskset", "time")


def is_package_executable(path: str) -> bool:
    """Whether a path is `<prefix>/lib/<package>/<executable>` in a prefix with an ament index."""
    if not os.path.isabs(path) or not os.path.isfile(path):
        return False
    folder = Path(path).parent
    prefix = folder.parent.parent
    return folder.parent.name == "lib" and (prefix / "share" / folder.name).is_dir()


def prefixed(command: Sequence[str]) -> list[str]:
    """Return the command in a form that can be executed here.

    A Python executable of a package runs inside the session, where priorities and buffers of system processes cannot be
    set: such prefixes are dropped. With any other prefix (a debugger, a profiler) the interpreter is inserted if the file
    does not name one.

    >>> prefixed(["nice", "-n", "3", "ls"])
    ['nice', '-n', '3', 'ls']
    """
    words = list(command)
    at = next((at for at, word in enumerate(words) if is_package_executable(word)), 0)
    if not at or not is_python(Path(words[at])):
        return words
    if os.path.basename(words[0]) in _OUT_OF_REACH:
        return words[at:]
    if UNDERLAY in Path(words[at]).parents and not any(names_python(word) for word in words[:at]):
        words.insert(at, sys.executable)
    return words
