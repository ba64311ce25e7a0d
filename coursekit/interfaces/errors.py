"""What can be wrong with an interface: its text, its name, its bytes."""

from __future__ import annotations

import difflib
from collections.abc import Iterable


class InterfaceError(ValueError):
    """A definition file says something that ROS does not understand.

    Carries the place: `file`, `line` (1-based), `column` (1-based), `source` (the text of that line).

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
    """No definition of that name is in any sourced workspace or in the underlay."""

    def __init__(self, name: str, known: Iterable[str] = ()) -> None:
        self.name = name
        self.known = sorted(known)
        close = difflib.get_close_matches(name, self.known, n=3)
        hint = f"; did you mean {' or '.join(close)}?" if close else ""
        super().__init__(f"no interface '{name}' found{hint}")

    def __str__(self) -> str:
        return str(self.args[0])


class CdrError(ValueError):
    """Bytes that are not the CDR form of the message they are said to be."""


def suggestion(word: str, known: Iterable[str]) -> str:
    """Return "; did you mean 'x'?" for the closest known word, or an empty text.

    >>> suggestion('flaot32', ['float32', 'int8'])
    "; did you mean 'float32'?"
    """
    close = difflib.get_close_matches(word, list(known), n=1)
    return f"; did you mean '{close[0]}'?" if close else ""
