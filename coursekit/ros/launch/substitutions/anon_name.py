"""A unique name."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ..frontend.expose import expose_substitution
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


@expose_substitution("anon")
class AnonName(Substitution):
    """A name made unique; within one launch, the same name results in the same unique name."""

    def __init__(self, name: SomeSubstitutionsType) -> None:
        super().__init__()
        self.__name = normalize_to_list_of_substitutions(name)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[Substitution], dict[str, Any]]:
        """Read `$(anon name)`."""
        if len(data) != 1:
            raise TypeError("anon substitution expects 1 argument")
        return cls, {"name": data[0]}

    @property
    def name(self) -> list[Substitution]:
        """The name before it is made unique, as substitutions."""
        return self.__name

    def describe(self) -> str:
        """Return a description of the name."""
        return f"AnonName({' + '.join(sub.describe() for sub in self.__name)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the unique name, created on first use."""
        name = perform_substitutions(context, self.__name)
        key = "anon" + name
        if key not in context.launch_configurations:
            context.launch_configurations[key] = _unique(name)
        return context.launch_configurations[key]


def _unique(name: str) -> str:
    """Return `name` with two numbers from the session; they are the same in every run on the virtual clock."""
    from coursekit.processes import session

    uuid = session.current().new_uuid()
    numbers = [int.from_bytes(part, "big") for part in (uuid[:2], uuid[2:8])]
    return re.sub(r"[.:-]", "_", f"{name}_{numbers[0]}_{numbers[1]}")
