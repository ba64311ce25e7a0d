"""Executables of packages: where they are, and how they become processes."""

from __future__ import annotations

import difflib
import os
import subprocess
import sysconfig
import threading
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from coursekit.files import read_text
from coursekit.interfaces.find import UNDERLAY, prefixes
from coursekit.systems import children, layout
from coursekit.systems.words import join_words

from .elsewhere import remark, remark_on_executable
from .modules import use_private_modules
from .process import Output, Process, current_process
from .terminal import open_terminal

if TYPE_CHECKING:
    from .session import Session

_HOW = "a Python node needs a line under console_scripts in setup.py, and a build; C++ is not compiled here"


class PackageNotFound(LookupError):
    """No such package in any prefix; the text names close ones."""

    def __init__(self, package: str, known: Sequence[str]) -> None:
        why = remark(package)
        super().__init__(f"Package '{package}' not found{'; ' + why if why else _hint(package, known)}")
        self.package = package


class ExecutableNotFound(LookupError):
    """The package has no such executable; the text names those that it has."""

    def __init__(self, package: str, executable: str, known: Sequence[str]) -> None:
        names = ", ".join(known) or f"none ({_HOW})"
        why = why_missing(package, executable)
        super().__init__(f"No executable '{executable}' in package '{package}'. It has: {names}{why and '; ' + why}")
        self.package = package
        self.executable = executable


def why_missing(package: str, executable: str) -> str:
    """Why a package lacks an executable, when that is known: `colcon build` passed over it, or it is not for here."""
    return why_skipped(package, executable) or remark_on_executable(package, executable)


def why_skipped(package: str, executable: str) -> str:
    """Why `colcon build` passed over an executable; empty for those that it did not pass over."""
    for prefix in prefixes():
        listed = _index(prefix).parent / "coursekit_skipped" / package
        if listed.is_file() and executable in read_text(listed).splitlines():
            return f"'{executable}' is written in C++, which is not compiled here: write it in Python"
    return ""


def _hint(name: str, known: Sequence[str]) -> str:
    close = difflib.get_close_matches(name, known, 3)
    return f"; did you mean {' or '.join(close)}?" if close else ""


def _index(prefix: Path) -> Path:
    return prefix / "share" / "ament_index" / "resource_index" / "packages"


def packages() -> dict[str, Path]:
    """Every package and its prefix; the first prefix that has one wins."""
    found: dict[str, Path] = {}
    for prefix in prefixes():
        folder = _index(prefix)
        for entry in sorted(folder.iterdir()) if folder.is_dir() else ():
            found.setdefault(entry.name, prefix)
    return dict(sorted(found.items()))


def prefix_of(package: str) -> Path:
    """The prefix of a package; raises PackageNotFound."""
    for prefix in prefixes():
        if (_index(prefix) / package).exists():
            return prefix
    raise PackageNotFound(package, list(packages()))


def executables_of(package: str) -> list[Path]:
    """The executables of a package, sorted; raises PackageNotFound."""
    prefix = prefix_of(package)
    folder = prefix / "lib" / package
    if not folder.is_dir():
        return []
    return [entry for entry in sorted(folder.iterdir()) if entry.is_file() and _runs(entry, prefix)]


def _runs(path: Path, prefix: Path) -> bool:
    if path.name.startswith((".", "__")) or layout.is_executables_part(path):
        return False
    return prefix == UNDERLAY or os.access(path, os.X_OK) or path.suffix == ".exe"


def find(package: str, executable: str) -> Path:
    """The file of an executable; raises PackageNotFound or ExecutableNotFound.

    >>> find("demo_nodes_py", "talkr")
    Traceback (most recent call last):
        ...
    coursekit.core.executables.ExecutableNotFound: No executable 'talkr' in package 'demo_nodes_py'. It has: ...
    """
    known = executables_of(package)
    for path in known:
        if executable in (path.name, layout.executable_name(path)):
            return path
    raise ExecutableNotFound(package, executable, [path.name for path in known])


def is_python(path: Path) -> bool:
    """Whether a file is a Python program, or what setuptools makes of one on Windows."""
    path = layout.python_script(path)
    if path.suffix == ".py" or UNDERLAY in path.parents:
        return True
    with open(path, "rb") as file:
        first = file.readline(256)
    return first.startswith(b"#!") and b"python" in first


def python_folders(env: Mapping[str, str]) -> list[str]:
    """The folders that PYTHONPATH and the prefixes of `env` add to Python's path, without those of the interpreter."""
    folders = [one for one in env.get("PYTHONPATH", "").split(os.pathsep) if one]
    for prefix in env.get("AMENT_PREFIX_PATH", "").split(os.pathsep):
        if prefix and Path(prefix) != UNDERLAY:
            folders.append(str(layout.site_packages(Path(prefix))))
    ours = {sysconfig.get_path("purelib"), sysconfig.get_path("platlib"), str(UNDERLAY / "ros"), str(UNDERLAY.parent)}
    return [one for one in dict.fromkeys(folders) if one not in ours and Path(one).is_dir()]


