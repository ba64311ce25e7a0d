"""The transport between a Jupyter server and its kernels: Unix sockets, else encrypted ports on loopback.

With ports, jupyter_client looks for free ones before the kernel binds them. If a class starts its kernels in the same minute
on one server, another kernel can bind a port first: "Address already in use", and a notebook without a kernel.
"""

from __future__ import annotations

import socket
import uuid
from pathlib import Path

import zmq

from coursekit.systems.user_socket import HAS_UNIX


def kernel_options(runtime: Path) -> list[str]:
    """Return the server's options for its kernels' transport, with Jupyter's runtime folder.

    >>> kernel_options(Path("/dev/null"))  # no folder for a Unix socket
    ['--KernelManager.transport_encryption=auto']
    """
    if takes_sockets(runtime):
        return ["--KernelManager.transport=ipc"]
    return ["--KernelManager.transport_encryption=auto"] if zmq.has("curve") else []


def takes_sockets(folder: Path) -> bool:
    """Return whether kernels can have Unix sockets in a folder: not if its name is long, nor if it is shared with Windows.

    >>> takes_sockets(Path("/dev/null"))
    False
    """
    if not HAS_UNIX:
        return False
    path = folder / f"kernel-{uuid.uuid4()}-ipc-5"  # as jupyter_client names it
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        with socket.socket(socket.AF_UNIX) as probe:
            probe.bind(str(path))
        path.unlink()
    except OSError:
        return False
    return True
