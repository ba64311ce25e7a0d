"""Run in Wine: a session with the compiled programs of a prefix; says as JSON how each ended and what it printed.

python cpp_session.py PREFIX virtual|wall STORY
"""

from __future__ import annotations

import json
import os
import sys

from coursekit.processes.executables import find, make_process
from coursekit.processes.session import Session


def main(prefix: str, clock: str, story: str) -> None:
    """Tell one of the stories below."""
    os.environ["AMENT_PREFIX_PATH"] = prefix
    with (session := Session(virtual=clock == "virtual")).use():
        print(json.dumps(STORIES[story](session)))


def _start(session: Session, name: str) -> object:
    return session.launch(make_process(session, find("far", name), [], name=name))


def _ended(*processes: object) -> list[tuple[int, str]]:
    return [(process.wait(30.0), process.output) for process in processes]  # type: ignore[attr-defined]


def _until(session: Session, process: object, text: str, seconds: float) -> None:
    """On the virtual clock wait so long, on the wall clock until the process has said it: a computer may be busy."""
    session.clock.sleep(seconds)
    while not session.clock.virtual and text not in process.output and process.exit_code is None:  # type: ignore[attr-defined]
        session.clock.sleep(0.05)


def _pair(session: Session) -> list[tuple[int, str]]:
    """A talker and a listener until Ctrl-C."""
    both = [_start(session, "talker"), _start(session, "listener")]
    _until(session, both[1], "heard", 1.6)
    for process in both:
        process.interrupt()  # type: ignore[attr-defined]
    return _ended(*both)


def _threads(session: Session) -> list[tuple[int, str]]:
    """A program that ends by itself."""
    return _ended(_start(session, "threads"))


def _interrupted(session: Session) -> list[tuple[int, str]]:
    """Ctrl-C for one that does not catch it, and for one that computes."""
    both = [_start(session, "plain"), _start(session, "busy")]
    for process in both:
        _until(session, process, "begun", 0.5)
    for process in both:
        process.interrupt()  # type: ignore[attr-defined]
    return _ended(*both)


STORIES = {"pair": _pair, "threads": _threads, "interrupted": _interrupted}

if __name__ == "__main__":
    main(*sys.argv[1:])
