"""The program run by rosidl_generate_interfaces() in a CMakeLists.txt.

`python -m coursekit.packages.generate_interfaces PACKAGE FOLDER --dependencies ... --files ...` writes FOLDER/include (the
C++ headers), FOLDER/python (the Python package), FOLDER/share (IDL files translated to .msg, .srv and .action) and
FOLDER/index (the ament index). Where ROS would fail, it prints the reason.
"""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

from coursekit.files import read_text
from coursekit.interfaces.errors import InterfaceError
from coursekit.interfaces.idl import definition_file, is_translated
from coursekit.interfaces.stubs import package_stubs
from coursekit.packages import interface_rules


def main(words: list[str]) -> int:
    """Run a command line; return the exit code."""
    args = _parsed(words)
    prefixes = [Path(folder) for folder in os.environ.get("AMENT_PREFIX_PATH", "").split(os.pathsep) if folder]
    try:
        files = [definition_file(path) for path in args.files]
        problems = interface_rules.field_problems(args.package, files, args.dependencies, prefixes)
        if not problems:
            generate(args.package, args.folder, files)
    except (InterfaceError, OSError) as error:
        problems = [error]
    for problem in problems:
        print(problem, file=sys.stderr)
    return int(bool(problems))


def _parsed(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="generate_interfaces")
    parser.add_argument("package")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--dependencies", nargs="*", default=[])
    parser.add_argument("--files", nargs="*", default=[], type=Path)
    return parser.parse_args(words)


def generate(package: str, folder: Path, files: list[Path]) -> None:
    """Write the headers, the Python package and the index entry for a package's definition files."""
    for name, text in interface_rules.cpp_files(package, files).items():
        _write(folder / "include" / name, text)
    text_by_name = {**interface_rules.python_files(package, files), **package_stubs(package, files)}
    for name, text in text_by_name.items():
        _write(folder / "python" / name, text)
    (folder / "share").mkdir(parents=True, exist_ok=True)
    for path in filter(is_translated, files):
        _write(folder / "share" / path.suffix[1:] / path.name, read_text(path))
    listed = "".join(f"{path.suffix[1:]}/{path.name}\n" for path in files)
    _write(folder / "index" / "rosidl_interfaces" / package, listed)


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.is_file() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
