"""Advice below the traceback for rclpy errors caused by running cells again or in another order."""

from __future__ import annotations

import re

from IPython.core.interactiveshell import ExecutionResult, InteractiveShell

from coursekit.words.gettext import gettext

_INIT_TWICE = r"RuntimeError: Context\.init\(\) must only be called once"
_ENDED_ALREADY = r"RuntimeError: Context must be initialized before it can be shutdown|RCLError: failed to shutdown"
_NOT_BEGUN = r"NotInitializedException|ExternalShutdownException|RCLError: .*context is invalid"
_DECLARED_TWICE = r"ParameterAlreadyDeclaredException"
"""Patterns for the beginnings of error messages."""


def install(shell: InteractiveShell) -> None:
    """Print advice after cells that end with such an error."""
    shell.events.register("post_run_cell", _look)


def _look(result: ExecutionResult) -> None:
    error = result.error_in_exec
    if error is not None and (said := advice(error)):
        print(said)


def advice(error: BaseException) -> str:
    """Return advice for this error; empty for other errors.

    >>> advice(RuntimeError("Context must be initialized before it can be shutdown"))
    'rclpy is shut down already: this cell has nothing left to do, go on.'
    >>> advice(ValueError("no"))
    ''
    """
    told = f"{type(error).__name__}: {error}"
    if re.match(_INIT_TWICE, told):
        return gettext("Another cell has called rclpy.init() already. Leave it out here, or end all before it: reset()")
    if re.match(_ENDED_ALREADY, told):
        return gettext("rclpy is shut down already: this cell has nothing left to do, go on.")
    if re.match(_NOT_BEGUN, told):
        return gettext("rclpy is shut down, or not initialised yet: run the cells again from the one with rclpy.init() on.")
    if re.match(_DECLARED_TWICE, told):
        return gettext("The node has this parameter since an earlier run: run the cell that makes the node again first.")
    return ""


__all__ = ["advice", "install"]
