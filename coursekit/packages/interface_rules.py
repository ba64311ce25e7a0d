"""rosidl_generate_interfaces(...): its definition files, checked, and the Python package for them."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from coursekit.cpp.exported import exported_by
from coursekit.files import read_text
from coursekit.interfaces.c_source import c_headers
from coursekit.interfaces.cpp_source import header, header_name, inner_headers
from coursekit.interfaces.errors import InterfaceError, suggestion
from coursekit.interfaces.find import UNDERLAY
from coursekit.interfaces.idl import definition_file
from coursekit.interfaces.model import Interface, Message
from coursekit.interfaces.parser import parse_file
from coursekit.packages.cmake_run import Call, Reading
from coursekit.packages.cmake_text import CMakeError

_KEYWORDS = (
    "DEPENDENCIES",
    "LIBRARY_NAME",
    "SKIP_INSTALL",
    "SKIP_GROUP_MEMBERSHIP_CHECK",
    "ADD_LINTER_TESTS",
)
_NO_TUPLE = (
    "must be represented as an absolute base path separated by a colon from the relative path to the interface file; "
    "write its path in the package, such as msg/Length.msg; file(GLOB ...) gives such paths with RELATIVE"
)
_FACE = """{said}

from coursekit.interfaces.face import expose

__getattr__, __dir__, __all__ = expose(__name__, __file__)
"""


def interface_files(reading: Reading) -> list[Path]:
    """Return the definition files of a package's interfaces; raises CMakeError for missing ones."""
    files = []
    for call in _calls(reading):
        if not _listed(call):
            raise _problem(call, "called without any interface files")
        files += [definition_file(_definition(call, name)) for name in _listed(call)]
    return files


def _definition(call: Call, name: str) -> Path:
    """Return the file of a path: relative, or an absolute folder, a colon and a path in that folder."""
    base, _, inner = name.rpartition(":")
    is_tuple = os.path.isabs(base)
    if os.path.isabs(name) and not is_tuple:
        raise _problem(call, f"the passed absolute file '{name}' {_NO_TUPLE}")
    path = Path(base, inner) if is_tuple else call.folder / name
    if not path.is_file():
        where = "" if is_tuple else f" relative to the CMAKE_CURRENT_SOURCE_DIR '{call.folder}'"
        raise _problem(call, f"the passed file '{name}' doesn't exist{where}")
    return path


def _calls(reading: Reading) -> list[Call]:
    return [call for call in reading.calls if call.command.name == "rosidl_generate_interfaces"]


def _listed(call: Call) -> list[str]:
    names = call.words[1:]
    for index, word in enumerate(names):
        if word in _KEYWORDS:
            return names[:index]
    return names


def dependencies(reading: Reading) -> list[str]:
    """Return the packages on which a package's interfaces depend."""
    return [name for call in _calls(reading) for name in _dependencies(call)]


def exported_dependencies(reading: Reading) -> list[str]:
    """Return the packages that find_package() finds along with this one."""
    exports = [call for call in reading.calls if call.command.name == "ament_export_dependencies"]
    return list(dict.fromkeys([*dependencies(reading), *(word for call in exports for word in call.words)]))


def _dependencies(call: Call) -> list[str]:
    words = call.words[call.words.index("DEPENDENCIES") + 1 :] if "DEPENDENCIES" in call.words else []
    for index, word in enumerate(words):
        if word in _KEYWORDS:
            return words[:index]
    return words


def check(package: str, reading: Reading, groups: Iterable[str], prefixes: Iterable[Path]) -> list[Exception]:
    """Return all reasons why real ROS would not generate these interfaces."""
    calls = _calls(reading)
    if not calls:
        return []
    problems = _package_problems(reading, calls[0], groups) + _not_found(reading, prefixes)
    return problems + field_problems(package, interface_files(reading), dependencies(reading), prefixes)


def field_problems(
    package: str, files: Iterable[Path], dependencies: Iterable[str], prefixes: Iterable[Path]
) -> list[Exception]:
    """Return the errors in a package's definition files, given its declared dependencies."""
    files, named, places = list(files), set(dependencies), [*prefixes, UNDERLAY]
    own = {f"{package}/msg/{path.stem}" for path in files if path.suffix == ".msg"}
    problems: list[Exception] = []
    for path in files:
        try:
            problems += _field_problems(parse_file(package, path), own, named, places)
        except InterfaceError as error:
            problems.append(error)
    return problems


