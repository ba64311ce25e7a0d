"""Executes a CMakeLists.txt as far as files are concerned: variables, conditions, loops, installs.

Nothing is compiled. Compiled targets are recorded, so that they can be reported.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from coursekit.files import read_text
from coursekit.packages.cmake_beyond import demand
from coursekit.packages.cmake_condition import holds
from coursekit.packages.cmake_text import CMakeError, Command, read_commands
from coursekit.packages.cmake_variables import Variables

_BLOCKS = {
    "if": "endif",
    "foreach": "endforeach",
    "while": "endwhile",
    "function": "endfunction",
    "macro": "endmacro",
}


@dataclass(frozen=True)
class Call:
    """A relevant command, with its expanded arguments and its source folder."""

    command: Command
    words: list[str]
    folder: Path


@dataclass
class Reading:
    """The content of a CMakeLists.txt."""

    project: str = ""
    found: list[str] = field(default_factory=list)
    targets: list[str] = field(default_factory=list)
    tests: list[Call] = field(default_factory=list)
    calls: list[Call] = field(default_factory=list)
    hooks: dict[str, str] = field(default_factory=dict)
    """Scripts to run when the workspace is sourced, by file name."""


_KEPT = (
    "install",
    "rosidl_generate_interfaces",
    "ament_auto_find_build_dependencies",
    "ament_export_dependencies",
    "ament_python_install_package",
    "ament_auto_package",
    "ament_index_register_resource",
    "generate_parameter_module",
)
_TARGETS = (
    "add_executable",
    "add_library",
    "ament_auto_add_executable",
    "ament_auto_add_library",
    "pybind11_add_module",
)

_TESTS = (
    "ament_add_pytest_test", "ament_add_ros_isolated_pytest_test", "add_launch_test",
    "ament_add_gtest", "ament_add_gmock", "ament_add_ros_isolated_gtest", "ament_add_ros_isolated_gmock",
    "ament_auto_add_gtest", "ament_add_test", "ament_add_ros_isolated_test", "add_test",
    "ament_copyright", "ament_flake8", "ament_pep257",
)  # fmt: skip


class _Returned(Exception):
    """Raised by return()."""


def read_project(folder: Path, *, testing: bool = False, strict: bool = False) -> Reading:
    """Read the CMakeLists.txt of a folder, optionally with its tests; raises CMakeError.

    With `strict` it raises NeedsCMake for unsupported commands; otherwise they are ignored.
    """
    if not (folder / "CMakeLists.txt").is_file():
        raise CMakeError("there is no such file, but this is a CMake package", folder / "CMakeLists.txt", 1)
    runner = _Runner(folder)
    runner.variables.values["BUILD_TESTING"] = "ON" if testing else "OFF"
    runner.strict = strict
    runner.run_file(folder / "CMakeLists.txt")
    return runner.reading


class _Runner:
    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.reading = Reading()
        self.functions: dict[str, tuple[str, list[str], list[Command]]] = {}
        self.depth = 0
        self.strict = False
        self.variables = Variables(folder)

    def run_file(self, file: Path) -> None:
        """Execute a file, up to its return()."""
        try:
            self.run(read_commands(file))
        except _Returned:
            pass

    def run(self, commands: list[Command]) -> None:
        index = 0
        while index < len(commands):
            command = commands[index]
            if command.name in _BLOCKS:
                end = _block_end(commands, index)
                self._block(command, commands[index + 1 : end])
                index = end
            elif command.name == "return":
                raise _Returned
            else:
                self._command(command)
            index += 1

    def _block(self, command: Command, body: list[Command]) -> None:
        if self.strict and command.name in ("foreach", "while"):
            demand(command, self.variables.words(command))
        if command.name == "if":
            self._if(command, body)
        elif command.name == "foreach":
            self._foreach(command, body)
        elif command.name in ("function", "macro"):
            name, *parameters = self.variables.words(command) or [""]
            self.functions[name.lower()] = (command.name, parameters, body)

    def _if(self, command: Command, body: list[Command]) -> None:
        branch: list[Command] = []
        taken, test, depth = False, command, 0
        for inner in [*body, Command("else", (), command.file, command.line)]:
            if depth == 0 and inner.name in ("elseif", "else"):
                if not taken and (test.name == "else" or holds(self.variables.words(test), self.variables.values)):
                    taken = True
                    self.run(branch)
                branch, test = [], inner
                continue
            depth += (inner.name in _BLOCKS) - (inner.name in _BLOCKS.values())
            branch.append(inner)

    def _foreach(self, command: Command, body: list[Command]) -> None:
        name, *items = self.variables.words(command) or [""]
        if items[:1] == ["IN"]:
            lists = items[items.index("LISTS") + 1 :] if "LISTS" in items else []
            values = items[items.index("ITEMS") + 1 :] if "ITEMS" in items else []
            items = [word for key in lists for word in self.variables.elements(key)] + values
        for item in items:
            self.variables.values[name] = item
            self.run(body)

    def _command(self, command: Command) -> None:
        words = self.variables.words(command)
        if command.name in self.functions:
            self._call(command, words)
        elif command.name in _KEPT:
            self.reading.calls.append(Call(command, words, self.folder))
        elif command.name in _TESTS:
            self.reading.tests.append(Call(command, words, self.folder))
        elif command.name in _TARGETS:
            if words and not {"INTERFACE", "IMPORTED", "ALIAS"} & set(words):
                self.reading.targets.append(words[0])
        else:
            if self.strict:
                demand(command, words)
            if command.name in _ACTIONS:
                _ACTIONS[command.name](self, command, words)

    def _call(self, command: Command, words: list[str]) -> None:
        """Call a function or macro of the file: variables set by a function are local, those set by a macro are not."""
        if self.depth > 20:
            raise command.error(f"{command.name}() calls itself without an end")
        kind, parameters, body = self.functions[command.name]
        given = dict(zip(parameters, words, strict=False))
        given |= {"ARGV": ";".join(words), "ARGC": str(len(words)), "ARGN": ";".join(words[len(parameters) :])}
        given |= {f"ARGV{at}": word for at, word in enumerate(words)}
        self.depth += 1
        if kind == "function":
            self._run_inside(body, given)
        else:
            with self.variables.lent(given):
                self.run(body)  # a macro's return() returns from its caller
        self.depth -= 1

    def _run_inside(self, body: list[Command], given: dict[str, str]) -> None:
        with self.variables.inside(given):
            try:
                self.run(body)
            except _Returned:
                pass

    def project(self, command: Command, words: list[str]) -> None:
        if not words:
            raise command.error("project() needs a name")
        self.reading.project = words[0]
        self.variables.values |= {"PROJECT_NAME": words[0], "CMAKE_PROJECT_NAME": words[0]}

    def find_package(self, command: Command, words: list[str]) -> None:
        self.reading.found += words[:1]
        if words:
            self.variables.values[f"{words[0]}_FOUND"] = "1"

    def set_variable(self, command: Command, words: list[str]) -> None:
        self.variables.set_command(words)

    def unset_variable(self, command: Command, words: list[str]) -> None:
        self.variables.unset_command(words)

    def list_command(self, command: Command, words: list[str]) -> None:
        self.variables.list_command(words)

    def file_command(self, command: Command, words: list[str]) -> None:
        if len(words) < 3 or words[0] not in ("GLOB", "GLOB_RECURSE"):
            return
        patterns, base = words[2:], None
        if "RELATIVE" in patterns:
            at = patterns.index("RELATIVE")
            base, patterns = Path(patterns[at + 1]), patterns[:at] + patterns[at + 2 :]
        files = {p for text in patterns if text != "CONFIGURE_DEPENDS" for p in self._glob(text, words[0])}
        paths = [os.path.relpath(path, base) if base else str(path) for path in sorted(files)]
        self.variables.values[words[1]] = ";".join(paths)

    def _glob(self, text: str, mode: str) -> list[Path]:
        pattern = os.path.relpath(self.folder / text, self.folder)
        paths = self.folder.rglob(pattern) if mode == "GLOB_RECURSE" else self.folder.glob(pattern)
        return list(paths)

    def add_subdirectory(self, command: Command, words: list[str]) -> None:
        folder = self.folder / words[0] if words else self.folder
        if not (folder / "CMakeLists.txt").is_file():
            raise command.error(f"add_subdirectory: there is no {folder / 'CMakeLists.txt'}")
        outer, self.folder = self.folder, folder
        here = {"CMAKE_CURRENT_SOURCE_DIR": str(folder), "CMAKE_CURRENT_LIST_DIR": str(folder)}
        self._run_inside(read_commands(folder / "CMakeLists.txt"), here)
        self.folder = outer

    def environment_hooks(self, command: Command, words: list[str]) -> None:
        for path in (self.folder / word for word in words):
            if not path.is_file():
                raise command.error(f"ament_environment_hooks: there is no {path}")
            name = path.name.removesuffix(".in")
            self.reading.hooks[name] = read_text(path) if name == path.name else self._filled_in(read_text(path))

    def _filled_in(self, template: str) -> str:
        """Replace words between @ by variables, except for the prefix, which only the installer knows."""
        known = {**self.variables.values, "CMAKE_INSTALL_PREFIX": "@CMAKE_INSTALL_PREFIX@"}
        return re.sub(r"@(\w+)@", lambda word: known.get(word[1], ""), template)

    def lint_auto(self, command: Command, words: list[str]) -> None:
        """Add a test with the packages that set(NAME_FOUND TRUE) marks without find_package(): their linters are skipped."""
        values = self.variables.values
        said = [name.removesuffix("_FOUND") for name in values if name.endswith("_FOUND") and holds([name], values)]
        self.reading.tests.append(Call(command, [name for name in said if name not in self.reading.found], self.folder))

    def message(self, command: Command, words: list[str]) -> None:
        if words[:1] == ["FATAL_ERROR"]:
            raise command.error(" ".join(words[1:]))


def _block_end(commands: list[Command], start: int) -> int:
    depth = 0
    for index in range(start, len(commands)):
        depth += (commands[index].name in _BLOCKS) - (commands[index].name in _BLOCKS.values())
        if depth == 0:
            return index
    name = commands[start].name
    raise commands[start].error(f"{name}() has no {_BLOCKS[name]}()")


_ACTIONS: dict[str, Callable[[_Runner, Command, list[str]], None]] = {
    "project": _Runner.project,
    "find_package": _Runner.find_package,
    "set": _Runner.set_variable,
    "unset": _Runner.unset_variable,
    "list": _Runner.list_command,
    "file": _Runner.file_command,
    "add_subdirectory": _Runner.add_subdirectory,
    "message": _Runner.message,
    "ament_environment_hooks": _Runner.environment_hooks,
    "ament_lint_auto_find_test_dependencies": _Runner.lint_auto,
}
