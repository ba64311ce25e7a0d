"""Reads `<composable_node>` elements."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch.conditions import IfCondition, UnlessCondition
from launch.frontend import Entity, Parser

if TYPE_CHECKING:
    from ..descriptions import ComposableNode


def parse_composable_node(entity: Entity, parser: Parser) -> dict[str, Any]:
    """Return the keyword arguments of a ComposableNode from its element.

    Raises:
        RuntimeError: if it has both `if` and `unless`.
    """
    from ..actions.node_frontend import parse_parameters, parse_remaps

    kwargs: dict[str, Any] = {
        "package": parser.parse_substitution(entity.get_attr("pkg")),
        "plugin": parser.parse_substitution(entity.get_attr("plugin")),
        "remappings": parse_remaps(entity, parser),
    }
    for attribute in ("name", "namespace"):
        value = entity.get_attr(attribute, optional=True)
        if value is not None:
            kwargs[attribute] = parser.parse_substitution(value)
    parameters = entity.get_attr("param", data_type=list[Entity], optional=True)
    if parameters:
        kwargs["parameters"] = parse_parameters(parameters, parser)
    extra = entity.get_attr("extra_arg", data_type=list[Entity], optional=True)
    if extra:
        kwargs["extra_arguments"] = [_extra_argument(entity, parser) for entity in extra]
    return {**kwargs, **_condition(entity, parser)}


def _extra_argument(entity: Entity, parser: Parser) -> dict[Any, Any]:
    name = tuple(parser.parse_substitution(entity.get_attr("name")))
    value = parser.parse_substitution(entity.get_attr("value"))
    entity.assert_entity_completely_parsed()
    return {name: value}


def _condition(entity: Entity, parser: Parser) -> dict[str, Any]:
    wanted, unwanted = (entity.get_attr(name, optional=True) for name in ("if", "unless"))
    if wanted is not None and unwanted is not None:
        raise RuntimeError("if and unless conditions can't be used simultaneously")
    if wanted is not None:
        return {"condition": IfCondition(predicate_expression=parser.parse_substitution(wanted))}
    if unwanted is not None:
        return {"condition": UnlessCondition(predicate_expression=parser.parse_substitution(unwanted))}
    return {}


def parse_composable_nodes(entity: Entity, parser: Parser, *, optional: bool) -> list[ComposableNode]:
    """Return the components inside an element."""
    from ..descriptions import ComposableNode

    composable_nodes = []
    for item in entity.get_attr("composable_node", data_type=list[Entity], optional=optional) or []:
        cls, kwargs = ComposableNode.parse(parser, item)
        item.assert_entity_completely_parsed()
        composable_nodes.append(cls(**kwargs))
    return composable_nodes
