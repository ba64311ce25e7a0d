"""Limits by control groups, if the system offers them to users: they apply to all processes together, immediately."""

from __future__ import annotations

import functools
import os
import subprocess

from coursekit.systems import rights

_SYSTEMD_RUN = "/usr/bin/systemd-run"
SERVICE_VARIABLES = ("XDG_RUNTIME_DIR", "DBUS_SESSION_BUS_ADDRESS")
"""The variables that systemd-run needs; the sandbox starts with an empty environment."""


def confined(memory: int, processes: int) -> list[str]:
    """Return a command prefix that creates a control group; empty without a service for that.

    >>> confined(1 << 30, 100)[:1] in ([], [_SYSTEMD_RUN])
    True
    """
    if not _works():
        return []
    return [*_words(), "-p", f"MemoryMax={memory}", "-p", "MemorySwapMax=0", "-p", f"TasksMax={processes}", "--"]


def _words() -> list[str]:
    manager = [] if rights.is_root() else ["--user"]
    return [_SYSTEMD_RUN, *manager, "--scope", "--quiet", "--collect"]


@functools.cache
def _works() -> bool:
    if not os.access(_SYSTEMD_RUN, os.X_OK):
        return False
    try:
        return subprocess.run([*_words(), "--", "true"], capture_output=True, timeout=10).returncode == 0
    except (OSError, subprocess.TimeoutExpired):
        return False
