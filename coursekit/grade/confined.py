"""Limits by control groups, where the system lends some to its users: they hold for all processes together, at once."""

from __future__ import annotations

import functools
import os
import subprocess

from coursekit.systems import rights

_SYSTEMD_RUN = "/usr/bin/systemd-run"
SERVICE_VARIABLES = ("XDG_RUNTIME_DIR", "DBUS_SESSION_BUS_ADDRESS")
"""The variables that it needs; the sandbox begins with an empty environment."""


def confined(memory: int, processes: int) -> list[str]:
    """Words before a command that give it a control group of its own; none where there is no service for that.

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
