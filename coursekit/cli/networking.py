"""`coursekit network serve`, a router for a class, and `coursekit gateway`, the program for a robot."""

from __future__ import annotations

import argparse
import threading
from pathlib import Path

from . import practice_robot
from .router_text import welcome


def add_commands(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add both commands to the parser."""
    network = commands.add_parser("network", help="run a router, or a robot to practise with, at which notebooks meet")
    verbs = network.add_subparsers(dest="verb", required=True, metavar="serve|robot")
    serve = verbs.add_parser("serve", help="run the router until Ctrl-C")
    serve.add_argument(
        "--listen", nargs="+", default=["tcp/127.0.0.1:7447"], metavar="ADDRESS",
        help="where to listen; tcp/0.0.0.0:7447 is for all computers of the network (default: this computer only)",
    )  # fmt: skip
    serve.add_argument("--users", type=Path, metavar="FILE", help="who may come in: lines NAME:PASSWORD")
    serve.add_argument("--certificate", type=Path, metavar="FILE", help="for addresses that begin with tls/ (PEM)")
    serve.add_argument("--key", type=Path, metavar="FILE", help="the certificate's private key (PEM)")
    serve.set_defaults(main=serve_network)
    practice_robot.add_command(verbs)
    gateway = commands.add_parser("gateway", help="write the program that joins a robot with DDS to notebooks")
    gateway.add_argument("--write", type=Path, required=True, metavar="FILE", help="for example gateway.pyz")
    gateway.set_defaults(main=write_gateway)


def serve_network(args: argparse.Namespace) -> int:
    """Run the router until Ctrl-C."""
    from coursekit.net.address import read_address
    from coursekit.net.errors import NoNetwork
    from coursekit.net.router_users import check_users
    from coursekit.net.zenoh_session import open_router

    try:
        users = check_users(args.users) if args.users is not None else 0
        addresses = [read_address(text) for text in args.listen]
        router = open_router(addresses, args.users, args.certificate, args.key)
    except NoNetwork as error:
        raise SystemExit(str(error)) from None
    print(*welcome(addresses, users), sep="\n", flush=True)
    try:
        threading.Event().wait()
    except KeyboardInterrupt:
        print("The router ends.")
    finally:
        router.close()
    return 0


def write_gateway(args: argparse.Namespace) -> int:
    """Write the gateway's file."""
    from coursekit.net.gateway_file import write

    try:
        write(args.write)
    except OSError as error:
        raise SystemExit(f"The gateway cannot be written to '{args.write}': {error.strerror}.") from None
    name = args.write.name
    print(
        f"Wrote {args.write}. On the robot, once: pip install eclipse-zenoh xxhash\n"
        f"Then, in a terminal that has sourced ROS: python3 {name} --listen tcp/0.0.0.0:7447\n"
        "Here: %network tcp/ROBOT:7447"
    )
    return 0


__all__ = ["add_commands"]
