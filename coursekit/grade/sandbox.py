"""A place where a student's code can do no harm: no network, no files but its own, limits on everything.

Tiers, the best that works here is taken and named in each result: `bubblewrap` (own namespaces, only the folders that
are needed, read-only), then `limits` (a process of its own with limits, but the files and network of the user).
"""

from __future__ import annotations

import contextlib
import functools
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1]
_SYSTEM = ("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/etc/alternatives", "/etc/fonts", "/etc/ld.so.cache")

LOOK_SECONDS = 0.15
"""How often it is seen what a program uses: each look reads the list of all processes."""


@dataclass(frozen=True)
class Limits:
    """What a sandboxed program may use."""

    seconds: float = 120.0
    """Real time."""
    memory: int = 3 << 30
    """Bytes of address space of each process, and of resident memory of all together."""
    processes: int = 150
    """Processes and threads."""
    file: int = 64 << 20
    """Bytes of one file."""
    folder: int = 256 << 20
    """Bytes of all files of the work folder."""
    output: int = 8 << 20
    """Bytes that are read from it."""


@dataclass
class Sandboxed:
    """A running program and, afterwards, why it was ended if it was."""

    child: subprocess.Popen[bytes]
    stopped: str = ""
    _ended: threading.Event = field(default_factory=threading.Event)

    def answer(self, question: bytes, most: int) -> bytes:
        """Give it the question and hang up; what it wrote until it ended, `most` bytes of it."""
        assert self.child.stdin is not None and self.child.stdout is not None
        with contextlib.suppress(BrokenPipeError):
            self.child.stdin.write(question)
            self.child.stdin.close()
        out = self.child.stdout.read(most + 1)
        if len(out) > most:
            self.end("it wrote more than it may")
        return out

    def end(self, why: str = "") -> None:
        """End it and all that it started."""
        self.stopped = self.stopped or why
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(self.child.pid, signal.SIGKILL)
        with contextlib.suppress(ProcessLookupError):
            self.child.kill()
        self.child.wait()
        self._ended.set()


@functools.cache
def tier() -> str:
    """The best tier that works on this machine.

    >>> tier() in ("bubblewrap", "limits")
    True
    """
    bwrap = shutil.which("bwrap")
    if bwrap is None:
        return "limits"
    probe = [bwrap, "--unshare-all", "--die-with-parent", "--ro-bind", "/", "/", "--proc", "/proc", "--dev", "/dev", "true"]
    with contextlib.suppress(OSError):
        if subprocess.run(probe, capture_output=True).returncode == 0:
            return "bubblewrap"
    return "limits"


def start(
    command: Sequence[str], work: Path, env: Mapping[str, str], limits: Limits, *, writable: bool = True
) -> Sandboxed:
    """Run a command in a sandbox whose only own folder is `work`; its stdin and stdout are pipes."""
    inside = env_inside(env, work)
    words = [*(_bubblewrap(work, writable, inside) if tier() == "bubblewrap" else ()), *_limited(limits), *command]
    child = subprocess.Popen(
        words,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        cwd=work,
        env=inside,
        start_new_session=True,
    )
    running = Sandboxed(child)
    threading.Thread(target=_watch, args=(running, work, limits), daemon=True).start()
    return running


def env_inside(env: Mapping[str, str], work: Path) -> dict[str, str]:
    """What a sandboxed program sees of the environment: what it needs, and a home of its own."""
    wanted = ("AMENT_PREFIX_PATH", "PYTHONPATH", "LANG", "ROS_DISTRO", "ROS_VERSION", "ROS_PYTHON_VERSION")
    kept = {name: value for name, value in env.items() if name in wanted or name.startswith("COURSEKIT_")}
    path = os.pathsep.join([str(Path(sys.executable).parent), "/usr/bin", "/bin"])
    quiet = {"PYTHONDONTWRITEBYTECODE": "1", "MPLBACKEND": "Agg", "COLUMNS": "120", "NUMBA_CACHE_DIR": str(work / ".numba")}
    single = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "NUMBA_NUM_THREADS"), "1")
    return {**kept, **quiet, **single, "PATH": path, "HOME": str(work), "USER": "student", "TMPDIR": "/tmp"}


def _bubblewrap(work: Path, writable: bool, env: Mapping[str, str]) -> list[str]:
    words = ["bwrap", "--unshare-all", "--die-with-parent", "--hostname", "sandbox", "--clearenv"]
    for name, value in env.items():
        words += ["--setenv", name, value]
    words += ["--proc", "/proc", "--dev", "/dev", "--tmpfs", "/tmp", "--size", str(64 << 20), "--tmpfs", "/dev/shm"]
    for folder in _SYSTEM:
        words += ["--ro-bind-try", folder, folder]
    for folder in _python_folders():
        words += ["--ro-bind-try", folder, folder]
    words += ["--tmpfs", str(PACKAGE / "grade" / "chapters")]
    return [*words, "--bind" if writable else "--ro-bind", str(work), str(work), "--chdir", str(work), "--"]


def _python_folders() -> list[str]:
    """The interpreter, its packages and coursekit; of a checkout nothing else: its notebooks hold solutions."""
    checkout = PACKAGE.parent
    beside = [str(checkout / name) for name in ("robots", "maps")] if (checkout / "pyproject.toml").is_file() else []
    found = [sys.base_prefix, sys.prefix, str(PACKAGE), *beside]
    return [one for one in dict.fromkeys(found) if Path(one) != Path("/usr")]


def _limited(limits: Limits) -> list[str]:
    return [sys.executable, "-I", str(Path(__file__).with_name("limited.py")), str(limits.memory), str(limits.processes),
            str(limits.file), str(int(limits.seconds) + 1), "--"]  # fmt: skip


def _watch(running: Sandboxed, work: Path, limits: Limits) -> None:
    """End it when its time is over, or when all its processes together use too much."""
    give_up = time.monotonic() + limits.seconds
    look_at_folder = 0.0
    while not running._ended.wait(LOOK_SECONDS) and running.child.poll() is None:
        now = time.monotonic()
        if now > give_up:
            running.end(f"it took longer than {limits.seconds:g} s")
            return
        family = _family(running.child.pid)
        if len(family) > limits.processes:
            running.end(f"it started more than {limits.processes} processes")
        elif sum(resident for _, resident in family) > limits.memory:
            running.end(f"it used more than {limits.memory >> 20} MB of memory")
        elif now > look_at_folder:
            look_at_folder = now + 0.5
            if _size(work) > limits.folder:
                running.end(f"it wrote more than {limits.folder >> 20} MB of files")


def _family(pid: int) -> list[tuple[int, int]]:
    """(pid, resident bytes) of a process and all that it started."""
    children: dict[int, list[tuple[int, int]]] = {}
    if not Path("/proc/self/stat").exists():
        return []
    page = os.sysconf("SC_PAGE_SIZE")
    for entry in os.scandir("/proc"):
        if entry.name.isdigit():
            with contextlib.suppress(OSError, ValueError, IndexError):
                fields = Path(entry.path, "stat").read_text().rpartition(")")[2].split()
                children.setdefault(int(fields[1]), []).append((int(entry.name), int(fields[21]) * page))
    found: list[tuple[int, int]] = []
    waiting = [pid]
    while waiting:
        for child in children.get(waiting.pop(), ()):
            found.append(child)
            waiting.append(child[0])
    return found


def _size(folder: Path) -> int:
    total = 0
    for place, _, files in os.walk(folder):
        for name in files:
            with contextlib.suppress(OSError):
                total += os.lstat(os.path.join(place, name)).st_size
    return total
