"""The description of a program to start."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from coursekit.systems.command_lines import join_words, split_words

from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..substitutions import FindExecutable, LaunchConfiguration
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from ..action import Action
    from ..launch_context import LaunchContext

SomeEnvironment = Mapping[Any, SomeSubstitutionsType]
EnvironmentPairs = list[tuple[list[Substitution], list[Substitution]]]


class Executable:
    """A command line with its name, folder and environment; `prepare` performs the substitutions."""

    def __init__(
        self,
        *,
        cmd: Iterable[SomeSubstitutionsType],
        prefix: SomeSubstitutionsType | None = None,
        name: SomeSubstitutionsType | None = None,
        cwd: SomeSubstitutionsType | None = None,
        env: SomeEnvironment | None = None,
        additional_env: SomeEnvironment | None = None,
        arguments: Iterable[SomeSubstitutionsType] | None = None,
    ) -> None:
        self.__cmd = [normalize_to_list_of_substitutions(part) for part in cmd]
        self.__arguments = None if arguments is None else list(arguments)
        self.__cmd += [normalize_to_list_of_substitutions(part) for part in self.__arguments or []]
        self.__prefix = normalize_to_list_of_substitutions(
            LaunchConfiguration("launch-prefix", default="") if prefix is None else prefix
        )
        self.__prefix_filter = normalize_to_list_of_substitutions(
            LaunchConfiguration("launch-prefix-filter", default="") if prefix is None else ""
        )
        self.__name = None if name is None else normalize_to_list_of_substitutions(name)
        self.__cwd = None if cwd is None else normalize_to_list_of_substitutions(cwd)
        self.__env = _pairs(env)
        self.__additional_env = _pairs(additional_env)
        self.__final: dict[str, Any] = {}

    @property
    def name(self) -> list[Substitution] | None:
        """The name, as substitutions; None for the program's name."""
        return self.__name

    @property
    def prefix(self) -> list[Substitution]:
        """The words before the command, as substitutions."""
        return self.__prefix

    @property
    def cmd(self) -> list[list[Substitution]]:
        """The command line; each part is a list of substitutions."""
        return self.__cmd

    @property
    def cwd(self) -> list[Substitution] | None:
        """The working folder, as substitutions; None for the launch's folder."""
        return self.__cwd

    @property
    def env(self) -> EnvironmentPairs | None:
        """The whole environment, as substitutions; None for the launch's environment."""
        return self.__env

    @property
    def additional_env(self) -> EnvironmentPairs | None:
        """The variables that are added to the environment, as substitutions."""
        return self.__additional_env

    @property
    def arguments(self) -> list[SomeSubstitutionsType] | None:
        """The arguments that were given separately from the command."""
        return self.__arguments

    @property
    def final_name(self) -> str | None:
        """The name with its number, such as talker-1; None before `prepare`."""
        return self.__final.get("name")

    @property
    def final_cmd(self) -> list[str] | None:
        """The command line as text; None before `prepare`."""
        return self.__final.get("cmd")

    @property
    def final_cwd(self) -> str | None:
        """The working folder as text; None for the launch's folder."""
        return self.__final.get("cwd")

    @property
    def final_env(self) -> dict[str, str] | None:
        """The whole environment; None before `prepare`."""
        return self.__final.get("env")

    def prepare(self, context: LaunchContext, action: Action | None = None) -> None:
        """Perform all substitutions, and number the process."""
        pieces = [[(piece, context.perform_substitution(piece)) for piece in part] for part in self.__cmd]
        program = os.path.basename(_joined(pieces[0]))
        join = _joined_for_shell if getattr(action, "shell", False) else _joined
        cmd = [join(part) for part in pieces]
        context._process_count += 1
        name = program if self.__name is None else perform_substitutions(context, self.__name)
        prefix = split_words(perform_substitutions(context, self.__prefix))
        wanted = perform_substitutions(context, self.__prefix_filter)
        if prefix and re.match(wanted, program):
            cmd = [*prefix, *cmd]
        self.__final = {
            "name": f"{name}-{context._process_count}",
            "cmd": cmd,
            "cwd": None if self.__cwd is None else perform_substitutions(context, self.__cwd),
            "env": self.__environment(context),
        }

    def __environment(self, context: LaunchContext) -> dict[str, str]:
        environment = dict(context.environment) if self.__env is None else {}
        for key, value in [*(self.__env or []), *(self.__additional_env or [])]:
            environment[perform_substitutions(context, key)] = perform_substitutions(context, value)
        return environment


def _joined(pieces: Iterable[tuple[Substitution, str]]) -> str:
    return "".join(text for _, text in pieces)


def _joined_for_shell(pieces: Iterable[tuple[Substitution, str]]) -> str:
    """Join the texts of substitutions; the path of a program stays one word, though its folder has spaces."""
    return "".join(join_words([text]) if isinstance(piece, FindExecutable) else text for piece, text in pieces)


def _pairs(environment: SomeEnvironment | None) -> EnvironmentPairs | None:
    if environment is None:
        return None
    return [
        (normalize_to_list_of_substitutions(key), normalize_to_list_of_substitutions(value))
        for key, value in environment.items()
    ]
