"""The user's private folder for sockets and similar files."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from pathlib import Path

from coursekit.systems import rights, shell_spelling
from coursekit.systems.computer import socket_path_bytes


def folder() -> Path:
    """Return the folder, created on first use. PermissionError when others can open every candidate.

    Tests that pytest-xdist runs in parallel, and the programs that they start, have one for each worker.
    """
    path = choose()[0]
    worker = os.environ.get("PYTEST_XDIST_WORKER")
    if worker:
        path /= worker
        rights.make_folder(path)
    return path


def choose() -> tuple[Path, list[str]]:
    """Return the folder, and the problems of the candidates before it; PermissionError as in `folder`."""
    faults: list[str] = []
    for path in _places():
        fault = _fault(path)
        if not fault:
            return path, faults
        faults.append(fault)
    raise PermissionError(
        f"{'; '.join(faults)}. So there is no safe place for sessions to listen. Name a folder of yours, and start again: "
        + shell_spelling.set_variable("COURSEKIT_RUNTIME_DIR", "~/coursekit-run")
    )


def _places() -> Iterator[Path]:
    """Yield the user's runtime folder, or one in /tmp (which another user may have created), then one in the home folder."""
    named = os.environ.get("COURSEKIT_RUNTIME_DIR")
    if named:
        yield Path(named).expanduser() / "coursekit"
        return
    if os.environ.get("XDG_RUNTIME_DIR"):
        yield Path(os.environ["XDG_RUNTIME_DIR"]) / "coursekit"
    yield Path(tempfile.gettempdir()) / f"coursekit-{rights.user_name()}"
    yield Path.home() / ".cache" / "coursekit" / "run"


def _fault(path: Path) -> str:
    """Create the folder; return why it cannot be used, '' when it can."""
    socket = path / f"session-{os.environ.get('ROS_DOMAIN_ID') or 0}-{os.getpid()}"
    length, most = len(os.fsencode(socket)), socket_path_bytes() - 1
    if length > most:
        return f"'{path}' is too long a path: a socket in it would have {length} bytes, and {most} are allowed"
    try:
        rights.make_folder(path)
        return rights.fault(path)
    except OSError as error:
        return f"'{path}' cannot be made ({error.strerror})"


__all__ = ["choose", "folder"]
