"""Type stubs of interface packages: editors and type checkers then know every field."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from coursekit.files import in_order
from coursekit.interfaces.fields import DTYPES, python_type
from coursekit.interfaces.find import KINDS
from coursekit.interfaces.model import Action, FieldType, Interface, Message, Service
from coursekit.interfaces.parser import parse_file

_HEAD = """\
# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing
"""


def stub(interfaces: Iterable[Interface]) -> str:
    """Return the text of a stub that declares the classes of interfaces of one kind.

    >>> from coursekit.interfaces.parser import parse
    >>> 'def data(self) -> str: ...' in stub([parse('p', 'msg', 'Text', 'string data')])
    True
    """
    known = list(interfaces)
    imports = sorted({used.split("/")[0] for interface in known for m in _messages(interface) for used in m.dependencies()})
    lines = [_HEAD, *(f"import {name}.msg" for name in imports), ""]
    for interface in known:
        lines += _declare(interface)
    return "\n".join(lines)


def _messages(interface: Interface) -> list[Message]:
    return [interface] if isinstance(interface, Message) else list(interface.messages())


def _declare(interface: Interface) -> list[str]:
    lines = [line for message in _messages(interface) for line in _message(message)]
    if isinstance(interface, Service):
        names = {"Request": interface.request.name, "Response": interface.response.name}
        lines += [f"class {interface.name}:", "    _TYPE_NAME: ClassVar[str]"]
        return [*lines, *(f"    {k}: TypeAlias = {v}" for k, v in names.items()), ""]
    if isinstance(interface, Action):
        parts = {"Goal": interface.goal, "Result": interface.result, "Feedback": interface.feedback}
        lines += [f"class {interface.name}:", *(f"    {k}: TypeAlias = {v.name}" for k, v in parts.items())]
        return [*lines, "    Impl: ClassVar[Any]", ""]
    return lines


def _message(message: Message) -> list[str]:
    arguments = "".join(f", {f.name}: {_taken(f.type)} = ..." for f in message.fields)
    lines = [f"class {message.name}:", "    _TYPE_NAME: ClassVar[str]", f"    def _clone(self) -> {message.name}: ..."]
    lines += [f"    {c.name}: ClassVar[{_scalar(c.type)}]" for c in message.constants]
    lines += [f"    def __init__(self{', *' if arguments else ''}{arguments}) -> None: ..."]
    lines += ["    SLOT_TYPES: ClassVar[tuple[Any, ...]]", "    @classmethod"]
    lines += ["    def get_fields_and_field_types(cls) -> dict[str, str]: ..."]
    for field in message.fields:
        lines += ["    @property", f"    def {field.name}(self) -> {_given(field.type)}: ..."]
        lines += [
            f"    @{field.name}.setter",
            f"    def {field.name}(self, value: {_taken(field.type)}) -> None: ...",
        ]
    return [*lines, ""]


def _scalar(kind: FieldType) -> str:
    if kind.is_primitive:
        return python_type(kind)
    package, _, name = kind.base.split("/")
    return f"{package}.msg.{name}"


def _given(kind: FieldType) -> str:
    if not kind.is_array:
        return _scalar(kind)
    if not kind.is_number_block:
        return f"list[{_scalar(kind)}]"
    return f"numpy.typing.NDArray[numpy.{DTYPES[kind.base]}]" if kind.is_fixed else f"array[{_scalar(kind)}]"


def _taken(kind: FieldType) -> str:
    if not kind.is_array:
        return _scalar(kind)
    numbers = " | numpy.typing.NDArray[Any]" if kind.is_number_block and kind.is_fixed else ""
    return f"Collection[{_scalar(kind)}]{numbers}"


def package_stubs(package: str, files: Iterable[Path]) -> dict[str, str]:
    """Return the stubs for a package's definition files, by path relative to site-packages."""
    stub_by_path = {}
    paths = in_order(files)
    for kind in KINDS:
        interfaces = [parse_file(package, path) for path in paths if path.suffix == f".{kind}"]
        if interfaces:
            stub_by_path[f"{package}/{kind}/__init__.pyi"] = stub(interfaces)
    return stub_by_path
