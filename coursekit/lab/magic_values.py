"""Python values in the line of a magic: `%ros2 run nav2_map_server map_saver_cli -f {workspace()}/room`.

IPython inserts them before the line is split into words; a folder such as `José Luis` would become two words.
"""

from __future__ import annotations

import os
import re
import sys
from pathlib import PurePath

from IPython.core.interactiveshell import InteractiveShell
from IPython.utils.text import DollarFormatter

from coursekit.words.gettext import gettext

_PLACE = re.compile("\ue000([0-9]+)\ue001")
"""The placeholder of a path until the line is split; private-use characters, which nobody types."""
_NAME = re.compile(r"(?<!\{)\{([A-Za-z_]\w*)\}(?!\})")
"""A name in braces; IPython leaves the whole line unchanged when one name has no value."""
_NOWHERE = 100_000
"""A depth beyond any caller: only the notebook's variables are then visible."""


class Values(DollarFormatter):
    """Inserts values. A path stays part of one word, whatever its name contains; other values may become several words.

    >>> values = Values()
    >>> line = values.vformat("run a b {folder}/x {more}", (), {"folder": PurePath("/my ws"), "more": "-r c:=d"})
    >>> [values.restored(word).replace("\\\\", "/") for word in line.split()]
    ['run', 'a', 'b', '/my ws/x', '-r', 'c:=d']
    """

    def __init__(self) -> None:
        super().__init__()
        self._paths: list[str] = []

    def format_field(self, value: object, format_spec: str) -> str:
        """Return the text of a value, or the placeholder of a path."""
        if not _is_path(value):
            return str(super().format_field(value, format_spec))
        self._paths.append(str(value))
        return f"\ue000{len(self._paths) - 1}\ue001"

    def restored(self, word: str) -> str:
        """Return a word with its placeholders replaced by paths; right after YAML's quote an apostrophe is doubled."""
        return _PLACE.sub(self._path, word)

    def _path(self, place: re.Match[str]) -> str:
        path = self._paths[int(place[1])]
        return path.replace("'", "''") if place.string[: place.start()].endswith("'") else path

    def expanded(self, shell: InteractiveShell | None, line: str) -> str:
        """Return the line of a magic with values of the calling cell or function inserted."""
        depth = _frames_to_caller()
        if shell is None or (depth is None and "{" in line):  # called by a program: its braces are YAML
            return line
        expanded = str(shell.var_expand(line, depth=_NOWHERE if depth is None else depth, formatter=self))
        for name in _NAME.findall(expanded) if expanded == line else ():
            print(gettext(f"`{name}` has no value yet, and stays as it was typed: run the cell that makes it."))
        return expanded


def _is_path(value: object) -> bool:
    return isinstance(value, PurePath) or (isinstance(value, str) and os.path.isabs(value) and os.path.exists(value))


def _frames_to_caller() -> int | None:
    """Count the frames from `expanded` up to the code that calls the magic; None if IPython did not call it."""
    frame, depth = sys._getframe(1), 0
    while frame is not None:
        if frame.f_code.co_name == "run_line_magic":
            return depth + 1
        frame, depth = frame.f_back, depth + 1  # type: ignore[assignment]
    return None


__all__ = ["Values"]
