"""Normalizes the many forms of a value to a list."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from ..launch_description_entity import LaunchDescriptionEntity
from ..some_entities_type import SomeEntitiesType
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution


def normalize_to_list_of_substitutions(subs: SomeSubstitutionsType) -> list[Substitution]:
    """Return text, a substitution or a list of both as a list of substitutions.

    Raises:
        TypeError: if it contains anything else.
    """
    from ..substitutions.text_substitution import TextSubstitution

    def one(item: Any) -> Substitution:
        if isinstance(item, Substitution):
            return item
        if isinstance(item, (str, Path)):
            return TextSubstitution(text=str(item))
        raise TypeError(
            "Failed to normalize given item of type "
            f"'{type(item)}', when only 'str' or 'launch.Substitution' were expected."
        )

    if isinstance(subs, (str, Path, Substitution)):
        return [one(subs)]
    if isinstance(subs, Iterable):
        return [one(item) for item in subs]
    raise TypeError(f"'{subs}' is not a valid SomeSubstitutionsType.")


def normalize_to_list_of_entities(
    entities: SomeEntitiesType | Iterable[SomeEntitiesType],
) -> list[LaunchDescriptionEntity]:
    """Return one entity, or arbitrarily nested lists of entities, as one flat list."""
    if isinstance(entities, LaunchDescriptionEntity):
        return [entities]
    flat: list[LaunchDescriptionEntity] = []
    for item in entities:
        flat += normalize_to_list_of_entities(item)
    return flat
