"""Which state of the runtime a compiled program or library was made for: one of another state speaks another language."""

from __future__ import annotations

import hashlib
import mmap
from pathlib import Path

from coursekit.files import in_order, read_bytes

MARK = b"coursekit-runtime:"
"""The mark before the key in every program and every library that is loaded; `src/link.cpp` has it, too."""
_LENGTH = 16
_ROOM = Path(__file__).parent


def runtime_key() -> str:
    """A text that changes with the runtime's headers and sources."""
    seen = hashlib.sha256()
    for folder in ("include", "src"):
        for path in in_order(path for path in (_ROOM / folder).rglob("*") if path.is_file()):
            seen.update(path.relative_to(_ROOM).as_posix().encode() + b"\0" + read_bytes(path))
    return seen.hexdigest()[:_LENGTH]


def age_source() -> str:
    """C++ that puts the mark and the key into a library."""
    declared = 'extern "C" {extern __attribute__((visibility("default"))) const char coursekit_age[];}'
    return f'{declared}\nconst char coursekit_age[] = "{MARK.decode()}{runtime_key()}";\n'


def is_of_another_age(program: Path) -> bool:
    """Whether a program that was built here has another runtime than this one, or does not say which."""
    with open(program, "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
        at = data.find(MARK)
        found = data[at + len(MARK) : at + len(MARK) + _LENGTH] if at >= 0 else b""
    return found != runtime_key().encode()
