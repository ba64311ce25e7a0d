"""A process that does nothing and thus keeps a launch running."""

from __future__ import annotations

import sys

from launch.actions import ExecuteProcess

_WAIT = "import time\ntry:\n    while True:\n        time.sleep(3600)\nexcept KeyboardInterrupt:\n    pass\n"


def KeepAliveProc() -> ExecuteProcess:
    """Return an action that keeps a launch running after its processes end; it ends with the launch, with code 0."""
    return ExecuteProcess(cmd=[sys.executable, "-c", _WAIT])
