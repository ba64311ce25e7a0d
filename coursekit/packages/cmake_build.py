"""Builds a package by CMake and a compiler: colcon's own task for CMake, told of the tools and of our place of ament."""

from __future__ import annotations

import hashlib
import importlib.util
import os
import re
import shutil
import sys
from functools import partial
from pathlib import Path
from typing import Any

from colcon_cmake.task import cmake as colcon_tools
from colcon_cmake.task.cmake import build as colcon_cmake
from colcon_core.event.output import StderrLine, StdoutLine

from coursekit.cpp.runtime import ROOM, runtime_folder
from coursekit.cpp.toolchain import Toolchain
from coursekit.files import read_text
from coursekit.systems import layout

_MAKES = re.compile(
    r"^\s*((add_executable|add_library|ament_auto_add_(executable|library)|ament_add_g(test|mock)|pybind11_add_module)\s*\("
    r"|ament_(auto_)?package\s*\([^)]*\bCONFIG_EXTRAS|(set|list)\s*\([^)]*_CONFIG_EXTRAS"
    r"|(ament_add_\w*test|add_launch_test|add_ros_test)\s*\([^)]*(\$<|_BINARY_DIR))",
    re.M | re.I,
)
_RUNTIME = re.compile(r"/cpp/([0-9a-f]{16})/share/")
_COLOR = re.compile(rb"\x1b\[[\d;]*m")
_OF_CMAKE = re.compile(rb"\[\d+/\d+\] |ninja: |FAILED: |--|loading initial cache file |\Z")


def needs_compiler(folder: Path) -> bool:
    """Whether a package has C++ to compile, tests among it, or to give to others, or tests whose files CMake writes."""
    return any(_MAKES.search(read_text(path, errors="replace")) for path in folder.rglob("CMakeLists.txt") if path.is_file())


def installed(build: Path, prefix: Path) -> list[str]:
    """The files that CMake installed, relative to the prefix."""
    manifest = build / "install_manifest.txt"
    lines = read_text(manifest).splitlines() if manifest.is_file() else []
    return [os.path.relpath(line, prefix) for line in lines]


def package_config(package: str, dependencies: list[str]) -> str:
    """The config that find_package() reads of a package that has no C++ of its own."""
    text = read_text(ROOM / "cmake" / "package_config.cmake.in")
    known = {"PROJECT_NAME": package, "DEPENDENCIES": ";".join(dependencies)}
    return re.sub(r"@(\w+)@", lambda found: known.get(found[1], ""), text)


async def build_with_cmake(context: Any, tools: Toolchain) -> tuple[int, list[bytes]]:
    """Configure, build and install the package of colcon's context.

    Returns the exit code of the first step that fails, and the lines of errors and warnings, which are not told yet.
    """
    args = context.args
    reuse_compiler(Path(args.build_base), runtime_folder(tools))
    own_words = list(args.cmake_args or [])
    args.cmake_args = [*_words(context, tools), *own_words]
    task = colcon_cmake.CmakeBuildTask()
    listening = ErrorsAside(context)
    complete = partial(_complete, runtime=runtime_folder(tools))
    task.set_context(context=listening)
    colcon_cmake.CMAKE_EXECUTABLE = colcon_tools.CMAKE_EXECUTABLE = tools.cmake  # theirs may be none, or not on PATH
    try:
        code = await task.build(skip_hook_creation=True, environment_callback=complete)
    finally:
        args.cmake_args = own_words or None
    return int(code or 0), listening.errors


def _words(context: Any, tools: Toolchain) -> list[str]:
    args = context.args
    linking = "ON" if getattr(args, "symlink_install", False) else "OFF"
    facts = initial_cache(Path(args.build_base), Path(args.install_base), tools)
    return ["-G", tools.generator, "-C", str(facts), f"-DAMENT_CMAKE_SYMLINK_INSTALL={linking}"]


