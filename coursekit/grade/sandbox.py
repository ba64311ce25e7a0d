"""A sandbox for a student's code: no network, no files but its own, limits on everything.

The tiers, named in each result, are `bubblewrap` (own namespaces, no capability, an unprivileged user, only the
needed folders, read-only) and `limits` (a process with limits, but with the user's files and network: only for
trusted work).
"""

from __future__ import annotations

import contextlib
import functools
import os
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from coursekit.systems import children, inherited, operating_system

from . import folders
from .cgroup_limits import SERVICE_VARIABLES, confined
from .unsandboxed import cure

PACKAGE = Path(__file__).resolve().parents[1]
_SYSTEM = ("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/etc/alternatives", "/etc/fonts", "/etc/ld.so.cache")
_BWRAP = ("/usr/bin/bwrap", "/usr/local/bin/bwrap", "/bin/bwrap")
_NOBODY = "65534"
_WINDOWS = ("SYSTEMROOT", "SYSTEMDRIVE", "WINDIR", "COMSPEC", "PATHEXT", "LOCALAPPDATA", "APPDATA")
"""The variables required by Windows programs, for instance by sockets and random numbers."""
_HIDDEN = ("grade/chapters",)
"""Folders of the package with exercises' checks and answers."""

LOOK_SECONDS = 0.15
"""The period of measuring a program's usage [s]: each time the list of all processes is read."""


@dataclass(frozen=True)
class Limits:
    """The limits of a sandboxed program."""

    seconds: float = 120.0
    """Real time [s]."""
    memory: int = 3 << 30
    """The address space of each process, and the resident memory of all together [bytes]."""
    processes: int = 150
    """The number of processes and threads."""
    file: int = 64 << 20
    """The size of one file [bytes]."""
    folder: int = 256 << 20
    """The size of all files in the work folder [bytes]."""
    output: int = 8 << 20
    """The size of the output that is read [bytes]."""
    scratch: int = 64 << 20
    """The size of /tmp and of /dev/shm each [bytes]."""
    cell: float = 20.0
    """The computing time of a student's cell [s]."""
    course_cell: float = 60.0
    """The computing time of a course cell [s]."""
    build: float = 60.0
    """The duration of a build [s]."""
    call: float = 10.0
    """The duration of a call of a student's function [s]."""
    chapter: float = 600.0
    """The real time for marking one chapter of one submission [s]."""
    tier: str = ""
    """The sandbox tier; empty for the best available one."""


@dataclass
class Sandboxed:
    """A running program, and the reason if it was ended."""

    child: subprocess.Popen[bytes]
    scratch: Path | None = None
    """A folder for its temporary files, removed with it."""
    stopped: str = ""
    timed_out: bool = False
    """Whether it was ended because it exceeded its time."""
    _ended: threading.Event = field(default_factory=threading.Event)

    def answer(self, question: bytes, most: int) -> bytes:
        """Send the question and close the input. Returns at most `most` bytes of the output."""
        assert self.child.stdin is not None and self.child.stdout is not None
        with contextlib.suppress(OSError):
            self.child.stdin.write(question)
            self.child.stdin.close()
        out = self.child.stdout.read(most + 1)
        if len(out) > most:
            self.end("it wrote more than it may")
        return out

    def end(self, why: str = "", *, timed_out: bool = False) -> None:
        """End the program and its child processes; the first reason is kept."""
        if why and not self.stopped:
            self.stopped, self.timed_out = why, timed_out
        # On Windows the children of an ended program are unknown.
        if self.child.poll() is None or not operating_system.WINDOWS:
            children.end_family(self.child)
        self.child.wait()
        self._ended.set()
        if self.scratch is not None:
            folders.remove(self.scratch)


def tier() -> str:
    """Return the best tier that works on this machine.

    >>> tier() in ("bubblewrap", "limits")
    True
    """
    return "bubblewrap" if complaint() == "" else "limits"


