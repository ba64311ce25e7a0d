"""Advice about `ros2` command lines that are refused: what to write in their place."""

from __future__ import annotations

import re

_NO_FIELD = r"Failed to populate .*has no attribute '\w+"
"""What ros2 says of a field that a type has not; the student's own program says only the end of it."""
_CAUSES = (
    (_NO_FIELD + ":", "YAML wants a space after each colon, as in {x: 1.5}."),
    (r".*unrecognized arguments: &", "The commands run side by side without `&`: leave it out."),
    (r"unrecognized arguments: [^-].*\}", "What stands in braces belongs between quotes, as in '{x: 1.5, y: 2.0}'."),
    (r".*needs to be a dictionary in YAML", "Has each brace a closing brace?"),
    (r".*is expected to be a dictionary", "That field is a message: its values stand in braces of its own, as in {x: 1.5}."),
    (_NO_FIELD + "'", "`ros2 interface show` prints the fields of a type: is the name one of these?"),
    (r"passed (?:message|service|action) type is invalid", "Types are written in full, with capitals as `-t` lists them."),
)
"""What a command says that refuses its arguments, and the likely causes."""


def why_refused(said: str) -> str:
    """Return the likely cause of what a command says of its arguments; empty if none is known.

    >>> why_refused("Failed to populate field: 'Spawn_Request' object has no attribute 'x:2.5'")
    'YAML wants a space after each colon, as in {x: 1.5}.'
    """
    return next((cause for pattern, cause in _CAUSES if re.search(pattern, said)), "")


def has_word_ros2(command: str) -> bool:
    """Whether a command line begins with the word ros2, also in the form of a cell's.

    >>> has_word_ros2("%ros2 node list"), has_word_ros2("node list")
    (True, False)
    """
    return command.lstrip("%! ").split()[:1] == ["ros2"] or command.lstrip().startswith("%")
