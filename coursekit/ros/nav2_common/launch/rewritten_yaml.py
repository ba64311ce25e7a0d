"""A copy of a parameter file with other values."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import yaml
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.temporary_files import temporary_files
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

from coursekit.files import installed

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class RewrittenYaml(Substitution):
    """The name of a copy of `source_file` with rewritten values and renamed keys, nested under `root_key`.

    `param_rewrites` names a key at any depth, or one key by its path (`amcl.ros__parameters.min_particles`). Values
    are texts. `true` and `false` become booleans; with `convert_types`, numeric texts become numbers.
    """

    def __init__(
        self,
        source_file: SomeSubstitutionsType,
        param_rewrites: Mapping[str, SomeSubstitutionsType],
        root_key: SomeSubstitutionsType | None = None,
        key_rewrites: Mapping[str, SomeSubstitutionsType] | None = None,
        convert_types: bool = False,
    ) -> None:
        super().__init__()
        self.__source_file = normalize_to_list_of_substitutions(source_file)
        self.__values = {key: normalize_to_list_of_substitutions(to) for key, to in dict(param_rewrites).items()}
        self.__keys = {key: normalize_to_list_of_substitutions(to) for key, to in (key_rewrites or {}).items()}
        self.__root = None if root_key is None else normalize_to_list_of_substitutions(root_key)
        self.__convert_types = convert_types

    @property
    def name(self) -> list[Substitution]:
        """The file, as substitutions."""
        return self.__source_file

    def describe(self) -> str:
        """Return the substitution in words."""
        return f"RewrittenYaml({', '.join(sub.describe() for sub in self.__source_file)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the name of the new file."""
        with open(installed(perform_substitutions(context, self.__source_file)), encoding="utf-8") as file:
            data = yaml.safe_load(file)
        values = {key: perform_substitutions(context, to) for key, to in self.__values.items()}
        keys = {key: perform_substitutions(context, to) for key, to in self.__keys.items()}
        data = self._rewritten(data, values, keys, "")
        root = "" if self.__root is None else perform_substitutions(context, self.__root)
        path = temporary_files.new_path("rewritten_")
        with open(path, "w", encoding="utf-8") as file:
            yaml.safe_dump({root: data} if root else data, file)
        return path

    def _rewritten(self, data: Any, values: dict[str, str], keys: dict[str, str], path: str) -> Any:
        if not isinstance(data, dict):
            return data
        rewritten = {}
        for key, value in data.items():
            here = f"{path}.{key}" if path else str(key)
            text = values.get(here, values.get(key))
            if text is None or isinstance(value, dict):
                value = self._rewritten(value, values, keys, here)
            else:
                value = self._typed(text)
            rewritten[keys.get(key, key)] = value
        return rewritten

    def _typed(self, text: str) -> Any:
        if self.__convert_types:
            try:
                return float(text) if "." in text else int(text)
            except ValueError:
                pass
        return {"true": True, "false": False}.get(text.lower(), text)
