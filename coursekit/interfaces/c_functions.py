"""C source of a message's functions: what begins, ends, compares and copies it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from coursekit.interfaces.c_types import TEXTS, owner_type
from coursekit.interfaces.cpp_types import literal
from coursekit.interfaces.model import Field, FieldType


def function_lines(name: str, fields: Iterable[Field]) -> Iterator[str]:
    """Yield the functions of a message, which are inline: no library has to have them.

    >>> list(function_lines("p__msg__A", [Field(FieldType("int8"), "a")]))[0]
    'static inline void p__msg__A__fini(p__msg__A * msg)'
    """
    fields = list(fields)
    ends = (_each(field, "{owner}__fini(&msg->{at});") for field in fields)
    yield from _function(f"void {name}__fini({name} * msg)", "", ["if (!msg) {return;}", *ends])
    yield from _function(f"bool {name}__init({name} * msg)", "ok", _init(name, fields))
    same = (
        _each(field, _unless("{owner}__are_equal(&a->{at}, &b->{at})"), _unless("a->{at} == b->{at}")) for field in fields
    )
    yield from _function(
        f"bool {name}__are_equal(const {name} * a, const {name} * b)", "true", ["if (!a || !b) {return false;}", *same]
    )
    copies = (_each(field, _unless("{owner}__copy(&from->{at}, &to->{at})"), "to->{at} = from->{at};") for field in fields)
    yield from _function(
        f"bool {name}__copy(const {name} * from, {name} * to)", "true", ["if (!from || !to) {return false;}", *copies]
    )


def _function(head: str, result: str, lines: Iterable[str]) -> Iterator[str]:
    yield f"static inline {head}"
    yield "{"
    yield from (f"  {line}" for line in lines if line)
    if result:
        yield f"  return {result};"
    yield "}"


def _unless(condition: str) -> str:
    return f"if (!({condition})) {{{{return false;}}}}"


def _init(name: str, fields: Iterable[Field]) -> Iterator[str]:
    yield "if (!msg) {return false;}"
    yield "memset(msg, 0, sizeof(*msg));"
    yield "bool ok = true;"
    for field in fields:
        yield _each(field, "ok = ok && {owner}__init(&msg->{at}{size});")
        yield from _defaults(field)
    yield f"if (!ok) {{{name}__fini(msg);}}"


def _each(field: Field, with_owner: str, of_number: str = "") -> str:
    """Return a statement about a field, or about each element of a fixed array."""
    owner, kind = owner_type(field.type), field.type
    size = f", {len(field.default) if isinstance(field.default, list) else 0}" if kind.is_sequence else ""
    at = f"{field.name}[i]" if kind.is_fixed else field.name
    text = (with_owner if owner else of_number).format(owner=owner, at=at, size=size)
    return f"for (size_t i = 0; i < {kind.size}; ++i) {{{text}}}" if text and kind.is_fixed else text


def _defaults(field: Field) -> Iterator[str]:
    if field.default is None:
        return
    if not isinstance(field.default, list):
        yield _set(field.type, field.name, field.default)
        return
    data = field.name if field.type.is_fixed else f"{field.name}.data"
    yield from (_set(field.type, f"{data}[{i}]", value) for i, value in enumerate(field.default))


def _set(kind: FieldType, at: str, value: object) -> str:
    text = literal(kind.element, value)
    if kind.base in TEXTS:
        units = "(const uint_least16_t *)" if kind.base == "wstring" else ""
        return f"ok = ok && {TEXTS[kind.base]}__assign(&msg->{at}, {units}{text});"
    return f"if (ok) {{msg->{at} = {text};}}"
