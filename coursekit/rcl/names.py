"""Names of the graph: their validation and the expansion of short names to full ones.

In ROS 2: rcl's expand_topic_name and rmw's validators; reasons and indices are the same.
"""

from __future__ import annotations

import re

MAX_TOPIC_LENGTH = 247
MAX_NAMESPACE_LENGTH = 245
MAX_NODE_NAME_LENGTH = 255

Reason = tuple[str, int]

_NOT_WORD = re.compile(r"[^A-Za-z0-9_]")
_NOT_PATH = re.compile(r"[^A-Za-z0-9_/]")
_NOT_TOPIC = re.compile(r"[^A-Za-z0-9_/~{}]")
_NUMBER_TOKEN = re.compile(r"(?:^|(?<=/))[0-9]")
_SUBSTITUTION = re.compile(r"\{([^{}]*)\}")


class InvalidName(ValueError):
    """An invalid name in the graph.

    Attributes: `name` as given, `message` (the reason), `index` of the first bad character.
    """

    kind = "name"

    def __init__(self, name: str, message: str, index: int) -> None:
        super().__init__(f"{self.kind} '{name}' is invalid: {message}")
        self.name = name
        self.message = message
        self.index = index


class InvalidTopicName(InvalidName):
    """A topic or service name that breaks the rules."""

    kind = "topic name"


class UnknownSubstitution(InvalidTopicName):
    """A `{name}` in a topic that is not {node}, {ns} or {namespace}."""


class InvalidNodeName(InvalidName):
    """A node name that breaks the rules."""

    kind = "node name"


class InvalidNamespace(InvalidName):
    """A namespace that breaks the rules."""

    kind = "node namespace"


def validate_topic_name(text: str) -> Reason | None:
    """Return (reason, index) when `text` is not a topic name, else None. Short names and `{...}` are allowed.

    >>> validate_topic_name("chatter")
    >>> validate_topic_name("chatter/42_is")
    ('topic name token must not start with a number', 8)
    """
    if not text:
        return "topic name must not be empty string", 0
    if text[0].isascii() and text[0].isdigit():
        return "topic name token must not start with a number", 0
    if text.endswith("/"):
        return "topic name must not end with a forward slash", len(text) - 1
    return _bad_character(text) or _lone_tilde(text) or _number_token(text)


def _bad_character(text: str) -> Reason | None:
    opened: int | None = None
    for index, char in enumerate(text):
        if opened is not None and char not in "{}~" and _NOT_WORD.match(char):
            return "substitution name must not contain characters other than alphanumerics or '_'", index
        if opened is not None and index == opened + 1 and char.isdigit():
            return "substitution name must not start with a number", index
        if char == "{":
            if opened is not None:
                return "substitution name must not contain characters other than alphanumerics or '_'", index
            opened = index
        elif char == "}":
            if opened is None:
                return "topic name must not have unmatched (unbalanced) curly braces '{}'", index
            opened = None
        elif char == "~" and index:
            return "topic name must not have tilde '~' unless it is the first character", index
        elif _NOT_TOPIC.match(char):
            reason = "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'"
            return reason, index
    if opened is not None:
        return "topic name must not have unmatched (unbalanced) curly braces '{}'", opened
    return None


def _lone_tilde(text: str) -> Reason | None:
    if text[0] == "~" and len(text) > 2 and text[1] != "/":  # rcl accepts "~a"
        return "topic name must not have a tilde '~' that is not followed by a forward slash '/'", 1
    return None


def _number_token(text: str) -> Reason | None:
    match = _NUMBER_TOKEN.search(text)
    return ("topic name token must not start with a number", match.start()) if match else None


def validate_full_topic_name(text: str) -> Reason | None:
    """Return (reason, index) when `text` is not an absolute, fully expanded topic name, else None.

    >>> validate_full_topic_name("scan"), validate_full_topic_name("/scan")
    (("topic name must be absolute, it must lead with a '/'", 0), None)
    """
    if not text:
        return "topic name must not be empty", 0
    if text[0] != "/":
        return "topic name must be absolute, it must lead with a '/'", 0
    if text.endswith("/"):
        return "topic name must not end with a '/'", len(text) - 1
    if reason := _bad_path("topic name", text):
        return reason
    if len(text) > MAX_TOPIC_LENGTH:
        return "topic length should not exceed '255U - 8U'", MAX_TOPIC_LENGTH - 1
    return None


