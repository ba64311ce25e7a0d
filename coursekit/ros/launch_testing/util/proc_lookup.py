"""The search for the processes that a test selects."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from launch import LaunchContext
from launch.actions import ExecuteLocal

NO_CMD_ARGS = object()
"""Selects a process that was started without arguments."""


class NoMatchingProcessException(Exception):
    """No known process matches."""


def resolveProcesses(
    info_obj: Any, *, process: Any = None, cmd_args: Any = None, strict_proc_matching: bool = True
) -> list[ExecuteLocal]:
    """Return the selected processes of `info_obj`.

    `process` is an action, a part of a process's name, or None for all. `cmd_args` (a text, several, or NO_CMD_ARGS)
    distinguishes processes of one name. With `strict_proc_matching`, a name must match one process only.

    Raises:
        NoMatchingProcessException: when no process matches.
        Exception: when several processes match with `strict_proc_matching`.
        TypeError: when `process` is of another type.
    """
    known = list(info_obj.processes())
    if process is None:
        if not known:
            raise NoMatchingProcessException("No data recorded for any process")
        return known
    if isinstance(process, ExecuteLocal):
        if process not in known:
            raise NoMatchingProcessException(f"No data recorded for proc {_name_and_args(process)}")
        return [process]
    if not isinstance(process, str):
        raise TypeError(f"proc argument must be 'ExecuteProcess' or 'str' not {type(process)}")
    if isinstance(cmd_args, str):
        cmd_args = [cmd_args]
    actions = [event for event in known if _is_meant(event, process, cmd_args)]
    names = ", ".join(sorted(map(_name_and_args, known)))
    if not actions:
        raise NoMatchingProcessException(
            f"Did not find any processes matching name '{process}' and args '{cmd_args}'. Procs: {names}"
        )
    if strict_proc_matching and len(actions) > 1:
        raise Exception(f"Found multiple processes matching name '{process}' and cmd_args '{cmd_args}'. Procs: {names}")
    return actions


def _is_meant(action: ExecuteLocal, name: str, cmd_args: Sequence[str] | object | None) -> bool:
    details: Any = action.process_details
    if name not in details["name"]:
        return False
    given = details["cmd"][1:]
    if cmd_args is None or cmd_args is NO_CMD_ARGS:
        return cmd_args is None or not given
    return all(arg in given for arg in cmd_args)  # type: ignore[attr-defined]


def _name_and_args(action: ExecuteLocal) -> str:
    """The name and arguments of a process, also before it has been launched."""
    if action.process_details:
        return " ".join([action.process_details["name"], *action.process_details["cmd"][1:]])
    nowhere = LaunchContext()
    try:
        parts = ("".join(substitution.perform(nowhere) for substitution in part) for part in action.process_description.cmd)
        return " ".join(parts)
    except Exception:  # a substitution that needs the launch
        return "Unknown - Process not launched yet"
