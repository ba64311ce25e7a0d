"""zig's C++ library with its symbols visible: a program can then share it with the libraries that it loads at run time.

zig links its own C++ library, with hidden symbols, into every program and every library. An exception type then has two
addresses, and exceptions from a loaded library are never caught. With only the program's copy, there is one address.
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
    """Write zig's libc++.a and libc++abi.a for these tools, with visible symbols, to a folder.

    Raises:
        OSError, subprocess.CalledProcessError: when zig cannot link, or does not report these libraries.
    """
    for path in _linked_by(tools):
        (folder / path.name).write_bytes(visible_archive(read_bytes(path)))


def _linked_by(tools: Toolchain) -> list[Path]:
    """Return zig's own library files, which it builds when it links for the first time."""
    with tempfile.TemporaryDirectory() as name:
        source = Path(name, "empty.cpp")
        source.write_text("int main() {}\n", encoding="utf-8")
        command = [*tools.cxx, "-v", str(source), "-o", str(Path(name, "empty"))]
        told = subprocess.run(command, cwd=name, capture_output=True, encoding="utf-8", errors="replace", check=True).stderr
    return [_file_in(told, part) for part in PARTS]


def _file_in(told: str, name: str) -> Path:
    """Find a file by name in a command line that zig does not quote: folder names may contain spaces."""
    for end in (match.end() for match in re.finditer(rf"/{re.escape(name)}(?=\s|$)", told)):
        for start in reversed([match.start() for match in re.finditer(r"(?<!\S)/", told[:end])]):
            if (path := Path(told[start:end])).is_file():
                return path
    raise FileNotFoundError(f"zig names no {name} among what it links")


def visible_archive(data: bytes) -> bytes:
    """Return an `ar` archive with all hidden global symbols in its 64-bit ELF members made visible.

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
    """Make the global symbols of an object file visible, in place."""
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
