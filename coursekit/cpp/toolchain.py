"""The tools that make programs of C++: a compiler, CMake and what runs the build, of the system or from `coursekit[cpp]`."""

from __future__ import annotations

import importlib.util
import os
import platform
import shlex
import shutil
import subprocess
import sys
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from coursekit.files import read_text, write_whole
from coursekit.systems import which

MISSING = "there is no {what} here: `pip install \"coursekit[cpp]\"` brings all that C++ needs"
ON_WINDOWS = (
    "C++ is not compiled on Windows, where only Python runs; in WSL it is: type `wsl --install`, and set the course up "
    "there as the README says for Ubuntu"
)
_SYSTEMS = {"windows": "Windows", "macos": "Darwin", "linux": "Linux"}
"""CMake's names of systems, by zig's."""
_COMPILERS = (("g++", "gcc"), ("clang++", "clang"), ("c++", "cc"))


class NoToolchain(RuntimeError):
    """C++ cannot be compiled here; the text says what to type."""


@dataclass(frozen=True)
class Toolchain:
    """Commands that compile C++ and C, put objects into libraries, configure and build."""

    cxx: tuple[str, ...]
    cc: tuple[str, ...]
    archiver: tuple[str, str] | None
    """The programs that make libraries and index them, where CMake would not find them itself."""
    cmake: str
    ninja: str | None
    """None where make does its work."""
    system: str | None = None
    """CMake's name of the system that the programs are for, where it is another than this one."""

    def defines(self) -> dict[str, str]:
        """What CMake is to be told of them."""
        told = {"CMAKE_CXX_COMPILER": ";".join(self.cxx), "CMAKE_C_COMPILER": ";".join(self.cc)}
        if self.archiver:
            told |= {"CMAKE_AR": self.archiver[0], "CMAKE_RANLIB": self.archiver[1]}
        if self.ninja:
            told["CMAKE_MAKE_PROGRAM"] = self.ninja
        if self.system:
            told["CMAKE_SYSTEM_NAME"] = self.system
        return told

    @property
    def generator(self) -> str:
        """CMake's name for what runs the build."""
        return "Ninja" if self.ninja else "Unix Makefiles"


@cache
def find_toolchain() -> Toolchain:
    """The tools of this computer: the system's compiler first, else zig's from PyPI.

    NoToolchain where some are missing, and on Windows, for which nothing is linked yet.
    """
    if which.WINDOWS:
        raise NoToolchain(ON_WINDOWS)
    cmake, ninja = _program("cmake", "CMAKE_BIN_DIR"), _program("ninja", "BIN_DIR")
    if cmake is None:
        raise NoToolchain(MISSING.format(what="CMake"))
    if ninja is None and shutil.which("make") is None:
        raise NoToolchain(MISSING.format(what="ninja or make"))
    for cxx, cc in _COMPILERS:
        if found := shutil.which(cxx):
            return Toolchain((found,), (shutil.which(cc) or found,), None, cmake, ninja)
    zig = _zig()
    if zig is None:
        raise NoToolchain(MISSING.format(what="C++ compiler"))
    return _of_zig(zig, cmake, ninja, f"{platform.machine()}-linux-gnu.2.28" if sys.platform == "linux" else None)


def cross_toolchain(target: str) -> Toolchain:
    """zig's tools that make programs for another computer, such as x86_64-windows-gnu or aarch64-macos; NoToolchain."""
    zig, cmake = _zig(), _program("cmake", "CMAKE_BIN_DIR")
    if zig is None or cmake is None:
        raise NoToolchain(MISSING.format(what="zig" if zig is None else "CMake"))
    system = next(name for word, name in _SYSTEMS.items() if word in target)
    return _of_zig(zig, cmake, _program("ninja", "BIN_DIR"), target, system)


def _of_zig(zig: str, cmake: str, ninja: str | None, target: str | None, system: str | None = None) -> Toolchain:
    folder = cache_folder() / "zig" / (target if system and target else "")
    cxx, cc, ar, ranlib = (_as_program(zig, folder / name, target) for name in ("c++", "cc", "ar", "ranlib"))
    return Toolchain((cxx,), (cc,), (ar, ranlib), cmake, ninja, system)


def _program(name: str, folder: str) -> str | None:
    """A program of the system, else of the wheel of that name."""
    found = shutil.which(name)
    if found is None and importlib.util.find_spec(name) is not None:
        module = importlib.import_module(name)
        found = shutil.which(name, path=str(getattr(module, folder, "")))
    return found


def _zig() -> str | None:
    spec = importlib.util.find_spec("ziglang")
    if spec is None or not spec.submodule_search_locations:
        return None
    return shutil.which("zig", path=str(Path(spec.submodule_search_locations[0])))


def _as_program(zig: str, path: Path, target: str | None) -> str:
    """A program that is one of zig's tools: CMake wants a program for each, and zig's usual flags are not a robot's."""
    flags = [] if path.name in ("ar", "ranlib") else ["-fno-sanitize=undefined"]  # what would trap goes on under g++
    if flags and target:
        flags = ["-target", target, *flags]
    text = f'#!/bin/sh\nexec {shlex.quote(zig)} {path.name} {" ".join(flags)} "$@"\n'
    if not path.is_file() or read_text(path) != text:
        write_whole(path, text, 0o755, parents=True)
    return str(path)


def cache_folder() -> Path:
    """The user's folder for what can be made again: COURSEKIT_CACHE, else where this system keeps such things."""
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
    """What a compiler says of itself, to tell it from another."""
    done = subprocess.run([*command, "--version"], capture_output=True, encoding="utf-8", errors="replace", check=False)
    return f"{' '.join(command)}\n{done.stdout}"


__all__ = ["NoToolchain", "Toolchain", "cache_folder", "cross_toolchain", "find_toolchain", "version_of"]
