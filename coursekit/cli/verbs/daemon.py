"""`ros2 daemon status|start|stop`: here the session itself answers, there is no daemon to manage."""

from __future__ import annotations

from typing import Any


def register(subparsers: Any) -> None:
    """Add the command."""
    parser = subparsers.add_parser("daemon", help="Various daemon related sub-commands")
    verbs = parser.add_subparsers(title="Verbs", dest="_verb", required=True)
    for name, text, answer in (
        ("status", "Output the status of the daemon", "The daemon is running"),
        ("start", "Start the daemon if it isn't running", "The daemon is already running"),
        ("stop", "Stop the daemon if it is running", "The daemon is the session itself; it ends with its last process"),
    ):
        verb = verbs.add_parser(name, help=text)
        verb.set_defaults(main=lambda _args, answer=answer: print(answer))