def initial_cache(build: Path, prefix: Path, tools: Toolchain) -> Path:
    """A file of what CMake is told of this computer: unlike words on the command line, such need not all be used."""
    facts = {
        **tools.defines(),
        "CMAKE_PROJECT_INCLUDE": ROOM / "cmake" / "project.cmake",
        "COURSEKIT_CPP": runtime_folder(tools),
        "COURSEKIT_CMAKE": ROOM / "cmake",
        "COURSEKIT_ROOT": ROOM,
        "COURSEKIT_PYTHON": Path(sys.executable),
        "COURSEKIT_SITE_PACKAGES": layout.site_packages(prefix).relative_to(prefix),
        "BUILD_TESTING": "OFF",  # tests in C++ are named by `colcon test`, and not compiled
        "CMAKE_INSTALL_LIBDIR": "lib",
        "CMAKE_INSTALL_MESSAGE": "NEVER",
        "CMAKE_SUPPRESS_DEVELOPER_WARNINGS": "ON",
        "CMAKE_WARN_DEPRECATED": "OFF",  # Humble's packages ask for a CMake that newer ones call old
        "CMAKE_EXPORT_NO_PACKAGE_REGISTRY": "ON",
        "CMAKE_POLICY_VERSION_MINIMUM": "3.5",
    }
    told = {name: value.as_posix() if isinstance(value, Path) else str(value) for name, value in facts.items()}
    text = "".join(f'set({name} {bracketed(value)} CACHE STRING "" FORCE)\n' for name, value in told.items())
    path = build / f"coursekit-{hashlib.sha256(text.encode()).hexdigest()[:8]}.cmake"  # a new name: CMake configures again
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    return path


def bracketed(value: str) -> str:
    """A value as CMake reads it without looking at what is in it.

    >>> bracketed('my "$ENV{HOME}"'), bracketed("a]=]b")
    ('[=[my "$ENV{HOME}"]=]', '[==[a]=]b]==]')
    """
    level = "="
    while f"]{level}]" in value:
        level += "="
    return f"[{level}[{value}]{level}]"


def _complete(env: dict[str, str], runtime: Path) -> None:
    """Where find_package() looks: sourced workspaces, what the package depends on, what comes with coursekit."""
    sourced = [env.get("AMENT_PREFIX_PATH", ""), env.get("CMAKE_PREFIX_PATH", "")]
    known = os.pathsep.join([*sourced, str(runtime), *_of_wheels()])
    env["CMAKE_PREFIX_PATH"] = os.pathsep.join(dict.fromkeys(filter(None, known.split(os.pathsep))))


def _of_wheels() -> list[str]:
    """Where the wheels of C++ libraries have put theirs: cmeel-eigen's is Eigen."""
    spec = importlib.util.find_spec("cmeel")
    folders = [Path(place).with_name("cmeel.prefix") for place in (spec.submodule_search_locations or [])] if spec else []
    return [str(folder) for folder in folders if (folder / "share" / "eigen3" / "cmake").is_dir()]


def completed(env: dict[str, str], tools: Toolchain) -> dict[str, str]:
    """An environment in which CMake finds what we have."""
    full = dict(env)
    _complete(full, runtime_folder(tools))
    return full


def configure_tests(build: Path, tools: Toolchain, results: Path) -> list[str]:
    """The command that has CMake look at the tests of a package that has been built; their results go to a folder."""
    return [tools.cmake, "-DBUILD_TESTING=ON", f"-DAMENT_TEST_RESULTS_DIR={results.as_posix()}", str(build)]


def build_tests(build: Path, tools: Toolchain) -> list[str]:
    """The command that builds a package with its tests."""
    return [tools.cmake, "--build", str(build), "--parallel", str(os.cpu_count() or 1)]


def reuse_compiler(build: Path, runtime: Path) -> None:
    """Spare CMake its questions to the compiler: the answers are kept from the build of the runtime.

    What CMake remembers of another runtime is forgotten: find_package() would go on finding that one's packages.
    """
    cache = build / "CMakeCache.txt"
    if cache.exists() and set(_RUNTIME.findall(read_text(cache, errors="replace"))) - {runtime.name}:
        cache.unlink()
    if not cache.exists():
        shutil.copytree(runtime / "compiler", build / "CMakeFiles", dirs_exist_ok=True)


class ErrorsAside:
    """colcon's context, that keeps errors and warnings; a compiler's are among them under ninja too, as under make."""

    def __init__(self, context: Any) -> None:
        self._context = context
        self.errors: list[bytes] = []
        self._last = b""

    def __getattr__(self, name: str) -> Any:
        return getattr(self._context, name)

    def put_event_into_queue(self, event: Any) -> None:
        """Pass an event on, or keep its line."""
        line = getattr(event, "line", b"")
        line = _COLOR.sub(b"", line if isinstance(line, bytes) else line.encode())  # Jupyter asks programs for colours
        is_error = isinstance(event, StderrLine) or (isinstance(event, StdoutLine) and not _OF_CMAKE.match(line.strip()))
        if is_error and not self._last.startswith(b"FAILED: "):  # ninja's command follows that line
            self.errors.append(line)
        else:
            self._context.put_event_into_queue(event)
        self._last = line
