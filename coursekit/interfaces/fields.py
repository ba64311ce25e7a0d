"""Pieces of source for one field: its default, its copy, its comparison, its setter."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from coursekit.interfaces.cdr_runs import FORMATS
from coursekit.interfaces.checks import FLOAT32_MAX
from coursekit.interfaces.literals import integer_range
from coursekit.interfaces.model import INTEGERS, Field, FieldType

Alias = Callable[[str], str]
TYPE_CODES = {base: code for base, code in FORMATS.items() if base not in ("bool", "byte")}
"""The numbers' codes in module array, which are those of module struct."""
DTYPES = {"char": "uint8", **{name: name for name in (*INTEGERS, "float32", "float64")}}
_ZEROS = {
    "bool": "False",
    "byte": r"b'\x00'",
    "float32": "0.0",
    "float64": "0.0",
    "string": "''",
    "wstring": "''",
}
_PYTHON = {
    "bool": "bool",
    "byte": "bytes",
    "float32": "float",
    "float64": "float",
    "string": "str",
    "wstring": "str",
}


def python_type(kind: FieldType) -> str:
    """Return the name of the Python type of one element, as in Humble's messages.

    >>> python_type(FieldType("float32")), python_type(FieldType("std_msgs/Header"))
    ('float', 'Header')
    """
    return _PYTHON.get(kind.base, "int") if kind.is_primitive else kind.base.rsplit("/", 1)[1]


def value_source(kind: FieldType, value: Any) -> str:
    """Return the source of a constant or a default.

    >>> value_source(FieldType('uint8', is_array=True), [1, 2])
    "array.array('B', (1, 2))"
    """
    if not kind.is_array:
        if kind.base == "byte":
            return repr(bytes([value]))
        return _float_source(value) if isinstance(value, float) else repr(value)
    items = ", ".join(value_source(kind.element, item) for item in value)
    if not kind.is_number_block:
        return f"[{items}]"
    block = f"({items},)" if len(value) == 1 else f"({items})"
    if kind.is_fixed:
        return f"numpy.array({block}, dtype=numpy.{DTYPES[kind.base]})"
    return f"array.array('{TYPE_CODES[kind.base]}', {block})"


def _float_source(value: float) -> str:
    return repr(value) if value - value == 0 else f"float({str(value)!r})"


def default_of(field: Field, alias: Alias) -> str:
    """Return the source of a new message's value for this field.

    >>> from coursekit.interfaces.model import FieldType
    >>> default_of(Field(FieldType("float64", is_array=True, size=9), "k"), str)
    'numpy.zeros(9, dtype=numpy.float64)'
    """
    kind = field.type
    if field.default is not None:
        return value_source(kind, field.default)
    if kind.is_sequence:
        return f"array.array('{TYPE_CODES[kind.base]}')" if kind.is_number_block else "[]"
    if not kind.is_array:
        return _zero(kind, alias)
    if kind.is_number_block:
        return f"numpy.zeros({kind.size}, dtype=numpy.{DTYPES[kind.base]})"
    return f"[{_zero(kind, alias)} for _ in range({kind.size})]"


def _zero(kind: FieldType, alias: Alias) -> str:
    return _ZEROS.get(kind.base, "0") if kind.is_primitive else f"{alias(kind.base)}()"


def kwarg_lines(field: Field, alias: Alias) -> list[str]:
    """Return the constructor's statements that set this field from its arguments; defaults need no check."""
    kind, name = field.type, field.name
    given = f"kwargs[{name!r}]"
    taken = [f"self.{name} = {given}"]
    if kind.is_number_block and kind.is_sequence and field.default is None:
        taken = [f"self.{name} = array.array('{TYPE_CODES[kind.base]}', {given})"]
    elif not kind.is_array:  # its setter, inlined
        taken = [f"value = {given}", *setter_lines(field, alias)]
    default = default_of(field, alias)
    return [f"if {name!r} in kwargs:", *(f"    {line}" for line in taken), "else:", f"    self._{name} = {default}"]


_AS_SENT = {"float32": "checks.float32({})", "float64": "float({})", **dict.fromkeys((*INTEGERS, "char"), "+{}")}
"""The conversion of a received number: a numpy.float64 becomes a float, and True becomes 1."""


def clone_of(field: Field) -> str:
    """Return the source of a copy as a receiver gets it: it shares no mutable object.

    >>> from coursekit.interfaces.model import FieldType
    >>> clone_of(Field(FieldType("geometry_msgs/msg/Point"), "position"))
    'self._position._clone()'
    """
    kind, value = field.type, f"self._{field.name}"
    if kind.is_number_block:
        return f"{value}.copy()" if kind.is_fixed else f"{value}[:]"
    if kind.is_array:
        return f"list({value})" if kind.is_primitive else f"[item._clone() for item in {value}]"
    if kind.base == "byte":
        return f"bytes({value})"
    if kind.base in _AS_SENT:
        return _AS_SENT[kind.base].format(value)
    return value if kind.is_primitive else f"{value}._clone()"


def difference_of(field: Field) -> str:
    """Return the source of the test that this field differs.

    >>> from coursekit.interfaces.model import FieldType
    >>> difference_of(Field(FieldType("int32"), "count"))
    'self._count != other._count'
    """
    name = field.name
    if field.type.is_number_block and field.type.is_fixed:
        return f"not numpy.array_equal(self._{name}, other._{name})"
    return f"self._{name} != other._{name}"


