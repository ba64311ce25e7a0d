"""The parser of `ros2`: commands are the modules of `coursekit.cli.verbs`."""

from __future__ import annotations

import argparse
import importlib
import importlib.util
import sys
from collections.abc import Sequence
from typing import Any

from coursekit.processes.executables import ExecutableNotFound, PackageNotFound, python_folders
from coursekit.processes.private_modules import use_private_modules
from coursekit.processes.process import current_process
from coursekit.rcl.arguments import RosArgumentsError

from . import extensions
from .api import Unhappy
from .start_wait import let_settle

COMMANDS = (
    "action",
    "bag",
    "component",
    "control",
    "daemon",
    "doctor",
    "interface",
    "launch",
    "lifecycle",
    "multicast",
    "node",
    "param",
    "pkg",
    "run",
    "security",
    "service",
    "topic",
    "wtf",
)
_OF_THE_GRAPH = {"action", "component", "control", "lifecycle", "node", "param", "service", "topic"}
_STRATEGY = {
    ("--spin-time",): "Seconds to wait for discovery (here the graph is known at once)",
    ("-s", "--use-sim-time"): "Enable ROS simulation time: follow /clock",
    ("--no-daemon",): "Do not ask the daemon (here there is none)",
}
_HIDDEN = {
    "gz": "coursekit.cli.gz_commands",
    "extension_points": "coursekit.cli.extension_lists",
    "extensions": "coursekit.cli.extension_lists",
}
"""Commands omitted from the help; other programs reach the session through `gz`."""


def available() -> list[str]:
    """Return the commands whose module exists."""
    return [name for name in COMMANDS if importlib.util.find_spec(_module(name)) is not None]


def _module(command: str) -> str:
    return f"coursekit.cli.verbs.{command}"


def make_parser(command: str | None = None) -> argparse.ArgumentParser:
    """Make the whole parser, or faster, one that knows only `command`."""
    parser = argparse.ArgumentParser(
        prog="ros2",
        description="ros2 is an extensible command-line tool for ROS 2.",
        epilog="Call `ros2 <command> -h` for more detailed usage.",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "--use-python-default-buffering", action="store_true", help="Here every line is shown at once: it changes nothing"
    )
    subparsers = parser.add_subparsers(title="Commands", metavar="Call `ros2 <command> -h`", dest="_command")
    if command in _HIDDEN:
        importlib.import_module(_HIDDEN[command]).register(subparsers)
        return parser
    wanted = [command] if command in available() else available()
    for name in wanted:
        importlib.import_module(_module(str(name))).register(subparsers)
    for name, added in subparsers.choices.items():
        verbs = next((action for action in added._actions if isinstance(action, argparse._SubParsersAction)), None)
        if verbs is not None:
            _let_stand_alone(added, verbs)
            if name in _OF_THE_GRAPH:
                _add_strategy(verbs)
            extensions.add_verbs(name, verbs)
    if command not in available():
        extensions.add_commands(subparsers, available(), command)
    return parser


def _let_stand_alone(command: argparse.ArgumentParser, verbs: Any) -> None:
    """Make a command without a verb print its help."""
    if verbs.required:
        verbs.required = False
        command.set_defaults(main=lambda _args: command.print_help())


def _add_strategy(verbs: Any) -> None:
    """Accept the discovery flags in every verb. They have no effect: the session knows the graph."""
    for verb in verbs.choices.values():
        for words, text in _STRATEGY.items():
            if words[-1] in verb._option_string_actions:
                continue  # it has its own
            options = {"type": float} if "--spin-time" in words else {"action": "store_true"}
            verb.add_argument(*words, help=text, **options)


def run(argv: Sequence[str]) -> int:
    """Run one command line (without the word `ros2`). Returns its exit code."""
    _see_workspace()
    parser = make_parser(next((word for word in argv if not word.startswith("-")), None))
    args, rest = parser.parse_known_args(list(argv))
    args.unknown = rest
    main = getattr(args, "main", None)
    if main is None:
        parser.print_help()
        return 0
    if rest and not getattr(args, "takes_rest", False):
        parser.error(f"unrecognized arguments: {' '.join(rest)}")
    try:
        if args._command in _OF_THE_GRAPH or args._command not in COMMANDS:
            let_settle()
        return int(main(args) or 0)
    except KeyboardInterrupt:
        return 2
    except Unhappy as error:
        print(error, file=sys.stderr)
        return error.code
    except (PackageNotFound, ExecutableNotFound, RosArgumentsError) as error:
        print(error.args[0], file=sys.stderr)
        return 1


def _see_workspace() -> None:
    """Let the command's process import the current packages of the workspace in which it was started."""
    process = current_process()
    if process is not None:
        use_private_modules(process, python_folders(process.env))
