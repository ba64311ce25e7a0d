"""The transport between a Jupyter server and its kernels: Unix sockets, else encrypted ports on loopback.

With ports, jupyter_client looks for free ones before the kernel binds them. If a class starts its kernels in the same minute
on one server, another kernel can bind a port first: "Address already in use", and a notebook without a kernel.
"""

from __future__ import annotations

from pathlib import Path

import zmq

from coursekit.systems import which

_NAME = len("/kernel-01234567-89ab-cdef-0123-456789abcdef-ipc-5")
"""Length of a socket's name, which ends in a number of one digit."""
_LONGEST = 103
"""Greatest length of a Unix socket's path on macOS; Linux allows 107."""


def kernel_options(runtime: Path) -> list[str]:
    """Return the server's options for its kernels' transport, with Jupyter's runtime folder.

    >>> kernel_options(Path("/home/vera/" + "long" * 30))  # too long for a Unix socket
    ['--KernelManager.transport_encryption=auto']
    """
    fits = len(str(runtime).encode()) + _NAME <= _LONGEST
    if fits and not which.WINDOWS:
        return ["--KernelManager.transport=ipc"]
    return ["--KernelManager.transport_encryption=auto"] if zmq.has("curve") else []
