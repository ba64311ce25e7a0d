"""One remap rule of a command line: `[node:][rostopic://]match:=replacement`."""

from __future__ import annotations

import re
from dataclasses import dataclass

from coursekit.rcl import names

_WORD = r"(?:[A-Za-z]|_(?!_))(?:[A-Za-z0-9]|_(?!_))*"
_PATH = rf"/?{_WORD}(?:/{_WORD})*"
_SCOPE = re.compile(rf"(?:({_WORD}):(?!=))?(.*)", re.DOTALL)
_MATCH = re.compile(rf"(?:(rostopic|rosservice)://)?((?:~/)?{_PATH})")
_REPLACEMENT = re.compile(rf"(?:~/)?{_PATH}")


@dataclass(frozen=True)
class Remap:
    """One rule.

    `kind` is 'node', 'namespace', 'topic', 'service' or 'any' (topics and services).
    """

    kind: str
    node: str | None
    match: str
    replacement: str


class RuleError(ValueError):
    """An invalid rule after -r, -p or --log-level."""


def scope(text: str) -> tuple[str | None, str]:
    """Return the node that a rule applies to (None for all nodes) and the rest of the rule.

    >>> scope("talker:chatter:=news"), scope("chatter:=news")
    (('talker', 'chatter:=news'), (None, 'chatter:=news'))
    """
    match = _SCOPE.fullmatch(text)
    assert match is not None  # the pattern matches any text
    if match[1] in ("rostopic", "rosservice") and match[2].startswith("//"):
        return None, text
    return match[1], match[2]


def sides(rule: str) -> tuple[str, str]:
    """Return the parts before and after `:=`. Raises RuleError for any other form.

    >>> sides("chatter:=news")
    ('chatter', 'news')
    """
    left, mark, right = rule.partition(":=")
    if not mark:
        raise RuleError("Expected ':=' between the two sides, as in name:=value")
    if not right:
        raise RuleError("nothing follows ':='")
    if "*" in left:
        raise RuleError("Wildcard '*' is not implemented")
    return left, right


def remap_rule(text: str) -> Remap:
    """Parse a remap rule. Raises RuleError.

    >>> remap_rule("talker:chatter:=news")
    Remap(kind='any', node='talker', match='chatter', replacement='news')
    """
    node, rule = scope(text)
    left, right = sides(rule)
    if left in ("__node", "__name"):
        _expect(names.validate_node_name(right))
        return Remap("node", node, left, right)
    if left == "__ns":
        _expect(names.validate_namespace(right))
        return Remap("namespace", node, left, right)
    match = _MATCH.fullmatch(left)
    if not match:
        raise RuleError(f"Expecting token or wildcard, got '{left}'")
    if not _REPLACEMENT.fullmatch(right):
        raise RuleError(f"'{right}' is no name to remap to")
    kind = {"rostopic": "topic", "rosservice": "service"}.get(match[1], "any")
    return Remap(kind, node, match[2], right)


def _expect(reason: names.Reason | None) -> None:
    if reason:
        raise RuleError(reason[0])
