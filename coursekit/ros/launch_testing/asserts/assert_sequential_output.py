"""Assertions on the order of a process's output."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from ..util import resolveProcesses

_LINES_AROUND = 2


class SequentialTextChecker:
    """Searches for texts in order in an output that is given in pieces.

    >>> checker = SequentialTextChecker(["one two\\n", "three\\n"])
    >>> checker.assertInText("two")
    >>> checker.assertInText("one")
    Traceback (most recent call last):
        ...
    AssertionError: 'one' not found in sequence after previous match.  The output near the last matched line:
    one two
    three
    """

    def __init__(self, output: Sequence[str]) -> None:
        self._output = list(output)
        self._piece = 0
        self._at = 0

    def assertInText(self, msg: str) -> None:
        """Fail unless `msg` comes after the last match."""
        self.assertInStdout(msg)

    def assertInStdout(self, msg: str) -> None:
        """Fail unless `msg` comes after the last match; a text that spans two pieces is not found."""
        for number in range(self._piece, len(self._output)):
            index = self._output[number].find(msg, self._at if number == self._piece else 0)
            if index >= 0:
                self._piece, self._at = number, index + len(msg)
                return
        raise AssertionError(
            f"'{msg}' not found in sequence after previous match.  "
            f"The output near the last matched line:\n{self.get_nearby_lines()}"
        )

    def get_nearby_lines(self) -> str:
        """Return the line after the last match, with two lines before and after it."""
        whole = "".join(self._output)
        at = sum(map(len, self._output[: self._piece])) + self._at
        line = whole.count("\n", 0, at + 1)  # after a match up to the end of its line, this is the next line
        return "\n".join(whole.splitlines()[max(0, line - _LINES_AROUND) : line + _LINES_AROUND + 1])


@contextmanager
def assertSequentialStdout(proc_output: Any, process: Any, cmd_args: Any = None) -> Iterator[SequentialTextChecker]:
    """Return a checker of the order of a process's output.

    with assertSequentialStdout(proc_output, "talker") as checker:
        checker.assertInStdout("Loop 1")
        checker.assertInStdout("Loop 2")
    """
    (action,) = resolveProcesses(proc_output, process=process, cmd_args=cmd_args)
    yield SequentialTextChecker([event.text.decode() for event in proc_output[action]])
