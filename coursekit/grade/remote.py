"""A student's work seen from outside of its sandbox: the judge asks, the sandbox answers in JSON."""

from __future__ import annotations

import builtins
import contextlib
import json
import select
import sys
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from . import sandbox
from .inside import PATIENCE
from .interruptions import Gone, NeedsWorkspace
from .trial import PATIENCE as PATIENT
from .trial import Plan, Seen, TrialFailed, answered, asked
from .variants import Values
from .verdict import Wrong
from .wire import pack, refresh, unpack
from .work import Work, _words

CALL_SECONDS = 10.0
BUILD_SECONDS = 60.0


class Line:
    """Questions and answers over the sandbox's stdin and stdout."""

    def __init__(self, running: sandbox.Sandboxed, limits: sandbox.Limits) -> None:
        self._running = running
        self._limits = limits
        self._read = 0
        self._rest = b""

    def ask(self, question: dict[str, Any], seconds: float) -> dict[str, Any]:
        """The answer; Gone when there is none."""
        assert self._running.child.stdin is not None
        try:
            self._running.child.stdin.write(json.dumps(question).encode() + b"\n")
            self._running.child.stdin.flush()
            answer = json.loads(self._line(time.monotonic() + seconds))
        except (OSError, ValueError) as error:
            raise Gone(self._why(error)) from None
        if not isinstance(answer, dict):
            raise Gone("the sandbox answered nonsense")
        return answer

    def _line(self, give_up: float) -> bytes:
        assert self._running.child.stdout is not None
        pipe = self._running.child.stdout
        while b"\n" not in self._rest:
            left = give_up - time.monotonic()
            if left <= 0 or not select.select([pipe], [], [], min(left, 0.5))[0]:
                if left <= 0:
                    self._running.end("it did not answer in time")
                    raise ValueError("no answer")
                continue
            data = pipe.read1(65536)  # type: ignore[attr-defined]
            self._read += len(data)
            if not data or self._read > self._limits.output:
                self._running.end("" if not data else "it wrote more than it may")
                raise ValueError("no answer")
            self._rest += data
        line, _, self._rest = self._rest.partition(b"\n")
        return line

    def _why(self, error: Exception) -> str:
        return self._running.stopped or f"the program ended while it ran ({error})"