@functools.cache
def complaint() -> str | None:
    """Return bubblewrap's error message on this machine; empty if it works, None if it is missing."""
    if _bwrap() is None:
        return None
    with tempfile.TemporaryDirectory() as work:
        probe = [*_bubblewrap(Path(work), True, {"PATH": "/usr/bin:/bin"}, Limits()), "true"]
        try:
            tried = subprocess.run(probe, stdin=subprocess.DEVNULL, stderr=subprocess.PIPE)
        except OSError as error:
            return str(error)
    said = tried.stderr.decode(errors="replace").strip()
    return "" if tried.returncode == 0 else said or f"exit code {tried.returncode}"


def refusal(*, allow_root: bool = False, unsafe: bool = False) -> str:
    """Return why other people's work must not be run here, in words for the teacher; empty if it may."""
    if tier() != "bubblewrap" and not unsafe:
        return (
            "Submissions are programs of other people, and this computer has nothing that keeps them in: "
            f"{cure(complaint())} For work that you trust as your own, add --unsafe: it can then read your files, the "
            "solutions and other submissions."
        )
    if hasattr(os, "geteuid") and os.geteuid() == 0 and not allow_root:
        return (
            "You are root, and a fault in a sandbox would then reach the whole computer. Grade as an ordinary user; where "
            "there is none, in a container for instance, add --allow-root."
        )
    return ""


def start(
    command: Sequence[str],
    work: Path,
    env: Mapping[str, str],
    limits: Limits,
    *,
    writable: bool = True,
    pipes: Sequence[int] = (),
) -> Sandboxed:
    """Run a command in a sandbox with `work` as its only own folder; stdin and stdout are pipes, `pipes` stay open too."""
    walls = (limits.tier or tier()) == "bubblewrap"
    scratch = None if walls else Path(tempfile.mkdtemp(prefix="sandbox-"))  # without walls, /tmp is shared
    inside = env_inside(env, work, writable, str(scratch or "/tmp"))
    own: list[str] = []
    around: dict[str, str] = {}
    if walls:
        own = [*confined(limits.memory, limits.processes), *_bubblewrap(work, writable, inside, limits)]
        around = {name: os.environ[name] for name in SERVICE_VARIABLES if name in os.environ}
    child = subprocess.Popen(
        [*own, *_limited(limits), *command],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        cwd=work,
        env=inside | around,
        **children.apart(),
        **inherited.given(pipes),
    )
    running = Sandboxed(child, scratch)
    threading.Thread(target=_watch, args=(running, work if writable else None, limits), daemon=True).start()
    return running


def env_inside(env: Mapping[str, str], work: Path, writable: bool = True, scratch: str = "/tmp") -> dict[str, str]:
    """Return the environment of a sandboxed program: the variables it needs, and its own home."""
    wanted = ("AMENT_PREFIX_PATH", "PYTHONPATH", "LANG", "ROS_DISTRO", "ROS_VERSION", "ROS_PYTHON_VERSION")
    kept = {name: value for name, value in env.items() if name in wanted or name.startswith("COURSEKIT_")}
    path = os.pathsep.join([str(Path(sys.executable).parent), "/usr/bin", "/bin"])
    home = str(work) if writable else scratch
    if operating_system.WINDOWS:
        kept |= {name: env[name] for name in _WINDOWS if name in env}
        kept |= {"USERPROFILE": home, "TEMP": scratch, "TMP": scratch}
        path = os.pathsep.join([str(Path(sys.executable).parent), env.get("PATH", "")])
    quiet = {"PYTHONDONTWRITEBYTECODE": "1", "MPLBACKEND": "Agg", "COLUMNS": "120", "NUMBA_CACHE_DIR": f"{scratch}/.numba"}
    single = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "NUMBA_NUM_THREADS"), "1")
    return {**kept, **quiet, **single, "PATH": path, "HOME": home, "USER": "student", "TMPDIR": scratch}


def _bwrap() -> str | None:
    """Return the path of bubblewrap, never from PATH, which may contain another program of that name."""
    if operating_system.WINDOWS or operating_system.MAC:  # only Linux has it; another program of that name is unrelated
        return None
    return next((path for path in _BWRAP if os.access(path, os.X_OK)), None)


