"""Comparison of text and of lines with an expected output."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence
from typing import Any

Span = tuple[int, int]
Match = Callable[..., Span | None]


def normalize_lineseps(lines: str) -> str:
    r"""Return text whose lines all end with '\n', also if a terminal or another system wrote it."""
    return lines.replace(os.linesep, "\n").replace("\r\n", "\n")


def build_text_match(expected_text: Any, *, strict: bool = False) -> Match:
    """Return a function that finds `expected_text` in a text and returns its start and end, or None.

    A text is found anywhere, a compiled regular expression by its `search`, several of them one after the other. With
    `strict`, a text must be the whole, an expression must match at the start, and several must follow without gaps.

    >>> build_text_match(["one", "two"])("one, two")
    (0, 8)

    Raises:
        ValueError: when the expectation is of another type.
    """
    if isinstance(expected_text, str):

        def of_text(actual: str, start: int = 0) -> Span | None:
            actual = normalize_lineseps(actual)
            if strict:
                return (start, len(actual)) if actual[start:] == expected_text else None
            begin = actual.find(expected_text, start)
            return None if begin < 0 else (begin, begin + len(expected_text))

        return of_text
    if hasattr(expected_text, "search"):

        def of_pattern(actual: str, start: int = 0) -> Span | None:
            look = expected_text.match if strict else expected_text.search
            match = look(normalize_lineseps(actual), start)
            return None if match is None else match.span()

        return of_pattern
    if isinstance(expected_text, Iterable):
        of_all = _in_order([build_text_match(text) for text in expected_text], strict)
        return lambda actual, start=0: of_all(normalize_lineseps(actual), start)
    raise ValueError("Unknown format for expected text")


def build_line_match(expected_lines: Any, *, strict: bool = False) -> Match:
    """Return a function that finds `expected_lines` among lines: the first index and the one past the last, or None.

    A text is found in a line that contains it, a compiled regular expression in a line that it matches, several of them in
    lines one after the other. With `strict`, every line must be the text or match; several must follow without gaps.

    >>> build_line_match(["b", "d"])(["abc", "", "cde"])
    (0, 3)

    Raises:
        ValueError: when the expectation is of another type.
    """
    if isinstance(expected_lines, str):
        same: Any = expected_lines.__eq__ if strict else lambda line: expected_lines in line
        return _of_lines(same, strict)
    if hasattr(expected_lines, "match"):
        return _of_lines(expected_lines.match, strict)
    if isinstance(expected_lines, Iterable):
        return _in_order([build_line_match(text) for text in expected_lines], strict)
    raise ValueError("Unknown format for expected lines")


def _of_lines(fits: Callable[[str], Any], strict: bool) -> Match:
    def match(lines: Sequence[str], start: int = 0) -> Span | None:
        if strict:
            return (start, len(lines)) if all(fits(line) for line in lines[start:]) else None
        return next(((at, at + 1) for at in range(start, len(lines)) if fits(lines[at])), None)

    return match


def _in_order(matches: list[Match], strict: bool) -> Match:
    if not matches:
        raise ValueError("There is nothing expected: the list is empty")

    def match(actual: Any, start: int = 0) -> Span | None:
        begin, end = None, start
        for find in matches:
            span = find(actual, end)
            if span is None or (strict and span[0] != end):
                return None
            begin = span[0] if begin is None else begin
            end = span[1]
        assert begin is not None
        return begin, end

    return match
