"""C++ source of rosidl_generator_traits' facts about services, actions and their messages."""

from __future__ import annotations

from collections.abc import Iterator

from coursekit.interfaces.model import Action, Interface, Service


def trait_lines(interface: Interface, namespace: str) -> list[str]:
    """Return the traits of an interface in a C++ namespace; a message has none of its own.

    >>> from coursekit.interfaces.parser import parse
    >>> trait_lines(parse("std_srvs", "srv", "Empty", "---"), "std_srvs::srv")[0]
    'COURSEKIT_IS(is_service, std_srvs::srv::Empty)'
    """
    return [f"COURSEKIT_IS({trait}, {namespace}::{name})" for trait, name in _traits(interface)]


def _traits(interface: Interface) -> Iterator[tuple[str, str]]:
    if isinstance(interface, Service):
        yield from _of_service(interface.name)
    if isinstance(interface, Action):
        yield "is_action", interface.name
        for part in ("Goal", "Result", "Feedback"):
            yield f"is_action_{part.lower()}", f"{interface.name}_{part}"
        for part in ("SendGoal", "GetResult"):
            yield from _of_service(f"{interface.name}_{part}")


def _of_service(name: str) -> Iterator[tuple[str, str]]:
    yield "is_service", name
    for part in ("Request", "Response"):
        yield f"is_service_{part.lower()}", f"{name}_{part}"
