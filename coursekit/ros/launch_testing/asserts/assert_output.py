"""Assertions on the output of processes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from osrf_pycommon.terminal_color import remove_ansi_escape_sequences

from ..matching import build_text_match
from ..util import resolveProcesses

_ATTRIBUTES = {"stdout": "from_stdout", "stderr": "from_stderr"}


def assertInStream(
    proc_output: Any,
    expected_output: Any,
    process: Any,
    cmd_args: Any = None,
    *,
    output_filter: Callable[[str], str] | None = None,
    strict_proc_matching: bool = True,
    strip_ansi_escape_sequences: bool = True,
    stream: str = "stderr",
) -> None:
    """Fail unless one of the selected processes printed `expected_output` to `stream` ('stdout' or 'stderr').

    `expected_output` is a text, a compiled regular expression, or several of them in order; `output_filter` comes first.

    Raises:
        ValueError: when the stream, the filter or the expected output is invalid.
        NoMatchingProcessException: when no process matches.
    """
    meant = resolveProcesses(proc_output, process=process, cmd_args=cmd_args, strict_proc_matching=strict_proc_matching)
    if output_filter is not None and not callable(output_filter):
        raise ValueError("output_filter is not callable")
    match = build_text_match(expected_output)
    if stream not in _ATTRIBUTES:
        raise ValueError("Invalid value for stream; must be 'stdout' or 'stderr'")
    for action in meant:
        pieces = [event.text.decode() for event in proc_output[action] if getattr(event, _ATTRIBUTES[stream])]
        text = "".join(pieces)
        if strip_ansi_escape_sequences:
            text = remove_ansi_escape_sequences(text)
        if output_filter is not None:
            text = output_filter(text)
        if match(text) is not None:
            return
    names = ", ".join(sorted(action.process_details["name"] for action in meant if action.process_details))
    raise AssertionError(f"Did not find '{expected_output}' in output for any of the matching processes: {names}")


def assertInStdout(proc_output: Any, expected_output: Any, process: Any, cmd_args: Any = None, **options: Any) -> None:
    """Fail unless `expected_output` was printed to standard output; see `assertInStream`."""
    assertInStream(proc_output, expected_output, process, cmd_args, stream="stdout", **options)


def assertInStderr(proc_output: Any, expected_output: Any, process: Any, cmd_args: Any = None, **options: Any) -> None:
    """Fail unless `expected_output` was printed to standard error; see `assertInStream`."""
    assertInStream(proc_output, expected_output, process, cmd_args, stream="stderr", **options)


def assertDefaultStream() -> str:
    """Return the stream that `assertInStream` searches by default: the stream that nodes log to."""
    return "stderr"
