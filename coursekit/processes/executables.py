"""Executables of packages: finding them, and running them as processes."""

from __future__ import annotations

import mmap
import os
import sysconfig
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from coursekit.files import read_text
from coursekit.interfaces.find import UNDERLAY, prefixes
from coursekit.suggestions import hint
from coursekit.systems import layout, link_copies
from coursekit.wiring import COMPILED_HOST

from .child import ChildProcess
from .private_modules import private_of_process, use_private_modules
from .process import Process, current_process
from .unavailable_packages import remark, remark_on_executable

if TYPE_CHECKING:
    from .session import Session

_PROGRAMS = (b"\x7fELF", b"\xcf\xfa\xed\xfe", b"MZ")
"""The first bytes of programs: on Linux, on a Mac, on Windows."""
_LINK = b"COURSEKIT_LINK"
"""The runtime's name for its address, contained only in programs linked with it."""
_HOW = (
    "a Python node needs a line under console_scripts in setup.py, a C++ node "
    "install(TARGETS ... DESTINATION lib/${PROJECT_NAME}) in CMakeLists.txt, both a build"
)


class PackageNotFound(LookupError):
    """No such package in any prefix; the message suggests similar names."""

    def __init__(self, package: str, known: Sequence[str]) -> None:
        why = remark(package)
        super().__init__(f"Package '{package}' not found{'; ' + why if why else hint(package, known)}")
        self.package = package


class ExecutableNotFound(LookupError):
    """The package has no such executable; the message lists those that it has."""

    def __init__(self, package: str, executable: str, known: Sequence[str]) -> None:
        why = why_missing(package, executable)
        names = ", ".join(known) or ("none" if why else f"none ({_HOW})")
        super().__init__(f"No executable '{executable}' in package '{package}'. It has: {names}{why and '; ' + why}")
        self.package = package
        self.executable = executable


def why_missing(package: str, executable: str) -> str:
    """Return why a package lacks an executable, if known: its build skipped or misplaced it, or it is not available here."""
    asked = package, executable
    return why_skipped(*asked) or why_misplaced(*asked) or remark_on_executable(*asked)


def why_skipped(package: str, executable: str) -> str:
    """Return why `colcon build` skipped an executable; empty if it did not."""
    if any(executable in skipped_of(package, prefix) for prefix in prefixes()):
        return f"'{executable}' is written in C++, which the last build of '{package}' skipped: `colcon build` shows why"
    return ""


def skipped_of(package: str, prefix: Path) -> list[str]:
    """Return the C++ targets that `colcon build` skipped when it installed the package into `prefix`."""
    listed = _index(prefix).parent / "coursekit_skipped" / package
    return read_text(listed).splitlines() if listed.is_file() else []


def _index(prefix: Path) -> Path:
    return prefix / "share" / "ament_index" / "resource_index" / "packages"


def packages() -> dict[str, Path]:
    """Return every package with its prefix; the first prefix with a package wins."""
    prefix_by_package: dict[str, Path] = {}
    for prefix in prefixes():
        folder = _index(prefix)
        for entry in sorted(folder.iterdir()) if folder.is_dir() else ():
            prefix_by_package.setdefault(entry.name, prefix)
    return dict(sorted(prefix_by_package.items()))


def prefix_of(package: str) -> Path:
    """Return the prefix of a package; raises PackageNotFound."""
    for prefix in prefixes():
        if (_index(prefix) / package).exists():
            link_copies.renew(prefix, package)
            return prefix
    raise PackageNotFound(package, list(packages()))


def why_misplaced(package: str, executable: str) -> str:
    """Return what the package's author forgot if the file is installed, but not as an executable of it; else empty."""
    for prefix in (prefix for prefix in prefixes() if (_index(prefix) / package).exists()):
        if (prefix / "lib" / package / executable).is_file():
            return f"'{executable}' may not be run: `chmod +x` its source, or install(PROGRAMS ...) in CMakeLists.txt"
        if any((prefix / folder / executable).is_file() for folder in ("bin", "Scripts")):
            folder = f"$base/lib/{package}"
            return (
                f"'{executable}' was installed into bin: setup.cfg needs [develop] with script_dir={folder} and [install] "
                f"with install_scripts={folder}, then a build"
            )
    return ""


def executables_of(package: str) -> list[Path]:
    """Return the executables of a package, sorted; raises PackageNotFound.

    For skipped C++ executables, coursekit's own programs of that package are included.
    """
    prefix = prefix_of(package)
    path_by_name = {path.name: path for path in stand_ins(package)} if skipped_of(package, prefix) else {}
    path_by_name |= {path.name: path for path in _programs(package, prefix)}
    return [path_by_name[name] for name in sorted(path_by_name)]


