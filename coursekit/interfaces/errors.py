"""Errors of an interface: in its text, its name or its bytes."""

from __future__ import annotations

from collections.abc import Iterable

from coursekit.suggestions import hint


class InterfaceError(ValueError):
    """An error in a definition file.

    Carries the location: `file`, `line` (1-based), `column` (1-based), `source` (the text of that line).

    >>> print(InterfaceError("unknown type 'flot'", file='A.msg', line=2, column=1, source='flot x'))
    A.msg:2:1: unknown type 'flot'
      flot x
      ^
    """

    def __init__(
        self, message: str, *, file: str = "", line: int = 0, column: int = 1, source: str = ""
    ) -> None:
        super().__init__(message)
        self.message, self.file, self.line, self.column, self.source = message, file, line, column, source

    def __str__(self) -> str:
        if not self.line:
            return f"{self.file}: {self.message}" if self.file else self.message
        caret = " " * (self.column - 1) + "^"
        return (
            f"{self.file or '<text>'}:{self.line}:{self.column}: {self.message}\n  {self.source}\n  {caret}"
        )


class UnknownInterface(LookupError):
    """No definition of that name exists in any sourced workspace or in the underlay.

    >>> print(UnknownInterface("std_msgs/msg/Strng", ["std_msgs/msg/String"]))
    no interface 'std_msgs/msg/Strng' found; did you mean std_msgs/msg/String?
    """

    def __init__(self, name: str, known: Iterable[str] = ()) -> None:
        self.name = name
        self.known = sorted(known)
        super().__init__(f"no interface '{name}' found{hint(name, self.known, 3)}")

    def __str__(self) -> str:
        return str(self.args[0])


class CdrError(ValueError):
    """Bytes that are not a valid CDR form of the expected message."""


def suggestion(word: str, known: Iterable[str]) -> str:
    """Return "; did you mean 'x'?" for the closest known word, or an empty text.

    >>> suggestion('flaot32', ['float32', 'int8'])
    "; did you mean 'float32'?"
    """
    return hint(word, known, quotes="'")
