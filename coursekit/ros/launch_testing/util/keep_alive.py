"""A process that does nothing, so that a launch does not end."""

from __future__ import annotations

import sys

from launch.actions import ExecuteProcess

_WAIT = "import time\ntry:\n    while True:\n        time.sleep(3600)\nexcept KeyboardInterrupt:\n    pass\n"


def KeepAliveProc() -> ExecuteProcess:
    """Return an action that keeps a launch running while its own processes end; it ends with the launch, with 0."""
    return ExecuteProcess(cmd=[sys.executable, "-c", _WAIT])
