"""`ros2 daemon status|start|stop`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from coursekit.cli import api, daemon
from coursekit.cli.session_client import domain_id

if TYPE_CHECKING:
    import argparse
    from argparse import Namespace


def register(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the command."""
    parser = subparsers.add_parser("daemon", help="Various daemon related sub-commands")
    verbs = parser.add_subparsers(title="Verbs", dest="_verb", required=True)
    for name, text, main in (
        ("status", "Output the status of the daemon", show_status),
        ("start", "Start the daemon if it isn't running", start),
        ("stop", "Stop the daemon if it is running", stop),
    ):
        verb = verbs.add_parser(name, help=text)
        verb.set_defaults(main=main)
        if name == "start":
            verb.add_argument("--debug", action="store_true", help="Here the session answers: it changes nothing")


def show_status(_args: Namespace) -> None:
    """Print whether the daemon is running."""
    print(f"The daemon is {'' if daemon.is_running(api.graph()) else 'not '}running")


def start(_args: Namespace) -> None:
    """Start the daemon."""
    print("The daemon has been started" if daemon.start(api.graph(), domain_id()) else "The daemon is already running")


def stop(_args: Namespace) -> None:
    """Stop the daemon."""
    print("The daemon has been stopped" if daemon.stop(api.graph()) else "The daemon is not running")
