"""Inside the sandbox: run a student's cells, then answer the judge's questions about the results.

Started as `python -m coursekit.grade.sandbox_program`; each JSON line on stdin is answered by one JSON line.
"""

from __future__ import annotations

import _thread
import contextlib
import io
import json
import os
import signal
import sys
from collections.abc import Callable, Iterator
from types import SimpleNamespace
from typing import Any

from coursekit.jupyter.kernel import load_lab

from .sandbox_json import pack, refresh, unpack_of_judge
from .stopped_function import error_of

WAIT_SECONDS = 600.0
"""The maximum virtual duration of a cell [s]."""
SLOWNESS = 2.0
"""The maximum ratio of real time to computing time."""


CANNOT_BE_TOLD = "it raised something that cannot be told"


class TookTooLong(KeyboardInterrupt):
    """Ends a cell that would run forever."""


@contextlib.contextmanager
def _alarm(seconds: float) -> Iterator[list[TookTooLong]]:
    """Interrupt code that computes for longer, or waits for much longer, so that a busy machine does no harm.

    Yields a list with the interruption, if there was one: the interrupted code may have handled it as the user's
    Ctrl-C.
    """
    rung: list[TookTooLong] = []

    def ring(_signum: int, _frame: Any) -> None:
        rung.append(TookTooLong("the cell took too long"))
        raise rung[-1]

    if not hasattr(signal, "setitimer"):
        with _alarm_of_a_thread(SLOWNESS * seconds, ring):
            yield rung
        return
    timers = ((signal.ITIMER_PROF, signal.SIGPROF, seconds), (signal.ITIMER_REAL, signal.SIGALRM, SLOWNESS * seconds))
    for timer, number, limit in timers:
        signal.signal(number, ring)
        signal.setitimer(timer, limit, limit)  # repeated: code may swallow the first one
    try:
        yield rung
    finally:
        for timer, _, _ in timers:
            signal.setitimer(timer, 0)


@contextlib.contextmanager
def _alarm_of_a_thread(seconds: float, ring: Callable[[int, Any], None]) -> Iterator[None]:
    """Call `ring` in the main thread after a real time [s], by Windows' otherwise unused Ctrl-Break."""
    number = signal.SIGBREAK  # type: ignore[attr-defined]
    signal.signal(number, ring)
    over = _thread.allocate_lock()  # independent of the session's clock
    over.acquire()

    def watch() -> None:
        while not over.acquire(timeout=seconds):  # repeated, in case the code continues after an interrupt
            signal.raise_signal(number)

    _thread.start_new_thread(watch, ())
    try:
        yield
    finally:
        over.release()


@contextlib.contextmanager
def _silence() -> Iterator[None]:
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        yield


@contextlib.contextmanager
def _virtual_alarm(seconds: float) -> Iterator[None]:
    """Interrupt code that waits forever on the session's clock; no real time is lost."""
    from coursekit.processes.session import current

    clock = current().clock

    def ring() -> None:
        raise TookTooLong(f"the cell waited for {seconds:g} s")

    alarm = clock.call_at(clock.steady() + round(seconds * 1e9), lambda: clock.main.post(ring))
    try:
        yield
    finally:
        alarm.cancel()


