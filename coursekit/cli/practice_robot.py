"""`coursekit network robot`: a practice robot, and the router through which notebooks reach it."""

from __future__ import annotations

import argparse
import contextlib
import os
import sys
import threading
import time
from pathlib import Path

from .router_text import welcome

END_SECONDS = 5.0
"""The timeout for the robot's programs to end before they are killed [s]."""


def add_command(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the verb to `coursekit network`."""
    robot = verbs.add_parser("robot", help="run a simulated robot to practise with, and its router, until Ctrl-C")
    where = "where to listen (default: this computer only)"
    robot.add_argument("--listen", default="tcp/127.0.0.1:7447", metavar="ADDRESS", help=where)
    robot.add_argument("--users", type=Path, metavar="FILE", help="who may come in: lines NAME:PASSWORD")
    robot.add_argument("--world", default="robot_world", help="a world of coursekit_maps (default: robot_world)")
    robot.add_argument("--until-input-ends", action="store_true", help="end when standard input does, as well")
    robot.set_defaults(main=run_robot)


def run_robot(args: argparse.Namespace) -> int:
    """Run the router and the robot's programs until Ctrl-C. Returns their exit code."""
    from coursekit.net.address import read_address
    from coursekit.net.errors import NoNetwork
    from coursekit.net.router_users import check_users
    from coursekit.net.zenoh_session import open_router

    try:
        users = check_users(args.users) if args.users is not None else 0
        address = read_address(args.listen)
        router = open_router([address], args.users)
    except NoNetwork as error:
        raise SystemExit(str(error)) from None
    try:
        _join_by_environment(address, args.users)
        if args.until_input_ends:
            threading.Thread(target=_end_with_input, name="coursekit-input", daemon=True).start()
        print(*welcome([address], users), sep="\n", flush=True)
        return _run_programs(args.world)
    finally:
        router.close()


def _join_by_environment(address: str, users: Path | None) -> None:
    """Join the robot's programs to the router as any permitted user; they connect to no other programs on this computer."""
    from coursekit.net.router_users import first_user
    from coursekit.processes.session import NETWORK_VARIABLE

    os.environ |= {NETWORK_VARIABLE: address, "COURSEKIT_ALONE": "1"}
    for name in ("COURSEKIT_TIME", f"{NETWORK_VARIABLE}_USER", f"{NETWORK_VARIABLE}_PASSWORD"):  # another network's
        os.environ.pop(name, None)
    if users is not None:
        user, password = first_user(users)
        os.environ |= {f"{NETWORK_VARIABLE}_USER": user, f"{NETWORK_VARIABLE}_PASSWORD": password}


def _run_programs(world: str) -> int:
    from coursekit.packages.environment import source_underlay
    from coursekit.processes.session import current

    from .own_session import run_in

    source_underlay(os.environ)
    return run_in(current(), ["launch", "coursekit_robots", "practice_robot.launch.py", f"world:={world}"])


def _end_with_input() -> None:
    """End the program when the other end of its input is closed, or the owner was killed."""
    from coursekit.systems.children import interrupt_self
    from coursekit.systems.pipes import wait_for_end

    with contextlib.suppress(OSError, ValueError):
        wait_for_end(sys.stdin.fileno())
    interrupt_self()
    time.sleep(END_SECONDS)
    os._exit(1)


__all__ = ["add_command"]
