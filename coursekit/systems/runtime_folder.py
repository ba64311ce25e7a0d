"""The user's own folder for sockets and the like, which nobody else can open."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from pathlib import Path

from coursekit.systems import rights, typed
from coursekit.systems.computer import socket_path_bytes


def folder() -> Path:
    """The folder; made on first use. PermissionError when every place for it can be opened by others.

    Tests that pytest-xdist runs side by side, and the programs that they start, have one for each worker.
    """
    path = choose()[0]
    worker = os.environ.get("PYTEST_XDIST_WORKER")
    if worker:
        path /= worker
        rights.make_folder(path)
    return path


def choose() -> tuple[Path, list[str]]:
    """The folder, and what is wrong with the places that come before it; PermissionError as `folder`."""
    faults: list[str] = []
    for path in _places():
        fault = _fault(path)
        if not fault:
            return path, faults
        faults.append(fault)
    raise PermissionError(
        f"{'; '.join(faults)}. So there is no safe place for sessions to listen. Name a folder of yours, and start again: "
        + typed.set_variable("COURSEKIT_RUNTIME_DIR", "~/coursekit-run")
    )


def _places() -> Iterator[Path]:
    """The user's runtime folder, else one in /tmp, which somebody else may have taken, else one at home."""
    named = os.environ.get("COURSEKIT_RUNTIME_DIR")
    if named:
        yield Path(named).expanduser() / "coursekit"
        return
    if os.environ.get("XDG_RUNTIME_DIR"):
        yield Path(os.environ["XDG_RUNTIME_DIR"]) / "coursekit"
    yield Path(tempfile.gettempdir()) / f"coursekit-{rights.user_name()}"
    yield Path.home() / ".cache" / "coursekit" / "run"


def _fault(path: Path) -> str:
    """Make the folder; why it cannot be used, '' when it can."""
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