def stand_ins(package: str) -> list[Path]:
    """Return coursekit's own programs of a package."""
    return _programs(package, UNDERLAY)


def _programs(package: str, prefix: Path) -> list[Path]:
    folder = prefix / "lib" / package
    return [path for path in folder.iterdir() if path.is_file() and _runs(path, prefix)] if folder.is_dir() else []


def _runs(path: Path, prefix: Path) -> bool:
    if path.name.startswith((".", "__")) or layout.is_executables_part(path):
        return False
    return prefix == UNDERLAY or os.access(path, os.X_OK) or path.suffix == ".exe"


def find(package: str, executable: str) -> Path:
    """Return the file of an executable; raises PackageNotFound or ExecutableNotFound.

    >>> find("demo_nodes_py", "talkr")
    Traceback (most recent call last):
        ...
    coursekit.processes.executables.ExecutableNotFound: No executable 'talkr' in package 'demo_nodes_py'. It has: ...
    """
    known = executables_of(package)
    for path in known:
        if executable in (path.name, layout.executable_name(path)):
            return path
    raise ExecutableNotFound(package, executable, [path.name for path in known])


def is_python(path: Path) -> bool:
    """Whether a file is a Python program, or setuptools' .exe for one on Windows."""
    path = layout.python_script(path)
    if path.suffix == ".py" or UNDERLAY in path.parents:
        return True
    with open(path, "rb") as file:
        first = file.readline(256)
    return first.startswith(b"#!") and b"python" in first


def is_compiled_here(path: Path) -> bool:
    """Whether a file is a C++ program that was built here: its rclcpp calls go to the session."""
    if UNDERLAY in path.parents:
        return False
    with open(path, "rb") as file:
        if not file.read(4).startswith(_PROGRAMS):
            return False
        with mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
            return data.find(_LINK) >= 0


def has_compiled_here(command: Sequence[str]) -> bool:
    """Whether a command runs a C++ program that was built here, possibly under a debugger: `gdb -ex run --args PATH`."""
    return any(is_compiled_here(Path(word)) for word in command if os.path.isfile(word))


def python_folders(env: Mapping[str, str]) -> list[str]:
    """Return the folders that PYTHONPATH and the prefixes of `env` add to Python's path, without the interpreter's own."""
    folders = [folder for folder in env.get("PYTHONPATH", "").split(os.pathsep) if folder]
    for prefix in env.get("AMENT_PREFIX_PATH", "").split(os.pathsep):
        if prefix and Path(prefix) != UNDERLAY:
            folders.append(str(layout.site_packages(Path(prefix))))
    ours = {sysconfig.get_path("purelib"), sysconfig.get_path("platlib"), str(UNDERLAY / "ros"), str(UNDERLAY.parent)}
    return [folder for folder in dict.fromkeys(folders) if folder not in ours and Path(folder).is_dir()]


def make_process(
    session: Session,
    path: Path,
    argv: Sequence[str] = (),
    *,
    name: str | None = None,
    env: Mapping[str, str] | None = None,
    cwd: str | os.PathLike[str] | None = None,
) -> Any:
    """Return a process that runs the file: in this interpreter if it is Python, else as a child process."""
    name = name or path.name
    if not path.exists():
        raise FileNotFoundError(f"'{path}' does not exist, so it cannot be run. Was its package built?")
    if is_compiled_here(path):
        path, argv = UNDERLAY / COMPILED_HOST, [str(path), *argv]
    if not is_python(path):
        return ChildProcess(session, [str(path), *argv], name=name, env=env, cwd=cwd)
    path = layout.python_script(path)
    parent = current_process()
    process = Process(
        session, _program(path), name=name, argv=argv, env=None if env is None else dict(env), cwd=cwd, parent=parent
    )
    process.argv = [str(path), *argv]
    beside = [] if UNDERLAY in path.parents else [str(path.parent)]
    use_private_modules(process, [*beside, *python_folders(process.env)])
    return process


def _program(path: Path) -> Callable[[], Any]:
    """Return a function equivalent to `python PATH`."""

    def main() -> None:
        module = ModuleType("__main__")
        module.__file__ = str(path)
        module.__dict__["__builtins__"] = __builtins__
        private = private_of_process()
        if private is not None:
            private.main = module
        exec(compile(path.read_bytes(), str(path), "exec"), module.__dict__)

    return main
