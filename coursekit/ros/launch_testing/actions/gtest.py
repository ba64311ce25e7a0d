"""An action that runs a GTest program."""

from __future__ import annotations

from typing import Any

from launch.some_substitutions_type import SomeSubstitutionsType

from .test import Test


class GTest(Test):
    """Starts the GTest program at `path`; other arguments are those of `Test`."""

    def __init__(self, *, path: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(cmd=[path], **kwargs)
        self.__path = path

    @property
    def path(self) -> SomeSubstitutionsType:
        """The path of the program."""
        return self.__path
