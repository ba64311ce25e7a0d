"""`python loopback.py COMMAND...`: run a command in a network that has nothing but its own loopback.

The real rclpy's middleware listens on all networks of a computer, and finds who else is there. Run by `unshare -n`.
"""

from __future__ import annotations

import os
import socket
import struct
import subprocess
import sys
from pathlib import Path

_SIOCSIFFLAGS, _UP_AND_RUNNING = 0x8914, 0x41
_TRUE = [sys.executable, "-c", ""]


def alone(command: list[str]) -> list[str] | None:
    """The words that run a command so; None where the system does not allow it."""
    for way in (["unshare", "-n"], ["unshare", "-rn"]):
        words = [*way, sys.executable, str(Path(__file__))]
        try:
            if subprocess.run([*words, *_TRUE], stderr=subprocess.DEVNULL, check=False).returncode == 0:
                return [*words, *command]
        except FileNotFoundError:
            return None
    return None


def main() -> None:
    """Bring the loopback up and become the command."""
    import fcntl  # Linux alone comes here

    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        fcntl.ioctl(any_socket, _SIOCSIFFLAGS, struct.pack("16sh14x", b"lo", _UP_AND_RUNNING))
    os.execvp(sys.argv[1], sys.argv[1:])


if __name__ == "__main__":
    main()
