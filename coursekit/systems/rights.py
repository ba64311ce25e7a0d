"""Folders and files that only this user can open: by their mode, and on Windows by their access control list."""

from __future__ import annotations

import os
import re
import stat
from pathlib import Path

from . import access_lists, operating_system

_OURS = "D:P(A;OICI;FA;;;SY)(A;OICI;FA;;;BA)(A;OICI;FA;;;{user})"
"""The system, administrators and the user, in Windows' notation of access control lists; nothing is inherited."""
_TRUSTED = ("SY", "BA", "LA", "DA", "OW", "CO")
"""The accounts allowed in such a list beside the user: the system, administrators, the owner."""
_ENTRY = re.compile(r"\(([^;()]*);[^;()]*;[^;()]*;[^;()]*;[^;()]*;([^;()]*)[;)]")


def make_folder(path: Path) -> None:
    """Create a folder for this user only, unless it exists; raises OSError."""
    fresh = not path.exists()
    path.mkdir(mode=0o700, parents=True, exist_ok=True)
    if fresh and access_lists.THERE:
        access_lists.write(path, _OURS.format(user=access_lists.user()))


def fault(path: Path) -> str:
    """Return why others could read a folder, or replace it; empty when they cannot."""
    if access_lists.THERE:
        others = readers(access_lists.read(path), access_lists.user())
        return f"'{path}' can be opened by others: {', '.join(others)}" if others else ""
    status = path.lstat()
    if path.is_symlink() or status.st_uid != os.getuid():
        return f"'{path}' is a link or belongs to another user"
    if stat.S_IMODE(status.st_mode) & 0o077:
        return f"'{path}' can be opened by others (mend that with: chmod 700 '{path}')"
    return ""


def is_root() -> bool:
    """Whether this program has all rights; Windows' administrators must confirm each time, and do not count.

    >>> is_root() == (not operating_system.WINDOWS and os.geteuid() == 0)
    True
    """
    return not operating_system.WINDOWS and os.geteuid() == 0


def user_name() -> str:
    """Return the user-specific part of a file name, for folders shared by several users."""
    return os.environ.get("USERNAME", "user") if operating_system.WINDOWS else str(os.getuid())


def readers(access: str, user: str) -> list[str]:
    """Return the accounts other than the user and administrators with access to a file, according to an SDDL list.

    >>> readers("D:(A;OICI;FA;;;SY)(A;;FR;;;WD)(A;;FA;;;S-1-5-21-7-1001)(D;;FA;;;BG)", "S-1-5-21-7-1001")
    ['WD']
    """
    _, there, entries = access.partition("D:")
    if not there or "NO_ACCESS_CONTROL" in entries:
        return ["everybody"]
    return [who for kind, who in _ENTRY.findall(entries) if not kind.endswith("D") and who not in (*_TRUSTED, user)]


def write_text(path: Path, text: str) -> None:
    """Write a file that is for this user only from its creation on; an existing file is replaced."""
    path.unlink(missing_ok=True)
    number = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    with os.fdopen(number, "w", encoding="utf-8") as file:
        file.write(text)


__all__ = ["fault", "is_root", "make_folder", "readers", "user_name", "write_text"]
