"""The commands `gz` and `ign`: `gz sim WORLD`, `gz topic`, `gz service`."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from typing import Any

from . import parser, ros2

_KNOWN = (
    "gz sim WORLD [-r], gz topic -l | -i -t TOPIC | -e -t TOPIC | -t TOPIC -m TYPE -p MESSAGE, "
    "gz service -l | -i -s SERVICE | -s SERVICE --reqtype TYPE --reptype TYPE --timeout MS --req REQUEST"
)
_HELP = """Works with the simulation of the newer Gazebo.

  gz <command> [options]

List of available commands:

  help:     Print this text.
  sim:      Simulate a world.
  topic:    List Gazebo's topics, print their messages, or publish one.
  service:  List Gazebo's services, or call one.

'gz <command> --help' prints the options of a command."""


def main() -> int:
    """Run `gz ...` or `ign ...` from a shell, as `ros2 gz` in the running session."""
    return ros2.main(["gz", *_words(sys.argv[1:])])


def run_inside(argv: Sequence[str]) -> int:
    """Run the command inside a session."""
    return parser.run(["gz", *_words(argv)])


def _words(argv: Sequence[str]) -> list[str]:
    """Return the words with a command in front."""
    return list(argv) if argv and argv[0] not in ("-h", "--help") else ["help"]


def carry_out(words: Sequence[str]) -> int:
    """Carry out the words after `gz`. Returns the exit code."""
    command, rest = (words[0], list(words[1:])) if words else ("", [])
    if command == "help":
        print(_HELP)
        return 0
    if command in ("sim", "gazebo"):
        from coursekit.nodes.gz.server import main as simulate

        return int(simulate(rest) or 0)
    if command == "topic":
        from . import gz_topics

        return gz_topics.carry_out(rest)
    if command == "service":
        from . import gz_services

        return gz_services.carry_out(rest)
    print(f"gz {command}: not part of coursekit. There are: {_KNOWN}", file=sys.stderr)
    return 255


def register(subparsers: Any) -> None:
    """Add the hidden command `ros2 gz`, through which terminals reach the session."""
    added = subparsers.add_parser("gz", add_help=False)
    added.add_argument("words", nargs=argparse.REMAINDER)
    added.set_defaults(main=lambda args: carry_out(args.words))
