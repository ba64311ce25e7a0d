"""Values written in definition files: constants and defaults."""

from __future__ import annotations

import re

from coursekit.interfaces.model import INTEGERS, FieldType, Value


class LiteralError(ValueError):
    """A value that does not fit its type; the parser adds the location."""

    def __init__(self, type_name: str, text: str, why: str) -> None:
        super().__init__(f"value '{text}' can not be converted to type '{type_name}': {why}")


def parse_value(kind: FieldType, text: str) -> Value | list[Value]:
    """Return the Python value of a default.

    >>> parse_value(FieldType('int8', is_array=True, size=2), '[1, 0x10]')
    [1, 16]
    """
    if not kind.is_primitive:
        raise LiteralError(str(kind), text, "only primitive fields can have a default value")
    if not kind.is_array:
        return parse_scalar(kind, text)
    if len(text) < 2 or text[0] != "[" or text[-1] != "]":
        raise LiteralError(str(kind), text, "array value must start with '[' and end with ']'")
    items = _split(kind, text[1:-1])
    _check_length(kind, text, len(items))
    return [parse_scalar(kind.element, item) for item in items]


def _check_length(kind: FieldType, text: str, length: int) -> None:
    if kind.is_fixed and length != kind.size:
        raise LiteralError(str(kind), text, f"array must have exactly {kind.size} elements, not {length}")
    if kind.size is not None and length > kind.size:
        raise LiteralError(
            str(kind), text, f"array must have not more than {kind.size} elements, not {length}"
        )


_QUOTED = r""""(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'"""
_STRING_ITEM = re.compile(rf"\s*({_QUOTED}|[^,\"'\s][^,]*)\s*(,|$)")


def _split(kind: FieldType, inner: str) -> list[str]:
    if not inner.strip():
        return []
    if kind.base not in ("string", "wstring"):
        return [item.strip() for item in inner.split(",")]
    items, position = [], 0
    while position < len(inner):
        match = _STRING_ITEM.match(inner, position)
        if match is None:
            raise LiteralError(
                str(kind), inner, "strings in an array stand in quotes, with commas between them"
            )
        items.append(match[1].strip())
        position = match.end()
    return items


def parse_scalar(kind: FieldType, text: str) -> Value:
    """Return the Python value of one primitive.

    >>> parse_scalar(FieldType('bool'), 'true'), parse_scalar(FieldType('byte'), '0xff')
    (True, 255)
    """
    if kind.base == "bool":
        return _bool(text)
    if kind.base in ("float32", "float64"):
        return _float(kind.base, text)
    if kind.base in ("string", "wstring"):
        return _string(kind, text)
    return _integer(kind.base, text)


def _bool(text: str) -> bool:
    if text.lower() not in ("true", "1", "false", "0"):
        raise LiteralError("bool", text, "must be either 'true' / '1' or 'false' / '0'")
    return text.lower() in ("true", "1")


def _float(base: str, text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise LiteralError(base, text, "must be a floating point number using '.' as the separator") from None


def integer_range(base: str) -> tuple[int, int]:
    """Return the smallest and the largest value of an integer type.

    >>> integer_range('int8'), integer_range('byte')
    ((-128, 127), (0, 255))
    """
    if base not in INTEGERS:
        return 0, 255
    unsigned = base.startswith("u")
    bits = int(base[4 if unsigned else 3 :])
    return (0, 2**bits - 1) if unsigned else (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1)


def _integer(base: str, text: str) -> int:
    low, high = integer_range(base)
    value = None
    for radix in (10, 0):
        try:
            value = int(text, radix)
            break
        except ValueError:
            continue
    if value is None or not low <= value <= high:
        raise LiteralError(base, text, f"must be a valid integer value >= {low} and <= {high}")
    return value


def _string(kind: FieldType, text: str) -> str:
    for quote in ('"', "'"):
        if len(text) > 1 and text[0] == quote and text[-1] == quote:
            text = text[1:-1]
            if re.search(rf"(?<!\\){quote}", text):
                raise LiteralError(kind.base, text, "string inner quotes not properly escaped")
            text = text.replace("\\" + quote, quote)
            break
    if kind.string_bound and len(text) > kind.string_bound:
        why = f"string must not exceed the maximum length of {kind.string_bound} characters"
        raise LiteralError(str(kind), text, why)
    return text
