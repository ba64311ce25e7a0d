"""The kind of this computer, where the course has to know it."""

from __future__ import annotations

import contextlib
import platform
import subprocess
import sys
from pathlib import Path

from . import which

SYNCHRONISED = ("OneDrive", "Dropbox", "Google Drive", "GoogleDrive", "iCloud Drive", "Mobile Documents", "Nextcloud")
"""Names of folders that a program copies to other computers while it is worked in."""
_LONG_PATHS = r"SYSTEM\CurrentControlSet\Control\FileSystem"


def bits() -> int:
    """How wide this Python's addresses are.

    >>> bits() in (32, 64)
    True
    """
    return 64 if sys.maxsize > 2**32 else 32


def is_intel_mac() -> bool:
    """Whether this is a Mac with Intel's processor, or a Python made for one."""
    return which.MAC and platform.machine() == "x86_64"


def is_arm_python_on_windows() -> bool:
    """Whether this Python was made for Windows on ARM, for which few packages exist."""
    return which.WINDOWS and platform.machine().upper() == "ARM64" and "ARM64" in sys.version


def socket_path_bytes() -> int:
    """How many bytes the path of a socket may have, with the zero at its end; Windows has none of that kind.

    >>> socket_path_bytes() >= 104
    True
    """
    return 32767 if which.WINDOWS else 104 if which.MAC else 108


def is_from_the_store() -> bool:
    """Whether this Python was installed from Microsoft's Store, which shows programs other folders than it writes to."""
    return which.WINDOWS and "WindowsApps" in sys.base_prefix


def synchronised_by(folder: Path) -> str:
    """By which program a folder is copied to other computers; empty when its path names none.

    >>> synchronised_by(Path("/home/vera/OneDrive - School/course"))
    'OneDrive'
    """
    named = [known for part in folder.parts for known in SYNCHRONISED if part.startswith(known)]
    return named[0] if named else ""


def has_long_paths() -> bool:
    """Whether programs may open files whose paths have more than 260 characters: Windows has to be told."""
    if not which.WINDOWS:
        return True
    import winreg

    with contextlib.suppress(OSError), winreg.OpenKey(winreg.HKEY_LOCAL_MACHINE, _LONG_PATHS) as key:  # type: ignore[attr-defined]
        return bool(winreg.QueryValueEx(key, "LongPathsEnabled")[0])  # type: ignore[attr-defined]
    return False


def runs_scripts() -> bool:
    """Whether PowerShell runs scripts such as install\\setup.ps1; True where there is none."""
    if not which.WINDOWS:
        return True
    command = ["powershell", "-NoProfile", "-NonInteractive", "-Command", "Get-ExecutionPolicy"]
    try:
        said = subprocess.run(command, capture_output=True, encoding="utf-8", errors="replace", timeout=20, check=False)
    except (OSError, subprocess.TimeoutExpired):
        return True
    return said.returncode != 0 or said.stdout.strip() not in ("Restricted", "AllSigned")
