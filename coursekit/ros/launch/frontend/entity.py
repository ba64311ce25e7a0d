"""The base class of elements of XML and YAML launch files."""

from __future__ import annotations

from typing import Any


class Entity:
    """One element: its name, attributes and children, independent of the file format."""

    @property
    def type_name(self) -> str:
        """The element's name."""
        raise NotImplementedError

    @property
    def parent(self) -> Entity | None:
        """The parent element."""
        raise NotImplementedError

    @property
    def children(self) -> list[Entity]:
        """The elements inside this one."""
        raise NotImplementedError

    @property
    def place(self) -> str:
        """The element's position as file:line, for error messages."""
        return ""

    def assert_entity_completely_parsed(self) -> None:
        """Raise ValueError if an attribute or child of this element was never read."""
        raise NotImplementedError

    def get_attr(
        self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True
    ) -> Any:
        """Return an attribute as `data_type`, or None if it is optional and missing.

        `data_type` is a scalar type, a list of a scalar type (`List[int]`), `List[Entity]` for child elements,
        or None for the type by YAML's rules. With `can_be_str`, text that contains substitutions is
        accepted for any type.

        Raises:
            AttributeError: if it is missing.
            TypeError: if it has another type.
        """
        raise NotImplementedError
