"""The base class of elements of XML and YAML launch files."""

from __future__ import annotations

from typing import Any


class Entity:
    """One element: its name, attributes and children, whatever the file's format is."""

    @property
    def type_name(self) -> str:
        """The element's name."""
        raise NotImplementedError

    @property
    def parent(self) -> Entity | None:
        """The element around this one."""
        raise NotImplementedError

    @property
    def children(self) -> list[Entity]:
        """The elements inside this one."""
        raise NotImplementedError

    @property
    def place(self) -> str:
        """The element's place, as file:line, for error messages."""
        return ""

    def assert_entity_completely_parsed(self) -> None:
        """Raise ValueError when an attribute or child of this element was never asked for."""
        raise NotImplementedError

    def get_attr(
        self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True
    ) -> Any:
        """Return an attribute as `data_type`, or None when it is optional and missing.

        `data_type` is a scalar type, a list of one (`List[int]`), `List[Entity]` for child elements,
        or None for whatever YAML's rules make of it. With `can_be_str` text that holds substitutions
        may stand for any type.

        Raises:
            AttributeError: when it is missing.
            TypeError: when it has another type.
        """
        raise NotImplementedError
