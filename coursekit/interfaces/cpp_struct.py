"""C++ source of a message's structure: its fields, its constructor, and its size traits."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from coursekit.interfaces.cpp_types import constant_type, cpp_type, element_type, literal
from coursekit.interfaces.model import Constant, Field, FieldType, Message

_FILLER = Field(FieldType("uint8"), "structure_needs_at_least_one_member")
_INIT = "rosidl_runtime_cpp::MessageInitialization"
_IF_USED = "template<class = void>"
"""Of a template a compiler makes only what a program uses: each include of a message with lists takes it less time."""


def struct_lines(message: Message) -> list[str]:
    """Return the structure of a message.

    >>> print(*struct_lines(Message("p", "msg", "Empty")), sep="\\n")  # doctest: +ELLIPSIS
    struct Empty
    {
    ...
    """
    name, fields = message.name, message.fields or (_FILLER,)
    visits = " ".join(f'visit("{field.name}", message.{field.name});' for field in fields)
    same = " && ".join(f"{field.name} == o.{field.name}" for field in fields)
    return [
        f"struct {name}",
        "{",
        f'  COURSEKIT_MESSAGE({name}, "{message.full_name}")',
        *(_constant(constant) for constant in message.constants),
        *(line for field in fields for line in _field(field, name)),
        *_constructor(name, fields),
        f"  static constexpr bool coursekit_fixed_size = {_all(_fixed_size, fields)};",
        f"  static constexpr bool coursekit_bounded_size = {_all(_bounded_size, fields)};",
        *_octets(fields),
        *_text_bounds(fields),
        f"  template<class V, class M> static void each_field(V & visit, M & message) {{{visits}}}",
        f"  {_IF_USED} bool operator==(const {name} & o) const {{return {same};}}",
        f"  {_IF_USED} bool operator!=(const {name} & o) const {{return !(*this == o);}}",
        "};",
        f"template<class ContainerAllocator = std::allocator<void>> using {name}_ = {name};",
    ]


def _constant(constant: Constant) -> str:
    return f"  static constexpr {constant_type(constant.type)} {constant.name} = {literal(constant.type, constant.value)};"


def _field(field: Field, owner: str) -> Iterable[str]:
    kind = cpp_type(field.type)
    yield f"  using _{field.name}_type = {kind};"
    yield f"  {kind} {field.name};"
    if field is not _FILLER:
        setter = f"set__{field.name}(const {kind} & value) {{this->{field.name} = value; return *this;}}"
        yield f"  {_IF_USED} {owner} & {setter}"


def _constructor(name: str, fields: Iterable[Field]) -> Iterator[str]:
    """Return a constructor like upstream's: zeros first, then the defaults, each if the initialization requests them."""
    fields = list(fields)
    nested = [f"{field.name}(_init)" for field in fields if not field.type.is_primitive and not field.type.is_array]
    zeros = [_zero(field) for field in fields if _begins_undefined(field.type)]
    blocks = [_fill(field) for field in fields if field.type.is_fixed and not field.type.is_primitive]
    defaults = [f"{field.name} = {literal(field.type, field.default)};" for field in fields if field.default is not None]
    yield f"  explicit {name}({_INIT} _init = {_INIT}::ALL)"
    if nested:
        yield f"  : {', '.join(nested)}"
    yield "  {"
    yield from (f"    if (coursekit::{when}(_init)) {{{' '.join(what)}}}" for when, what in (
        ("with_zeros", zeros), ("unlike_default", blocks), ("with_defaults", defaults),
    ) if what)  # fmt: skip
    yield from [] if zeros or blocks or defaults or nested else ["    (void)_init;"]
    yield "  }"


def _begins_undefined(kind: FieldType) -> bool:
    """Whether C++ leaves a field's memory uninitialized: numbers and fixed arrays of numbers."""
    return kind.is_primitive and not kind.is_sequence and kind.base not in ("string", "wstring")


def _zero(field: Field) -> str:
    return f"{field.name}.fill({{}});" if field.type.is_array else f"{field.name} = {{}};"


def _fill(field: Field) -> str:
    return f"{field.name}.fill({element_type(field.type)}(_init));"


def _octets(fields: Iterable[Field]) -> list[str]:
    """Return the names of the byte fields: in C++ they have the type of uint8, but YAML writes them differently."""
    names = ", ".join(f'"{field.name}"' for field in fields if field.type.base == "byte")
    return [f"  static constexpr const char * coursekit_octets[] = {{{names}}};"] if names else []


def _text_bounds(fields: Iterable[Field]) -> list[str]:
    """Return the names of the fields of bounded texts with the bounds, which their type in C++ does not tell."""
    bounds = ", ".join(f'{{"{field.name}", {field.type.string_bound}}}' for field in fields if field.type.string_bound)
    return [f"  static constexpr std::pair<const char *, size_t> coursekit_text_bounds[] = {{{bounds}}};"] if bounds else []


def _all(condition: Callable[[FieldType], str], fields: Iterable[Field]) -> str:
    """Return the conjunction of a condition over all fields; fields for which it always holds are left out."""
    conditions = dict.fromkeys(text for field in fields if (text := condition(field.type)))
    return "false" if "false" in conditions else " && ".join(conditions) or "true"


def _fixed_size(kind: FieldType) -> str:
    if kind.is_sequence or kind.base in ("string", "wstring"):
        return "false"
    return "" if kind.is_primitive else f"{element_type(kind)}::coursekit_fixed_size"


def _bounded_size(kind: FieldType) -> str:
    text = kind.base in ("string", "wstring") and not kind.string_bound
    if text or (kind.is_sequence and not kind.is_upper_bound):
        return "false"
    return "" if kind.is_primitive else f"{element_type(kind)}::coursekit_bounded_size"
