"""Launch files of a known markup language."""

from __future__ import annotations

from ..frontend import Parser
from ..some_substitutions_type import SomeSubstitutionsType
from .frontend_launch_description_source import FrontendLaunchDescriptionSource


class XMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """An XML launch file."""

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(
            launch_file_path,
            method="interpreted XML launch file",
            parser=Parser.get_parser_from_extension("xml"),
        )


class YAMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """A YAML launch file."""

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(
            launch_file_path,
            method="interpreted YAML launch file",
            parser=Parser.get_parser_from_extension("yaml"),
        )
