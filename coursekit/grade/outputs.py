"""What a student's programs said and did in a trial: the exception that ended one, its last words, its nodes."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from .plain import fields, is_number
from .verdict import NO_HINT, Wrong

_LAUNCHED = re.compile(r"^\[[\w.-]+-\d+\] ")
_FRAME = re.compile(r'^ +File "(?P<file>[^"]+)", line (?P<line>\d+)')
_OURS = str(Path(__file__).resolve().parents[1])
DIED = "The program ended with that error: mend the line that it names, build, and run it in a cell."
_CALL = re.compile(
    r"TypeError: (?:\w+\.)+(?P<name>\w+)\(\) takes \d+ positional arguments? but (?P<given>[12]) (?:was|were) given"
)
"""A method that was defined without `self`, or without the message: Python tells it where it was called."""
_UNPACKED = re.compile(r"TypeError: cannot unpack non-iterable|ValueError: (?:not enough|too many) values to unpack")
_UNKNOWN = "Does the executable start, and are the node's name and namespace right? Was it built after the last change?"
_NO_FAULT = ("KeyboardInterrupt", "rclpy.executors.ExternalShutdownException", "ExternalShutdownException")
"""What a program may end with when Ctrl-C is pressed at the end of a trial."""


def exception_in(output: str) -> str:
    """The last exception that a program's output tells of, with the student's own line; empty when there is none.

    >>> trace = 'Traceback (most recent call last):\\n  File "/ws/my_node.py", line 9, in main\\n    spin()\\n'
    >>> exception_in(trace + 'NameError: no spin')
    'NameError: no spin (line 9 of my_node.py: spin())'
    """
    lines = [_LAUNCHED.sub("", line) for line in output.splitlines()]
    starts = [place for place, line in enumerate(lines) if line.startswith("Traceback (most recent call last)")]
    for start in reversed(starts):
        found = _told(lines[start + 1 :])
        if found and not found.startswith(_NO_FAULT):
            return found
    return ""


def cause_of(died: str) -> str:
    """What to do about the exception that ended a program.

    >>> cause_of("TypeError: Ear.heard() takes 1 positional argument but 2 were given (line 9 of ear.py: rclpy.spin(node))")
    '`heard` gets two values, the object itself and what it is called with: begin it with `def heard(self, msg):`.'
    """
    if died.startswith("NotImplementedError"):
        return "The stub is still there: write your code where that line stands."
    if _UNPACKED.match(died):
        return "Another number of values is taken there than came: what should your function return?"
    call = _CALL.match(died)
    if call is None:
        return DIED
    name = call["name"]
    if call["given"] == "1":
        return f"`{name}` gets one value, the object itself: begin it with `def {name}(self):`."
    return f"`{name}` gets two values, the object itself and what it is called with: begin it with `def {name}(self, msg):`."


def _told(lines: list[str]) -> str:
    place, own = "", ""
    for number, line in enumerate(lines):
        if frame := _FRAME.match(line):
            source = lines[number + 1].strip() if number + 1 < len(lines) else ""
            place = f"line {frame['line']} of {Path(frame['file']).name}: {source[:100]}"
            own = place if _is_own(frame["file"]) else own
        elif line and not line.startswith(" "):
            return f"{line[:300]} ({own or place})" if place else line[:300]
    return ""


def _is_own(file: str) -> bool:
    return not file.startswith((_OURS, "<frozen")) and not re.search(r"/lib/python3[.\d]*/(?!site-packages/s?\w+_)", file)


def last_words(output: str) -> str:
    """The exception that ended a program, or else its last line.

    >>> last_words("one\\ntwo\\n"), last_words("")
    ('two', 'nothing')
    """
    lines = [line for line in output.splitlines() if line.strip()]
    return exception_in(output) or (lines[-1][:200] if lines else "nothing")


def expect_node(seen: Any, name: str, program: int = 0) -> None:
    """Wrong unless a node of that name runs; what its program said last is told."""
    if name not in seen.nodes:
        raise Wrong(
            f"a node named {name}",
            f"nodes: {', '.join(seen.nodes) or 'none'}; the program said: {last_words(said(seen, program))}",
            cause_of(died) if (died := exception_in(said(seen, program))) else _UNKNOWN,
        )


def said(seen: Any, program: int = 0) -> str:
    """What a program of a trial wrote."""
    outputs = seen.outputs
    return outputs[program] if program < len(outputs) and type(outputs[program]) is str else ""


def exit_code(seen: Any, program: int = 0) -> int | None:
    """The exit status of a program of a trial; None when it did not end."""
    codes = seen.exit_codes
    found = codes[program] if program < len(codes) else None
    return found if type(found) is int else None


def course_said(seen: Any, topic: str) -> list[tuple[float, Any]]:
    """What the course's own programs said on a topic, and when."""
    return [(when, message) for when, message in seen.of_course(topic) if is_number(when)]


def way_of(seen: Any, topic: str) -> list[tuple[float, ...]]:
    """Where turtlesim says that a turtle was, as x, y and theta, in order; Wrong when it says nothing."""
    found = [fields(pose, ("x", "y", "theta"), topic) for _, pose in course_said(seen, topic)]
    if not found:
        raise Wrong(f"poses on {topic}", "there are none", hint=NO_HINT)
    return found


def heard(seen: Any, topic: str) -> list[tuple[float, Any]]:
    """The messages of a topic with the seconds at which they came, the first ones first."""
    return [(when, message) for when, message in seen.messages.get(topic, []) if is_number(when)]
