"""YAML that compiled programs read where the system has no yaml-cpp: `cpp/yaml_cpp` is the other end."""

from __future__ import annotations

from typing import TYPE_CHECKING

import yaml

from coursekit.nodes.compiled.frames import Unpacker, packed

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host

NULL, SCALAR, SEQUENCE, MAP = 1, 2, 3, 4
"""yaml-cpp's NodeType."""
NULLS = {"", "~", "null", "Null", "NULL"}
MOST = 1_000_000
"""The most nodes of a text: aliases are written out, and a few lines of them can stand for billions."""


class _Writer:
    def __init__(self) -> None:
        self.count = 0

    def write(self, node: yaml.Node) -> bytes:
        self.count += 1
        if self.count > MOST:
            raise yaml.MarkedYAMLError(problem=f"more than {MOST} nodes", problem_mark=node.start_mark)
        kind = _kind(node)
        flow = int(bool(getattr(node, "flow_style", False)))
        head = packed(kind, node.start_mark.line, node.start_mark.column, _tag(node), flow)
        if isinstance(node, yaml.MappingNode):
            pairs = b"".join(self.write(key) + self.write(value) for key, value in node.value)
            return head + packed(len(node.value)) + pairs
        if isinstance(node, yaml.SequenceNode):
            return head + packed(len(node.value)) + b"".join(map(self.write, node.value))
        return head + (packed(int(_is_quoted(node)), node.value) if kind == SCALAR else b"")


def _kind(node: yaml.Node) -> int:
    if isinstance(node, yaml.MappingNode):
        return MAP
    if isinstance(node, yaml.SequenceNode):
        return SEQUENCE
    return NULL if not _is_quoted(node) and node.value in NULLS else SCALAR


def _is_quoted(node: yaml.Node) -> bool:
    return isinstance(node, yaml.ScalarNode) and bool(node.style)


def _tag(node: yaml.Node) -> str:
    """yaml-cpp's tag: `!` for quoted scalars, `?` for what has none."""
    if _is_quoted(node):
        return "!"
    return "?" if node.tag.startswith("tag:yaml.org,2002:") else str(node.tag)


def nodes(text: str) -> bytes:
    """Pack the documents of a text, or -1, the place and the words of what is wrong with it."""
    writer = _Writer()
    try:
        documents = [writer.write(node) for node in yaml.compose_all(text, yaml.SafeLoader)]
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        line, column = (mark.line, mark.column) if mark is not None else (-1, -1)
        return packed(-1, line, column, str(getattr(error, "problem", None) or error))
    except RecursionError:
        return packed(-1, -1, -1, "the nodes are too deep, or contain themselves")
    return packed(len(documents)) + b"".join(documents)


def do_yaml_nodes(_host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Read a text."""
    return nodes(frame.text())
