"""`ros2 run PACKAGE EXECUTABLE [ARGS]`."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from coursekit.interfaces.find import UNDERLAY
from coursekit.processes.executables import (
    ExecutableNotFound,
    PackageNotFound,
    executables_of,
    find,
    has_compiled_here,
    is_compiled_here,
    make_process,
    packages,
)
from coursekit.processes.prefixed import prefixed
from coursekit.processes.process import current_process
from coursekit.processes.session import current
from coursekit.systems.command_lines import split_words
from coursekit.systems.signal_names import described
from coursekit.wiring import COMPILED_HOST

if TYPE_CHECKING:
    from argparse import Namespace

    from coursekit.processes.base_process import BaseProcess

PREFIX = "[ros2run]:"


def register(subparsers: Any) -> None:
    """Add the command."""
    parser = subparsers.add_parser("run", help="Run a package specific executable")
    parser.add_argument("--prefix", help="Prefix command, which should go before the executable")
    package = parser.add_argument("package_name", help="Name of the ROS package")
    package.completer = lambda **_: list(packages())
    executable = parser.add_argument("executable_name", help="Name of the executable")
    executable.completer = _executable_names
    parser.add_argument("argv", nargs=argparse.REMAINDER, help="Pass arbitrary arguments to the executable")
    parser.set_defaults(main=main)


def _executable_names(parsed_args: Namespace, **_: Any) -> list[str]:
    try:
        return [path.name for path in executables_of(parsed_args.package_name)]
    except PackageNotFound:
        return []


def main(args: Namespace) -> int:
    """Run the executable and wait for its end, passing through its output and Ctrl-C."""
    path = _by_itself(args)
    if path is not None:
        return int(_wait(current().start_executable(path, args.argv, name=args.executable_name, on_output=_pass_on())))
    try:
        path = find(args.package_name, args.executable_name)
    except PackageNotFound as error:
        print(error.args[0])
        return 1
    except ExecutableNotFound as error:
        print("No executable found")
        print(error.args[0], file=sys.stderr)
        return 1
    command = prefixed([*split_words(args.prefix or ""), str(path)])
    if len(command) > 1:
        return _run_with_prefix([*command, *args.argv])
    process = current().start_executable(path, args.argv, name=args.executable_name, on_output=_pass_on())
    return _outcome(_wait(process))


def _by_itself(args: Namespace) -> Path | None:
    """Return the compiled program that called this command itself: it passes its folder in place of a package."""
    path = Path(args.package_name, args.executable_name)
    return path if os.path.isabs(args.package_name) and path.is_file() and is_compiled_here(path) else None


def _pass_on() -> Any:
    """Return a function that writes the child's output to this process's streams."""
    own = current_process()

    def write(stream: str, text: str) -> None:
        if own is not None:
            own.out.write(stream, text)

    return write


def _wait(process: BaseProcess) -> int:
    """Wait for the process's end. Ctrl-C is forwarded to it, and `kill` ends it as well."""
    own = current_process()

    def react(signum: int) -> bool:
        process.send_signal(signum)
        return True

    if own is not None:
        own.on_signal.append(react)
        own.stdin_to = process
        own.cleanups.append(process.kill)
    code = process.wait()
    return 0 if code is None else code


def _outcome(code: int) -> int:
    if code < 0:
        print(PREFIX, described(-code))
    elif code:
        print(f"{PREFIX} Process exited with failure {code}")
    return code


def _run_with_prefix(command: list[str]) -> int:
    from coursekit.processes.child import ChildProcess

    if has_compiled_here(command):
        process: Any = make_process(current(), UNDERLAY / COMPILED_HOST, command, name=command[0])
    else:
        process = ChildProcess(current(), command, name=command[0])
    return _outcome(_wait(current().launch(process, _pass_on())))
