"""The users of a router: a file of lines USER:PASSWORD."""

from __future__ import annotations

import re
from pathlib import Path

from .errors import NoNetwork

_LINE = re.compile(r"[^\s:]+:\S.*")


def first_user(path: Path) -> tuple[str, str]:
    """Return the name and the password in the first line of a file already validated by `check_users`."""
    first = next(line.strip() for line in path.read_text(encoding="utf-8").splitlines() if line.strip())
    user, _, password = first.partition(":")
    return user, password


def check_users(path: Path) -> int:
    r"""Return the number of users in a file.

    Raises:
        NoNetwork: when the file is unreadable or malformed.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "users")
    ...     _ = file.write_text("ada:secret\nbob:hidden\n", encoding="utf-8")
    ...     check_users(file), first_user(file)
    (2, ('ada', 'secret'))
    """
    try:
        lines = [line for line in path.read_text(encoding="utf-8").splitlines() if line.strip()]
    except (OSError, UnicodeDecodeError) as error:
        raise NoNetwork(f"The file of users cannot be read: {error}") from None
    for number, line in enumerate(lines, 1):
        if not _LINE.fullmatch(line):
            raise NoNetwork(f"Line {number} of {path.name} is no user. Write: NAME:PASSWORD")
    if not lines:
        raise NoNetwork(f"{path.name} names nobody. Write a line for each user: NAME:PASSWORD")
    return len(lines)
