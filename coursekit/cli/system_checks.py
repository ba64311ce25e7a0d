"""Checks of `coursekit doctor` for particular computers: each returns None if there is nothing to report."""

from __future__ import annotations

import platform
import sys
from collections.abc import Callable
from pathlib import Path

from coursekit.systems import computer

from .check import Check

NEWEST = (3, 14)
"""The newest Python for which all of the course's dependencies have packages."""
NEWEST_ON_INTEL_MACS = (3, 13)
"""The same for Macs with Intel processors, for which Numba no longer has packages."""
MOST_CHARACTERS = 120
"""The maximum length of a folder's path where Windows limits paths to 260 characters: builds add the rest."""
ARM = (
    "OpenCV has no package for Python on ARM",
    "Install 'Windows installer (64-bit)' from https://www.python.org/downloads/, which runs on ARM too; then delete .venv.",
)


def interpreter() -> Check | None:
    """Check for a Python with packages."""
    version = platform.python_version()
    if computer.bits() == 32:
        cure = "Install 'Windows installer (64-bit)' from https://www.python.org/downloads/; then delete .venv."
        return Check("packages", version, "this Python has 32 bits; NumPy and OpenCV have packages for 64", cure)
    if computer.is_arm_python_on_windows():
        return Check("packages", version, *ARM)
    if computer.is_intel_mac() and sys.version_info[:2] > NEWEST_ON_INTEL_MACS:
        cure = "Install Python 3.13 from https://www.python.org/downloads/, and make .venv with that."
        return Check("packages", version, "Numba has no package for Macs with Intel's processor and this Python", cure)
    if sys.version_info[:2] > NEWEST:
        fault = f"Python {version} is newer than the packages that the course needs"
        return Check(
            "packages", version, fault, "Install Python 3.13 beside it, and make .venv with that.", only_warning=True
        )
    if computer.is_from_the_store():
        fault = "this Python is the Store's: programs see other folders than it writes to"
        return Check("packages", version, fault, "Install one from https://www.python.org/downloads/.", only_warning=True)
    return None


def folder_of_the_course() -> Check | None:
    """Check for a folder in which many small files can be written and replaced."""
    folder = Path.cwd()
    by = computer.synchronised_by(folder)
    if by:
        fault = f"{by} copies this folder while you build in it, which makes builds slow, and some fail"
        cure = "Work in a folder outside of it: coursekit lab --folder ~/course"
        return Check("folder", str(folder), fault, cure, only_warning=True)
    if not computer.has_long_paths() and len(str(folder)) > MOST_CHARACTERS:
        fault = f"this folder's path has {len(str(folder))} characters, and Windows takes 260 for a file"
        cure = r"Work in a shorter one, such as C:\course; or switch on 'long paths' in Windows' settings for developers."
        return Check("folder", str(folder), fault, cure, only_warning=True)
    return None


def scripts() -> Check | None:
    """Check that PowerShell runs colcon's scripts."""
    if computer.runs_scripts():
        return None
    cure = "Type: Set-ExecutionPolicy -Scope CurrentUser RemoteSigned"
    return Check("PowerShell", "", r"it refuses scripts, and so . install\setup.ps1", cure, only_warning=True)


SYSTEM_CHECKS: tuple[Callable[[], Check | None], ...] = (interpreter, folder_of_the_course, scripts)


def run_system_checks() -> list[Check]:
    """Return remarks about this computer; empty if there are none."""
    return [remark for check in SYSTEM_CHECKS if (remark := check()) is not None]
