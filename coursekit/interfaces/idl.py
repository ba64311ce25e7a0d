"""Definitions in OMG IDL: ROS 2 installs them beside .msg, .srv and .action files, and packages may contain their own."""

from __future__ import annotations

import atexit
import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from coursekit.files import write_whole
from coursekit.interfaces.model import IDL_NAMES, Field, FieldType, Interface, Message
from coursekit.interfaces.parser import parse_file

_written: dict[Path, Path] = {}
_folder: list[Path] = []
_read: list[Path] = []


def idl_file(package: str, definition: Path) -> Path:
    """Write the IDL of a definition file to this interpreter's own folder, once; return its path.

    Raises:
        InterfaceError: when the definition cannot be read.
    """
    if definition not in _written:
        path = _own_folder() / package / definition.suffix[1:] / f"{definition.stem}.idl"
        path.parent.mkdir(parents=True, exist_ok=True)
        write_whole(path, idl_text(parse_file(package, definition)).encode())
        _written[definition] = path
    return _written[definition]


def definition_file(path: Path) -> Path:
    """Return a definition file; one in IDL is translated to .msg, .srv or .action in this interpreter's own folder.

    Raises:
        InterfaceError: when the IDL cannot be read.
    """
    if path.suffix != ".idl":
        return path
    from coursekit.interfaces.idl_reader import definition_of_idl  # few packages have IDL files

    kind, text = definition_of_idl(path)
    definition = Path(_own_folder(), str(len(_read)), kind, f"{path.stem}.{kind}")
    definition.parent.mkdir(parents=True)
    write_whole(definition, text.encode())
    _read.append(definition)
    return definition


def is_translated(path: Path) -> bool:
    """Whether a definition file is the translation of an IDL file."""
    return path in _read


def _own_folder() -> Path:
    if not _folder:
        _folder.append(Path(tempfile.mkdtemp(prefix="idl_")))
        atexit.register(shutil.rmtree, _folder[0], ignore_errors=True)
    return _folder[0]


def idl_text(interface: Interface) -> str:
    """Return an interface as IDL.

    >>> from coursekit.interfaces.parser import parse
    >>> print(idl_text(parse("p", "msg", "A", "float64[2] x")), end="")
    module p {
      module msg {
        typedef double double__2[2];
        struct A {
          double__2 x;
        };
      };
    };
    """
    messages = [interface] if isinstance(interface, Message) else list(interface.messages())
    needed = dict.fromkeys(name for message in messages for name in message.dependencies())
    includes = [f'#include "{name}.idl"' for name in needed]
    body = [line for message in messages for line in _structure(message, _typedefs(messages, message))]
    opening = [f"module {messages[0].package} {{", f"  module {messages[0].kind} {{"]
    lines = [*includes, *([""] if includes else []), *opening, *(f"    {line}" for line in body), "  };", "};"]
    return "\n".join(lines) + "\n"


def _typedefs(messages: list[Message], of: Message) -> list[str]:
    """Return the typedefs of the fixed arrays that `of` is the first of `messages` to use."""
    before = {f.type for message in messages[: messages.index(of)] for f in message.fields}
    new = dict.fromkeys(f.type for f in of.fields if f.type.is_fixed and f.type not in before)
    return [f"typedef {_element(kind)} {_type(kind)}[{kind.size}];" for kind in new]


def _structure(message: Message, typedefs: list[str]) -> Iterator[str]:
    yield from typedefs
    if message.constants:
        yield f"module {message.name}_Constants {{"
        for constant in message.constants:
            yield f"  const {_type(constant.type)} {constant.name} = {_literal(constant.value)};"
        yield "};"
    yield f"struct {message.name} {{"
    for field in message.fields:
        yield from (f"  {line}" for line in _member(field))
    if not message.fields:
        yield "  uint8 structure_needs_at_least_one_member;"
    yield "};"


def _member(field: Field) -> Iterator[str]:
    if isinstance(field.default, list):
        values = ", ".join(_literal(value) for value in field.default).replace('"', "'")
        yield f'@default (value="({values})")'
    elif field.default is not None:
        yield f"@default (value={_literal(field.default)})"
    yield f"{_type(field.type)} {field.name};"


def _element(kind: FieldType) -> str:
    if not kind.is_primitive:
        return kind.base.replace("/", "::")
    return IDL_NAMES.get(kind.base, kind.base) + (f"<{kind.string_bound}>" if kind.string_bound else "")


def _type(kind: FieldType) -> str:
    element = _element(kind)
    if kind.is_fixed:
        return f"{element.replace('::', '__').replace('<', '_').replace('>', '').replace(' ', '_')}__{kind.size}"
    if kind.is_array:
        return f"sequence<{element}, {kind.size}>" if kind.size else f"sequence<{element}>"
    return element


def _literal(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).upper()
    if isinstance(value, str):
        escaped = value.replace("\\", "\\\\").replace('"', '\\"')
        return f'"{escaped}"'
    return repr(value)
