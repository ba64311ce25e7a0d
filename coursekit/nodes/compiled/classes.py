"""The programs of C++ packages that have the classes of their libraries, for processes of Python."""

from __future__ import annotations

from pathlib import Path
from typing import NoReturn

from coursekit.cpp.age import is_of_another_age
from coursekit.nodes.compiled.channel import Gone
from coursekit.nodes.compiled.embedded_program import EmbeddedProgram
from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.nodes.compiled.host import ANOTHER_AGE
from coursekit.nodes.compiled.plugins import InvalidManifest, Plugin, declared
from coursekit.processes.executables import prefix_of
from coursekit.processes.process import ProcessKilled
from coursekit.systems import signal_names
from coursekit.systems.layout import executable_files


class PluginFault(Exception):
    """A class that cannot be loaded: pluginlib's exception and its text."""

    def __init__(self, kind: str, text: str) -> None:
        super().__init__(text)
        self.kind = f"pluginlib::{kind}"


class CppFault(Exception):
    """An exception that a C++ class has thrown: its type and its text."""

    def __init__(self, kind: str, text: str) -> None:
        super().__init__(text)
        self.kind = kind


def plugins_of(package: str, base: str) -> dict[str, Plugin]:
    """Return the classes of all packages for a base class, by their names. Raises PluginFault."""
    try:
        return {class_.name: class_ for class_ in declared(package, base)}
    except InvalidManifest as fault:
        raise PluginFault("InvalidXMLException", str(fault)) from None


def program_of(plugin: Plugin) -> tuple[str, str]:
    """Return the program that has a class, and the class. Raises PluginFault."""
    stem = Path(plugin.library).name.removesuffix(".dylib").removesuffix(".so").removeprefix("lib")
    folder = prefix_of(plugin.package) / "lib" / plugin.package
    for path in executable_files(folder, f"__plugins_{stem}"):
        if path.is_file() and is_of_another_age(path):
            raise PluginFault("LibraryLoadException", ANOTHER_AGE.format(name=plugin.library))
        if path.is_file():
            return str(path), plugin.type
    raise PluginFault(
        "LibraryLoadException",
        f"Could not find library corresponding to plugin {plugin.name}. Make sure that the library '{plugin.library}' "
        "actually exists.",
    )


class Program:
    """A program that has the class `type` of a kind that `cpp/src/served.cpp` knows.

    As on a robot, where a library would be loaded into this process, what ends the program ends this process.
    """

    def __init__(self, path: str, kind: str, type_: str) -> None:
        self._part = EmbeddedProgram(path, [kind, type_])
        try:
            self._part.start()
        except Gone:
            self._end()

    def ask(self, *words: str | int, rest: bytes = b"") -> Unpacker:
        """Let it do something."""
        try:
            return self._part.ask(packed(*words) + rest)
        except Gone:
            self._end()

    def share(self, thing: object) -> int:
        """Let it use an object of this process. Returns its number there."""
        return self._part.keep(thing)

    def unshare(self, number: int) -> None:
        """Let it use an object no longer."""
        self._part.things.pop(number, None)

    def close(self) -> None:
        """Destroy the object, and end the program."""
        self._part.close()

    def _end(self) -> NoReturn:
        """End this process as the program ended."""
        code = self._part.code or 0
        if code > 0:
            raise SystemExit(code)
        raise ProcessKilled(-code or signal_names.ABORT)


def check(answer: Unpacker) -> None:
    """Raise the exception of an answer, if it has one."""
    kind, text = answer.text(), answer.text()
    if kind:
        raise CppFault(kind, text)

