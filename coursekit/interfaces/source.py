"""Python source of message classes, as simple as handwritten code, with Humble's checks.

In ROS 2: rosidl_generator_py. The source is shown in tracebacks.
"""

from __future__ import annotations

from collections.abc import Collection

from coursekit.interfaces.fields import (
    clone_of,
    default_of,
    difference_of,
    kwarg_lines,
    setter_lines,
    value_source,
)
from coursekit.interfaces.model import Field, Message


def alias(full_name: str) -> str:
    """Return the name of another message class in the source.

    >>> alias('std_msgs/msg/Header')
    'std_msgs__msg__Header'
    """
    return full_name.replace("/", "__")


def message_source(message: Message, given: Collection[str] = ()) -> str:
    """Return the source of one message class and its metaclass; `given` classes need no import."""
    parts = [_imports(message, given), _metaclass(message), _head(message), _init(message), _methods(message)]
    parts += [_property(field) for field in message.fields]
    return "\n".join(parts)


def _imports(message: Message, given: Collection[str]) -> str:
    lines = [
        repr(f"{message.full_name}, made from {message.file or 'text'}."),  # a path may contain quotes and backslashes
        "",
        "import array",
        "import math",
        "",
    ]
    if any(f.type.is_number_block and f.type.is_fixed for f in message.fields):
        lines.append("import numpy")
    lines += [
        "from coursekit.interfaces import checks, definition",
        "from coursekit.interfaces.metaclass import InterfaceType, reject_unknown, text_of",
        "from coursekit.interfaces.registry import load",
        "",
        *(f"{alias(name)} = load({name!r})" for name in message.dependencies() if name not in given),
        "",
    ]
    return "\n".join(lines)


def _metaclass(message: Message) -> str:
    lines = ["", f"class Metaclass_{message.name}(InterfaceType):", f'    """Class of {message.name}."""']
    for constant in message.constants:
        lines += _read_only(constant.name, value_source(constant.type, constant.value))
    for field in message.fields:
        if field.default is not None:
            lines += _read_only(f"{field.name.upper()}__DEFAULT", value_source(field.type, field.default))
    return "\n".join(lines)


def _read_only(name: str, value: str) -> list[str]:
    return ["", "    @property", f"    def {name}(cls):", f"        return {value}"]


def _head(message: Message) -> str:
    fields = message.fields
    lines = ["", "", f"_FIELDS = frozenset({[f.name for f in fields]!r})", "", ""]
    lines.append(f"class {message.name}(metaclass=Metaclass_{message.name}):")
    lines.append(f'    """{_doc(message)}"""')
    lines += ["", f"    _TYPE_NAME = {message.full_name!r}"]
    lines += [f"    {c.name} = {value_source(c.type, c.value)}" for c in message.constants]
    for f in fields:
        if f.default is not None:
            lines.append(f"    {f.name.upper()}__DEFAULT = {value_source(f.type, f.default)}")
    lines.append(f"    __slots__ = {[f'_{f.name}' for f in fields]!r}")
    lines.append(f"    _fields_and_field_types = { ({f.name: f.type.idl_text() for f in fields})!r}")
    lines.append(f"    _BLOCKS = {tuple(f.type.is_number_block and f.type.is_sequence for f in fields)!r}")
    lines.append(f"    SLOT_TYPES = ({''.join(f'definition.{_slot(f)}, ' for f in fields)})")
    return "\n".join(lines)


def _slot(field: Field) -> str:
    kind = field.type.slot_type()
    inner = getattr(kind, "value_type", None)
    text = repr(kind)
    if inner is None:
        return text
    name = type(kind).__name__
    size = getattr(kind, "size", getattr(kind, "maximum_size", None))
    return f"{name}(definition.{inner!r}{'' if size is None else f', {size}'})"


def _doc(message: Message) -> str:
    text = f"Message class '{message.name}'."
    return text + (
        f" Constants: {', '.join(c.name for c in message.constants)}." if message.constants else ""
    )


def _init(message: Message) -> str:
    fields = message.fields
    lines = ["", "    def __init__(self, **kwargs):"]
    if not fields:
        return "\n".join(
            [*lines, "        if kwargs:", f"            reject_unknown({message.name}, kwargs)"]
        )
    lines.append("        if not kwargs:")
    lines += [f"            self._{f.name} = {default_of(f, alias)}" for f in fields]
    lines += ["            return", "        if not _FIELDS.issuperset(kwargs):"]
    lines.append(f"            reject_unknown({message.name}, kwargs)")
    lines += [f"        {line}" for f in fields for line in kwarg_lines(f, alias)]
    return "\n".join(lines)


def _methods(message: Message) -> str:
    name, fields = message.name, message.fields
    differences = " or ".join(difference_of(f) for f in fields) or "False"
    lines = [
        "",
        "    __repr__ = text_of",
        "",
        "    def __eq__(self, other):",
        f"        return isinstance(other, {name}) and not ({differences})",
        "",
        "    __hash__ = None",
        "",
        "    @classmethod",
        "    def get_fields_and_field_types(cls):",
        "        return dict(cls._fields_and_field_types)",
        "",
        "    def _clone(self):",
        f"        copy = {name}.__new__({name})",
        *(f"        copy._{f.name} = {clone_of(f)}" for f in fields),
        "        return copy",
        "",
        "    def __deepcopy__(self, memo):",
        "        return self._clone()",
    ]
    return "\n".join(lines)


def _property(field: Field) -> str:
    name = field.name
    lines = [
        "",
        "    @property",
        f"    def {name}(self):",
        f'        """Field {name!r}, {field.type.idl_text()}."""',
        f"        return self._{name}",
        "",
        f"    @{name}.setter",
        f"    def {name}(self, value):",
        *(f"        {line}" for line in setter_lines(field, alias)),
    ]
    return "\n".join(lines)
