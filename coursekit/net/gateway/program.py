"""The gateway's program."""

from __future__ import annotations

import argparse
import json
import os
import queue
import sys
import time
from collections.abc import Callable, Sequence
from typing import Any

import rclpy
import zenoh
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.node import Node

from ..wire.names import data_key
from ..wire.token import ADMIN
from .announced import PREFIX, Announced
from .executor import InformingExecutor
from .visitors import Visitors

LOOK_SECONDS = 0.5
"""Polling period of the ROS graph [s]."""
OTHERS_SECONDS = 3.0
"""Time for another gateway to appear in the ROS graph [s]."""


class Gateway:
    """Both sides of the gateway; all changes are made by one thread at a time, in the order in which they arrive."""

    def __init__(self, domain_id: int, config: Any) -> None:
        self.domain_id = domain_id
        name = f"{PREFIX}{time.time_ns()}"
        self.node = Node(name, start_parameter_services=False, enable_rosout=False, use_global_arguments=False)
        self.executor = InformingExecutor(8)
        self.executor.add_node(self.node)
        self.group = ReentrantCallbackGroup()
        self._refuse_a_second()
        self.session = zenoh.open(config)
        self.id = str(self.session.info.zid())
        self.announced, self.visitors = Announced(self), Visitors(self)
        self.error = ""
        self._told: set[str] = set()
        self._jobs: queue.SimpleQueue[tuple[Callable[[str], None], str]] = queue.SimpleQueue()
        alone = MutuallyExclusiveCallbackGroup()
        self._wake = self.node.create_guard_condition(self._work, callback_group=alone)
        self._timer = self.node.create_timer(LOOK_SECONDS, self._look, callback_group=alone)
        key = f"{ADMIN}/{domain_id}/**"
        self._tokens = self.session.liveliness().declare_subscriber(key, self._hear, history=True)
        self._look()  # a peer that joins as soon as the gateway reports that it listens must see the robot's graph

    def key(self, name: str, type_name: str, type_hash: str) -> str:
        """The key of a topic or service."""
        return data_key(self.domain_id, name, type_name, type_hash)

    def tell(self, sentence: str) -> None:
        """Print a message, once."""
        if sentence not in self._told and len(self._told) < 1000:
            self._told.add(sentence)
            print(f"[gateway] {sentence}", file=sys.stderr, flush=True)

    def run(self) -> None:
        """Run until Ctrl-C, or until an older gateway appears."""
        while rclpy.ok() and not self.error:
            self.executor.spin_once(0.2)
        if self.error:
            raise SystemExit(self.error)

    def _hear(self, sample: Any) -> None:
        gone = str(sample.kind).endswith("DELETE")
        self._jobs.put((self.visitors.left if gone else self.visitors.came, str(sample.key_expr)))
        self._wake.trigger()

    def _work(self) -> None:
        while not self._jobs.empty():
            job, text = self._jobs.get()
            job(text)
        self.visitors.compare()

    def _look(self) -> None:
        self.error = self._older()
        self.announced.compare()
        self.visitors.compare()

    def _refuse_a_second(self) -> None:
        give_up = time.monotonic() + OTHERS_SECONDS
        while time.monotonic() < give_up:
            self.executor.spin_once(0.1)
            if self._older():
                raise SystemExit(self._older())

    def _older(self) -> str:
        """Return an error message if another gateway was here first: two would carry everything twice."""
        others = [name for name in self.node.get_node_names() if name.startswith(PREFIX)]
        if any(int(other[len(PREFIX) :]) < int(self.node.get_name()[len(PREFIX) :]) for other in others):
            return "A gateway runs in this ROS domain already: two would carry everything twice. End that one first."
        return ""


def settings(listen: Sequence[str], connect: Sequence[str], user: str, password: str, users: str) -> Any:
    """Return Zenoh's configuration: a router if it listens, else a client of another router; no multicast scouting."""
    config = zenoh.Config()
    wanted: dict[str, object] = {
        "mode": "router" if listen else "client",
        "scouting/multicast/enabled": False,
        "scouting/gossip/enabled": False,
        "timestamping/enabled": True,
        "transport/link/tx/lease": 2000,
        "transport/link/tx/queue/congestion_control/drop/wait_before_drop": 10_000,  # microseconds, as BUSY_SECONDS
        "listen/endpoints": list(listen),
        "connect/endpoints": list(connect),
        "connect/timeout_ms": -1,
        "connect/exit_on_failure": False,
    }
    if users:
        wanted["transport/auth/usrpwd/dictionary_file"] = os.path.abspath(users)
    if user:
        wanted |= {"transport/auth/usrpwd/user": user, "transport/auth/usrpwd/password": password}
    for name, value in wanted.items():
        config.insert_json5(name, json.dumps(value))
    return config


def main(argv: Sequence[str] | None = None) -> int:
    """Run the gateway; it ends with `os._exit`, since the threads of rclpy and Zenoh may still need Python."""
    parser = argparse.ArgumentParser(prog="gateway", description="Joins this robot's ROS 2 graph to notebooks of coursekit.")
    parser.add_argument("--listen", nargs="*", default=[], metavar="ADDRESS", help="for example tcp/0.0.0.0:7447")
    parser.add_argument("--connect", nargs="*", default=[], metavar="ADDRESS", help="a router that runs elsewhere")
    parser.add_argument("--users", default="", metavar="FILE", help="who may come in: lines NAME:PASSWORD")
    parser.add_argument("--user", default="", help="for --connect; the password is in COURSEKIT_NETWORK_PASSWORD")
    args = parser.parse_args(argv)
    listen = args.listen or ([] if args.connect else ["tcp/127.0.0.1:7447"])
    password = os.environ.get("COURSEKIT_NETWORK_PASSWORD", "")
    rclpy.init(args=[])
    domain_id = int(os.environ.get("ROS_DOMAIN_ID") or 0)
    code = 0
    try:
        gateway = Gateway(domain_id, settings(listen, args.connect, args.user, password, args.users))
        print(f"[gateway] ROS domain {domain_id} is at {', '.join([*listen, *args.connect])}. Ctrl-C ends it.", flush=True)
        gateway.run()
        gateway.session.close()
    except KeyboardInterrupt:
        pass
    except (SystemExit, zenoh.ZError) as error:
        print(f"[gateway] {error}", file=sys.stderr, flush=True)
        code = 1
    sys.stdout.flush()
    os._exit(code)
