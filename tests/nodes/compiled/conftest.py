"""Compiles programs against rclcpp's names here, with the system's compiler; without one these tests are skipped, aloud."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

import coursekit.cpp
from coursekit.cpp.runtime import runtime_folder
from coursekit.cpp.toolchain import NoToolchain, find_toolchain
from coursekit.processes.executables import make_process
from coursekit.processes.session import Session
from tests.conftest import make_cpp_runtime

ROOM = Path(coursekit.cpp.__file__).parent
PROGRAMS = Path(__file__).parent / "programs"


def program(name: str) -> str:
    """The text of one of the programs beside the tests."""
    return (PROGRAMS / name).read_text(encoding="utf-8")


@pytest.fixture(scope="session")
def cpp_library() -> Path:
    """A folder with `include/`, the headers of all interfaces, and `lib/`, the runtime: what `colcon build` uses too."""
    if os.name != "posix" or shutil.which("g++") is None:
        pytest.skip("needs g++")
    try:
        tools = find_toolchain()
    except NoToolchain as error:
        pytest.skip(str(error))
    make_cpp_runtime()
    return runtime_folder(tools)


@pytest.fixture(scope="session")
def build(cpp_library: Path, tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Path]:
    """Compile a program's text under a name, once; more words are for the compiler."""
    path_by_program: dict[tuple[str, str], Path] = {}

    def compiled(name: str, text: str, *words: str) -> Path:
        if (name, text) not in path_by_program:
            path = tmp_path_factory.mktemp("programs") / name
            source = path.with_suffix(".cpp")
            source.write_text(text, encoding="utf-8")
            archive = str(cpp_library / "lib" / "libcoursekit.a")
            library = ["-Wl,--whole-archive", archive, "-Wl,--no-whole-archive", "-ldl", "-lpthread"]
            _compile(cpp_library, *words, str(source), "-o", str(path), *library)
            path_by_program[name, text] = path  # not before: what does not compile fails each of its tests
        return path_by_program[name, text]

    return compiled


@pytest.fixture
def said(session: Session, build: Callable[..., Path], tmp_path: Path) -> Callable[[str], list[str]]:
    """Run one of the programs beside the tests in a folder of its own, to its good end; the lines that it printed."""

    def lines(name: str) -> list[str]:
        process = session.launch(make_process(session, build(name, program(f"{name}.cpp")), name=name, cwd=tmp_path))
        assert process.wait(20.0) == 0, process.output
        return process.output.splitlines()

    return lines


def _compile(library: Path, *words: str) -> None:
    own = [PROGRAMS.parent / "conformance", ROOM / "include", ROOM / "opencv", ROOM / "yaml_cpp"]
    folders = [*(f"-I{folder}" for folder in own), "-isystem", str(library / "include"), "-isystem", "/usr/include/eigen3"]
    flags = ["-std=gnu++17", "-O0", "-Wall", "-Wextra", *folders]
    done = subprocess.run(["g++", *flags, *words], capture_output=True, encoding="utf-8")
    assert done.returncode == 0, done.stderr