def _package_problems(reading: Reading, call: Call, groups: Iterable[str]) -> list[Exception]:
    problems: list[Exception] = []
    if "rosidl_default_generators" not in reading.found:
        problems.append(_problem(call, "needs find_package(rosidl_default_generators REQUIRED) above this line"))
    if "rosidl_interface_packages" not in groups:
        member = "<member_of_group>rosidl_interface_packages</member_of_group>"
        problems.append(_problem(call, f"needs {member} in package.xml"))
    return problems


def _not_found(reading: Reading, prefixes: Iterable[Path]) -> list[Exception]:
    """Return dependencies that no find_package() has found, directly or through another package."""
    if any(call.command.name == "ament_auto_find_build_dependencies" for call in reading.calls):
        return []  # it finds all dependencies in package.xml
    known, places = set(reading.found), [*prefixes, UNDERLAY]
    waiting = list(known)
    while waiting:
        name = waiting.pop()
        more = {other for place in places for other in exported_by(name, place / "share")} - known
        known |= more
        waiting += more
    return [
        _problem(call, f"the passed dependency '{name}' has not been found before using find_package()")
        for call in _calls(reading)
        for name in _dependencies(call)
        if name not in known
    ]


def _problem(call: Call, text: str) -> CMakeError:
    return call.command.error(f"rosidl_generate_interfaces() {text}")


def _field_problems(interface: Interface, own: set[str], named: set[str], prefixes: list[Path]) -> list[Exception]:
    messages = [interface] if isinstance(interface, Message) else list(interface.messages())
    problems: list[Exception] = []
    for message in messages:
        for field in message.fields:
            why = None if field.type.is_primitive else _unknown(field.type.base, message, own, named, prefixes)
            if why:
                source = read_text(message.file).splitlines()[field.line - 1]
                problems.append(InterfaceError(why, file=message.file, line=field.line, source=source))
    return problems


def _unknown(base: str, message: Message, own: set[str], named: set[str], prefixes: list[Path]) -> str | None:
    package, _, name = base.split("/")
    if package == message.package:
        return None if base in own else f"unknown type '{name}'{_meant(name, own, named, prefixes)}"
    if not any((prefix / "share" / package / "msg" / f"{name}.msg").is_file() for prefix in prefixes):
        return f"unknown type '{package}/{name}': no package {package} with such a message is built or installed"
    if package not in named:
        return f"'{package}/{name}' needs DEPENDENCIES {package} in rosidl_generate_interfaces()"
    return None


def _meant(name: str, own: set[str], named: set[str], prefixes: list[Path]) -> str:
    """Return what may be meant by the name of a type that stands without a package."""
    for package in sorted(named):
        if any((prefix / "share" / package / "msg" / f"{name}.msg").is_file() for prefix in prefixes):
            return f"; did you mean '{package}/{name}'?"
    return suggestion(name, [known.rpartition("/")[2] for known in sorted(own)]) or "; is it in CMakeLists.txt?"


def python_files(package: str, files: Iterable[Path]) -> dict[str, str]:
    """Return the files of the Python package with their text, by path relative to site-packages."""
    kinds = {path.suffix[1:] for path in files}
    text_by_name = {f"{package}/__init__.py": _docstring(f"Interfaces of {package}.") + "\n", f"{package}/py.typed": ""}
    for kind, what in (("msg", "Messages"), ("srv", "Services"), ("action", "Actions")):
        if kind in kinds:
            said = _docstring(f"{what} of {package}, made from their definition files when first used.")
            text_by_name[f"{package}/{kind}/__init__.py"] = _FACE.format(said=said)
    return text_by_name


def cpp_files(package: str, files: Iterable[Path]) -> dict[str, str]:
    """Return the C++ and C headers of the definition files with their text, by path relative to the include folder."""
    text_by_name: dict[str, str] = {}
    for path in files:
        kind = path.suffix[1:]
        interface = parse_file(package, path)
        text_by_name[f"{package}/{kind}/{header_name(path.stem)}.hpp"] = header(interface, kind)
        text_by_name |= {**inner_headers(package, kind, path.stem), **c_headers(interface, kind)}
    return text_by_name


def _docstring(text: str) -> str:
    """Return the source of a docstring; a name in it may contain quotes and backslashes."""
    plain = not {'"', "\\"} & set(text) and text.isprintable()
    return f'"""{text}"""' if plain else repr(text)
