"""C++ source of messages, services and actions, under the names that rosidl_generator_cpp gives them."""

from __future__ import annotations

from collections.abc import Iterator

from coursekit.interfaces.compound import action_parts
from coursekit.interfaces.cpp_builder import builder_lines
from coursekit.interfaces.cpp_struct import struct_lines
from coursekit.interfaces.cpp_traits import trait_lines
from coursekit.interfaces.model import Action, Interface, Message, Service
from coursekit.interfaces.registry import module_name

_PARTS = ("struct", "builder", "traits", "type_support")
"""The inner headers of an interface."""
_OF_ALL_ACTIONS = ("action_msgs/msg/GoalStatusArray", "action_msgs/srv/CancelGoal")
"""The interfaces beside its own by which an action is watched and cancelled."""


def header_name(name: str) -> str:
    """Return the name of an interface's header, without its suffix.

    >>> header_name("HardwareStatus")
    'hardware_status'
    """
    return module_name("p", "msg", name).rsplit("._", 1)[1]


def header(interface: Interface, kind: str) -> str:
    """Return the text of an interface's header, which includes those of its nested messages."""
    own = {message.full_name for message in messages_of(interface)}
    inner = dict.fromkeys(
        base for message in messages_of(interface) for base in message.dependencies() if base not in own
    )
    if isinstance(interface, Action):
        inner |= dict.fromkeys(_OF_ALL_ACTIONS)
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
        *trait_lines(interface, f"{interface.package}::{kind}"),
        "",
    ])  # fmt: skip


def inner_headers(package: str, kind: str, name: str) -> dict[str, str]:
    """Return rosidl's inner headers by name, beside the interface's own: editors insert includes of them automatically.

    >>> [name for name in inner_headers("std_msgs", "msg", "String")][0]
    'std_msgs/msg/detail/string__struct.hpp'
    """
    own = header_name(name)
    text = f'#pragma once\n#include "{package}/{kind}/{own}.hpp"\n'
    return {f"{package}/{kind}/detail/{own}__{part}.hpp": text for part in _PARTS}


def messages_of(interface: Interface) -> list[Message]:
    """Return all structures of an interface: two for a service; for an action also those of its topics and services."""
    if isinstance(interface, Message):
        return [interface]
    extra = action_parts(interface) if isinstance(interface, Action) else []
    return [*interface.messages(), *extra]


def _body(interface: Interface) -> Iterator[str]:
    if isinstance(interface, Message):
        yield from struct_lines(interface)
        return
    for message in messages_of(interface):
        yield from struct_lines(message)
    if isinstance(interface, Service):
        yield from _service(interface.name, interface.full_name)
    else:
        yield from _action(interface.name, interface.full_name)


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
        "    using CancelGoalService = action_msgs::srv::CancelGoal;",
        "    using GoalStatusMessage = action_msgs::msg::GoalStatusArray;",
        "  };",
        "};",
    ]
