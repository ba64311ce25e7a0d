"""`ros2 security`: prints why there is nothing to encrypt here, and where the command works."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from coursekit.cli import api

if TYPE_CHECKING:
    from argparse import Namespace

VERBS = (
    "create_enclave",
    "create_key",
    "create_keystore",
    "create_permission",
    "generate_artifacts",
    "generate_policy",
    "list_enclaves",
    "list_keys",
)
WHY = (
    "ros2 security makes keys for DDS, which encrypts what travels over a network. Here no message leaves the computer, so "
    "there is nothing to encrypt, and ROS_SECURITY_ENABLE changes nothing. On a robot: sudo apt install ros-humble-sros2, "
    "then the same command."
)


def register(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the command."""
    parser = subparsers.add_parser("security", help="Various security related sub-commands", epilog=WHY)
    verbs = parser.add_subparsers(title="Verbs", dest="_verb", required=True)
    for name in VERBS:
        verb = verbs.add_parser(name, help="needs DDS: works on a robot only")
        verb.add_argument("words", nargs=argparse.REMAINDER, help="what the command takes on a robot")
        verb.set_defaults(main=main)


def main(args: Namespace) -> int:
    """Print why the command is not available."""
    raise api.Unhappy(WHY)
