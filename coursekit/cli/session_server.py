"""The session server: runs `ros2` commands from terminals.

A kernel starts one for its session. `python -m coursekit.cli.session_server` is a session of its own, started when a
command finds none; it ends soon after its last command.
"""

from __future__ import annotations

import json
import socket
import sys
import threading
import time
from collections.abc import Callable
from typing import Any

from coursekit.processes.process import Process
from coursekit.processes.session import Session, current
from coursekit.systems.folder import working_folder

from . import endpoint
from .parser import run

IDLE_SECONDS = 3.0


class SessionServer:
    """Listens for a domain and runs each received command as a process of the session.

    `name` is the session's notebook, or ''. With `take` it takes over the domain's terminals; otherwise OSError is
    raised if another session owns them.
    """

    def __init__(self, session: Session, domain_id: int, name: str = "", *, take: bool = False) -> None:
        self.session = session
        self.domain_id = domain_id
        self.name = name
        self.connections = 0
        self.last_left = time.monotonic()
        self._server = endpoint.listen(domain_id, take=take)
        session.meet(domain_id)
        self._token = endpoint.token(domain_id)
        self._thread = threading.Thread(target=self._accept, name="coursekit-session-server", daemon=True)
        self._thread.start()

    def claim(self) -> bool:
        """Take over the terminals of the domain. Returns whether that is a change."""
        return endpoint.claim(self.domain_id)

    def close(self) -> None:
        """Stop listening."""
        endpoint.close(self._server, self.domain_id)

    def _accept(self) -> None:
        while True:
            try:
                client, _ = self._server.accept()
            except OSError:
                return
            threading.Thread(target=self._serve, args=(client,), name="coursekit-connection", daemon=True).start()

    def _serve(self, client: socket.socket) -> None:
        self.connections += 1
        try:
            with client, client.makefile("r", encoding="utf-8") as lines:
                Connection(self, client).serve(lines)
        except (OSError, ValueError):
            pass  # the terminal is gone
        finally:
            self.connections -= 1
            self.last_left = time.monotonic()

    def allows(self, token: str) -> bool:
        """Whether the token of a connection's first line is correct."""
        return token == self._token


class Connection:
    """One command of one terminal."""

    def __init__(self, server: SessionServer, client: socket.socket) -> None:
        self._session_server = server
        self._client = client
        self._writing = threading.Lock()
        self._process: Process | None = None

    def serve(self, lines: Any) -> None:
        """Read the terminal's messages until it disconnects."""
        first = json.loads(next(lines, "{}"))
        if not self._session_server.allows(str(first.get("token", ""))):
            return
        self._say({"session": self._session_server.name})
        if "argv" not in first:
            return  # it only asked for the session's name
        try:
            self._start(first)
            for line in lines:
                self._hear(json.loads(line))
        finally:  # a terminal that died before reading all output raises an error here
            self._end()

    def _start(self, first: dict[str, Any]) -> None:
        argv = [str(word) for word in first.get("argv", [])]
        script = str(first.get("script") or "")
        session = self._session_server.session
        around: Any = {
            "env": {str(key): str(value) for key, value in first.get("env", {}).items()},
            "cwd": str(first.get("cwd") or working_folder()),
            "on_output": lambda stream, text: self._say({stream: text}),
        }
        if script:
            process = session.start_executable(script, argv, **around)
        else:
            process = session.start(lambda: run(argv), name="ros2", argv=argv, **around)
        self._process = process
        process.on_wants_keys = lambda: self._say({"keys": True})
        process.on_exit(lambda ended: self._say({"exit": ended.exit_code}))

    def _end(self) -> None:
        """End a running process: Ctrl-C, and soon after it kill."""
        if self._process is None or self._process.exit_code is not None:
            return
        self._process.interrupt()
        if self._process.wait(2.0) is None:
            self._process.kill()

    def _hear(self, said: dict[str, Any]) -> None:
        process = self._process
        if process is None:
            return
        if "stdin" in said:
            process.write_stdin(str(said["stdin"]))
        elif "eof" in said:
            process.close_stdin()
        elif "signal" in said:
            process.send_signal(int(said["signal"]))

    def _say(self, message: dict[str, Any]) -> None:
        try:
            with self._writing:
                self._client.sendall(json.dumps(message).encode() + b"\n")
        except OSError:
            pass  # the terminal is gone; its process is interrupted when that is noticed


def serve(session: Session, domain_id: int, name: str = "", *, take: bool = False) -> SessionServer | None:
    """Listen for the session; None when another one owns the domain's terminals, or listening is impossible."""
    try:
        return SessionServer(session, domain_id, name, take=take)
    except OSError:
        return None


def main(domain_id: int, ready: Callable[[], None] = lambda: None) -> int:
    """Run as a session of its own until it is idle."""
    server = serve(current(), domain_id)
    ready()
    if server is None:
        return 0
    while server.connections or time.monotonic() - server.last_left < IDLE_SECONDS:
        time.sleep(0.2)
    server.close()
    current().close()
    return 0


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1])))
