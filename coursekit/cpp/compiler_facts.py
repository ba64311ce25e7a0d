"""What CMake learned of the compiler when the runtime was built: packages use that instead of examining it again."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

from coursekit.cpp.cmake_cache import cache_entry

FACTS = "facts.cmake"
_TOOL = re.compile(r"^(CMAKE_\w+):(?:FILEPATH=(.*)|INTERNAL=(ELF|MACHO|XCOFF))$", re.M)
"""An entry of CMake's cache: a tool such as nm or strip, or the format of executables."""
_KEEPS = "CMAKE_PLATFORM_INFO_INITIALIZED"
"""CMake deletes what it knows of a compiler from a folder in which this is not set."""


def keep_facts(build: Path, folder: Path) -> None:
    """Copy to a folder what CMake learned of the compiler of a build."""
    folder.mkdir()
    for path in build.glob("CMakeFiles/*/CMake*Compiler.cmake"):
        kept = folder / path.parent.name
        kept.mkdir(exist_ok=True)
        shutil.copy(path, kept)
    told = cache_entry(_KEEPS, "1", "INTERNAL") + tools_of((build / "CMakeCache.txt").read_text(encoding="utf-8"))
    (folder / FACTS).write_text(told, encoding="utf-8")


def tools_of(cache: str) -> str:
    """Return CMake's commands that set the tools named by a cache; the compiler is named elsewhere.

    >>> tools_of("CMAKE_NM:FILEPATH=/usr/bin/nm\\nCMAKE_C_COMPILER:FILEPATH=/usr/bin/gcc")
    'set(CMAKE_NM [=[/usr/bin/nm]=] CACHE INTERNAL "" FORCE)\\n'
    """
    told = {name: tool or form for name, tool, form in _TOOL.findall(cache) if not name.endswith(("_COMPILER", "_PROGRAM"))}
    return "".join(cache_entry(name, value, "INTERNAL") for name, value in told.items())


def reuse_facts(folder: Path, build: Path) -> list[str]:
    """Copy what was kept to a folder that CMake has not configured yet; return CMake's words for using it."""
    if not (build / "CMakeCache.txt").exists():
        shutil.copytree(folder, build / "CMakeFiles", dirs_exist_ok=True, ignore=shutil.ignore_patterns(FACTS))
    return ["-C", (folder / FACTS).as_posix()]
