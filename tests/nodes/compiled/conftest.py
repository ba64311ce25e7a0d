"""Compiles programs against rclcpp's names here, with the system's compiler; without one these tests are skipped, aloud."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

import coursekit.cpp
from coursekit.cpp.headers import write_headers
from coursekit.interfaces.find import known_interfaces

ROOM = Path(coursekit.cpp.__file__).parent


@pytest.fixture(scope="session")
def cpp_library(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with `include/`, the headers of all interfaces, and `libcoursekit.a`, the runtime."""
    if os.name != "posix" or shutil.which("g++") is None:
        pytest.skip("needs g++")
    folder = tmp_path_factory.mktemp("cpp")
    write_headers(folder / "include", known_interfaces())
    objects = []
    for source in sorted((ROOM / "src").glob("*.cpp")):
        objects.append(folder / f"{source.stem}.o")
        _compile(folder, "-Werror", "-c", str(source), "-o", str(objects[-1]))
    subprocess.run(["ar", "qc", str(folder / "libcoursekit.a"), *map(str, objects)], check=True)
    return folder


@pytest.fixture
def build(cpp_library: Path, tmp_path: Path) -> Callable[[str, str], Path]:
    """Compile a program's text under a name."""

    def compiled(name: str, text: str) -> Path:
        source = tmp_path / f"{name}.cpp"
        source.write_text(text, encoding="utf-8")
        library = ["-Wl,--whole-archive", str(cpp_library / "libcoursekit.a"), "-Wl,--no-whole-archive", "-ldl", "-lpthread"]
        _compile(cpp_library, str(source), "-o", str(tmp_path / name), *library)
        return tmp_path / name

    return compiled


def _compile(library: Path, *words: str) -> None:
    flags = ["-std=gnu++17", "-O0", "-Wall", "-Wextra", "-I", str(ROOM / "include"), "-isystem", str(library / "include")]
    done = subprocess.run(["g++", *flags, *words], capture_output=True, encoding="utf-8")
    assert done.returncode == 0, done.stderr
