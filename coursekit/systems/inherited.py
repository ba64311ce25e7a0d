"""Additional pipes for a child: by file descriptor, or on Windows by handle."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Sequence
from typing import Any

from . import operating_system


def name_for_child(pipe: int) -> str:
    """Return the name by which a child can open an inherited pipe.

    >>> name_for_child(7)
    '7'
    """
    return str(_handle(pipe)) if operating_system.WINDOWS else str(pipe)


def given(pipes: Sequence[int]) -> dict[str, Any]:
    """Return the arguments of `subprocess.Popen` that let a child inherit these pipes.

    >>> given([7, 8])
    {'pass_fds': (7, 8)}
    """
    if not operating_system.WINDOWS:
        return {"pass_fds": tuple(pipes)}
    handles = [_handle(pipe) for pipe in pipes]
    for handle in handles:
        os.set_handle_inheritable(handle, True)  # type: ignore[attr-defined]
    info: Any = subprocess.STARTUPINFO()  # type: ignore[attr-defined]
    info.lpAttributeList = {"handle_list": handles}
    return {"startupinfo": info} if handles else {}


def opened(name: str) -> int:
    """Return, in the child, the file descriptor of an inherited pipe.

    >>> opened("7")
    7
    """
    if not operating_system.WINDOWS:
        return int(name)
    import msvcrt

    return int(msvcrt.open_osfhandle(int(name), 0))  # type: ignore[attr-defined]


def _handle(pipe: int) -> int:
    import msvcrt

    return int(msvcrt.get_osfhandle(pipe))  # type: ignore[attr-defined]
