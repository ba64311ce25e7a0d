"""`gz service`: the services of the newer Gazebo's worlds, listed and called."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

import rclpy
from rosidl_runtime_py.utilities import get_service

from coursekit.nodes.gz.bridge_types import SERVICES, without_prefix
from coursekit.nodes.gz.text_format import GzTextError, fill
from coursekit.nodes.gz.transport import gz_node

if TYPE_CHECKING:
    from rclpy.node import Node

TIMED_OUT = "Service call timed out"


def _arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="gz service")
    parser.add_argument("-l", "--list", action="store_true", help="list the services")
    parser.add_argument("-i", "--info", action="store_true", help="the types of its request and its answer")
    parser.add_argument("-s", "--service", dest="name", default="", help="its name")
    parser.add_argument("--reqtype", default="", help="the type of the request, such as gz.msgs.WorldControl")
    parser.add_argument("--reptype", default="", help="the type of the answer: gz.msgs.Boolean")
    parser.add_argument("--timeout", type=float, default=1000.0, help="milliseconds to wait")
    parser.add_argument("-r", "--req", help='the request: "pause: false"')
    return parser.parse_args(words)


def carry_out(words: list[str]) -> int:
    """List services, or call one. Returns the exit code."""
    told = _arguments(words)
    with gz_node("gz_service") as node:
        known = {name: types[0] for name, types in node.get_service_names_and_types() if types[0] in SERVICES}
        if told.list:
            print("\n".join(sorted(known)))
            return 0
        name = "/" + told.name.strip("/")
        if name not in known:
            print(f"No service providers on service [{told.name}]. There are: {', '.join(known) or 'none'}", file=sys.stderr)
            return 255
        if told.info:
            print("Service providers [Address, Request Message Type, Response Message Type]:")
            print(f"  1, gz.msgs.{SERVICES[known[name]][0]}, gz.msgs.Boolean")
            return 0
        return _call(node, name, known[name], told)


def _call(node: Node, name: str, kind: str, told: argparse.Namespace) -> int:
    wanted, fields = SERVICES[kind]
    if without_prefix(told.reqtype) != wanted or without_prefix(told.reptype) != "Boolean":
        print(f"{TIMED_OUT}: {name} takes --reqtype gz.msgs.{wanted} --reptype gz.msgs.Boolean", file=sys.stderr)
        return 255
    service = get_service(kind)
    request = service.Request()
    try:
        fill(told.req or "", told.reqtype, *(getattr(request, field) for field in fields))
    except GzTextError as fault:
        print(f"Unable to create request of type[{told.reqtype}] with data[{told.req}].\n{fault}", file=sys.stderr)
        return 255
    future = node.create_client(service, name).call_async(request)
    executor = rclpy.executors.SingleThreadedExecutor(context=node.context)
    rclpy.spin_until_future_complete(node, future, executor, told.timeout * 1e-3)
    if not future.done():
        print(TIMED_OUT)
        return 255
    print(f"data: {str(future.result().success).lower()}\n")
    return 0