class Runner:
    """A shell like the notebook's, without a kernel."""

    def __init__(self) -> None:
        os.environ["COURSEKIT_TIME"] = "virtual"
        from IPython.core.interactiveshell import InteractiveShell

        shell: Any = InteractiveShell.instance()
        self.shell = shell
        shell.kernel = SimpleNamespace(get_parent=lambda: {"a": "cell"})  # required by the lab's magics
        self.shell.colors = "NoColor"
        with _silence():
            load_lab(shell)
        self.build: list[str] = []

    def run(self, source: str, seconds: float) -> dict[str, Any]:
        """Run a cell. Returns its error; the output is discarded."""
        source = self._without_builds(source)
        try:
            with _alarm(seconds), _virtual_alarm(WAIT_SECONDS), _silence():
                done = self.shell.run_cell(source, store_history=False)
        except TookTooLong as late:
            return _told(late)
        error = done.error_before_exec or done.error_in_exec
        return _told(error) if error is not None else {"error": ""}

    def _without_builds(self, source: str) -> str:
        """Postpone builds to the end, where one serves them all."""
        lines = source.splitlines()
        kept = [line for line in lines if not line.startswith("%colcon build")]
        self.build += [line for line in lines if line.startswith("%colcon build")]
        return "\n".join(kept)

    def ask(self, question: dict[str, Any]) -> dict[str, Any]:
        """Answer one question of the judge."""
        kind = question.get("ask")
        if kind == "run":
            return self.run(str(question["source"]), float(question["seconds"]))
        if kind == "value":
            names = self.shell.user_ns
            return {"value": pack(names[question["name"]])} if question["name"] in names else {"missing": True}
        if kind == "callable":
            return {} if callable(self.shell.user_ns.get(question["name"])) else {"missing": True}
        if kind == "call":
            return self._call(question)
        if kind == "build":
            return self._build(float(question["seconds"]))
        return {"error": f"there is no question {kind!r}"}

    def _call(self, question: dict[str, Any]) -> dict[str, Any]:
        names = self.shell.user_ns
        function = names.get(question["name"])
        if not callable(function):
            return {"missing": True}
        try:
            with _alarm(float(question["seconds"])), contextlib.redirect_stdout(io.StringIO()):
                return _called(function, question, names)
        except BaseException as error:
            return {**_told(error), "error": error_of(error)[:500]}

    def _build(self, seconds: float) -> dict[str, Any]:
        if not self.build:
            return {"error": ""}
        chosen = {word for line in self.build for word in line.split()[2:] if not word.startswith("-")}
        everything = any("--packages-select" not in line for line in self.build)
        self.build = []
        folder = os.environ["COURSEKIT_WORKSPACE"]
        there = {entry for _, folders, _ in os.walk(os.path.join(folder, "src")) for entry in folders}
        select = "" if everything else " --packages-select " + " ".join(sorted(chosen & there))
        return {"error": ""} if not everything and not chosen & there else self.run_build(select, seconds)

    def run_build(self, select: str, seconds: float) -> dict[str, Any]:
        """Build now; a timeout is reported to the judge."""
        with contextlib.suppress(TookTooLong), _alarm(seconds) as rung, contextlib.redirect_stdout(io.StringIO()):
            self.shell.run_line_magic("colcon", f"build{select}")
        return _told(rung[-1]) if rung else {"error": ""}


def _told(error: BaseException) -> dict[str, Any]:
    """Return an exception of the student's code for the judge."""
    return {"error": f"{type(error).__name__}: {error}"[:500], "timed_out": isinstance(error, TookTooLong)}


def _called(function: Any, question: dict[str, Any], names: dict[str, Any]) -> dict[str, Any]:
    """Call a function with the judge's arguments and variables. Returns its result and its changes."""
    given = dict(question.get("variables") or {})
    for name, packed in given.items():
        if pack(names.get(name)) != packed:
            refresh(names.get(name), unpack_of_judge(packed))
    args = [unpack_of_judge(arg) for arg in question["args"]]
    value = function(*args)
    after = [pack(arg) for arg in args]
    changed = {place: value for place, value in enumerate(after) if value != question["args"][place]}
    variables = {name: now for name in given if (now := pack(names.get(name))) != given[name]}
    told = {"args": changed, "variables": variables}
    same = [place for place, arg in enumerate(args) if arg is value and type(arg) not in (bool, int, str)]
    return {"argument": same[0], **told} if same else {"value": pack(value), **told}


def main() -> int:
    """Answer until the judge closes the connection."""
    questions = os.fdopen(os.dup(0), encoding="utf-8")
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    nothing = os.open(os.devnull, os.O_RDWR)
    for number in (0, 1, 2):
        os.dup2(nothing, number)
    getpid, own = os.getpid, os.getpid()  # saved from a cell's changes to `os`
    runner = Runner()
    for line in questions:
        try:
            answer = json.dumps(runner.ask(json.loads(line)))
        except BaseException as error:  # also exceptions whose own str() raises
            late = isinstance(error, TookTooLong)
            answer = json.dumps({"error": f"RuntimeError: {CANNOT_BE_TOLD}", "timed_out": late})
        if getpid() != own:
            break  # a cell forked and this is the child: only one may answer
        answers.write(answer + "\n")
        answers.flush()
    os._exit(0)


if __name__ == "__main__":
    sys.exit(main())
