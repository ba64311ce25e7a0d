"""Wine with a prefix of our own: programs of Windows run in it, with pipes for their streams."""

from __future__ import annotations

import os
import re
import select
import shutil
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import BinaryIO

ROOT = Path(__file__).resolve().parents[2]
HOME = Path(os.environ.get("COURSEKIT_WINE") or Path.home() / ".cache" / "coursekit" / "wine")
"""Where the prefix, the Python and what Wine lacks lie; they are made once."""
VENV = HOME / "venv"
COMMANDS = HOME / "commands"
PYTHON = VENV / "Scripts" / "python.exe"
LOOK_SECONDS = 0.5
"""How often it is looked whether a program that says nothing has ended."""
_UNWANTED = ("PYTHONDONTWRITEBYTECODE", "PYTHONUNBUFFERED", "PIP_FIND_LINKS", "VIRTUAL_ENV")
"""Settings of the system outside that mean something else inside."""


def is_there() -> bool:
    """Whether this computer has Wine."""
    return shutil.which("wine") is not None


def version() -> int:
    """Wine's version; 0 where there is none.

    >>> version() >= 0
    True
    """
    if not is_there():
        return 0
    done = subprocess.run(["wine", "--version"], env=environment(), stdout=subprocess.PIPE, encoding="utf-8", check=False)
    match = re.search(r"wine-(\d+)", done.stdout)
    return int(match[1]) if match else 0


def windows_path(path: Path) -> str:
    r"""How a program in Wine calls a file.

    >>> windows_path(Path("/tmp/two words"))
    'Z:\\tmp\\two words'
    """
    return "Z:" + str(path).replace("/", "\\")


def environment(extra: Mapping[str, str] | None = None) -> dict[str, str]:
    """The variables that programs of Windows see: a prefix of ours, and pip's certificates as they are called there."""
    env = {name: value for name, value in os.environ.items() if name not in _UNWANTED}
    path = ";".join(map(windows_path, (VENV / "Scripts", COMMANDS)))
    env |= {"WINEPREFIX": str(HOME / "prefix"), "WINEDEBUG": "-all", "WINEPATH": path}
    env |= {"PIP_DISABLE_PIP_VERSION_CHECK": "1", "PIP_CONFIG_FILE": "nul"}
    certificates = Path(env.get("PIP_CERT") or "/etc/ssl/certs/ca-certificates.crt")
    if certificates.is_file():
        env["PIP_CERT"] = windows_path(certificates)
    return env | dict(extra or {})


def start_services() -> None:
    """Start what Wine runs in the background by itself: else it would hold the pipes of the first program open."""
    quiet = subprocess.DEVNULL
    subprocess.run(["wine", "cmd", "/c", "exit"], env=environment(), stdin=quiet, stdout=quiet, stderr=quiet, check=False)


def stop_services() -> None:
    """End what is left in our prefix, and nothing else."""
    subprocess.run(["wineserver", "-k"], env=environment(), stderr=subprocess.DEVNULL, check=False)


def run(
    *words: str | Path,
    extra: Mapping[str, str] | None = None,
    folder: Path = ROOT,
    seconds: float | None = None,
    to: BinaryIO | None = None,
) -> int:
    """Run a program of Windows and show what it says; its exit code, or 124 when it takes longer than `seconds`.

    Its streams are pipes: a child of a venv's python.exe loses other ones in Wine.
    """
    start_services()
    command = ["timeout", "-k", "10", str(seconds), "wine"] if seconds else ["wine"]
    pipe = subprocess.PIPE
    with subprocess.Popen(
        [*command, *map(str, words)], env=environment(extra), cwd=folder, stdin=pipe, stdout=pipe, stderr=subprocess.STDOUT
    ) as child:
        assert child.stdin and child.stdout
        child.stdin.close()
        out = to or sys.stdout.buffer
        while _has_more(child):
            data = os.read(child.stdout.fileno(), 65536)
            if not data:
                break
            out.write(data)
            out.flush()
        return child.wait()


def _has_more(child: subprocess.Popen[bytes]) -> bool:
    """Whether there is something to read, or may be: what a program left in the background may hold the pipe for minutes."""
    assert child.stdout
    while not select.select([child.stdout], [], [], LOOK_SECONDS)[0]:
        if child.poll() is not None:
            return False
    return True


def must_run(*words: str | Path) -> None:
    """Run a program of Windows that has to succeed; SystemExit says which one did not."""
    if code := run(*words):
        raise SystemExit(f"{' '.join(map(str, words))} ended with {code} under Wine")
