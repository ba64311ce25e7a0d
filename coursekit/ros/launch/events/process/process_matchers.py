"""Matchers that select processes by pid, name or program."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ...actions.execute_local import ExecuteLocal


def matches_pid(pid: int) -> Callable[[ExecuteLocal], bool]:
    """Return a function that accepts the process with this pid."""
    return lambda action: action.process_details is not None and action.process_details.get("pid") == pid


def matches_name(name: str) -> Callable[[ExecuteLocal], bool]:
    """Return a function that accepts the process with this name."""
    return lambda action: action.process_details is not None and action.process_details["name"] == name


def matches_executable(executable: str) -> Callable[[ExecuteLocal], bool]:
    """Return a function that accepts processes of this program."""
    return lambda action: (
        action.process_details is not None and action.process_details["cmd"][0] == executable
    )
