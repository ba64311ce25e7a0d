"""A student's work seen from outside its sandbox: the judge asks, the sandbox answers in JSON."""

from __future__ import annotations

import builtins
import contextlib
import hashlib
import hmac
import json
import os
import random
import sys
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from coursekit.systems.inherited import name_for_child
from coursekit.systems.pipes import readable

from . import folders, sandbox
from .interruptions import Gone, NeedsWorkspace, TimeOver
from .reading import KINDS
from .sandbox_facts import checked
from .sandbox_json import pack, refresh, unpack
from .sandbox_program import SLOWNESS
from .trial import GIVES_WAY, PROGRAMS, WATCHER, Plan, Seen, TrialFailed, answered, question
from .variants import Values
from .verdict import NO_HINT, Wrong
from .work import NOTHING, Work

READ_SECONDS = 20.0


class Line:
    """Questions and answers over the sandbox's stdin and stdout."""

    def __init__(self, running: sandbox.Sandboxed, limits: sandbox.Limits) -> None:
        self.running = running
        self._limits = limits
        self._read = 0
        self._rest = b""

    def ask(self, question: dict[str, Any], seconds: float) -> dict[str, Any]:
        """Ask a question and return the answer; Gone when there is none."""
        assert self.running.child.stdin is not None
        try:
            self.running.child.stdin.write(json.dumps(question).encode() + b"\n")
            self.running.child.stdin.flush()
            answer = json.loads(self._line(time.monotonic() + seconds))
        except (OSError, ValueError, RecursionError) as error:
            raise Gone(self._why(error), timed_out=self.running.timed_out) from None
        if not isinstance(answer, dict):
            raise Gone("the sandbox answered nonsense")
        return answer

    def _line(self, give_up: float) -> bytes:
        assert self.running.child.stdout is not None
        pipe = self.running.child.stdout
        while b"\n" not in self._rest:
            left = give_up - time.monotonic()
            if left <= 0 or not readable(pipe.fileno(), min(left, 0.5)):
                if left <= 0:
                    self.running.end("it did not answer in time", timed_out=True)
                    raise ValueError("no answer")
                continue
            data = pipe.read1(65536)  # type: ignore[attr-defined]
            self._read += len(data)
            if not data or self._read > self._limits.output:
                self.running.end("" if not data else "it wrote more than it may")
                raise ValueError("no answer")
            self._rest += data
        line, _, self._rest = self._rest.partition(b"\n")
        return line

    def _why(self, error: Exception) -> str:
        return self.running.stopped or f"the program ended while it ran ({error})"


