"""A judge's view of a student's work: variables of the notebook, files of the workspace, trials of the programs."""

from __future__ import annotations

import math
import os
import random
import re
import tempfile
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from coursekit.suggestions import similar
from coursekit.systems.command_lines import split_words

from . import reading
from .trial import Plan, Seen, TrialFailed, try_out
from .verdict import NO_HINT, Skipped, Wrong

if TYPE_CHECKING:
    from coursekit.interfaces.model import Message
    from coursekit.urdf import Robot
    from coursekit.view.figure import Figure

    from .illustration import Illustration

T = TypeVar("T")
NOTHING = "there is none"
"""Shown in place of a variable or function that the notebook lacks."""


class Work:
    """A student's work for one exercise.

    Judges must use variables and functions first, then files and programs: in grading, the notebook has ended by
    then.
    """

    def __init__(self, variables: Mapping[str, Any], workspace: Path) -> None:
        self.variables = variables
        self.workspace = workspace
        self.variants: Mapping[str, Any] = {}
        """The values of this student's copy that differ from the course's notebook."""
        self.illustration: Illustration | None = None
        """Receives pictures if the verdict is displayed; None in grading."""
        self.asked: dict[str, None] = {}
        """The names that the judge looked for, in order: variables and functions, packages, files, executables."""

    def variant(self, name: str, usual: T) -> T:
        """Return this student's value of an exercise; the `usual` one if there are no variants.

        >>> Work({}, Path()).variant("boxes", 10)
        10
        """
        value: Any = self.variants.get(name, usual)
        if type(value) is int and isinstance(usual, float):
            value = float(value)  # JSON from a browser has no 3.0
        return value if type(value) is type(usual) else usual

    def dice(self, name: str) -> random.Random:
        """Return random numbers for the judge's questions: constant in a notebook, secret in grading.

        >>> Work({}, Path()).dice("poses").random() == Work({}, Path()).dice("poses").random()
        True
        """
        return random.Random(name)

    def illustrate(self, make: Callable[..., Figure], *facts: Any) -> None:
        """Show the figure drawn by `make(*facts)` beside the verdict; the last one counts.

        `facts` are plain values validated by the judge. Lists that grow meanwhile are drawn in their final state.
        Nothing is drawn if the verdict is not displayed, as in grading; a figure that cannot be drawn is omitted.
        """
        if self.illustration is not None:
            self.illustration.keep(self, make, *facts)

    # -- the notebook

    def value(self, name: str, kind: type[T]) -> T:
        """Return a variable of the notebook, of exactly that type."""
        self.asked[name] = None
        if name not in self.variables:
            cause = "Was the cell above run, and is the name right?"
            raise Wrong(f"a variable named `{name}`", NOTHING, self._alike(name, cause))
        value = self.variables[name]
        if type(value) is not kind:
            gave = f"{_a(type(value).__name__)}: {value!r:.80}"
            raise Wrong(f"`{name}` as {_a(kind.__name__)}", cause=_why_kind(kind, value), gave=gave, hint=NO_HINT)
        return value

    def function(self, name: str) -> Any:
        """Return a function of the notebook."""
        self.asked[name] = None
        function = self.variables.get(name)
        if not callable(function):
            cause = "Was the cell above run?"
            if name not in self.variables:
                raise Wrong(f"a function named `{name}`", NOTHING, self._alike(name, cause))
            gave = f"{_a(type(function).__name__)}: {function!r:.80}"
            raise Wrong(f"a function named `{name}`", cause=cause, gave=gave, hint=NO_HINT)
        return function

    def _alike(self, name: str, otherwise: str) -> str:
        """Return the cause of a missing name: another that was probably meant to be this one."""
        found = similar(name, [known for known in self.variables if type(known) is str], cutoff=0.8)
        return f"There is `{found[0]}`. Is its name a slip?" if found else otherwise

    # -- the workspace

    def text(self, path: str) -> str:
        """Return the text of a workspace file; Wrong when it does not exist."""
        content: str = self._read("text", path=path)
        return content

    def exists(self, path: str) -> bool:
        """Whether the workspace has a file or folder of that name."""
        there: bool = self._read("exists", path=path)
        return there

    def installed(self, package: str, path: str) -> bool:
        """Whether the last build of a package installed this file of its share folder; one of an older build is not."""
        there: bool = self._read("installed", package=package, path=path)
        return there

    def built(self, package: str, *of: str) -> None:
        """Raise Wrong when a package of the workspace was not built, or has changed since.

        `of` are the files of the exercise, without suffixes: changes for another exercise do not matter.
        """
        build = self._read("build", package=package, of=list(of))
        command = f"Run: %colcon build --packages-select {package}"
        if not build.there:
            raise Wrong(f"the package {package}, built", "it is not in install/", command)
        if build.fault:
            if build.fault.startswith("the last build of"):
                command = f"The build's output says why. Mend that, then {command[0].lower()}{command[1:]}"
            raise Wrong(f"the package {package}, built as it is now", build.fault, build.cure or command)

    def compiled(self, package: str, *of: str) -> None:
        """Raise Wrong when a C++ package was not built in its current state; Skipped when C++ cannot be compiled."""
        from coursekit.cpp.toolchain import NoToolchain, find_toolchain

        try:
            find_toolchain()
        except NoToolchain:
            why = "There is no C++ compiler here, and this exercise has no points. `coursekit cpp` gets one."
            raise Skipped(why) from None
        self.built(package, *of)

    def robot(self, path: str) -> Robot:
        """Return the robot in a URDF or xacro file; Wrong with the fault and its position."""
        from .sandbox_facts import robot_of

        return robot_of(self._read("robot", path=path), Path(self._scratch.name))

    def message(self, path: str) -> Message:
        """Return a message definition, src/PACKAGE/msg/NAME.msg; Wrong with the fault and its position."""
        message: Message = self._read("message", path=path)
        return message

    def parameters(self, path: str, nodes: Sequence[str]) -> dict[str, dict[str, Any]]:
        """Return the parameters that a file sets for each of these nodes, as parsed by ROS."""
        parameters: dict[str, dict[str, Any]] = self._read("parameters", path=path, nodes=list(nodes))
        return parameters

    def _read(self, what: str, **arguments: Any) -> Any:
        self._note(arguments.get("path", ""), arguments.get("package", ""))
        return reading.READINGS[what](self.workspace, **arguments)

    def _note(self, *texts: str) -> None:
        """Note the names in paths and commands; single words such as `run` and `src` are no names of an exercise."""
        self.asked.update((name, None) for text in texts for name in re.findall(r"\w+", text) if "_" in name.strip("_"))

    @cached_property
    def _scratch(self) -> tempfile.TemporaryDirectory[str]:
        """The folder for the judge's own files."""
        return tempfile.TemporaryDirectory(prefix="judge-")

    # -- programs

    def try_out(
        self, *commands: str, beside: Sequence[str] = (), later: Sequence[tuple[float, str]] = (), **plan: Any
    ) -> Seen:
        """Run command lines (without the word `ros2`) alone on the virtual clock; see `Plan` for the rest.

        `commands` and `later` are the student's; `beside` are the course's own programs, which run apart from all of
        a student's code.
        """
        self._note(*commands)
        planned = Plan(
            run=[_words(command) for command in commands],
            later=[(when, _words(line)) for when, line in later],
            beside=[_words(line) for line in beside],
            **plan,
        )
        try:
            return self._carry_out(planned)
        except TrialFailed as failure:
            raise Wrong("programs that run", str(failure), timed_out=failure.timed_out, hint=NO_HINT) from None

    def _carry_out(self, plan: Plan) -> Seen:
        return try_out(plan, {**os.environ, "COURSEKIT_WORKSPACE": str(self.workspace)}, str(self.workspace))


def _words(command: str) -> list[str]:
    try:
        return split_words(command)
    except ValueError:
        raise Wrong("a command line whose quotes come in pairs", command[:120], hint=NO_HINT) from None


def _why_kind(kind: type, value: Any) -> str:
    """Return what to write for a value of that type; empty where nothing short helps."""
    if kind is list and type(value) in (tuple, set):
        return "A list stands in square brackets."
    if kind is str and type(value) in (int, float):
        return "A text stands between quotes."
    if kind in (int, float) and is_text_of_number(value):
        return "A number stands without quotes."
    return "What gave this value returns nothing: to print is not to return." if value is None else ""


def is_text_of_number(value: Any) -> bool:
    """Whether a value is a text that reads as a finite number, as when quotes stand around it.

    >>> is_text_of_number("1.57"), is_text_of_number("hello"), is_text_of_number("nan"), is_text_of_number(1.57)
    (True, False, False, False)
    """
    try:
        return type(value) is str and math.isfinite(float(value))
    except ValueError:
        return False


def _a(noun: str) -> str:
    """Return the noun with its article.

    >>> _a("int"), _a("list")
    ('an int', 'a list')
    """
    return f"{'an' if noun[:1] in 'aeio' else 'a'} {noun}"
