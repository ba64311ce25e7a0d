"""Commands of a CMakeLists.txt that only CMake itself can execute: they are never silently ignored."""

from __future__ import annotations

from coursekit.packages.cmake_text import CMakeError, Command
from coursekit.systems import shell_spelling

_COMMANDS = {
    "add_custom_command", "add_custom_target", "break", "cmake_language", "cmake_parse_arguments", "cmake_path",
    "configure_file", "continue", "execute_process", "find_file", "find_path", "find_program", "get_directory_property",
    "get_filename_component", "get_property", "math", "separate_arguments", "set_property", "string", "while",
}  # fmt: skip
"""Commands that may affect the rest of a file."""
_LISTS = {"APPEND", "PREPEND", "REMOVE_ITEM", "REMOVE_DUPLICATES"}
_FILES = {"GLOB", "GLOB_RECURSE"}
_MODULES = {"GNUInstallDirs", "CTest", "CMakePackageConfigHelpers"}
"""CMake modules that do not affect the installed files."""


class NeedsCMake(CMakeError):
    """A command that only CMake can execute."""

    def __init__(self, command: Command, what: str) -> None:
        where = f"needs CMake itself, which is not here: {shell_spelling.install('coursekit[cpp]')} brings it"
        super().__init__(f"{what} {where}", command.file, command.line)


def demand(command: Command, words: list[str]) -> None:
    """Raise NeedsCMake if a command is one of those.

    >>> from pathlib import Path
    >>> from coursekit.packages.cmake_text import parse_commands
    >>> (command,) = parse_commands("file(DOWNLOAD url x)", Path("CMakeLists.txt"))
    >>> demand(command, ["DOWNLOAD", "url", "x"])  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    coursekit.packages.cmake_beyond.NeedsCMake: CMakeLists.txt:1: file(DOWNLOAD ...) needs CMake itself...
    """
    name, first = command.name, (words or [""])[0]
    if name in _COMMANDS:
        raise NeedsCMake(command, f"{name}()")
    if (name == "list" and first not in _LISTS) or (name == "file" and first not in _FILES):
        raise NeedsCMake(command, f"{name}({first} ...)")
    if name == "foreach" and words[1:2] and words[1] in ("RANGE", "IN") and {"RANGE", "ZIP_LISTS"} & set(words):
        raise NeedsCMake(command, "foreach() with RANGE or ZIP_LISTS")
    if name == "include" and first not in _MODULES:
        raise NeedsCMake(command, f"include({first})")
