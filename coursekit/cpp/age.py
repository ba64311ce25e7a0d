"""The version of the runtime for which a program or library was compiled: versions do not share a protocol."""

from __future__ import annotations

import hashlib
import mmap
from functools import cache
from pathlib import Path

from coursekit.files import in_order, read_bytes

MARK = b"coursekit-runtime:"
"""The mark before the key in every program and every loadable library; `src/link.cpp` has it, too."""
_LENGTH = 16
_ROOM = Path(__file__).parent


@cache
def runtime_key() -> str:
    """Return a hash of the runtime's headers and sources, as they are when it is first asked for.

    A process goes on with the code that it was started with, whatever is installed meanwhile; and each start of a node
    asks, which would take 20 ms.
    """
    seen = hashlib.sha256()
    for folder in ("include", "src"):
        for path in in_order(path for path in (_ROOM / folder).rglob("*") if path.is_file()):
            seen.update(path.relative_to(_ROOM).as_posix().encode() + b"\0" + read_bytes(path))
    return seen.hexdigest()[:_LENGTH]


def age_source() -> str:
    """Return C++ source that puts the mark and the key into a library."""
    declared = 'extern "C" {extern __attribute__((visibility("default"))) const char coursekit_age[];}'
    return f'{declared}\nconst char coursekit_age[] = "{MARK.decode()}{runtime_key()}";\n'


def is_of_another_age(program: Path) -> bool:
    """Whether a program built here has a different runtime, or does not name one."""
    with open(program, "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
        at = data.find(MARK)
        key = data[at + len(MARK) : at + len(MARK) + _LENGTH] if at >= 0 else b""
    return key != runtime_key().encode()
