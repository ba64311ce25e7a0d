"""Parameter files and parameter values in YAML, read as rcl reads them.

In ROS 2: rcl_yaml_param_parser. It is not a general YAML loader: quoted text stays text, lists hold one
type, and a repeated key adds to its earlier values.
"""

from __future__ import annotations

import math
import re
from pathlib import Path

import yaml

from coursekit.files import read_text
from coursekit.rcl import names

Scalar = bool | int | float | str
Value = Scalar | list[bool] | list[int] | list[float] | list[str] | None
Overrides = dict[str, dict[str, Value]]
"""Values by node pattern ('/**', '/ns/node') and dotted parameter name; None stands for an empty list."""

_MARK = "ros__parameters"
_YES = ("y", "Y", "yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON")
_NO = ("n", "N", "no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF")
_BOOLS = dict.fromkeys(_YES, True) | dict.fromkeys(_NO, False)
_INT = re.compile(r"[+-]?(?:0[xX][0-9a-fA-F]+|[0-9]+)")
_FLOAT = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_HEX_FLOAT = re.compile(r"[+-]?0[xX](?:[0-9a-fA-F]+\.?[0-9a-fA-F]*|\.[0-9a-fA-F]+)(?:[pP][+-]?[0-9]+)?")
_INFINITE = re.compile(r"([+-]?)(?:\.inf|\.Inf|\.INF|(?i:inf|infinity))")
_NAN = re.compile(r"[+-]?(?:\.nan|\.NaN|\.NAN|(?i:nan(?:\(\w*\))?))")
_TYPE_NAMES = {bool: "bool", int: "integer", float: "double", str: "string"}


class ParameterFileError(ValueError):
    """A parameter file or value that rcl would refuse; the message names the line."""


def scalar(text: str) -> Scalar:
    """Return the value of a plain (unquoted) YAML scalar.

    >>> [scalar(word) for word in ("yes", "0x1F", "1e3", "1.0.0", ".inf")]
    [True, 31, 1000.0, '1.0.0', inf]
    """
    if text in _BOOLS:
        return _BOOLS[text]
    integer = _integer(text)
    if integer is not None:
        return integer
    number = _number(text)
    return text if number is None else number


def _integer(text: str) -> int | None:
    if not _INT.fullmatch(text):
        return None
    digits = text.lstrip("+-")
    octal = len(digits) > 1 and digits[0] == "0" and digits[1] not in "xX"
    try:
        value = int(digits, 8 if octal else 0)
    except ValueError:  # 08 is not an octal number
        return None
    value = -value if text[0] == "-" else value
    return value if -(2**63) <= value < 2**63 else None


def _number(text: str) -> float | None:
    if match := _INFINITE.fullmatch(text):
        return -math.inf if match[1] == "-" else math.inf
    if _NAN.fullmatch(text):
        return math.nan
    try:
        value = float.fromhex(text) if _HEX_FLOAT.fullmatch(text) else _decimal(text)
    except OverflowError:
        return None
    return value


def _decimal(text: str) -> float | None:
    if not _FLOAT.fullmatch(text):
        return None
    value = float(text)
    return None if math.isinf(value) else value


def parse_value(text: str) -> Value:
    """Return the value set by `-p name:=text`. Raises ParameterFileError.

    >>> parse_value("[1, 2]"), parse_value("'1'"), parse_value("on")
    ([1, 2], '1', True)
    """
    node = _compose(text)[:1]
    return _value(node[0]) if node else None


def parse(text: str) -> Overrides:
    """Return the overrides in the text of a parameter file. Raises ParameterFileError.

    >>> parse("/sim:\\n  turtle:\\n    ros__parameters:\\n      pen: {width: 3}\\n")
    {'/sim/turtle': {'pen.width': 3}}
    """
    overrides: Overrides = {}
    for root in _compose(text):
        if isinstance(root, yaml.MappingNode):
            _read_nodes(root, "", overrides)
        elif isinstance(root, yaml.SequenceNode):
            raise ParameterFileError(f"Sequences cannot be key at line {_line(root)}")
    return overrides


def read(path: str | Path) -> Overrides:
    """Return the overrides in the parameter file at `path`. Raises ParameterFileError."""
    try:
        text = read_text(path)
    except OSError as error:
        raise ParameterFileError(f"Error opening YAML file: {error.strerror}: {path}") from error
    except UnicodeDecodeError as error:
        raise ParameterFileError(f"Error opening YAML file: {path} is not UTF-8 text") from error
    return parse(text)


def matches(pattern: str, node: str) -> bool:
    """Return whether the pattern (`*` is one name, `**` any number) matches the fully qualified node name.

    >>> matches("/**", "/ns/n"), matches("/*", "/ns/n"), matches("/*/n", "/ns/n")
    (True, False, True)
    """
    if "*" not in pattern:
        return pattern == node
    parts = {"*": r"/\w+", "**": r"(?:/\w+)*"}
    expression = "".join(parts.get(part, "/" + re.escape(part)) for part in pattern.split("/")[1:])
    return re.fullmatch(expression, node) is not None


