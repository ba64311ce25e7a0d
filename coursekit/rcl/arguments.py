"""The ROS part of a command line: `--ros-args ... --`.

In ROS 2: rcl's arguments.c; flags, rules and error texts are the same.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

from coursekit.rcl import names, parameter_file
from coursekit.rcl.parameter_file import Overrides, ParameterFileError, Value
from coursekit.rcl.remap_rule import Remap, RuleError, remap_rule, scope, sides

LOG_LEVELS = {"UNSET": 0, "DEBUG": 10, "INFO": 20, "WARN": 30, "ERROR": 40, "FATAL": 50}

_PARAMETER = re.compile(r"/?(?!__)[A-Za-z_]\w*(?:(?:\.?/|\.)[A-Za-z_]\w*)*/?", re.ASCII)
_NODE_PATTERN = "/**"


class RosArgumentsError(ValueError):
    """A command line that rcl refuses."""


class UnknownRosArguments(RosArgumentsError):
    """Words between --ros-args and -- that are not known flags; `.arguments` lists them."""

    def __init__(self, arguments: list[str]) -> None:
        super().__init__(repr(arguments))
        self.arguments = arguments


@dataclass(frozen=True)
class RosArguments:
    """The arguments of a command line for nodes: `unparsed` words are not ROS's, `warnings` are meant for the user."""

    remaps: tuple[Remap, ...] = ()
    layers: tuple[Overrides, ...] = ()
    log_levels: dict[str | None, int] = field(default_factory=dict)
    enclave: str | None = None
    rosout_enabled: bool = True
    stdout_enabled: bool = True
    external_lib_enabled: bool = True
    log_config_file: str | None = None
    unparsed: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()

    @property
    def overrides(self) -> tuple[tuple[str, str, Value], ...]:
        """Every (node pattern, parameter name, value), weakest first."""
        return tuple(
            (pattern, name, value)
            for layer in self.layers
            for pattern, values in layer.items()
            for name, value in values.items()
        )

    def node_name(self, default: str) -> str:
        """Return the final name of a node whose default name is `default`."""
        return self._first("node", default, default)

    def node_namespace(self, node_name: str, default: str) -> str:
        """Return the namespace of the node with the final name `node_name`."""
        return self._first("namespace", node_name, default)

    def _first(self, kind: str, node_name: str, default: str) -> str:
        for rule in self.remaps:
            if rule.kind == kind and rule.node in (None, node_name):
                return rule.replacement
        return default

    def remap(self, kind: str, name: str, node_name: str, namespace: str) -> str:
        """Return the remapped full `name` of a 'topic' or 'service'; the first matching rule wins."""
        for rule in self.remaps:
            if rule.kind not in (kind, "any") or rule.node not in (None, node_name):
                continue
            if names.expand(rule.match, node_name, namespace) == name:
                return names.expand(rule.replacement, node_name, namespace)
        return name

    def parameters_for(self, node: str) -> dict[str, Value]:
        """Return the parameter overrides for the fully qualified node name."""
        values: dict[str, Value] = {}
        for layer in self.layers:
            values.update(parameter_file.values_for(layer, node))
        return values


def merge(local: RosArguments, general: RosArguments) -> RosArguments:
    """Merge the node's own arguments with those of the process: own rules come first, own parameters last."""
    return replace(
        local,
        remaps=local.remaps + general.remaps,
        layers=general.layers + local.layers,
        log_levels=general.log_levels | local.log_levels,
        enclave=local.enclave or general.enclave,
        rosout_enabled=local.rosout_enabled and general.rosout_enabled,
        stdout_enabled=local.stdout_enabled and general.stdout_enabled,
        external_lib_enabled=local.external_lib_enabled and general.external_lib_enabled,
    )


def parse_ros_arguments(args: Sequence[str] | None) -> RosArguments:
    """Parse a command line (with or without the program name). Raises RosArgumentsError.

    >>> parsed = parse_ros_arguments(["talker", "--ros-args", "-r", "chatter:=news", "-p", "rate:=2"])
    >>> parsed.remap("topic", "/chatter", "talker", "/"), parsed.parameters_for("/talker"), parsed.unparsed
    ('/news', {'rate': 2}, ('talker',))
    """
    other, ours = _split(list(args or ()))
    reader = _Reader()
    for section in ours:
        reader.read(section)
    if reader.unknown:
        raise UnknownRosArguments(reader.unknown)
    return reader.result(tuple(word for word in other if not reader.read_old_rule(word)))


def remove_ros_arguments(args: Sequence[str]) -> list[str]:
    """Return the words that are not ROS arguments. Raises RosArgumentsError as `parse_ros_arguments` does.

    >>> remove_ros_arguments(["prog", "--ros-args", "-r", "a:=b", "--", "-x"])
    ['prog', '-x']
    """
    return list(parse_ros_arguments(args).unparsed)


