"""An action that runs pytest."""

from __future__ import annotations

import sys
from typing import Any

from launch.some_substitutions_type import SomeSubstitutionsType

from .test import Test


class PyTest(Test):
    """Starts pytest on `path` with this interpreter; other arguments are those of `Test`."""

    def __init__(self, *, path: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(cmd=[sys.executable, "-m", "pytest", path], **kwargs)
        self.__path = path

    @property
    def path(self) -> SomeSubstitutionsType:
        """The file or folder with the tests."""
        return self.__path