def make_process(
    session: Session,
    path: Path,
    argv: Sequence[str] = (),
    *,
    name: str | None = None,
    env: Mapping[str, str] | None = None,
    cwd: str | os.PathLike[str] | None = None,
) -> Any:
    """A process that runs the file: inside this interpreter if it is Python, else a child of the system."""
    name = name or path.name
    if not path.exists():
        raise FileNotFoundError(f"'{path}' does not exist, so it cannot be run. Was its package built?")
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
    """What `python PATH` does."""

    def main() -> None:
        module = ModuleType("__main__")
        module.__file__ = str(path)
        module.__dict__["__builtins__"] = __builtins__
        exec(compile(path.read_bytes(), str(path), "exec"), module.__dict__)

    return main


class ChildProcess:
    """A real child process behind the interface of `Process`.

    On the virtual clock time passes as on the wall while it lives, or, where `takes_time` is False, not at all. With
    `one_stream` its errors come among its other output in the order in which it wrote them, as in a terminal. With
    `tty` set before it begins, it writes to terminals.
    """

    def __init__(
        self,
        session: Session,
        command: Sequence[str],
        *,
        name: str,
        env: Mapping[str, str] | None = None,
        cwd: str | os.PathLike[str] | None = None,
        takes_time: bool = True,
        one_stream: bool = False,
    ) -> None:
        self.session = session
        self.name = name
        self._one_stream = one_stream
        self.takes_time = takes_time
        self.argv = list(command)
        self.pid = session.new_pid()
        self.parent = current_process()
        self.exit_code: int | None = None
        self.abandoned = False
        self.out = Output()
        self.tty = False
        self.env = children.with_utf8(os.environ if env is None else env)
        self.cwd = None if cwd is None else os.fspath(cwd)
        self._ended = session.clock.new_event()
        self._exit_listeners: list[Callable[[Any], None]] = []
        self._child: subprocess.Popen[str] | None = None

    state = Process.state
    output = Process.output
    on_output = Process.on_output
    on_exit = Process.on_exit
    wait = Process.wait
    interrupt = Process.interrupt
    terminate = Process.terminate
    __repr__ = Process.__repr__

    def begin(self) -> None:
        """Start it, and threads that read what it writes."""
        terminals = [open_terminal() if self.tty else None for _ in ("stdout", "stderr")]
        ends = [one[1] if one else subprocess.PIPE for one in terminals]
        try:
            self._child = subprocess.Popen(
                self.argv,
                stdin=subprocess.PIPE,
                stdout=ends[0],
                stderr=subprocess.STDOUT if self._one_stream else ends[1],
                encoding="utf-8",
                errors="replace",
                bufsize=1,
                env=self.env,
                cwd=self.cwd,
                **children.apart(),
            )
        finally:
            for one in terminals:
                if one:
                    os.close(one[1])
        self._count_child(1)
        pipes = [one[0] if one else pipe for one, pipe in zip(terminals, _outputs(self._child), strict=True)]
        readers = [
            threading.Thread(target=self._read, args=(stream, pipe), daemon=True)
            for stream, pipe in zip(("stdout", "stderr"), pipes, strict=True)
            if pipe is not None
        ]
        for thread in readers:
            _start_outside(thread)
        _start_outside(threading.Thread(target=self._watch, args=(readers,), daemon=True))

    def _count_child(self, change: int) -> None:
        clock = self.session.clock
        if clock.virtual and self.takes_time:
            clock.children += change
        elif clock.virtual:
            clock.frozen += change
            clock.wake()

    def _read(self, stream: str, pipe: Any) -> None:
        for line in pipe:
            self.out.write(stream, line)

    def _watch(self, readers: list[threading.Thread]) -> None:
        assert self._child is not None
        code = self._child.wait()
        for thread in readers:
            threading.Thread.join(thread, 1.0)
        self.exit_code = code
        self._count_child(-1)
        self.session.forget(self)
        for listener in self._exit_listeners:
            listener(self)
        self._ended.set()

    def write_stdin(self, text: str) -> None:
        """Type `text` into its standard input."""
        if self._child is not None and self._child.stdin is not None:
            self._child.stdin.write(text)
            self._child.stdin.flush()

    def close_stdin(self) -> None:
        """End its standard input."""
        if self._child is not None and self._child.stdin is not None:
            self._child.stdin.close()

    def kill(self) -> None:
        """End it at once."""
        self.send_signal(9)

    def send_signal(self, signum: int) -> None:
        """Deliver a signal to it."""
        if self._child is not None and self.exit_code is None:
            children.send_signal(self._child, signum)  # to what it started too, as a terminal's Ctrl-C goes

    def command_line(self) -> str:
        """What one would type."""
        return join_words(self.argv)


def _outputs(child: subprocess.Popen[str]) -> tuple[Any, Any]:
    return child.stdout, child.stderr


def _start_outside(thread: threading.Thread) -> None:
    """Start a real thread, also where threads are lanes of the virtual clock."""
    from .clock import _Thread_start

    _Thread_start(thread)
