"""The end of a student's programs in a trial: a fatal exception, the last output, the nodes."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any

from .exception_advice import cause_of
from .plain import fields, is_number
from .verdict import NO_HINT, Wrong

_LAUNCHED = re.compile(r"^\[[\w.-]+-\d+\] ")
_FRAME = re.compile(r'^ +File "(?P<file>[^"]+)", line (?P<line>\d+)')
_OURS = str(Path(__file__).resolve().parents[1]) + os.sep
_UNKNOWN = "Does the executable start, and are the node's name and namespace right? Was it built after the last change?"
_NO_FAULT = ("KeyboardInterrupt", "rclpy.executors.ExternalShutdownException", "ExternalShutdownException")
"""The exceptions of a program when Ctrl-C is pressed at the end of a trial."""


def exception_in(output: str) -> str:
    """Return the last exception in a program's output, with the student's own line; empty when there is none.

    >>> trace = 'Traceback (most recent call last):\\n  File "/ws/my_node.py", line 9, in main\\n    spin()\\n'
    >>> exception_in(trace + 'NameError: no spin')
    'NameError: no spin (line 9 of my_node.py: spin())'
    """
    lines = [_LAUNCHED.sub("", line) for line in output.splitlines()]
    launched = re.findall(r"\[launch\]: Caught exception in launch \(see debug for traceback\): (.*)", output)
    starts = [place for place, line in enumerate(lines) if line.startswith("Traceback (most recent call last)")]
    for start in reversed(starts):
        exception = _told(lines[start + 1 :])
        if exception and not exception.startswith(_NO_FAULT):
            return exception
    return _short(launched[-1]) if launched else ""


def _short(line: str) -> str:
    """Shorten the paths in a line of output to start at the workspace."""
    return re.sub(r"/[^\s'\"]*?/(?=(install|src)/)", "", line)[:300]


def _told(lines: list[str]) -> str:
    """Return the first exception in these lines, with its place in the student's code or else in a library's."""
    place, own = "", ""
    for number, line in enumerate(lines):
        if frame := _FRAME.match(line):
            if frame["file"].startswith(_OURS):
                continue  # a student can mend nothing there
            source = lines[number + 1].strip() if number + 1 < len(lines) else ""
            place = f"line {frame['line']} of {Path(frame['file']).name}: {source[:100]}"
            own = place if _is_own(frame["file"]) else own
        elif line and not line.startswith(" "):
            return f"{line[:300]} ({own or place})" if place else line[:300]
    return ""


def _is_own(file: str) -> bool:
    """Whether a file is the student's; `<...>` is compiled text, such as a message class."""
    return not file.startswith((_OURS, "<")) and not re.search(r"/lib/python3[.\d]*/(?!site-packages/s?\w+_)", file)


def last_words(output: str) -> str:
    """Return the exception that ended a program, or else its last line.

    >>> last_words("one\\ntwo\\n"), last_words("")
    ('two', 'nothing')
    """
    lines = [line for line in output.splitlines() if line.strip()]
    return exception_in(output) or (_short(lines[-1]) if lines else "nothing")


def wrote(seen: Any, nothing: str = "nothing was printed", program: int = 0) -> str:
    """Return a program's last lines, at most 300 characters; an end by Ctrl-C is noted instead of its traceback.

    >>> from types import SimpleNamespace
    >>> wrote(SimpleNamespace(outputs=["waiting\\nTraceback (most recent call last):\\n  ...\\nKeyboardInterrupt\\n"]))
    'waiting\\n(it still ran when Ctrl-C was pressed)'
    """
    output = said(seen, program).strip()
    before, traceback, after = output.rpartition("Traceback (most recent call last)")
    if traceback and any(line.startswith(_NO_FAULT) for line in after.splitlines()):
        output = f"{before}(it still ran when Ctrl-C was pressed)"
    lines = [line for line in output.splitlines() if not line.startswith("[ros2run]")]
    while len("\n".join(lines)) > 300 and len(lines) > 1:
        lines.pop(0)
    return "\n".join(lines)[:300] or nothing


def expect_node(seen: Any, name: str, program: int = 0) -> None:
    """Raise Wrong unless a node of that name runs; the message includes its program's last output."""
    if name not in seen.nodes:
        output = said(seen, program)
        cause = cause_of(died) if (died := exception_in(output)) else _UNKNOWN
        got = f"nodes: {', '.join(seen.nodes) or 'none'}; the program said: {last_words(output)}"
        raise Wrong(f"a node named {name}", got, cause)


def expect_subscription(seen: Any, topic: str, kind: str, hint: int | None = None) -> None:
    """Raise Wrong unless a node subscribes to that topic with that type: different types are never connected.

    >>> from types import SimpleNamespace
    >>> seen = SimpleNamespace(subscriptions={"/chater": [{"type": "std_msgs/msg/String"}]})
    >>> try:
    ...     expect_subscription(seen, "/chatter", "std_msgs/msg/String")
    ... except Wrong as wrong:
    ...     print(wrong.got, wrong.cause, sep=". ")
    subscriptions: /chater. Is the topic's name right?
    """
    ends = seen.subscriptions.get(topic)
    if not ends:
        others = ", ".join(name for name, listeners in seen.subscriptions.items() if listeners) or "none"
        raise Wrong(f"a subscription to {topic}", f"subscriptions: {others}", "Is the topic's name right?", hint=hint)
    kinds = [end.get("type") for end in ends]
    if kind not in kinds:
        cause = "Two ends with different types are never joined, and ROS does not say so."
        raise Wrong(f"a subscription to {topic} of type {kind}", f"type: {kinds[0]}", cause, hint=hint)


def said(seen: Any, program: int = 0) -> str:
    r"""Return the output of a program of a trial.

    >>> from types import SimpleNamespace
    >>> seen = SimpleNamespace(outputs=["hello\n"], exit_codes=[0])
    >>> said(seen), said(seen, program=1), exit_code(seen)
    ('hello\n', '', 0)
    """
    outputs = seen.outputs
    return outputs[program] if program < len(outputs) and type(outputs[program]) is str else ""


def exit_code(seen: Any, program: int = 0) -> int | None:
    """Return the exit status of a program of a trial; None when it did not end."""
    codes = seen.exit_codes
    code = codes[program] if program < len(codes) else None
    return code if type(code) is int else None


def course_said(seen: Any, topic: str) -> list[tuple[float, Any]]:
    """Return the messages of the course's own programs on a topic, with their times."""
    return [(when, message) for when, message in seen.of_course(topic) if is_number(when)]


def way_of(seen: Any, topic: str) -> list[tuple[float, ...]]:
    """Return a turtle's positions as published by turtlesim, as x, y and theta in order; Wrong when there are none."""
    way = [fields(pose, ("x", "y", "theta"), topic) for _, pose in course_said(seen, topic)]
    if not way:
        raise Wrong(f"poses on {topic}", "there are none", hint=NO_HINT)
    return way


def heard(seen: Any, topic: str) -> list[tuple[float, Any]]:
    """Return the messages of a topic with their arrival times [s], in order."""
    return [(when, message) for when, message in seen.messages.get(topic, []) if is_number(when)]