def validate_namespace(text: str, kind: str = "namespace") -> Reason | None:
    """Return (reason, index) when `text` is not an absolute namespace, else None.

    >>> validate_namespace("/robot/"), validate_namespace("/robot")
    (("namespace must not end with a '/', unless only a '/'", 6), None)
    """
    if not text:
        return f"{kind} must not be empty", 0
    if text == "/":
        return None
    if text[0] != "/":
        return f"{kind} must be absolute, it must lead with a '/'", 0
    if text.endswith("/"):
        return f"{kind} must not end with a '/', unless only a '/'", len(text) - 1
    if reason := _bad_path(kind, text):
        return reason
    if len(text) > MAX_NAMESPACE_LENGTH:
        return f"{kind} should not exceed 'RMW_NAMESPACE_MAX_NAME_LENGTH'", MAX_NAMESPACE_LENGTH - 1
    return None


def _bad_path(kind: str, text: str) -> Reason | None:
    if match := _NOT_PATH.search(text):
        reason = f"{kind} must not contain characters other than alphanumerics, '_', or '/'"
        return reason, match.start()
    if (index := text.find("//")) >= 0:
        return f"{kind} must not contain repeated '/'", index + 1
    if match := _NUMBER_TOKEN.search(text):
        return f"{kind} must not have a token that starts with a number", match.start()
    return None


def validate_node_name(text: str) -> Reason | None:
    """Return (reason, index) when `text` is not a node name, else None.

    >>> validate_node_name("2nd"), validate_node_name("second")
    (('node name must not start with a number', 0), None)
    """
    if not text:
        return "node name must not be empty", 0
    if match := _NOT_WORD.search(text):
        reason = "node name must not contain characters other than alphanumerics or '_'"
        return reason, match.start()
    if text[0].isdigit():
        return "node name must not start with a number", 0
    if len(text) > MAX_NODE_NAME_LENGTH:
        return f"node name length should not exceed '{MAX_NODE_NAME_LENGTH}'", MAX_NODE_NAME_LENGTH - 1
    return None


def expand(name: str, node_name: str, namespace: str) -> str:
    """Return the full name of `name` for the node `namespace`/`node_name`.

    Raises InvalidTopicName, InvalidNodeName, InvalidNamespace or UnknownSubstitution.

    >>> expand("~/pose", "turtle", "/sim")
    '/sim/turtle/pose'
    """
    _check(InvalidTopicName, validate_topic_name, name)
    _check(InvalidNodeName, validate_node_name, node_name)
    _check(InvalidNamespace, validate_namespace, namespace)
    prefix = namespace if namespace.endswith("/") else namespace + "/"
    text = prefix + node_name + name[1:] if name[0] == "~" else name
    values = {"node": node_name, "ns": namespace, "namespace": namespace}
    expanded = _SUBSTITUTION.sub(lambda match: _substitute(match, name, values), text)
    return expanded if expanded.startswith("/") else prefix + expanded


def _substitute(match: re.Match[str], name: str, values: dict[str, str]) -> str:
    try:
        return values[match[1]]
    except KeyError:
        raise UnknownSubstitution(name, f"unknown substitution: {match[0]}", match.start()) from None


def _check(error, validate, text: str) -> None:
    if reason := validate(text):
        raise error(text, *reason)


def is_hidden(name: str) -> bool:
    """Return whether a part of the full name starts with an underscore; lists leave hidden names out.

    >>> is_hidden("/fibonacci/_action/status")
    True
    """
    return "/_" in name or name.startswith("_")


def join(namespace: str, name: str) -> str:
    """Return the fully qualified name of a node.

    >>> join("/", "talker"), join("/ns", "talker")
    ('/talker', '/ns/talker')
    """
    return f"/{name}" if namespace in ("", "/") else f"{namespace}/{name}"