def values_for(overrides: Overrides, node: str) -> dict[str, Value]:
    """Return the values for the node; later patterns override earlier ones.

    >>> values_for({"/**": {"speed": 1.0}, "/turtle": {"speed": 2.0}}, "/turtle")
    {'speed': 2.0}
    """
    values: dict[str, Value] = {}
    for pattern, said in overrides.items():
        if matches(pattern, node):
            values.update(said)
    return values


def add(target: Overrides, more: Overrides) -> None:
    """Add `more` to `target`; a repeated pattern keeps its original position.

    >>> overrides = {"/turtle": {"speed": 1.0}}
    >>> add(overrides, {"/turtle": {"width": 3}})
    >>> overrides
    {'/turtle': {'speed': 1.0, 'width': 3}}
    """
    for pattern, values in more.items():
        target.setdefault(pattern, {}).update(values)


def _compose(text: str) -> list[yaml.Node]:
    try:
        return [node for node in yaml.compose_all(text, Loader=_Loader) if node is not None]
    except yaml.MarkedYAMLError as error:
        line = error.problem_mark.line + 1 if error.problem_mark else 1
        raise ParameterFileError(f"Error parsing a event near line {line}: {error.problem}") from error
    except yaml.YAMLError as error:
        raise ParameterFileError(f"Error parsing a event near line 1: {error}") from error
    except RecursionError:
        raise ParameterFileError("Error parsing a event near line 1: it is nested too deep") from None


class _Loader(yaml.SafeLoader):
    """Composes nodes; refuses aliases as rcl does."""

    def compose_node(self, parent: yaml.Node | None, index: int) -> yaml.Node | None:
        if self.check_event(yaml.AliasEvent):
            line = self.peek_event().start_mark.line + 1
            raise ParameterFileError(f"Will not support aliasing at line {line}")
        return super().compose_node(parent, index)


def _read_nodes(mapping: yaml.MappingNode, namespace: str, overrides: Overrides) -> None:
    for key, value in mapping.value:
        name = _key(key)
        if name != _MARK:
            if not isinstance(value, yaml.MappingNode):
                raise ParameterFileError(f"Cannot have a value before {_MARK} at line {_line(value)}")
            _read_nodes(value, _join(namespace, name), overrides)
        elif not namespace:
            raise ParameterFileError(f"There are no node names before {_MARK} at line {_line(key)}")
        elif not isinstance(value, yaml.MappingNode):
            raise ParameterFileError(f"Cannot have a value before {_MARK} at line {_line(value)}")
        else:
            _check_node(namespace)
            _read_values(value, "", overrides.setdefault(namespace, {}))


def _read_values(mapping: yaml.MappingNode, prefix: str, values: dict[str, Value]) -> None:
    for key, value in mapping.value:
        name = prefix + _key(key)
        if isinstance(value, yaml.MappingNode):
            _read_values(value, name + ".", values)
        else:
            values[name] = _value(value)


def _key(node: yaml.Node) -> str:
    if not isinstance(node, yaml.ScalarNode):
        kind = "Sequences" if isinstance(node, yaml.SequenceNode) else "Mappings"
        raise ParameterFileError(f"{kind} cannot be key at line {_line(node)}")
    return node.value


def _join(namespace: str, name: str) -> str:
    return f"{namespace}/{name.removeprefix('/')}"


def _check_node(pattern: str) -> None:
    for part in pattern.split("/")[1:]:
        reason = None if part in ("*", "**") else names.validate_node_name(part)
        if reason:
            raise ParameterFileError(f"{reason[0]}: '{pattern}'")


def _value(node: yaml.Node) -> Value:
    if isinstance(node, yaml.ScalarNode):
        return _typed(node)
    if isinstance(node, yaml.SequenceNode):
        return _list(node)
    raise ParameterFileError(f"Unknown YAML event: a mapping is no parameter value, at line {_line(node)}")


def _typed(node: yaml.ScalarNode) -> Scalar:
    if node.style is not None or _said_str(node):
        return node.value
    if not node.value:
        raise ParameterFileError(f"No value at line {_line(node)}")
    return scalar(node.value)


def _said_str(node: yaml.ScalarNode) -> bool:
    written, start = node.start_mark.buffer, node.start_mark.pointer
    return isinstance(written, str) and written[start : start + 5] == "!!str"


def _list(node: yaml.SequenceNode) -> Value:
    values: list[Scalar] = []
    for item in node.value:
        value = _value(item)
        values.extend(value if isinstance(value, list) else [] if value is None else [value])
        if values and type(values[-1]) is not type(values[0]):
            kind = _TYPE_NAMES[type(values[-1])]
            where = f"Value type '{kind}' do not belong at line_num {_line(item)}"
            raise ParameterFileError(f"Sequence should be of same type. {where}")
    return values or None  # type: ignore[return-value]


def _line(node: yaml.Node) -> int:
    return node.start_mark.line + 1
