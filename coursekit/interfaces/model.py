"""The content of a definition file: types, fields, constants, and the messages built from them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from coursekit.interfaces import definition as d

INTEGERS = ("int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64")
IDL_NAMES = {
    "bool": "boolean",
    "byte": "octet",
    "char": "uint8",
    "float32": "float",
    "float64": "double",
    **{name: name for name in INTEGERS},
}
PRIMITIVES = (*IDL_NAMES, "string", "wstring")
Value = bool | int | float | str


@dataclass(frozen=True)
class FieldType:
    """The type of a field as written: `base` is a primitive's name or 'package/msg/Name'.

    >>> matrix = FieldType("float64", is_array=True, size=9)
    >>> matrix.is_fixed, matrix.is_sequence, matrix.is_number_block
    (True, False, True)
    """

    base: str
    string_bound: int | None = None
    is_array: bool = False
    size: int | None = None
    is_upper_bound: bool = False

    @property
    def is_primitive(self) -> bool:
        """Return whether the element is not a message."""
        return "/" not in self.base

    @property
    def is_fixed(self) -> bool:
        """Return whether this is `type[N]`."""
        return self.is_array and self.size is not None and not self.is_upper_bound

    @property
    def is_sequence(self) -> bool:
        """Return whether this is `type[]` or `type[<=N]`."""
        return self.is_array and not self.is_fixed

    @property
    def element(self) -> FieldType:
        """The type of one element."""
        return FieldType(self.base, self.string_bound)

    @property
    def is_number_block(self) -> bool:
        """Return whether values are stored in an array.array (sequences) or a numpy.ndarray (fixed)."""
        return self.is_array and self.base in IDL_NAMES and self.base not in ("bool", "byte")

    def __str__(self) -> str:
        bound = f"<={self.string_bound}" if self.string_bound else ""
        name = self.base.replace("/msg/", "/")
        if not self.is_array:
            return name + bound
        return f"{name}{bound}[{'<=' if self.is_upper_bound else ''}{self.size or ''}]"

    def slot_type(self) -> d.AbstractType:
        """Return the type for SLOT_TYPES.

        >>> FieldType("int32", is_array=True).slot_type().has_maximum_size()
        False
        """
        element = self._slot_element()
        if not self.is_array:
            return element
        if self.size is None:
            return d.UnboundedSequence(element)
        return (d.BoundedSequence if self.is_upper_bound else d.Array)(element, self.size)

    def _slot_element(self) -> d.AbstractNestableType:
        if not self.is_primitive:
            package, kind, name = self.base.split("/")
            return d.NamespacedType([package, kind], name)
        if self.base == "string":
            return d.BoundedString(self.string_bound) if self.string_bound else d.UnboundedString()
        if self.base == "wstring":
            return d.BoundedWString(self.string_bound) if self.string_bound else d.UnboundedWString()
        return d.BasicType(IDL_NAMES[self.base])

    def idl_text(self) -> str:
        """Return the text of get_fields_and_field_types().

        >>> FieldType('float64', is_array=True, size=36).idl_text()
        'double[36]'
        """
        if not self.is_primitive:
            package, _, name = self.base.split("/")
            text = f"{package}/{name}"
        else:
            text = IDL_NAMES.get(self.base, self.base) + (
                f"<{self.string_bound}>" if self.string_bound else ""
            )
        if self.is_fixed:
            return f"{text}[{self.size}]"
        if self.is_array:
            return f"sequence<{text}, {self.size}>" if self.size else f"sequence<{text}>"
        return text


@dataclass(frozen=True)
class Field:
    """One field; `line` is its line in the file."""

    type: FieldType
    name: str
    default: Value | list[Value] | None = None
    comment: str = ""
    line: int = 0


@dataclass(frozen=True)
class Constant:
    """One constant; its type is always a plain primitive."""

    type: FieldType
    name: str
    value: Value
    comment: str = ""


@dataclass(frozen=True)
class Message:
    """A structure: 'package', 'msg' | 'srv' | 'action', and its name."""

    package: str
    kind: str
    name: str
    fields: tuple[Field, ...] = ()
    constants: tuple[Constant, ...] = ()
    comment: str = ""
    file: str = ""
    lines: tuple[str, ...] = field(default=(), repr=False)

    @property
    def full_name(self) -> str:
        """E.g. 'std_msgs/msg/String'."""
        return f"{self.package}/{self.kind}/{self.name}"

    def dependencies(self) -> list[str]:
        """Return the full names of the nested messages, without duplicates, in the order of the fields.

        >>> from coursekit.interfaces.registry import interface_of
        >>> interface_of("geometry_msgs/msg/PoseStamped").dependencies()
        ['std_msgs/msg/Header', 'geometry_msgs/msg/Pose']
        """
        return list(dict.fromkeys(f.type.base for f in self.fields if not f.type.is_primitive))


@dataclass(frozen=True)
class Service:
    """A request and a response."""

    package: str
    name: str
    request: Message
    response: Message

    @property
    def full_name(self) -> str:
        """E.g. 'std_srvs/srv/Empty'."""
        return f"{self.package}/{self.request.kind}/{self.name}"

    def messages(self) -> Iterator[Message]:
        """Yield its messages."""
        yield from (self.request, self.response)


@dataclass(frozen=True)
class Action:
    """A goal, a result and a feedback."""

    package: str
    name: str
    goal: Message
    result: Message
    feedback: Message

    @property
    def full_name(self) -> str:
        """E.g. 'test_msgs/action/Fibonacci'."""
        return f"{self.package}/action/{self.name}"

    def messages(self) -> Iterator[Message]:
        """Yield its messages."""
        yield from (self.goal, self.result, self.feedback)


Interface = Message | Service | Action
