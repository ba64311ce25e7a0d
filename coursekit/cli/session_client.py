"""The terminal's side: pass a command to the running session, and relay its output, input and Ctrl-C."""

from __future__ import annotations

import codecs
import contextlib
import itertools
import json
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator, Sequence
from pathlib import Path

from coursekit.systems.children import apart
from coursekit.systems.ending_signals import endings
from coursekit.systems.folder import working_folder
from coursekit.systems.keyboard import Keyboard
from coursekit.systems.streams import reader_has_gone, use_utf8
from coursekit.systems.waiting import lines

from . import endpoint

START_SECONDS = 20.0
ATTEMPTS = 3
"""How many sessions are tried: one that ends while it is being asked has not accepted the command."""


def domain_id() -> int:
    """Return the domain of this terminal."""
    text = os.environ.get("ROS_DOMAIN_ID") or "0"
    return int(text) if text.isdecimal() else 0


def connect_or_start() -> socket.socket:
    """Connect to the domain's session, which is started if there is none."""
    domain = domain_id()
    with contextlib.suppress(endpoint.NoSession):
        return endpoint.connect(domain)
    subprocess.Popen(
        [sys.executable, "-m", "coursekit.cli.session_server", str(domain)],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        **apart(),
    )
    give_up = time.monotonic() + START_SECONDS
    while time.monotonic() < give_up:
        with contextlib.suppress(endpoint.NoSession):
            return endpoint.connect(domain)
        time.sleep(0.02)
    raise endpoint.NoSession(
        f"No session answers for ROS_DOMAIN_ID={domain}, and none could be started. "
        "Try `coursekit doctor`; it shows what is wrong."
    )


def attach(argv: Sequence[str]) -> int:
    """Run `ros2 ARGV` in the session. Returns the exit code."""
    for _ in range(ATTEMPTS - 1):
        with contextlib.suppress(endpoint.NoSession):
            return _be_terminal(connect_or_start(), {"argv": list(argv)})
    return _be_terminal(connect_or_start(), {"argv": list(argv)})


def answer(argv: Sequence[str]) -> list[str]:
    """Return the words that the domain's session prints for `ros2 ARGV`; empty when no session runs."""
    try:
        client = endpoint.connect(domain_id())
    except endpoint.NoSession:
        return []
    with client:
        _send(client, _wish(argv=list(argv)))
        said = itertools.takewhile(lambda answer: "exit" not in answer, map(json.loads, lines(client)))
        return "".join(answer.get("stdout", "") for answer in said).split()


def who_answers() -> tuple[str, int]:
    """Return this terminal's notebook ('' if its session has none) and the number of sessions; raises NoSession."""
    return _name_of(domain_id()), endpoint.live_sessions(domain_id())


def holder(domain: int) -> str | None:
    """Return the notebook or test that owns the domain's terminals, '' for a session started by commands; None for none."""
    with contextlib.suppress(endpoint.NoSession):
        return _name_of(domain)
    return None


def _name_of(domain: int) -> str:
    client = endpoint.connect(domain)
    with client:
        _send(client, {"token": endpoint.token(domain)})
        return str(json.loads(next(lines(client), "{}")).get("session", ""))


def attach_script(path: Path, argv: Sequence[str]) -> int | None:
    """Run `python3 PATH ARGV` in the session. Returns the exit code, or None when no session runs."""
    try:
        return _be_terminal(endpoint.connect(domain_id()), {"script": str(path), "argv": list(argv)})
    except endpoint.NoSession:
        return None


def _be_terminal(client: socket.socket, wish: dict[str, object]) -> int:
    use_utf8()
    with client, _signals_to(client), Keyboard() as keyboard:
        try:
            _send(client, _wish(**wish))
        except ConnectionError:
            raise endpoint.NoSession("the session ended before it was asked") from None
        try:
            return _show(client, keyboard)
        except OSError as error:
            if not reader_has_gone(error):
                raise
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            return 128 + 13


def _wish(**wish: object) -> dict[str, object]:
    return {"token": endpoint.token(domain_id()), "env": dict(os.environ), "cwd": working_folder(), **wish}


def _send(client: socket.socket, message: dict[str, object]) -> None:
    client.sendall(json.dumps(message).encode() + b"\n")


@contextlib.contextmanager
def _signals_to(client: socket.socket) -> Iterator[None]:
    """Forward Ctrl-C and `kill` while the block runs."""

    def forward(signum: int, _frame: object) -> None:
        with contextlib.suppress(OSError):
            _send(client, {"signal": endings()[signum]})

    previous = {number: signal.signal(number, forward) for number in endings()}
    try:
        yield
    finally:
        for number, handler in previous.items():
            signal.signal(number, handler)


def _forward_stdin(client: socket.socket, keyboard: Keyboard) -> None:
    decoder = codecs.getincrementaldecoder("utf-8")("replace")
    with contextlib.suppress(OSError, ValueError):
        while data := keyboard.read():
            _send(client, {"stdin": decoder.decode(data)})
        _send(client, {"eof": True})


def _say_which(notebook: str) -> None:
    """Print which of several notebooks this terminal uses, for a person at the terminal."""
    if sys.stderr.isatty() and endpoint.live_sessions(domain_id()) > 1:
        print(f"(in the session of {notebook}, the notebook in which a cell was run last)", file=sys.stderr, flush=True)


def _show(client: socket.socket, keyboard: Keyboard) -> int:
    """Print the process's output until it ends. NoSession: the session ended before it accepted the command."""
    taken = False
    with contextlib.suppress(ConnectionResetError):
        for line in lines(client):
            message = json.loads(line)
            if not taken:  # typed input must go to a session that has the command, not to one that is ending
                threading.Thread(target=_forward_stdin, args=(client, keyboard), daemon=True).start()
                taken = True
            if message.get("session"):
                _say_which(message["session"])
            if "keys" in message:
                keyboard.want_keys()
            if "exit" in message:
                return int(message["exit"])
            for name, stream in (("stdout", sys.stdout), ("stderr", sys.stderr)):
                if name in message:
                    stream.write(message[name])
                    stream.flush()
    if not taken:
        raise endpoint.NoSession(f"the session of ROS_DOMAIN_ID={domain_id()} ended before it took the command")
    print("The session ended while the command ran.", file=sys.stderr)
    return 1
