"""The variables of a CMakeLists.txt: their scopes, their expansion, and the commands that change them."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from coursekit.packages.cmake_text import Command

_REFERENCE = re.compile(r"\$(ENV)?\{([^${}]*)\}")
_DEEPEST = 20
"""Maximum depth of nested variable references."""


def _parts(text: str) -> list[str]:
    """Return the elements of a list.

    >>> _parts("a;;b")
    ['a', 'b']
    """
    return [part for part in text.split(";") if part]


class Variables:
    """The variables in the current folder and function.

    >>> variables = Variables(Path("robot"))
    >>> variables.set_command(["NODES", "talker", "listener"])
    >>> with variables.inside({"NAME": "inner"}):
    ...     variables.set_command(["NODES", "alone", "PARENT_SCOPE"])
    ...     variables.expand("${NAME}: ${NODES}")
    'inner: talker;listener'
    >>> variables.expand("${NAME}: ${NODES}")
    ': alone'
    """

    def __init__(self, folder: Path) -> None:
        self.values = {
            "CMAKE_SOURCE_DIR": str(folder),
            "CMAKE_CURRENT_SOURCE_DIR": str(folder),
            "CMAKE_CURRENT_LIST_DIR": str(folder),
            "PROJECT_SOURCE_DIR": str(folder),
            "CMAKE_INSTALL_PREFIX": "",
            "UNIX": "1",
            "CMAKE_INSTALL_LIBDIR": "lib",
            "CMAKE_INSTALL_BINDIR": "bin",
            "CMAKE_INSTALL_DATADIR": "share",
            "CMAKE_INSTALL_INCLUDEDIR": "include",
            "CMAKE_BUILD_TYPE": "Release",
            "ROS_DISTRO": "humble",
        }
        self._outer: list[dict[str, str]] = []
        """The variables of the calling functions and parent folders."""

    @contextmanager
    def inside(self, given: dict[str, str]) -> Iterator[None]:
        """Open a scope, as functions and folders do: variables set in it are dropped at its end."""
        self._outer.append(self.values)
        self.values = self.values | given
        yield
        self.values = self._outer.pop()

    @contextmanager
    def lent(self, given: dict[str, str]) -> Iterator[None]:
        """Set the arguments of a macro, which has no scope of its own: only they are dropped at its end."""
        before = {name: self.values.get(name) for name in given}
        self.values |= given
        yield
        self.values = {**self.values, **{name: value or "" for name, value in before.items()}}

    def words(self, command: Command) -> list[str]:
        """Return the arguments of a command with variables expanded; unquoted lists become several arguments."""
        words: list[str] = []
        for argument in command.arguments:
            text = self.expand(argument.text)
            words += [text] if argument.quoted else _parts(text)
        return words

    def expand(self, text: str) -> str:
        """Expand the variables in a text; an unknown one is empty."""
        for _ in range(_DEEPEST):
            replaced = _REFERENCE.sub(self._value, text)
            if replaced == text:
                break
            text = replaced
        return text

    def _value(self, match: re.Match[str]) -> str:
        return os.environ.get(match[2], "") if match[1] else self.values.get(match[2], "")

    def elements(self, name: str) -> list[str]:
        """Return the elements of a list variable."""
        return _parts(self.values.get(name, ""))

    def set_command(self, words: list[str]) -> None:
        """set(NAME VALUES... [CACHE ...] [PARENT_SCOPE])."""
        values = words[1:]
        for stop in ("CACHE", "PARENT_SCOPE"):
            values = values[: values.index(stop)] if stop in values else values
        if words:
            self._meant(words)[words[0]] = ";".join(values)

    def unset_command(self, words: list[str]) -> None:
        """unset(NAME [PARENT_SCOPE])."""
        self._meant(words).pop((words or [""])[0], None)

    def _meant(self, words: list[str]) -> dict[str, str]:
        return self._outer[-1] if "PARENT_SCOPE" in words and self._outer else self.values

    def list_command(self, words: list[str]) -> None:
        """list(APPEND|PREPEND|REMOVE_ITEM|REMOVE_DUPLICATES NAME ...).

        >>> variables = Variables(Path("robot"))
        >>> variables.list_command(["APPEND", "NODES", "talker", "listener"])
        >>> variables.list_command(["REMOVE_ITEM", "NODES", "talker"])
        >>> variables.elements("NODES")
        ['listener']
        """
        if len(words) > 2 and words[0] in ("APPEND", "PREPEND"):
            known = self.elements(words[1])
            self.values[words[1]] = ";".join(known + words[2:] if words[0] == "APPEND" else words[2:] + known)
        elif len(words) > 1 and words[0] in ("REMOVE_ITEM", "REMOVE_DUPLICATES"):
            known = self.values.get(words[1], "").split(";")
            left = dict.fromkeys(known) if words[0] == "REMOVE_DUPLICATES" else [v for v in known if v not in words[2:]]
            self.values[words[1]] = ";".join(left)
