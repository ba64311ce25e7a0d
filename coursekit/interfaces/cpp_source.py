"""C++ source of messages, services and actions, under the names that rosidl_generator_cpp gives them."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator

from coursekit.interfaces.compound import action_parts
from coursekit.interfaces.cpp_builder import builder_lines
from coursekit.interfaces.model import Action, Constant, Field, FieldType, Interface, Message, Service
from coursekit.interfaces.registry import module_name

_CPP = {
    "bool": "bool", "byte": "unsigned char", "char": "unsigned char", "float32": "float", "float64": "double",
    "string": "std::string", "wstring": "std::u16string",
    **{f"{sign}int{bits}": f"{sign}int{bits}_t" for sign in ("", "u") for bits in (8, 16, 32, 64)},
}  # fmt: skip


def header_name(name: str) -> str:
    """The name of an interface's header, without its suffix.

    >>> header_name("HardwareStatus")
    'hardware_status'
    """
    return module_name("p", "msg", name).rsplit("._", 1)[1]


def cpp_type(kind: FieldType) -> str:
    """The C++ type of a field.

    >>> cpp_type(FieldType('float64', is_array=True, size=36))
    'std::array<double, 36>'
    """
    element = _element(kind)
    if kind.is_fixed:
        return f"std::array<{element}, {kind.size}>"
    if kind.is_upper_bound:
        return f"rosidl_runtime_cpp::BoundedVector<{element}, {kind.size}>"
    return f"std::vector<{element}>" if kind.is_array else element


def _element(kind: FieldType) -> str:
    return _CPP[kind.base] if kind.is_primitive else "::".join(kind.base.split("/"))


def literal(kind: FieldType, value: object) -> str:
    """A value as C++ has it.

    >>> literal(FieldType('uint64'), 3), literal(FieldType('float32'), 0.5)
    ('3ull', '0.5f')
    """
    if isinstance(value, list):
        return "{" + ", ".join(literal(kind.element, item) for item in value) + "}"
    if kind.base == "bool":
        return "true" if value else "false"
    if kind.base in ("string", "wstring"):
        return ("u" if kind.base == "wstring" else "") + json.dumps(value, ensure_ascii=False)
    if kind.base in ("float32", "float64"):
        return f"{value!r}{'f' if kind.base == 'float32' else ''}"
    if kind.base == "int64" and value == -(2**63):
        return "INT64_MIN"
    return f"{value}{'u' if kind.base.startswith('u') else ''}{'ll' if kind.base.endswith('64') else ''}"


def header(interface: Interface, kind: str) -> str:
    """The text of an interface's header, which includes those of the messages in it."""
    own = {message.full_name for message in messages_of(interface)}
    inner = dict.fromkeys(
        base for message in messages_of(interface) for base in message.dependencies() if base not in own
    )
    includes = [f'#include "{p}/{k}/{header_name(n)}.hpp"' for p, k, n in (base.split("/") for base in inner)]
    return "\n".join([
        f"// Made by coursekit from {interface.full_name}: do not edit.",
        "#pragma once",
        '#include "rosidl_runtime_cpp/message.hpp"',
        *includes,
        f"namespace {interface.package}::{kind}",
        "{",
        *(f"using coursekit::yaml::{name};" for name in ("to_block_style_yaml", "to_flow_style_yaml", "to_yaml")),
        *_body(interface),
        f"}}  // namespace {interface.package}::{kind}",
        *builder_lines(interface.package, kind, messages_of(interface)),
        "",
    ])  # fmt: skip


def inner_headers(package: str, kind: str, name: str) -> dict[str, str]:
    """The headers that rosidl has beside an interface's own, by their names: editors write their includes by themselves."""
    own = header_name(name)
    text = f'#pragma once\n#include "{package}/{kind}/{own}.hpp"\n'
    return {f"{package}/{kind}/detail/{own}__{part}.hpp": text for part in ("struct", "builder", "traits")}


def messages_of(interface: Interface) -> list[Message]:
    """All structures of an interface: of a service two, of an action those that its topics and services carry too."""
    if isinstance(interface, Message):
        return [interface]
    extra = action_parts(interface) if isinstance(interface, Action) else []
    return [*interface.messages(), *extra]


def _body(interface: Interface) -> Iterator[str]:
    if isinstance(interface, Message):
        yield from _struct(interface)
        return
    for message in messages_of(interface):
        yield from _struct(message)
    if isinstance(interface, Service):
        yield from _service(interface.name, interface.full_name)
    else:
        yield from _action(interface.name, interface.full_name)


def _struct(message: Message) -> list[str]:
    name, fields = message.name, message.fields
    names = [field.name for field in fields] or ["structure_needs_at_least_one_member"]
    visits = " ".join(f'visit("{field}", message.{field});' for field in names)
    return [
        f"struct {name}",
        "{",
        f'  COURSEKIT_MESSAGE({name}, "{message.full_name}")',
        *(_constant(constant) for constant in message.constants),
        *(line for field in fields for line in _field(field, name)),
        *([] if fields else ["  uint8_t structure_needs_at_least_one_member{};"]),
        f"  template<class V, class M> static void each_field(V & visit, M & message) {{{visits}}}",
        f"  bool operator==(const {name} & o) const {{return {' && '.join(f'{field} == o.{field}' for field in names)};}}",
        f"  bool operator!=(const {name} & o) const {{return !(*this == o);}}",
        "};",
    ]


def _constant(constant: Constant) -> str:
    kind = "const char *" if constant.type.base == "string" else _CPP[constant.type.base]
    return f"  static constexpr {kind} {constant.name} = {literal(constant.type, constant.value)};"


def _field(field: Field, owner: str) -> Iterable[str]:
    kind = cpp_type(field.type)
    return (
        f"  using _{field.name}_type = {kind};",
        f"  {kind} {field.name}{_initial(field)};",
        f"  {owner} & set__{field.name}(const {kind} & value) {{this->{field.name} = value; return *this;}}",
    )


def _initial(field: Field) -> str:
    if field.default is not None:
        value = literal(field.type, field.default)
        return value if field.type.is_array else f"{{{value}}}"
    # messages begin with their defaults; {} would want a constructor that is not explicit
    return "" if field.type.is_fixed and not field.type.is_primitive else "{}"


def _service(name: str, full_name: str) -> list[str]:
    return [
        f"struct {name}",
        "{",
        f"  using Request = {name}_Request;",
        f"  using Response = {name}_Response;",
        f'  static constexpr const char * coursekit_type = "{full_name}";',
        "};",
    ]


def _action(name: str, full_name: str) -> list[str]:
    return [
        *_service(f"{name}_SendGoal", f"{full_name}_SendGoal"),
        *_service(f"{name}_GetResult", f"{full_name}_GetResult"),
        f"struct {name}",
        "{",
        *(f"  using {part} = {name}_{part};" for part in ("Goal", "Result", "Feedback")),
        f'  static constexpr const char * coursekit_type = "{full_name}";',
        "  struct Impl",
        "  {",
        f"    using SendGoalService = {name}_SendGoal;",
        f"    using GetResultService = {name}_GetResult;",
        f"    using FeedbackMessage = {name}_FeedbackMessage;",
        "  };",
        "};",
    ]
