"""The address at which the daemon would listen."""

from __future__ import annotations

from ros2cli.helpers import get_ros_domain_id


def get_port() -> int:
    """The port of this domain's daemon."""
    return 11511 + get_ros_domain_id()


def get_address() -> tuple[str, int]:
    """The daemon's address."""
    return "127.0.0.1", get_port()


def get_xmlrpc_server_url(address: tuple[str, int] | None = None) -> str:
    """The daemon's URL. No process listens there: the session itself answers.

    >>> get_xmlrpc_server_url(("127.0.0.1", 11511))
    'http://127.0.0.1:11511/ros2cli/'
    """
    host, port = address or get_address()
    return f"http://{host}:{port}/ros2cli/"
