"""A folder through which a teacher and students of one server exchange files, laid out like nbgrader's exchange.

    outbound/WEEK2/...                         the teacher's releases; readable by everybody
    inbound/BEN+WEEK2+TIME+RANDOM/...          the students' submissions; only the teacher can list them

Therefore `nbgrader list`, `fetch`, `submit` and `collect` work with the same folder. The server sets
COURSEKIT_EXCHANGE.
"""

from __future__ import annotations

import contextlib
import datetime
import os
import secrets
import shutil
from collections.abc import Sequence
from pathlib import Path

from coursekit.files import write_whole

from .platform_names import platform_name

VARIABLE = "COURSEKIT_EXCHANGE"
OUTBOUND, INBOUND = "outbound", "inbound"
_READABLE, _ONLY_TO_PUT = 0o2755, 0o2733
"""Students can read; students can add files without seeing those of others."""


def hand_out(exchange: Path, name: str, files: Sequence[Path], beside: Path) -> Path:
    """Put files from below `beside` into the exchange as a release of that name. Returns its folder; OSError on failure."""
    target = _made(exchange / OUTBOUND, _READABLE) / name
    for file in files:
        copy = target / file.relative_to(beside)
        copy.parent.mkdir(parents=True, exist_ok=True)
        write_whole(copy, file.read_bytes(), 0o644)
    for folder in (target, *(path for path in target.rglob("*") if path.is_dir())):
        folder.chmod(_READABLE)
    _made(exchange / INBOUND, _ONLY_TO_PUT)
    return target


def releases(exchange: Path) -> list[Path]:
    """Return the released folders, by name; empty without an exchange."""
    with contextlib.suppress(OSError):
        return sorted(path for path in (exchange / OUTBOUND).iterdir() if path.is_dir())
    return []


def hand_in(exchange: Path, user: str, name: str, files: Sequence[Path]) -> Path:
    """Put copies of a student's files into the exchange, as a folder that appears at once; OSError on failure."""
    now = datetime.datetime.now(datetime.timezone.utc)
    when = now.strftime("%Y-%m-%d %H:%M:%S.%f UTC")
    # The name must be unguessable, because anyone who knows it could read it: as in nbgrader.
    place = exchange / INBOUND / f"{user}+{name}+{when}+{secrets.token_urlsafe(32)}"
    making = place.with_name(f".{secrets.token_urlsafe(32)}")
    making.mkdir(mode=0o755)
    try:
        for file in files:
            write_whole(making / file.name, file.read_bytes(), 0o644)
        write_whole(making / "timestamp.txt", when, 0o644)
        making.chmod(0o755)
        making.rename(place)
    except OSError:
        shutil.rmtree(making, ignore_errors=True)
        raise
    return place


def false_owner(folder: Path) -> str:
    """Return the fault of a submitted folder whose owner is another user of this computer than its name states."""
    told = platform_name(folder.name)
    if told is None or told.platform != "nbgrader" or os.path.expanduser(f"~{told.name}").startswith("~"):
        return ""  # or no user of this computer: a container's students share one user
    try:
        owner = folder.owner()
    except (KeyError, OSError, NotImplementedError):
        owner = "somebody else"
    return "" if owner == told.name else f"was not read: it names {told.name}, but {owner} put it there"


def _made(folder: Path, mode: int) -> Path:
    if not folder.is_dir():
        folder.mkdir(parents=True)
        folder.chmod(mode)
    return folder
