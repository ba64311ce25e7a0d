"""The tools that compile C++ programs: a compiler, CMake and a build tool, from the system or from `coursekit[cpp]`."""

from __future__ import annotations

import importlib.util
import os
import platform
import shutil
import subprocess
import sys
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from coursekit.systems import operating_system

MISSING = "there is no {what} here: `pip install \"coursekit[cpp]\"` brings all that C++ needs"
_SYSTEMS = {"windows": "Windows", "macos": "Darwin", "linux": "Linux"}
"""CMake's names of operating systems, by zig's."""
_COMPILERS = (("g++", "gcc"), ("clang++", "clang"), ("c++", "cc"))
_FOR_WINDOWS = "x86_64-windows-gnu"
_LIBRARY = "<CMAKE_AR> ar rcs <TARGET> <LINK_FLAGS> <OBJECTS>"
"""zig's command to create a static library with its index, in CMake's syntax: all of zig's tools are in one program."""


class NoToolchain(RuntimeError):
    """C++ cannot be compiled here; the message gives the command to install the tools."""


@dataclass(frozen=True)
class Toolchain:
    """Commands to compile C++ and C, create libraries, configure and build."""

    cxx: tuple[str, ...]
    cc: tuple[str, ...]
    archiver: str | None
    """zig if it also creates the libraries; None if CMake finds an archiver itself."""
    cmake: str
    ninja: str | None
    """None if make is used instead."""
    system: str | None = None
    """CMake's name of the target system, if it differs from this one."""

    def defines(self) -> dict[str, str]:
        """Return CMake's variables for these tools."""
        told = {"CMAKE_CXX_COMPILER": _listed(self.cxx), "CMAKE_C_COMPILER": _listed(self.cc)}
        if self.archiver:
            told["CMAKE_AR"] = Path(self.archiver).as_posix()
            told |= dict.fromkeys(("CMAKE_C_CREATE_STATIC_LIBRARY", "CMAKE_CXX_CREATE_STATIC_LIBRARY"), _LIBRARY)
        if self.ninja:
            told["CMAKE_MAKE_PROGRAM"] = Path(self.ninja).as_posix()
        if self.system:
            told["CMAKE_SYSTEM_NAME"] = self.system
        return told

    @property
    def ctest(self) -> str:
        """The test runner beside CMake."""
        return str(Path(self.cmake).with_stem("ctest"))

    @property
    def lends_library(self) -> bool:
        """Whether programs must share their C++ library with the libraries that they load: zig's, on Linux."""
        return self.archiver is not None and self.system is None and sys.platform == "linux"

    @property
    def generator(self) -> str:
        """CMake's name of the build tool."""
        return "Ninja" if self.ninja else "Unix Makefiles"


@cache
def find_toolchain() -> Toolchain:
    """Return the tools of this computer: the system's compiler first, else zig's from PyPI; on Windows always zig's.

    Raises NoToolchain if any are missing.
    """
    cmake, ninja = _program("cmake", "CMAKE_BIN_DIR"), _program("ninja", "BIN_DIR")
    if cmake is None:
        raise NoToolchain(MISSING.format(what="CMake"))
    if ninja is None and (operating_system.WINDOWS or shutil.which("make") is None):
        raise NoToolchain(MISSING.format(what="ninja" if operating_system.WINDOWS else "ninja or make"))
    for cxx, cc in () if operating_system.WINDOWS else _COMPILERS:  # a program named g++ there may be anything
        if compiler := shutil.which(cxx):
            return Toolchain((compiler,), (shutil.which(cc) or compiler,), None, cmake, ninja)
    zig = _zig()
    if zig is None:
        raise NoToolchain(MISSING.format(what="C++ compiler"))
    return _of_zig(zig, cmake, ninja, _own_target())


def cross_toolchain(target: str) -> Toolchain:
    """Return zig's tools for another target, such as x86_64-windows-gnu or aarch64-macos. Raises NoToolchain."""
    zig, cmake = _zig(), _program("cmake", "CMAKE_BIN_DIR")
    if zig is None or cmake is None:
        raise NoToolchain(MISSING.format(what="zig" if zig is None else "CMake"))
    system = next(name for word, name in _SYSTEMS.items() if word in target)
    return _of_zig(zig, cmake, _program("ninja", "BIN_DIR"), target, system)


def _own_target() -> str | None:
    """Return zig's name of this computer's target; None if zig detects it itself."""
    if operating_system.WINDOWS:
        return _FOR_WINDOWS
    return f"{platform.machine()}-linux-gnu.2.28" if sys.platform == "linux" else None


def _of_zig(zig: str, cmake: str, ninja: str | None, target: str | None, system: str | None = None) -> Toolchain:
    flags = ["-target", target] if target else []
    flags.append("-fno-sanitize=undefined")  # code that would trap continues under g++
    return Toolchain((zig, "c++", *flags), (zig, "cc", *flags), zig, cmake, ninja, system)


def _listed(command: tuple[str, ...]) -> str:
    """Format a program and its arguments for CMake.

    >>> _listed(("/opt/zig", "c++", "-g"))
    '/opt/zig;c++;-g'
    """
    return ";".join((Path(command[0]).as_posix(), *command[1:]))


def _program(name: str, folder: str) -> str | None:
    """Return a program of the system, else of the wheel with that name."""
    program = shutil.which(name)
    if program is None and importlib.util.find_spec(name) is not None:
        module = importlib.import_module(name)
        program = shutil.which(name, path=str(getattr(module, folder, "")))
    return program


def _zig() -> str | None:
    spec = importlib.util.find_spec("ziglang")
    if spec is None or not spec.submodule_search_locations:
        return None
    return shutil.which("zig", path=str(Path(spec.submodule_search_locations[0])))


def cache_folder() -> Path:
    """Return the user's cache folder: COURSEKIT_CACHE, else the system's usual one."""
    told = os.environ.get("COURSEKIT_CACHE")
    if told:
        return Path(told)
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", Path.home() / "AppData" / "Local")) / "coursekit" / "cache"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "coursekit"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "coursekit"


@cache
def version_of(command: tuple[str, ...]) -> str:
    """Return a compiler's version text, to distinguish it from others."""
    done = subprocess.run([*command, "--version"], capture_output=True, encoding="utf-8", errors="replace", check=False)
    return f"{' '.join(command)}\n{done.stdout}"


__all__ = ["NoToolchain", "Toolchain", "cache_folder", "cross_toolchain", "find_toolchain", "version_of"]
