"""C++ source of messages' builders: `geometry_msgs::build<geometry_msgs::msg::Point>().x(1).y(2).z(3)`.

Each step of a chain is a type with a setter only for the next field, so none is forgotten and their order is fixed.
"""

from __future__ import annotations

from collections.abc import Iterable

from coursekit.interfaces.model import Message


def builder_lines(package: str, kind: str, messages: Iterable[Message]) -> list[str]:
    """Return the builders for a header's messages, to be placed after the messages."""
    all_of_them = list(messages)
    return [
        f"namespace {package}::{kind}::builder",
        "{",
        *(step for message in all_of_them for step in _steps(message)),
        f"}}  // namespace {package}::{kind}::builder",
        f"namespace {package}",
        "{",
        "template<class M> auto build();",
        *(_build(kind, message) for message in all_of_them),
        f"}}  // namespace {package}",
    ]


def _steps(message: Message) -> list[str]:
    """Return the steps in reverse order: each step refers to the one that follows it in the chain."""
    names = [field.name for field in message.fields]
    following = [*(f"Init_{message.name}_{name}" for name in names[1:]), message.name]
    steps = [f"COURSEKIT_STEP({message.name}, {name}, {to})" for name, to in zip(names, following, strict=False)]
    return steps[::-1]


def _build(kind: str, message: Message) -> str:
    struct = f"{kind}::{message.name}"
    first = f"{kind}::builder::Init_{message.name}_{message.fields[0].name}({struct}())" if message.fields else f"{struct}()"
    return f"template<> inline auto build<{struct}>() {{return {first};}}"
