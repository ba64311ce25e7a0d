"""zig's C++ library with its names visible, so that a program can lend it to the libraries that it loads while it runs.

zig links a C++ library of its own, with hidden names, into every program and every library. A type of exception then has two
addresses, and what a loaded library throws is caught nowhere. With one copy, the program's, there is one address.
"""

from __future__ import annotations

import re
import subprocess
import tempfile
from pathlib import Path

from coursekit.cpp.toolchain import Toolchain
from coursekit.files import read_bytes

PARTS = ("libc++.a", "libc++abi.a")
_SIGNATURE, _HEADER = b"!<arch>\n", 60
_SYMBOLS, _SYMBOL = 2, 24
_GLOBAL, _WEAK, _HIDDEN, _VISIBILITY = 1, 2, 2, 3


def write_visible(folder: Path, tools: Toolchain) -> None:
    """Write zig's libc++.a and libc++abi.a, made for these tools, with visible names into a folder.

    Raises:
        OSError, subprocess.CalledProcessError: when zig cannot link, or names no such library.
    """
    for path in _linked_by(tools):
        (folder / path.name).write_bytes(visible_archive(read_bytes(path)))


def _linked_by(tools: Toolchain) -> list[Path]:
    """zig's own files of the library, which it makes when it links for the first time."""
    with tempfile.TemporaryDirectory() as name:
        source = Path(name, "empty.cpp")
        source.write_text("int main() {}\n", encoding="utf-8")
        command = [*tools.cxx, "-v", str(source), "-o", str(Path(name, "empty"))]
        told = subprocess.run(command, cwd=name, capture_output=True, encoding="utf-8", errors="replace", check=True).stderr
    return [_file_in(told, part) for part in PARTS]


def _file_in(told: str, name: str) -> Path:
    """The file of a name among the words of a command, which zig does not quote: a folder's name may have spaces."""
    for end in (found.end() for found in re.finditer(rf"/{re.escape(name)}(?=\s|$)", told)):
        for start in reversed([found.start() for found in re.finditer(r"(?<!\S)/", told[:end])]):
            if (path := Path(told[start:end])).is_file():
                return path
    raise FileNotFoundError(f"zig names no {name} among what it links")


def visible_archive(data: bytes) -> bytes:
    """An `ar` archive in whose 64-bit ELF members no global name is hidden any more.

    >>> visible_archive(b"!<arch>\\n")
    b'!<arch>\\n'
    """
    if not data.startswith(_SIGNATURE):
        raise ValueError("this is no archive of object files")
    changed, at = bytearray(data), len(_SIGNATURE)
    while at + _HEADER <= len(data):
        begin = at + _HEADER
        end = begin + int(data[at + 48 : at + 58])
        if data[begin : begin + 4] == b"\x7fELF":
            _show_names(memoryview(changed)[begin:end])
        at = end + end % 2
    return bytes(changed)


def _show_names(member: memoryview) -> None:
    """Make the global names of an object file visible, in place."""
    sections, size, count = _number(member, 40, 8), _number(member, 58, 2), _number(member, 60, 2)
    for header in range(sections, sections + size * count, size):
        if _number(member, header + 4, 4) == _SYMBOLS:
            begin, length = _number(member, header + 24, 8), _number(member, header + 32, 8)
            for symbol in range(begin, begin + length, _SYMBOL):
                if member[symbol + 4] >> 4 in (_GLOBAL, _WEAK) and member[symbol + 5] & _VISIBILITY == _HIDDEN:
                    member[symbol + 5] &= ~_VISIBILITY & 0xFF


def _number(member: memoryview, at: int, length: int) -> int:
    return int.from_bytes(member[at : at + length], "little")


__all__ = ["PARTS", "visible_archive", "write_visible"]
