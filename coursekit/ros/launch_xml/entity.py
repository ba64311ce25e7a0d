"""Elements of XML launch files."""

from __future__ import annotations

from typing import Any

from launch import frontend
from launch.frontend.type_utils import check_is_list_entity, get_typed_value

from .element import as_element


class Entity(frontend.Entity):
    """One XML element; attributes are text that is converted to the requested type."""

    def __init__(self, xml_element: Any, *, parent: Entity | None = None) -> None:
        self.__element = as_element(xml_element)
        self.__parent = parent
        self.__read_attributes: set[str] = set()
        self.__read_children: set[str] = set()

    @property
    def type_name(self) -> str:
        """The tag."""
        return self.__element.tag

    @property
    def parent(self) -> Entity | None:
        """The parent element."""
        return self.__parent

    @property
    def place(self) -> str:
        """The element's position as file:line."""
        return self.__element.place

    @property
    def children(self) -> list[frontend.Entity]:
        """The elements inside this one."""
        self.__read_children.update(child.tag for child in self.__element.children)
        return [Entity(child, parent=self) for child in self.__element.children]

    def assert_entity_completely_parsed(self) -> None:
        """Raise ValueError if an attribute or nested tag was never read."""
        tags = [child.tag for child in self.__element.children if child.tag not in self.__read_children]
        if tags:
            raise ValueError(f"Unexpected nested tag(s) found in `{self.type_name}`: {set(tags)}")
        names = [name for name in self.__element.attrib if name not in self.__read_attributes]
        if names:
            raise ValueError(f"Unexpected attribute(s) found in `{self.type_name}`: {set(names)}")

    def get_attr(
        self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True
    ) -> Any:
        """Return an attribute, or child elements, as `data_type`; see the base class."""
        if check_is_list_entity(data_type):
            return self.__child_entities(name, optional)
        if name not in self.__element.attrib:
            self.__complain(name, data_type, optional)
            return None
        value = self.__attribute(name)
        texts = [value] if isinstance(value, str) else value
        # Without a type, text that is no YAML, such as @home, stays text. With a type it is refused, unless it has a
        # substitution: then its value is read when it is known.
        may_stay_text = can_be_str and (data_type is None or any("$(" in text for text in texts))
        try:
            return get_typed_value(value, data_type, can_be_str=may_stay_text)
        except ValueError as error:
            raise TypeError(
                f"Attribute '{name}' of Entity '{self.type_name}' expected to be of type '{data_type}'. "
                f"'{value}' can not be converted to one of those types"
            ) from error

    def __attribute(self, name: str) -> str | list[str]:
        """Return an attribute's text, split at the separator in `name-sep` if that is given."""
        self.__read_attributes.update((name, name + "-sep"))
        text = self.__element.attrib[name]
        separator = self.__element.attrib.get(name + "-sep")
        return text if separator is None else text.split(separator)

    def __child_entities(self, name: str, optional: bool) -> list[Entity] | None:
        children = [child for child in self.__element.children if child.tag == name]
        if not children:
            self.__complain(name, "a nested tag", optional)
            return None
        self.__read_children.add(name)
        return [Entity(child, parent=self) for child in children]

    def __complain(self, name: str, data_type: Any, optional: bool) -> None:
        if not optional:
            raise AttributeError(
                f"Attribute '{name}' of type '{data_type}' not found in Entity '{self.type_name}'"
            )
