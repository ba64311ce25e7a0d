"""`ros2 multicast send|receive`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from coursekit.cli import api

if TYPE_CHECKING:
    import argparse
    from argparse import Namespace

_DATA = b"Hello World!"


def register(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the command."""
    parser = subparsers.add_parser("multicast", help="Various multicast related sub-commands")
    verbs = parser.add_subparsers(title="Verbs", dest="_verb", required=True)
    send = verbs.add_parser("send", help="Send a single UDP multicast packet")
    send.set_defaults(main=send_one)
    receive = verbs.add_parser("receive", help="Receive a single UDP multicast packet")
    receive.set_defaults(main=receive_one)
    for verb in (send, receive):
        verb.add_argument("--group", default="225.0.0.1", help="The multicast group (default: 225.0.0.1)")
        verb.add_argument("--port", type=int, default=49150, help="The multicast port (default: 49150)")
    send.add_argument("--ttl", type=int, default=None, help="The multicast TTL: how many networks it may cross")
    receive.add_argument("--timeout", type=float, default=None, help="How long to wait [s]")


def send_one(args: Namespace) -> int:
    """Send one datagram."""
    from ros2multicast.api import send

    print("Sending one UDP multicast datagram...")
    try:
        send(_DATA, group=args.group, port=args.port, ttl=args.ttl)
    except OSError as error:
        raise api.Unhappy(f"This computer's network does not send it: {error}") from None
    return 0


def receive_one(args: Namespace) -> int:
    """Wait for one datagram and show it."""
    from ros2multicast.api import receive

    print("Waiting for UDP multicast datagram...")
    try:
        data, (host, port) = receive(group=args.group, port=args.port, timeout=args.timeout)
    except OSError as error:
        raise api.Unhappy(f"Nothing came: {error}") from None
    print(f"Received from {host}:{port}: {data!r}")
    return 0
