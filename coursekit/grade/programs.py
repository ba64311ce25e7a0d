"""The student's side of a trial: runs the programs here, as far as the watcher's clock allows.

`python -m coursekit.grade.programs [READ WRITE]`: frames of `coursekit.joined` are exchanged on these file
descriptors, by default on stdin and stdout.
"""

from __future__ import annotations

import os
import sys
from collections import deque
from pathlib import Path
from typing import Any

from coursekit.systems.inherited import opened
from coursekit.wiring import COMMANDS, load

from .limited import end_with_parent


class Programs:
    """Starts programs on the watcher's orders, and reports how they ended."""

    def __init__(self, session: Any) -> None:
        self.session = session
        self.follower: Any = None
        self._orders: deque[list[Any]] = deque()
        self._waiter = session.clock.new_waiter()
        self._started: list[Any] = []

    def on_event(self, event: list[Any]) -> None:
        """Queue an order of the watcher for the main execution context."""
        self._orders.append(event)
        self._waiter.notify()

    def run(self) -> None:
        """Carry out orders forever: the watcher's end ends this interpreter."""
        while True:
            self._waiter.wait()
            while self._orders:
                kind, what = self._orders.popleft()
                if kind == "start":
                    self._start(what)
                else:
                    self._end(float(what))

    def _start(self, argv: list[str]) -> None:
        ros2 = load(COMMANDS["ros2"])
        self._started.append(self.session.start(lambda: ros2(argv), name="ros2", argv=argv))

    def _end(self, seconds: float) -> None:
        """Press Ctrl-C in all programs, and report their output and exit codes."""
        for process in self._started:
            process.interrupt()
        codes = [process.wait(seconds) for process in self._started]
        self.follower.post("ended", [process.output for process in self._started], codes)


def main() -> int:
    """Connect to the watcher."""
    end_with_parent()
    read, write = map(opened, sys.argv[1:3]) if len(sys.argv) == 3 else (os.dup(0), os.dup(1))
    nothing = os.open(os.devnull, os.O_RDWR)
    for number in (0, 1):  # output written past sys.stdout must not mix with frames
        os.dup2(nothing, number)
    from coursekit.joined import Follower, Pipe
    from coursekit.processes.session import current

    _source_workspace(os.environ.get("COURSEKIT_WORKSPACE", ""))
    session = current()
    programs = Programs(session)
    programs.follower = Follower(session.clock, session.graph(0), Pipe(read, write), programs.on_event)
    programs.run()
    return 0


def _source_workspace(workspace: str) -> None:
    """Set the environment as after `source install/setup.bash`."""
    from coursekit.packages.overlay import overlay_environment

    install = Path(workspace, "install")
    if workspace and install.is_dir():
        os.environ.update(overlay_environment(install, os.environ))


if __name__ == "__main__":
    sys.exit(main())
