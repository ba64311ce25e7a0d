"""Filters for output, and its comparison with expectations."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from osrf_pycommon.terminal_color import remove_ansi_escape_sequences

from ..matching import build_line_match, build_text_match


def get_default_filtered_prefixes() -> list[str]:
    """Return the prefixes of lines that are left out by default: process IDs and exit codes."""
    return ["pid", "rc"]


def get_default_filtered_patterns() -> list[str]:
    """Return the patterns of lines that are left out by default: none."""
    return []


def basic_output_filter(
    filtered_prefixes: Iterable[str] | None = None, filtered_patterns: Iterable[str] | None = None
) -> Callable[[str], str]:
    r"""Return a function that removes the lines that begin with a prefix or match a pattern.

    >>> basic_output_filter(filtered_prefixes=["pid"], filtered_patterns=[".*secret"])("pid 7\none\na secret\n")
    'one\n'
    """
    prefixes = tuple(get_default_filtered_prefixes() if filtered_prefixes is None else filtered_prefixes)
    patterns = get_default_filtered_patterns() if filtered_patterns is None else filtered_patterns
    compiled = [re.compile(pattern) for pattern in patterns]

    def kept(line: str) -> bool:
        return not line.startswith(prefixes) and not any(pattern.match(line) for pattern in compiled)

    return lambda output: "".join(line for line in output.splitlines(keepends=True) if kept(line))


def expected_output_from_file(path: str, encoding: str = "utf-8") -> list[Any]:
    """Return the lines of `path`.txt, or of `path`.regex as compiled expressions.

    Raises:
        RuntimeError: when neither file exists.
    """
    for ending, read in ((".txt", str), (".regex", re.compile)):
        if os.path.isfile(path + ending):
            with open(path + ending, encoding=encoding) as file:
                return [read(line) for line in file.read().splitlines()]  # type: ignore[operator]
    raise RuntimeError(f"could not find output check file: {path}")


def expect_output(
    text: str | None = None,
    *,
    lines: Sequence[str] | None = None,
    expected_text: Any = None,
    expected_lines: Any = None,
    strip_ansi_escape_sequences: bool = True,
    strict: bool = False,
) -> bool:
    r"""Return whether a text, or lines, match the expectation; see `build_text_match` and `build_line_match`.

    >>> expect_output("one\ntwo\n", expected_lines=["one", "two"], strict=True)
    True

    Raises:
        ValueError: unless either text or lines are given, and either text or lines are expected.
    """
    if (text is None) == (lines is None):
        raise ValueError("Either lines or text, but not both, must be specified")
    if (expected_text is None) == (expected_lines is None):
        raise ValueError("Either expected lines or text, but not both, must be specified")
    clean = remove_ansi_escape_sequences if strip_ansi_escape_sequences else str
    if expected_text is not None:
        whole = "\n".join(lines or ()) if text is None else text
        return build_text_match(expected_text, strict=strict)(clean(whole)) is not None
    each = [clean(line) for line in ((text or "").splitlines() if lines is None else lines)]
    return build_line_match(expected_lines, strict=strict)(each) is not None