class RemoteWork(Work):
    """`Work` whose variables are in a sandbox, and whose files and programs are examined in further ones.

    A judge that needs files before `finish` is interrupted by NeedsWorkspace, and called again afterwards. By then
    the notebook's sandbox has ended, so nothing can change the files any more; variables requested before are kept.
    """

    def __init__(
        self,
        running: sandbox.Sandboxed,
        workspace: Path,
        environment: Mapping[str, str],
        limits: sandbox.Limits,
        values: Values | None = None,
        secret: bytes = b"",
    ) -> None:
        super().__init__({}, workspace)
        self._values = values or {}
        self._running = running
        self._line = Line(running, limits)
        self._environment = environment
        self._limits = limits
        self._secret = secret
        self._given: dict[str, dict[str, Any]] = {}
        """By exercise: the variables requested by its judge."""
        self._moment = ""
        self._reader: Line | None = None
        self.cell_timed_out = False
        """Whether the last cell exceeded its time."""
        self.build_timed_out = False
        """Whether the build was ended before completion."""
        self.complete = False
        """Whether all cells have run, the packages are built, and the notebook has ended."""

    def run(self, source: str, seconds: float) -> str:
        """Run a cell in the sandbox. Returns its error."""
        question = {"ask": "run", "source": source, "seconds": seconds}
        answer = self._line.ask(question, SLOWNESS * seconds + 10)
        self.cell_timed_out = answer.get("timed_out") is True
        return str(answer.get("error", ""))

    def finish(self, seconds: float) -> None:
        """Run the notebook's builds, and end the notebook; then files and programs can be judged."""
        answer = self._line.ask({"ask": "build", "seconds": seconds}, SLOWNESS * seconds + 10)
        self.build_timed_out = answer.get("timed_out") is True
        self._running.end()
        folders.remove_pipes(self.workspace.parent)
        self.complete = True

    def end(self) -> None:
        """End all sandboxes."""
        self._running.end()
        if self._reader is not None:
            self._reader.running.end()

    def judge_from_here(self, exercise: str) -> None:
        """Judge the work for `exercise` in its current state."""
        self._moment = exercise
        self.variants = self._values.get(exercise, {})
        self._given.setdefault(exercise, {})

    def dice(self, name: str) -> random.Random:
        return random.Random(hmac.new(self._secret, f"{self._moment} {name}".encode(), hashlib.sha256).digest())

    def value(self, name: str, kind: type[Any]) -> Any:
        given = self._given[self._moment]
        if name not in given:
            answer = self._line.ask({"ask": "value", "name": name}, self._limits.call)
            self.variables = {} if answer.get("missing") else {name: _unpacked(answer)}
            given[name] = super().value(name, kind)
        return given[name]

    def function(self, name: str) -> Any:
        answer = self._line.ask({"ask": "callable", "name": name}, self._limits.call)
        if answer.get("missing"):
            held = self._line.ask({"ask": "value", "name": name}, self._limits.call)
            self.variables = {} if held.get("missing") else {name: _unpacked(held)}
            super().function(name)  # reports whether it is missing, or not a function
            raise Wrong(f"a function named `{name}`", NOTHING, "Was the cell above run?")
        return lambda *args: self._call(name, args)

    def _call(self, name: str, args: Sequence[Any]) -> Any:
        """Call the student's function; changes to arguments and variables are passed in both directions."""
        given = self._given[self._moment]
        question = {
            "ask": "call",
            "name": name,
            "args": [pack(arg) for arg in args],
            "variables": {known: pack(value) for known, value in given.items()},
            "seconds": self._limits.call,
        }
        said = self._line.ask(question, SLOWNESS * self._limits.call + 5)
        if said.get("timed_out") is True:
            raise TimeOver(str(said.get("error")).removeprefix("TookTooLong: "))
        if said.get("missing") or said.get("error"):
            raise _error_of(str(said.get("error") or f"RuntimeError: `{name}` cannot be called"))
        with contextlib.suppress(TypeError, ValueError, AttributeError, LookupError):  # invalid values change nothing
            for place, changed in dict(said.get("args") or {}).items():
                refresh(args[int(place)], unpack(changed))
            for known, changed in dict(said.get("variables") or {}).items():
                refresh(given[known], unpack(changed))
        returned = said.get("argument")
        return args[returned] if type(returned) is int and 0 <= returned < len(args) else _unpacked(said)

    def _read(self, what: str, **arguments: Any) -> Any:
        self._need()
        if self._reader is None:
            command = [sys.executable, "-I", "-m", "coursekit.grade.reader", str(self.workspace)]
            folder = self.workspace.parent
            running = sandbox.start(command, folder, self._environment, self._limits, writable=False)
            self._reader = Line(running, self._limits)
        try:
            answer = self._reader.ask({"ask": what, **arguments}, READ_SECONDS)
            if "wrong" in answer:
                expected, got, cause = checked(list[str], json.dumps(answer["wrong"]))
                raise Wrong(expected, got, cause)
            return checked(KINDS[what], json.dumps(answer["facts"]))
        except (Gone, ValueError, KeyError) as error:
            self._reader.running.end()
            self._reader = None
            late = isinstance(error, Gone) and error.timed_out
            raise Wrong("files that can be read", f"{error}"[:300], timed_out=late, hint=NO_HINT) from None

    def _need(self) -> None:
        if not self.complete:
            raise NeedsWorkspace

    def _carry_out(self, plan: Plan) -> Seen:
        """Run the watcher and the student's programs in one sandbox each, connected by two pipes."""
        self._need()
        env = dict(self._environment) | {"COURSEKIT_TIME": "virtual", "COURSEKIT_WORKSPACE": str(self.workspace)}
        folder = self.workspace.parent
        there, back = os.pipe(), os.pipe()
        started: list[sandbox.Sandboxed] = []
        try:
            command = [*WATCHER, str(GIVES_WAY), name_for_child(back[0]), name_for_child(there[1])]
            pipes = (back[0], there[1])
            started.append(sandbox.start(command, folder, env, self._limits, writable=False, pipes=pipes))
            command = [*PROGRAMS, name_for_child(there[0]), name_for_child(back[1])]
            started.append(sandbox.start(command, folder, env, self._limits, pipes=(there[0], back[1])))
            for end in (*there, *back):
                os.close(end)
            there = back = (-1, -1)
            out = started[0].answer(question(plan), self._limits.output)
            for running in reversed(started):
                if running.stopped:
                    raise TrialFailed(running.stopped, timed_out=running.timed_out)
            return answered(out)
        finally:
            for running in started:
                running.end()
            for end in (*there, *back):
                if end >= 0:
                    os.close(end)


def _unpacked(answer: dict[str, Any]) -> Any:
    try:
        return unpack(answer.get("value"))
    except Exception:
        raise Wrong("a value that can be told", "something else", hint=NO_HINT) from None


def _error_of(text: str) -> Exception:
    """Recreate the error of a student's function, with its type if built in, else a type of that name.

    >>> _error_of("ValueError: too near (line 3)")
    ValueError('too near (line 3)')
    >>> _error_of("JSONDecodeError: no value"), isinstance(_error_of("SystemExit: 0"), RuntimeError)
    (JSONDecodeError('no value'), True)
    """
    name, _, said = text.partition(": ")
    kind = getattr(builtins, name, None)
    if isinstance(kind, type) and issubclass(kind, Exception) and not issubclass(kind, (OSError, UnicodeError)):
        return kind(said)
    known = name.isascii() and name.isidentifier() and len(name) < 60
    return type(name, (RuntimeError,), {})(said) if known else RuntimeError(text)