def setter_lines(field: Field, alias: Alias) -> list[str]:
    """Return the body of the field's setter."""
    if field.type.is_array:
        return _array_setter(field, alias)
    return [*_scalar_checks(field, alias), f"self._{field.name} = value"]


def _assert(condition: str, text: str) -> str:
    return f"assert {condition}, {text!r}"


def _scalar_checks(field: Field, alias: Alias) -> list[str]:
    kind, said = field.type, f"The '{field.name}' field must be"
    if not kind.is_primitive:
        of = f"{said} a sub message of type '{python_type(kind)}'"
        return [_assert(f"isinstance(value, {alias(kind.base)})", of)]
    if kind.string_bound:
        condition = f"isinstance(value, (str, checks.UserString)) and len(value) <= {kind.string_bound}"
        return [_assert(condition, f"{said} string value not longer than {kind.string_bound}")]
    if kind.base == "byte":
        return [_assert("checks.is_octet(value)", f"{said} of type 'bytes' or 'ByteString' with length 1")]
    python = python_type(kind)
    return [_assert(f"isinstance(value, {python})", f"{said} of type '{python}'"), *_range_check(kind, said)]


def _range_check(kind: FieldType, said: str) -> list[str]:
    if kind.base == "float32":
        bound = FLOAT32_MAX
        condition = f"-{bound!r} <= value <= {bound!r} or not math.isfinite(value)"
        return [_assert(condition, f"{said} a float in [{-bound!r}, {bound!r}]")]
    if kind.base in TYPE_CODES and kind.base != "float64":
        low, high = integer_range(kind.base)
        sign = "an unsigned integer" if low == 0 else "an integer"
        return [_assert(f"{low} <= value <= {high}", f"{said} {sign} in [{low}, {high}]")]
    return []


def _array_setter(field: Field, alias: Alias) -> list[str]:
    kind, name = field.type, field.name
    lines = []
    if kind.is_number_block:
        lines = _ndarray_path(field) if kind.is_fixed else _array_path(field)
    conditions, words = _array_conditions(kind, alias)
    lines.append(_assert(" and ".join(conditions), f"The '{name}' field must be {' '.join(words)}"))
    if not kind.is_number_block:
        return [*lines, f"self._{name} = value"]
    if kind.is_fixed:
        return [*lines, f"self._{name} = numpy.array(value, dtype=numpy.{DTYPES[kind.base]})"]
    return [*lines, f"self._{name} = array.array('{TYPE_CODES[kind.base]}', value)"]


def _ndarray_path(field: Field) -> list[str]:
    dtype, said = f"numpy.{DTYPES[field.type.base]}", f"The '{field.name}' numpy.ndarray() must have"
    return [
        "if isinstance(value, numpy.ndarray):",
        "    " + _assert(f"value.dtype == {dtype}", f"{said} the dtype of '{dtype}'"),
        "    " + _assert(f"value.size == {field.type.size}", f"{said} a size of {field.type.size}"),
        f"    self._{field.name} = value",
        "    return",
    ]


def _array_path(field: Field) -> list[str]:
    kind, said = field.type, f"The '{field.name}' array.array() must have"
    code = TYPE_CODES[kind.base]
    lines = ["if isinstance(value, array.array):"]
    lines.append("    " + _assert(f"value.typecode == '{code}'", f"{said} the type code of '{code}'"))
    if kind.size:
        lines.append("    " + _assert(f"len(value) <= {kind.size}", f"{said} a size <= {kind.size}"))
    lines += [f"    self._{field.name} = value", "    return"]
    if code == "B" and not kind.size:
        lines += [
            "if isinstance(value, (bytes, bytearray)):",
            f"    self._{field.name} = array.array('B', value)",
        ]
        lines.append("    return")
    return lines


def _array_conditions(kind: FieldType, alias: Alias) -> tuple[list[str], list[str]]:
    python = python_type(kind)
    conditions, words = ["checks.is_collection(value)"], ["a set or sequence"]
    if kind.size:
        conditions.append(f"len(value) {'==' if kind.is_fixed else '<='} {kind.size}")
        words.append(f"with length {kind.size}" if kind.is_fixed else f"with length <= {kind.size}")
    if kind.string_bound:
        conditions.append(f"checks.all_no_longer_than(value, {kind.string_bound})")
        words.append(f"and each string value not longer than {kind.string_bound}")
    conditions.append(f"checks.all_are(value, {python if kind.is_primitive else alias(kind.base)})")
    words.append(f"and each value of type '{python}'")
    return conditions + _elements_check(kind), words + _elements_words(kind)


def _elements_check(kind: FieldType) -> list[str]:
    if kind.base == "float32":
        return ["checks.all_float32(value)"]
    if kind.is_number_block and kind.base != "float64":
        low, high = integer_range(kind.base)
        return [f"checks.all_within(value, {low}, {high})"]
    return []


def _elements_words(kind: FieldType) -> list[str]:
    if kind.base in ("float32", "float64"):
        bound = FLOAT32_MAX if kind.base == "float32" else 1.7976931348623157e308
        return [f"and each {'float' if kind.base == 'float32' else 'double'} in [{-bound:f}, {bound:f}]"]
    if kind.is_number_block:
        low, high = integer_range(kind.base)
        return [f"and each {'unsigned integer' if low == 0 else 'integer'} in [{low}, {high}]"]
    return []
