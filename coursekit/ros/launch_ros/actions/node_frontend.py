"""Reads `<node>` elements."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch.frontend import Entity, Parser

from ..parameter_descriptions import ParameterFile, ParameterValue

if TYPE_CHECKING:
    from .node import Node

TYPES: dict[str, Any] = {
    "int": int,
    "float": float,
    "bool": bool,
    "str": str,
    "list[int]": list[int],
    "list[float]": list[float],
    "list[bool]": list[bool],
    "list[str]": list[str],
    "list_of_int": list[int],
    "list_of_float": list[float],
    "list_of_bool": list[bool],
    "list_of_str": list[str],
}
ATTRIBUTES = {"name": "name", "exec_name": "exec_name", "pkg": "package", "namespace": "namespace"}


def parse_node(cls: type[Node], entity: Entity, parser: Parser) -> dict[str, Any]:
    """Return the keyword arguments of a Node from its element."""
    kwargs: dict[str, Any] = {"executable": parser.parse_substitution(entity.get_attr("exec"))}
    for attribute, keyword in ATTRIBUTES.items():
        value = entity.get_attr(attribute, optional=True)
        if value is not None:
            kwargs[keyword] = parser.parse_substitution(value)
    for attribute, keyword in (("args", "arguments"), ("ros_args", "ros_arguments")):
        line = entity.get_attr(attribute, optional=True)
        if line is not None:
            kwargs[keyword] = cls._parse_cmdline(line, parser)
    remappings = parse_remaps(entity, parser)
    if remappings:
        kwargs["remappings"] = remappings
    parameters = entity.get_attr("param", data_type=list[Entity], optional=True)
    if parameters is not None:
        kwargs["parameters"] = parse_parameters(parameters, parser)
    return kwargs


def parse_remaps(entity: Entity, parser: Parser) -> list[tuple[Any, Any]]:
    """Return the (from, to) pairs of an element's `<remap from= to=/>`."""
    remaps = entity.get_attr("remap", data_type=list[Entity], optional=True) or []
    pairs = [
        (parser.parse_substitution(remap.get_attr("from")), parser.parse_substitution(remap.get_attr("to")))
        for remap in remaps
    ]
    for remap in remaps:
        remap.assert_entity_completely_parsed()
    return pairs


def parse_parameters(entities: list[Entity], parser: Parser) -> list[Any]:
    """Return the `<param>` elements in the form of Node's argument: files and mappings, in order.

    Raises:
        RuntimeError: if a param has both a name and a file.
        ValueError: if it has neither.
    """
    return [_parse_parameter(entity, parser) for entity in entities]


def _parse_parameter(entity: Entity, parser: Parser) -> Any:
    file = entity.get_attr("from", optional=True)
    allow_substs = entity.get_attr("allow_substs", data_type=bool, optional=True)
    name = entity.get_attr("name", optional=True)
    if file is not None and name is not None:
        raise RuntimeError("name and from attributes are mutually exclusive")
    if file is not None:
        allowed = parser.parse_if_substitutions(allow_substs) if allow_substs is not None else False
        entity.assert_entity_completely_parsed()
        return ParameterFile(parser.parse_substitution(file), allow_substs=allowed)
    if name is None:
        raise ValueError("param Entity should have name or from attribute")
    if allow_substs is not None:
        raise RuntimeError("'allow_substs' can only be used together with 'from' attribute")
    return _nested([entity], parser)


def _nested(entities: list[Entity], parser: Parser) -> dict[Any, Any]:
    values: dict[Any, Any] = {}
    for entity in entities:
        name = tuple(parser.parse_substitution(entity.get_attr("name")))
        kind = _type(entity.get_attr("type", optional=True))
        value = entity.get_attr("value", data_type=kind, optional=True)
        inner = entity.get_attr("param", data_type=list[Entity], optional=True)
        entity.assert_entity_completely_parsed()
        if inner and (value is not None or kind is not None):
            raise RuntimeError("nested parameters and value attributes are mutually exclusive")
        if inner:
            values[name] = _nested(inner, parser)
        elif value is not None:
            values[name] = ParameterValue(parser.parse_if_substitutions(value), value_type=kind)
        else:
            raise RuntimeError("either a value attribute or nested params are needed")
    return values


def _type(identifier: str | None) -> Any:
    if identifier is None:
        return None
    if identifier not in TYPES:
        raise RuntimeError(f"'{identifier}' is no type of a parameter (known: {', '.join(TYPES)})")
    return TYPES[identifier]
