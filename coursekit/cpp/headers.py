"""Writes the C++ and C headers of interfaces: `python -m coursekit.cpp.headers FOLDER [PACKAGE ...]`, else all of them."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from pathlib import Path

from coursekit.files import read_text
from coursekit.interfaces.c_source import c_headers
from coursekit.interfaces.cpp_source import header, header_name, inner_headers
from coursekit.interfaces.find import KINDS, interfaces_of, known_interfaces
from coursekit.interfaces.registry import interface_of


def write_headers(folder: Path, names: Iterable[str]) -> list[Path]:
    """Write `folder/package/kind/name.hpp`, and `.h`, for each interface; unchanged files are not rewritten."""
    written = []
    for full_name in names:
        package, kind, name = full_name.split("/")
        path = folder / package / kind / f"{header_name(name)}.hpp"
        interface = interface_of(full_name)
        _write(path, header(interface, kind))
        for inner, text in {**inner_headers(package, kind, name), **c_headers(interface, kind)}.items():
            _write(folder / inner, text)
        written.append(path)
    return written


def _write(path: Path, text: str) -> None:
    if not path.is_file() or read_text(path) != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def names_in(package: str) -> list[str]:
    """Return the full names of a package's interfaces."""
    return [f"{package}/{kind}/{name}" for kind in KINDS for name in interfaces_of(package, kind)]


def main(words: list[str]) -> int:
    """Run a command line; return the exit code."""
    folder, *packages = words
    names = [name for package in packages for name in names_in(package)] if packages else known_interfaces()
    print(len(write_headers(Path(folder), names)))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
