"""Starts a program, given by its command line."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from ..action import Action
from ..descriptions import Executable
from ..frontend import Entity, Parser, expose_action
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..substitutions import TextSubstitution
from .execute_local import ExecuteLocal
from .shutdown_action import Shutdown

TIMEOUTS = ("sigterm_timeout", "sigkill_timeout")
SWITCHES = ("emulate_tty", "log_cmd", "shell")


@expose_action("executable")
class ExecuteProcess(ExecuteLocal):
    """Starts a command, for example `cmd=['ros2', 'topic', 'list']`.

    A program of the system runs as a real child process; `ros2` and executables of packages run inside
    the session. With `shell=True` the user's shell runs the command.

    >>> record = ExecuteProcess(cmd=["ros2", "bag", "record", "/scan"], output="screen")
    >>> [part[0].text for part in record.cmd]
    ['ros2', 'bag', 'record', '/scan']
    """

    def __init__(
        self,
        *,
        cmd: Iterable[SomeSubstitutionsType],
        prefix: SomeSubstitutionsType | None = None,
        name: SomeSubstitutionsType | None = None,
        cwd: SomeSubstitutionsType | None = None,
        env: Any = None,
        additional_env: Any = None,
        **kwargs: Any,
    ) -> None:
        description = Executable(
            cmd=cmd, prefix=prefix, name=name, cwd=cwd, env=env, additional_env=additional_env
        )
        super().__init__(process_description=description, **kwargs)

    @classmethod
    def parse(
        cls, entity: Entity, parser: Parser, ignore: Iterable[str] = ()
    ) -> tuple[type[Action], dict[str, Any]]:
        """Read `<executable cmd= name= cwd= output= ...><env name= value=/></executable>`."""
        _, kwargs = super().parse(entity, parser)
        if "cmd" not in ignore:
            kwargs["cmd"] = cls._parse_cmdline(entity.get_attr("cmd"), parser)
        texts = {"name": "name", "cwd": "cwd", "output": "output", "launch-prefix": "prefix"}
        for attribute, keyword in [*texts.items(), *((name, name) for name in TIMEOUTS)]:
            data_type = float if attribute in TIMEOUTS else str
            value = (
                entity.get_attr(attribute, data_type=data_type, optional=True)
                if attribute not in ignore
                else None
            )
            if value is not None:
                kwargs[keyword] = parser.parse_substitution(str(value))
        cls._parse_switches(entity, parser, kwargs, ignore)
        environment = entity.get_attr("env", data_type=list[Entity], optional=True)
        if environment is not None:
            kwargs["additional_env"] = {
                tuple(parser.parse_substitution(item.get_attr("name"))): parser.parse_substitution(
                    item.get_attr("value")
                )
                for item in environment
            }
        return cls, kwargs

    @classmethod
    def _parse_switches(
        cls, entity: Entity, parser: Parser, kwargs: dict[str, Any], ignore: Iterable[str]
    ) -> None:
        """Read the switches, the respawn settings, and the action on exit."""
        for name in SWITCHES:
            value = entity.get_attr(name, data_type=bool, optional=True, can_be_str=False)
            if value is not None:
                kwargs[name] = value
        respawn = entity.get_attr("respawn", data_type=bool, optional=True)
        if respawn is not None:
            kwargs["respawn"] = parser.parse_if_substitutions(respawn)
        for name, kind in (("respawn_delay", float), ("respawn_max_retries", int)):
            value = entity.get_attr(name, data_type=kind, optional=True, can_be_str=False)
            if value is not None:
                kwargs[name] = value
        on_exit = entity.get_attr("on_exit", optional=True)
        if on_exit is not None:
            if on_exit != "shutdown":
                raise ValueError(
                    f"Attribute on_exit of Entity node expected to be `shutdown` but got `{on_exit}` instead"
                )
            kwargs["on_exit"] = [Shutdown()]

    @classmethod
    def _parse_cmdline(cls, cmd: str, parser: Parser) -> list[list[Substitution]]:
        """Split a command line into arguments; spaces in quotes and in substitutions do not split."""
        return _Splitter().split(parser.parse_substitution(cmd))

    @property
    def name(self) -> Any:
        """The name, or its substitutions until it is known."""
        return self.process_description.final_name or self.process_description.name

    @property
    def cmd(self) -> Any:
        """The command line, or its substitutions until it is known."""
        return self.process_description.final_cmd or self.process_description.cmd

    @property
    def cwd(self) -> Any:
        """The working folder, or its substitutions until it is known."""
        return self.process_description.final_cwd or self.process_description.cwd

    @property
    def env(self) -> Any:
        """The environment, as substitutions."""
        return self.process_description.env

    @property
    def additional_env(self) -> Any:
        """The variables that are added to the environment, as substitutions."""
        return self.process_description.additional_env


class _Splitter:
    """Splits text and substitutions at the spaces in the text."""

    def __init__(self) -> None:
        self.arguments: list[list[Substitution]] = []
        self.current: list[Substitution] = []
        self.text = ""
        self.started = False

    def split(self, substitutions: Iterable[Substitution]) -> list[list[Substitution]]:
        """Return the arguments."""
        quote = ""
        for substitution in substitutions:
            if isinstance(substitution, TextSubstitution):
                for character in substitution.text:
                    quote = self.take(character, quote)
            else:
                self.end_text()
                self.current.append(substitution)
                self.started = True
        self.end_argument()
        return self.arguments

    def take(self, character: str, quote: str) -> str:
        """Process one character; return the quote that is open after it."""
        if character == quote:
            return ""
        if not quote and character in "'\"":
            self.started = True
            return character
        if not quote and character.isspace():
            self.end_argument()
        else:
            self.text += character
            self.started = True
        return quote

    def end_text(self) -> None:
        """Add the collected text to the current argument."""
        if self.text:
            self.current.append(TextSubstitution(text=self.text))
            self.text = ""

    def end_argument(self) -> None:
        """Add the current argument to the arguments."""
        self.end_text()
        if self.started:
            self.arguments.append(self.current or [TextSubstitution(text="")])
        self.current, self.started = [], False
