"""The registry of actions and substitutions that XML and YAML launch files can use."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, TypeVar

from coursekit.suggestions import hint

if TYPE_CHECKING:
    from ..action import Action
    from ..substitution import Substitution
    from .entity import Entity
    from .parser import Parser

Exposed = TypeVar("Exposed")

action_parse_methods: dict[str, Callable[..., tuple[type, dict[str, Any]]]] = {}
substitution_parse_methods: dict[str, Callable[..., tuple[type, dict[str, Any]]]] = {}


def expose_action(name: str) -> Callable[[Exposed], Exposed]:
    """Return a decorator that exposes an action class, or a parse function, as the element `name`."""
    return __expose_impl(name, action_parse_methods, "action")


def expose_substitution(name: str) -> Callable[[Exposed], Exposed]:
    """Return a decorator that exposes a substitution class, or a parse function, as `$(name ...)`."""
    return __expose_impl(name, substitution_parse_methods, "substitution")


def __expose_impl(name: str, register: dict[str, Any], kind: str) -> Callable[[Exposed], Exposed]:
    def decorate(exposed: Exposed) -> Exposed:
        parse = getattr(exposed, "parse", None) if inspect.isclass(exposed) else exposed
        if not callable(parse):
            raise RuntimeError(
                f"Exposed {kind} parser for {name} is not a callable or a class containing a parse method"
            )
        register[name] = parse
        return exposed

    return decorate


def instantiate_action(entity: Entity, parser: Parser) -> Action:
    """Return the action for an element.

    Raises:
        RuntimeError: if no action has that name, or if part of the element was not understood.
    """
    if entity.type_name not in action_parse_methods:
        raise RuntimeError(
            f"Unrecognized entity of the type: {entity.type_name}"
            + _alternatives(entity.type_name, action_parse_methods)
        )
    action_type, kwargs = action_parse_methods[entity.type_name](entity, parser)
    entity.assert_entity_completely_parsed()
    action: Action = action_type(**kwargs)
    return action


def instantiate_substitution(type_name: str, *args: Any) -> Substitution:
    """Return the substitution for `$(type_name args...)`.

    Raises:
        RuntimeError: if no substitution has that name.
    """
    if type_name not in substitution_parse_methods:
        raise RuntimeError(
            f"Unknown substitution: {type_name}" + _alternatives(type_name, substitution_parse_methods)
        )
    substitution_type, kwargs = substitution_parse_methods[type_name](list(args))
    positional = kwargs.pop("args", ())
    substitution: Substitution = substitution_type(*positional, **kwargs)
    return substitution


def _alternatives(name: str, known: Iterable[str]) -> str:
    names = sorted(known)
    return f"{hint(name, names)} (known: {', '.join(names)})"
