"""`ros2 wtf`: another name of `ros2 doctor`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .doctor import add_arguments

if TYPE_CHECKING:
    import argparse


def register(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the command."""
    add_arguments(subparsers.add_parser("wtf", help="Use `wtf` as alias to `doctor`"))