def _split(args: list[str]) -> tuple[list[str], list[list[str]]]:
    other: list[str] = []
    ours: list[list[str]] = []
    inside = False
    for word in args:
        if word == "--ros-args":
            if not inside:
                ours.append([])
            inside = True
        elif inside and word == "--":
            inside = False
        else:
            (ours[-1] if inside else other).append(word)
    return other, ours


class _Reader:
    """Collects the values of the flags, in their order."""

    def __init__(self) -> None:
        self.remaps: list[Remap] = []
        self.overrides: Overrides = {}
        self.log_levels: dict[str | None, int] = {}
        self.values: dict[str, str | bool] = {}
        self.unknown: list[str] = []
        self.warnings: list[str] = []

    def read(self, words: list[str]) -> None:
        rest = iter(words)
        for word in rest:
            if word in _SWITCHES:
                name, value = _SWITCHES[word]
                self.values[name] = value
            elif word in _FLAGS:
                self._take(word, next(rest, None))
            else:
                self.unknown.append(word)

    def read_old_rule(self, word: str) -> bool:
        """Return whether a word outside of --ros-args is a remap rule; such a rule still applies, although deprecated."""
        try:
            self.remaps.append(remap_rule(word))
        except RuleError:
            return False
        use = f"Use '--ros-args --remap {word}' instead."
        self.warnings.append(f"Found remap rule '{word}'. This syntax is deprecated. {use}")
        return True

    def _take(self, flag: str, text: str | None) -> None:
        what, missing, act = _FLAGS[flag]
        if text is None:
            shown = f"log level flag: '{flag}'" if what == "log level" else f"{flag} flag"
            raise RosArgumentsError(f"Couldn't parse trailing {shown}. No {missing}.")
        try:
            act(self, text)
        except (ParameterFileError, RuleError) as error:
            raise RosArgumentsError(f"Couldn't parse {what}: '{flag} {text}'. Error: {error}") from error

    def remap(self, text: str) -> None:
        self.remaps.append(remap_rule(text))

    def parameter(self, text: str) -> None:
        node, rule = scope(text)
        name, value = sides(rule)
        if not _PARAMETER.fullmatch(name):
            raise RuleError(f"'{name}' is no parameter name (letters, digits, '_', parts joined by '.')")
        pattern = _NODE_PATTERN if node is None else f"/{node}"
        parameter_file.add(self.overrides, {pattern: {name: parameter_file.parse_value(value)}})

    def parameter_file(self, text: str) -> None:
        parameter_file.add(self.overrides, parameter_file.read(text))

    def log_level(self, text: str) -> None:
        logger, _, level = text.rpartition(":=")
        if level.upper() not in LOG_LEVELS:
            known = ", ".join(LOG_LEVELS).lower()
            raise RuleError(f"Argument does not use a valid severity level (known: {known})")
        self.log_levels[logger or None] = LOG_LEVELS[level.upper()]

    def enclave(self, text: str) -> None:
        self.values["enclave"] = text
        if reason := names.validate_namespace(text, "context name"):
            index = f"Invalid index: {reason[1]}"
            raise RosArgumentsError(f"Enclave name is not valid: '{reason[0]}'. {index}")

    def log_config_file(self, text: str) -> None:
        self.values["log_config_file"] = text

    def log_file_name(self, text: str) -> None:
        """Ignored: logs are shown and not written to files."""

    def result(self, unparsed: tuple[str, ...]) -> RosArguments:
        layers = (self.overrides,) if self.overrides else ()
        return RosArguments(
            tuple(self.remaps),
            layers,
            self.log_levels,
            unparsed=unparsed,
            warnings=tuple(self.warnings),
            **self.values,  # type: ignore[arg-type]
        )


_SWITCHES = {
    "--enable-rosout-logs": ("rosout_enabled", True),
    "--disable-rosout-logs": ("rosout_enabled", False),
    "--enable-stdout-logs": ("stdout_enabled", True),
    "--disable-stdout-logs": ("stdout_enabled", False),
    "--enable-external-lib-logs": ("external_lib_enabled", True),
    "--disable-external-lib-logs": ("external_lib_enabled", False),
}
_Flag = tuple[str, str, Callable[[_Reader, str], None]]
_REMAP: _Flag = ("remap rule", "remap rule found", _Reader.remap)
_PARAM: _Flag = ("parameter override rule", "parameter override rule found", _Reader.parameter)
_ENCLAVE: _Flag = ("enclave path", "enclave path provided", _Reader.enclave)
_FLAGS: dict[str, _Flag] = {
    "-r": _REMAP,
    "--remap": _REMAP,
    "-p": _PARAM,
    "--param": _PARAM,
    "--params-file": ("params file", "file path provided", _Reader.parameter_file),
    "--log-level": ("log level", "log level provided", _Reader.log_level),
    "--log-config-file": ("log config file", "file path provided", _Reader.log_config_file),
    "--log-file-name": ("log file name prefix", "file name prefix provided", _Reader.log_file_name),
    "-e": _ENCLAVE,
    "--enclave": _ENCLAVE,
}