class RemoteWork(Work):
    """`Work` whose variables live in a sandbox and whose programs are tried out in further ones."""

    def __init__(
        self,
        line: Line,
        workspace: Path,
        environment: Mapping[str, str],
        limits: sandbox.Limits,
        values: Values | None = None,
    ) -> None:
        super().__init__({}, workspace)
        self._values = values or {}
        self._line = line
        self._environment = environment
        self._limits = limits
        self._moment = ""
        self._given: dict[str, Any] = {}
        self.complete = False
        """Whether all cells have run and the packages are built."""

    def run(self, source: str, seconds: float) -> str:
        """Run a cell in the sandbox; what went wrong."""
        question = {"ask": "run", "source": source, "seconds": seconds}
        return str(self._line.ask(question, PATIENCE * seconds + 10).get("error", ""))

    def build(self, seconds: float) -> None:
        """Build what the notebook builds; then files and programs can be judged."""
        self._line.ask({"ask": "build", "seconds": seconds}, PATIENCE * seconds + 10)
        self.complete = True

    def judge_from_here(self, exercise: str) -> None:
        """The work is judged as it is now: whoever judges `exercise` later still sees the variables of this moment."""
        self._moment = exercise
        self.variants = self._values.get(exercise, {})
        self._given = {}
        if not self.complete:
            self._line.ask({"ask": "keep", "moment": exercise}, CALL_SECONDS)

    def value(self, name: str, kind: type[Any]) -> Any:
        answer = self._line.ask({"ask": "value", "name": name, "moment": self._moment}, CALL_SECONDS)
        self.variables = {} if answer.get("missing") else {name: _unpacked(answer)}
        found = self._given[name] = super().value(name, kind)
        return found

    def function(self, name: str) -> Any:
        answer = self._line.ask({"ask": "value", "name": name, "moment": self._moment}, CALL_SECONDS)
        if answer.get("missing"):
            raise Wrong(f"a function named `{name}`", "there is none", "Was the cell above run?")
        return lambda *args: self._call(name, args)

    def _call(self, name: str, args: Sequence[Any]) -> Any:
        """Call the student's function; what it and the judge change in arguments and variables, both see."""
        question = {
            "ask": "call",
            "name": name,
            "moment": self._moment,
            "args": [pack(one) for one in args],
            "variables": {known: pack(one) for known, one in self._given.items()},
            "seconds": CALL_SECONDS,
        }
        said = self._line.ask(question, PATIENCE * CALL_SECONDS + 5)
        if said.get("missing") or said.get("error"):
            raise _error_of(str(said.get("error") or f"RuntimeError: `{name}` cannot be called"))
        with contextlib.suppress(TypeError, ValueError, AttributeError, LookupError):  # nonsense changes nothing
            for place, changed in dict(said.get("args") or {}).items():
                refresh(args[int(place)], unpack(changed))
            for known, changed in dict(said.get("variables") or {}).items():
                refresh(self._given[known], unpack(changed))
        returned = said.get("argument")
        return args[returned] if type(returned) is int and 0 <= returned < len(args) else _unpacked(said)

    def file(self, path: str) -> Path:
        self._need()
        found = super().file(path)
        if not found.resolve().is_relative_to(self.workspace.resolve()):
            raise Wrong(f"the file {path} in {self.workspace.name}/", "a link to a place outside of it")
        return found

    def built(self, package: str) -> Path:
        self._need()
        return super().built(package)

    def environment(self) -> dict[str, str]:
        from coursekit.packages.overlay import overlay_environment

        install = self.workspace / "install"
        env = dict(self._environment)
        return overlay_environment(install, env) if install.is_dir() else env

    def try_out(
        self, *commands: str, seconds: float = 3.0, later: Sequence[tuple[float, str]] = (), **plan: Any
    ) -> Seen:
        self._need()
        run, asked = [_words(one) for one in commands], [(when, _words(one)) for when, one in later]
        try:
            return self._sandboxed_trial(Plan(run=run, seconds=seconds, later=asked, **plan))
        except TrialFailed as failure:
            raise Wrong("programs that run", str(failure)) from None

    def _need(self) -> None:
        if not self.complete:
            raise NeedsWorkspace

    def _sandboxed_trial(self, plan: Plan) -> Seen:
        # -I: what the student's folders hold must not stand in for modules of ours
        command = [sys.executable, "-I", "-m", "coursekit.grade.trial", str(PATIENT)]
        env = self.environment() | {"COURSEKIT_TIME": "virtual"}
        running = sandbox.start(command, self.workspace.parent, env, self._limits)
        key, question = asked(plan)
        try:
            out = running.answer(question, self._limits.output)
            if running.stopped:
                raise TrialFailed(running.stopped)
            return answered(key, out)
        finally:
            running.end()


def _unpacked(answer: dict[str, Any]) -> Any:
    try:
        return unpack(answer.get("value"))
    except Exception:
        raise Wrong("a value that can be told", "something else") from None


def _error_of(text: str) -> Exception:
    """The error that a student's function raised, of its own kind where that is one of Python's.

    >>> _error_of("ValueError: too near (line 3)")
    ValueError('too near (line 3)')
    >>> _error_of("SystemExit: 0")
    RuntimeError('SystemExit: 0')
    """
    name, _, said = text.partition(": ")
    kind = getattr(builtins, name, None)
    if isinstance(kind, type) and issubclass(kind, Exception) and not issubclass(kind, (OSError, UnicodeError)):
        return kind(said)
    return RuntimeError(text)
