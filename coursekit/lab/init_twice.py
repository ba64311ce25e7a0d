"""A cell that calls `rclpy.init()` while another one's still counts says what to do."""

from __future__ import annotations

from typing import Any

from coursekit.words.gettext import gettext

_ERROR = "Context.init() must only be called once"


def install(shell: Any) -> None:
    """Have such a cell say it below its error."""
    shell.events.register("post_run_cell", _look)


def _look(result: Any) -> None:
    error = result.error_in_exec
    if isinstance(error, RuntimeError) and str(error) == _ERROR:
        print(gettext("Another cell has called rclpy.init() already. Leave it out here, or end all before it: reset()"))


__all__ = ["install"]
