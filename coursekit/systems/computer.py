"""Facts about this computer that the course needs."""

from __future__ import annotations

import contextlib
import platform
import subprocess
import sys
from pathlib import Path

from . import operating_system

SYNCHRONISED = ("OneDrive", "Dropbox", "Google Drive", "GoogleDrive", "iCloud Drive", "Mobile Documents", "Nextcloud")
"""Names of folders that a program synchronises with other computers."""
_LONG_PATHS = r"SYSTEM\CurrentControlSet\Control\FileSystem"


def bits() -> int:
    """Return the address size of this Python.

    >>> bits() in (32, 64)
    True
    """
    return 64 if sys.maxsize > 2**32 else 32


def is_intel_mac() -> bool:
    """Whether this is a Mac with an Intel processor, or a Python built for one."""
    return operating_system.MAC and platform.machine() == "x86_64"


def is_arm_python_on_windows() -> bool:
    """Whether this Python was built for Windows on ARM, for which few packages exist."""
    return operating_system.WINDOWS and platform.machine().upper() == "ARM64" and "ARM64" in sys.version


def socket_path_bytes() -> int:
    """Return the maximum length of a socket path in bytes, including the final zero; Windows has no such sockets.

    >>> socket_path_bytes() >= 104
    True
    """
    return 32767 if operating_system.WINDOWS else 104 if operating_system.MAC else 108


def is_from_the_store() -> bool:
    """Whether this Python is from Microsoft's Store, which redirects the files that programs write to other folders."""
    return operating_system.WINDOWS and "WindowsApps" in sys.base_prefix


def synchronised_by(folder: Path) -> str:
    """Return the program that synchronises a folder with other computers; empty if its path names none.

    >>> synchronised_by(Path("/home/vera/OneDrive - School/course"))
    'OneDrive'
    """
    named = [known for part in folder.parts for known in SYNCHRONISED if part.startswith(known)]
    return named[0] if named else ""


def has_long_paths() -> bool:
    """Whether programs may open files with paths of more than 260 characters: Windows needs a setting for it."""
    if not operating_system.WINDOWS:
        return True
    import winreg

    with contextlib.suppress(OSError), winreg.OpenKey(winreg.HKEY_LOCAL_MACHINE, _LONG_PATHS) as key:  # type: ignore[attr-defined]
        return bool(winreg.QueryValueEx(key, "LongPathsEnabled")[0])  # type: ignore[attr-defined]
    return False


def runs_scripts() -> bool:
    """Whether PowerShell runs scripts such as install\\setup.ps1; True on other systems."""
    if not operating_system.WINDOWS:
        return True
    command = ["powershell", "-NoProfile", "-NonInteractive", "-Command", "Get-ExecutionPolicy"]
    try:
        said = subprocess.run(command, capture_output=True, encoding="utf-8", errors="replace", timeout=20, check=False)
    except (OSError, subprocess.TimeoutExpired):
        return True
    return said.returncode != 0 or said.stdout.strip() not in ("Restricted", "AllSigned")
