"""Carries out a CMakeLists.txt as far as files go: variables, conditions, loops, installs.

Nothing is compiled. What would be compiled is remembered as a target, so that it can be said.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from coursekit.packages.cmake_beyond import demand
from coursekit.packages.cmake_condition import holds
from coursekit.packages.cmake_text import CMakeError, Command, read_commands

_REFERENCE = re.compile(r"\$(ENV)?\{([^${}]*)\}")
_BLOCKS = {
    "if": "endif",
    "foreach": "endforeach",
    "while": "endwhile",
    "function": "endfunction",
    "macro": "endmacro",
}


@dataclass(frozen=True)
class Call:
    """One command that matters, with its words after variables were put in, and its source folder."""

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


_KEPT = (
    "install",
    "rosidl_generate_interfaces",
    "ament_python_install_package",
    "ament_auto_package",
    "ament_index_register_resource",
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
)  # fmt: skip


class _Returned(Exception):
    """return() was met."""


def read_project(folder: Path, *, testing: bool = False, strict: bool = False) -> Reading:
    """Return what the CMakeLists.txt of a folder asks for, with its tests if asked; raises CMakeError.

    With `strict` it raises NeedsCMake for what cannot be carried out here; else that is passed over.
    """
    if not (folder / "CMakeLists.txt").is_file():
        raise CMakeError("there is no such file, but this is a CMake package", folder / "CMakeLists.txt", 1)
    runner = _Runner(folder)
    runner.variables["BUILD_TESTING"] = "ON" if testing else "OFF"
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
        self.outer: list[dict[str, str]] = []
        """The variables of those who called the functions that run, and of the folders above."""
        self.variables = {
            "CMAKE_SOURCE_DIR": str(folder),
            "CMAKE_CURRENT_SOURCE_DIR": str(folder),
            "CMAKE_CURRENT_LIST_DIR": str(folder),
            "PROJECT_SOURCE_DIR": str(folder),
            "CMAKE_INSTALL_PREFIX": "",
            "UNIX": "1",
            "CMAKE_INSTALL_LIBDIR": "lib",
            "CMAKE_INSTALL_BINDIR": "bin",
            "CMAKE_INSTALL_DATADIR": "share",
            "CMAKE_INSTALL_INCLUDEDIR": "include",
            "CMAKE_BUILD_TYPE": "Release",
            "ROS_DISTRO": "humble",
        }

    def run_file(self, file: Path) -> None:
        """Carry out a file, up to its return()."""
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

    def words(self, command: Command) -> list[str]:
        """Return the words of a command with variables put in; unquoted lists become several words."""
        words: list[str] = []
        for argument in command.arguments:
            text = self.expand(argument.text)
            words += [text] if argument.quoted else [part for part in text.split(";") if part]
        return words

    def expand(self, text: str) -> str:
        for _ in range(20):
            replaced = _REFERENCE.sub(self._value, text)
            if replaced == text:
                break
            text = replaced
        return text

    def _value(self, match: re.Match[str]) -> str:
        return os.environ.get(match[2], "") if match[1] else self.variables.get(match[2], "")

    def _block(self, command: Command, body: list[Command]) -> None:
        if self.strict and command.name in ("foreach", "while"):
            demand(command, self.words(command))
        if command.name == "if":
            self._if(command, body)
        elif command.name == "foreach":
            self._foreach(command, body)
        elif command.name in ("function", "macro"):
            name, *parameters = self.words(command) or [""]
            self.functions[name.lower()] = (command.name, parameters, body)

    def _if(self, command: Command, body: list[Command]) -> None:
        branch: list[Command] = []
        taken, test, depth = False, command, 0
        for inner in [*body, Command("else", (), command.file, command.line)]:
            if depth == 0 and inner.name in ("elseif", "else"):
                if not taken and (test.name == "else" or holds(self.words(test), self.variables)):
                    taken = True
                    self.run(branch)
                branch, test = [], inner
                continue
            depth += (inner.name in _BLOCKS) - (inner.name in _BLOCKS.values())
            branch.append(inner)

    def _foreach(self, command: Command, body: list[Command]) -> None:
        name, *items = self.words(command) or [""]
        if items[:1] == ["IN"]:
            lists = items[items.index("LISTS") + 1 :] if "LISTS" in items else []
            values = items[items.index("ITEMS") + 1 :] if "ITEMS" in items else []
            items = [v for key in lists for v in self.variables.get(key, "").split(";") if v] + values
        for item in items:
            self.variables[name] = item
            self.run(body)

    def _command(self, command: Command) -> None:
        words = self.words(command)
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
        """A function or macro of the file's own: what a function sets stays inside, what a macro sets does not."""
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
            before = {name: self.variables.get(name) for name in given}
            self.variables |= given
            self.run(body)  # its return() is its caller's
            self.variables = {**self.variables, **{name: value or "" for name, value in before.items()}}
        self.depth -= 1

    def _run_inside(self, body: list[Command], given: dict[str, str]) -> None:
        outer = self.variables
        self.outer.append(outer)
        self.variables = outer | given
        try:
            self.run(body)
        except _Returned:
            pass
        self.variables = self.outer.pop()

    def project(self, command: Command, words: list[str]) -> None:
        if not words:
            raise command.error("project() needs a name")
        self.reading.project = self.variables["PROJECT_NAME"] = self.variables["CMAKE_PROJECT_NAME"] = words[0]

    def find_package(self, command: Command, words: list[str]) -> None:
        self.reading.found += words[:1]
        if words:
            self.variables[f"{words[0]}_FOUND"] = "1"

    def set_variable(self, command: Command, words: list[str]) -> None:
        values = words[1:]
        for stop in ("CACHE", "PARENT_SCOPE"):
            values = values[: values.index(stop)] if stop in values else values
        if words:
            above = "PARENT_SCOPE" in words and self.outer
            (self.outer[-1] if above else self.variables)[words[0]] = ";".join(values)

    def unset_variable(self, command: Command, words: list[str]) -> None:
        above = "PARENT_SCOPE" in words and self.outer
        (self.outer[-1] if above else self.variables).pop((words or [""])[0], None)

    def list_command(self, command: Command, words: list[str]) -> None:
        if len(words) > 2 and words[0] in ("APPEND", "PREPEND"):
            known = [v for v in self.variables.get(words[1], "").split(";") if v]
            self.variables[words[1]] = ";".join(known + words[2:] if words[0] == "APPEND" else words[2:] + known)
        elif len(words) > 1 and words[0] in ("REMOVE_ITEM", "REMOVE_DUPLICATES"):
            known = self.variables.get(words[1], "").split(";")
            left = dict.fromkeys(known) if words[0] == "REMOVE_DUPLICATES" else [v for v in known if v not in words[2:]]
            self.variables[words[1]] = ";".join(left)

    def file_command(self, command: Command, words: list[str]) -> None:
        if len(words) < 3 or words[0] not in ("GLOB", "GLOB_RECURSE"):
            return
        patterns, base = words[2:], None
        if "RELATIVE" in patterns:
            at = patterns.index("RELATIVE")
            base, patterns = Path(patterns[at + 1]), patterns[:at] + patterns[at + 2 :]
        found = [p for text in patterns if text != "CONFIGURE_DEPENDS" for p in self._glob(text, words[0])]
        self.variables[words[1]] = ";".join(os.path.relpath(p, base) if base else str(p) for p in sorted(set(found)))

    def _glob(self, text: str, mode: str) -> list[Path]:
        pattern = os.path.relpath(self.folder / text, self.folder)
        found = self.folder.rglob(pattern) if mode == "GLOB_RECURSE" else self.folder.glob(pattern)
        return list(found)

    def add_subdirectory(self, command: Command, words: list[str]) -> None:
        folder = self.folder / words[0] if words else self.folder
        if not (folder / "CMakeLists.txt").is_file():
            raise command.error(f"add_subdirectory: there is no {folder / 'CMakeLists.txt'}")
        outer, self.folder = self.folder, folder
        here = {"CMAKE_CURRENT_SOURCE_DIR": str(folder), "CMAKE_CURRENT_LIST_DIR": str(folder)}
        self._run_inside(read_commands(folder / "CMakeLists.txt"), here)
        self.folder = outer

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
}
