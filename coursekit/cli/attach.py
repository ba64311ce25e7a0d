"""The terminal's side: hand a command to the session that runs, and be its screen, keyboard and Ctrl-C."""

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
from coursekit.systems.endings import endings
from coursekit.systems.folder import working_folder
from coursekit.systems.keyboard import Keyboard
from coursekit.systems.streams import reader_has_gone, use_utf8
from coursekit.systems.waiting import lines

from . import endpoint

START_SECONDS = 20.0
ATTEMPTS = 3
"""A session that ends in the moment in which it is asked has not taken the command: another one is asked."""


def domain_id() -> int:
    """The domain of this terminal."""
    text = os.environ.get("ROS_DOMAIN_ID") or "0"
    return int(text) if text.isdecimal() else 0


def connect_or_start() -> socket.socket:
    """A connection to the domain's session; one is started when there is none."""
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
    """Have the session carry out `ros2 ARGV`; its exit code."""
    for _ in range(ATTEMPTS - 1):
        with contextlib.suppress(endpoint.NoSession):
            return _be_terminal(connect_or_start(), {"argv": list(argv)})
    return _be_terminal(connect_or_start(), {"argv": list(argv)})


def answer(argv: Sequence[str]) -> list[str]:
    """The words that the domain's session prints to `ros2 ARGV`; none when no session runs."""
    try:
        client = endpoint.connect(domain_id())
    except endpoint.NoSession:
        return []
    with client:
        _send(client, _wish(argv=list(argv)))
        said = itertools.takewhile(lambda one: "exit" not in one, map(json.loads, lines(client)))
        return "".join(one.get("stdout", "") for one in said).split()


def who_answers() -> tuple[str, int]:
    """The notebook whose session this terminal speaks to, '' for none's, and how many sessions run; NoSession."""
    return _name_of(domain_id()), endpoint.live_sessions(domain_id())


def holder(domain: int) -> str | None:
    """The notebook or test that has the domain's terminals, '' for the session that commands start; None for nobody."""
    with contextlib.suppress(endpoint.NoSession):
        return _name_of(domain)
    return None


def _name_of(domain: int) -> str:
    client = endpoint.connect(domain)
    with client:
        _send(client, {"token": endpoint.token(domain)})
        return str(json.loads(next(lines(client), "{}")).get("session", ""))


def attach_script(path: Path, argv: Sequence[str]) -> int | None:
    """Have the session carry out `python3 PATH ARGV`; its exit code, or None when no session runs."""
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
    """Pass Ctrl-C and `kill` on while the block runs."""

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
    """Where several notebooks run, a person is told to which one this terminal speaks."""
    if sys.stderr.isatty() and endpoint.live_sessions(domain_id()) > 1:
        print(f"(in the session of {notebook}, the notebook in which a cell was run last)", file=sys.stderr, flush=True)


def _show(client: socket.socket, keyboard: Keyboard) -> int:
    """Print what the process prints; returns when it ends. NoSession: the session ended before it took the command."""
    taken = False
    with contextlib.suppress(ConnectionResetError):
        for line in lines(client):
            message = json.loads(line)
            if not taken:  # what is typed goes to a session that has the command, not to one that is going
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
