"""Waiting: for a time, and on until an event has happened, so that a slow or first start loses nothing."""

from __future__ import annotations

import re
import sys
from typing import Any

from coursekit.cli.api import full_name
from coursekit.processes.base_process import BaseProcess
from coursekit.processes.session import Session, current
from coursekit.view.progress_bar import ProgressBar
from coursekit.words.gettext import gettext

from .errors import NotNow, TooLate
from .known_terminals import failed
from .messages import listen
from .panel_node import HiddenNode

LOOK_SECONDS = 0.05
PATIENCE_SECONDS = 180.0
"""The default timeout [s]: the first start of SLAM compiles it, which takes a slow machine two minutes."""
REPEATED_LINES = 30
"""A program that waits in vain says so once a second: `tf2_echo` for a frame that nobody sends."""


def wait(seconds: float = 0.0, until: str = "", timeout_sec: float = PATIENCE_SECONDS) -> None:
    """Block this cell while the processes run on: for `seconds`, and with `until` also until that topic has a message.

    TooLate (a TimeoutError) when no message came, NotNow when no program runs that could publish one.
    `wait(3, until="/map")` waits 3 s, or longer if SLAM takes longer to start.

    >>> %ros2 run demo_nodes_py talker &
    [talker: running]
    >>> wait(until="/chatter")
    >>> echo("/chatter")
    data: 'Hello World: 1'
    ---
    """
    session = current()
    what = gettext(f"Waiting for a message on {until}") if until else gettext("Waiting")
    with ProgressBar(what, 0.0 if until else seconds) as bar:
        if not until:
            session.clock.sleep(seconds)
        elif not _wait_for(session, full_name(until), seconds, timeout_sec, bar):
            if _nobody_runs(session):
                raise NotNow(gettext(f"Nothing publishes {until}: no program runs. Run the cells above that start them."))
            said = gettext(
                f"No message came on {until} within {timeout_sec:g} s. {_failed()}`graph()` shows its publishers; "
                "the terminals show what the programs printed."
            )
            raise TooLate(said)


def _nobody_runs(session: Session) -> bool:
    """Whether no message can come: there is no process, no node except those of panels, and no network."""
    joining = sys.modules.get("coursekit.net.joining")  # not imported means never joined
    joined = joining is not None and any(joining.link_of(session, domain) for domain in session.graphs)
    nodes = [node for graph in session.graphs.values() for node in graph.nodes if not node.name.startswith("_")]
    return not session.processes and not nodes and not joined


def _failed() -> str:
    """Return a sentence for each terminal whose program ended with an error."""
    return "".join(gettext(f"{shown.title} ended with {shown.state}. ") for shown in failed())


def _while_nobody_publishes() -> str:
    """Return what to show below the bar: programs that ended with an error, without which the wait may be in vain."""
    ended = _failed()
    return gettext(f"Nobody publishes it yet. {ended}The stop button (■) ends this wait.") if ended else ""


def _wait_for(session: Session, topic: str, least: float, most: float, bar: ProgressBar) -> bool:
    clock = session.clock
    begin, hidden, heard = clock.steady(), HiddenNode("wait"), list[Any]()
    subscription = None
    try:
        while (passed := (clock.steady() - begin) * 1e-9) < least or (not heard and passed < most):
            if subscription is None and hidden.node.count_publishers(topic):
                subscription = listen(hidden, topic, heard.append)
            if subscription is None and passed >= least and _nobody_runs(session):
                break
            bar.note = _while_nobody_publishes() if subscription is None else ""
            clock.sleep(min(LOOK_SECONDS, least - passed) if passed < least else LOOK_SECONDS)
    finally:
        hidden.close()
    return bool(heard)


def until_said(
    process: BaseProcess, text: str, least: float = 0.0, most: float = PATIENCE_SECONDS, *, repeated: bool = True
) -> bool:
    """Wait `least` seconds, then until a process has printed `text` or ended, at most `most` seconds more; whether it did.

    Without `repeated` a process that only repeats its line is not waited for either.
    """
    clock = process.session.clock
    said = clock.new_event()
    process.on_output(lambda _stream, _text: said.set() if _is_enough(process.output, text, repeated) else None)
    process.on_exit(lambda _process: said.set())
    if process.wait(least) is None and text not in process.output:
        said.wait(most)
        process.wait(4 * LOOK_SECONDS)  # for the rest of the same output
    return text in process.output


def _is_enough(output: str, text: str, repeated: bool) -> bool:
    return text in output or (not repeated and _repeats(output))


def _repeats(output: str) -> bool:
    """Whether the last lines of an output are the same one again and again, but for its numbers.

    >>> _repeats("[1.0] no map\\n" * 30), _repeats("[1.0] no map\\n" * 10)
    (True, False)
    """
    last = output.splitlines()[-REPEATED_LINES:]
    return len(last) == REPEATED_LINES and len({re.sub(r"[\d.]+", "", line) for line in last}) == 1


__all__ = ["until_said", "wait"]