def _bubblewrap(work: Path, writable: bool, env: Mapping[str, str], limits: Limits) -> list[str]:
    words = [_bwrap() or _BWRAP[0], "--unshare-all", "--unshare-user", "--disable-userns", "--cap-drop", "ALL"]
    words += ["--uid", _NOBODY, "--gid", _NOBODY, "--die-with-parent", "--hostname", "sandbox", "--clearenv"]
    for name, value in env.items():
        words += ["--setenv", name, value]
    # root owns the system's settings and could write them without any capability
    words += ["--proc", "/proc", "--ro-bind", "/proc/sys", "/proc/sys", "--dev", "/dev"]
    for folder in ("/tmp", "/dev/shm"):
        words += ["--size", str(limits.scratch), "--tmpfs", folder]
    for folder in (*_SYSTEM, *_python_folders()):
        words += ["--ro-bind-try", folder, folder]
    for name in _HIDDEN:
        words += ["--size", "4096", "--tmpfs", str(PACKAGE / name), "--remount-ro", str(PACKAGE / name)]
    words += ["--bind" if writable else "--ro-bind", str(work), str(work), "--chdir", str(work)]
    return [*words, "--remount-ro", "/dev", "--remount-ro", "/", "--"]


def _python_folders() -> list[str]:
    """Return the folders of interpreter, packages and coursekit, without a checkout's notebooks: they hold solutions."""
    checkout = PACKAGE.parent
    beside = [str(checkout / name) for name in ("robots", "maps")] if (checkout / "pyproject.toml").is_file() else []
    paths = [sys.base_prefix, sys.prefix, str(PACKAGE), *beside]
    return [folder for folder in dict.fromkeys(paths) if Path(folder) != Path("/usr")]


def _limited(limits: Limits) -> list[str]:
    if operating_system.WINDOWS:  # there a program can neither replace nor limit itself: only the watcher limits it
        return []
    return [sys.executable, "-I", str(Path(__file__).with_name("limited.py")), str(limits.memory), str(limits.processes),
            str(limits.file), str(int(limits.seconds) + 1), "--"]  # fmt: skip


def _watch(running: Sandboxed, work: Path | None, limits: Limits) -> None:
    """End the program when its time is over, when its processes together use too much, or when usage cannot be measured."""
    give_up = time.monotonic() + limits.seconds
    look_at_folder = 0.0
    try:
        while not running._ended.wait(LOOK_SECONDS) and running.child.poll() is None:
            now = time.monotonic()
            over = now > give_up
            why = f"it took longer than {limits.seconds:g} s" if over else _excess(running.child.pid, limits)
            if not why and work is not None and now > look_at_folder:
                look_at_folder = now + 0.5
                why = folders.excess(work, limits.folder)
            if why:
                running.end(why, timed_out=over)
                return
    except Exception as error:
        running.end(f"it could not be watched: {type(error).__name__}")


def _excess(pid: int, limits: Limits) -> str:
    family = _family(pid)
    if len(family) > limits.processes:
        return f"it started more than {limits.processes} processes"
    if sum(resident for _, resident in family) > limits.memory:
        return f"it used more than {limits.memory >> 20} MB of memory"
    return ""


def _family(pid: int) -> list[tuple[int, int]]:
    """Return (pid, resident bytes) of a process and its descendants."""
    started: dict[int, list[tuple[int, int]]] = {}
    if operating_system.WINDOWS or not Path("/proc/self/stat").exists():  # Wine shows Linux's /proc
        return []
    page = os.sysconf("SC_PAGE_SIZE")
    for entry in os.scandir("/proc"):
        if entry.name.isdigit():
            with contextlib.suppress(OSError, ValueError, IndexError):
                fields = Path(entry.path, "stat").read_text(encoding="utf-8", errors="replace").rpartition(")")[2].split()
                started.setdefault(int(fields[1]), []).append((int(entry.name), int(fields[21]) * page))
    family: list[tuple[int, int]] = []
    waiting = [pid]
    while waiting:
        for child in started.get(waiting.pop(), ()):
            family.append(child)
            waiting.append(child[0])
    return family
