"""Elements of YAML launch files."""

from __future__ import annotations

from typing import Any

from launch import frontend
from launch.frontend.type_utils import check_is_list_entity
from launch.utilities.type_utils import is_instance_of


class Entity(frontend.Entity):
    """One element of a YAML launch file: `name: attributes`."""

    def __init__(
        self,
        element: Any,
        type_name: str | None = None,
        *,
        parent: Entity | None = None,
        file_name: str = "",
    ) -> None:
        self.__line = getattr(element, "line", parent.line if parent is not None else 1)
        self.__file_name = file_name
        self.__parent = parent
        if type_name is None:
            type_name, element = self.__only_item(element)
        self.__type_name = type_name
        self.__element = element
        self.__read_keys: set[str] = set()
        self.__children_called = False

    def __only_item(self, element: Any) -> tuple[str, Any]:
        if not isinstance(element, dict) or len(element) != 1:
            raise RuntimeError(
                f"{self.place}: expected one 'name: attributes' after the dash, got {element!r}; "
                "indent the attributes below the name"
            )
        ((type_name, value),) = element.items()
        return type_name, value

    @property
    def type_name(self) -> str:
        """The element's name."""
        return self.__type_name

    @property
    def parent(self) -> Entity | None:
        """The parent element."""
        return self.__parent

    @property
    def line(self) -> int:
        """The line in which this element starts."""
        return int(self.__line)

    @property
    def place(self) -> str:
        """The element's position as file:line."""
        return f"{self.__file_name}:{self.__line}"

    @property
    def children(self) -> list[frontend.Entity]:
        """The elements inside this one."""
        self.__children_called = True
        children = self.__element
        if isinstance(children, dict):
            if "children" not in children:
                raise ValueError(f"Expected entity `{self.type_name}` to have children entities.")
            self.__read_keys.add("children")
            children = children["children"]
        if not isinstance(children, list):
            raise TypeError(f"Expected `{self.type_name}` to hold a list, got {type(children).__name__}")
        return [Entity(child, parent=self, file_name=self.__file_name) for child in children]

    def assert_entity_completely_parsed(self) -> None:
        """Raise ValueError if a key was never read."""
        if isinstance(self.__element, list):
            if not self.__children_called:
                raise ValueError(
                    f"Unexpected nested entity(ies) found in `{self.type_name}`: {self.__element}"
                )
            return
        keys = [key for key in self.__element if key not in self.__read_keys]
        if keys:
            raise ValueError(f"Unexpected key(s) found in `{self.type_name}`: {set(keys)}")

    def get_attr(
        self, name: str, *, data_type: Any = str, optional: bool = False, can_be_str: bool = True
    ) -> Any:
        """Return an attribute, or child elements, as `data_type`; see the base class."""
        if not isinstance(self.__element, dict) or name not in self.__element:
            if optional:
                return None
            raise AttributeError(f"Can not find attribute {name} in Entity {self.type_name}")
        self.__read_keys.add(name)
        value = self.__element[name]
        if check_is_list_entity(data_type):
            return self.__entities(name, value)
        return self.__typed(name, value, data_type, can_be_str)

    def __entities(self, name: str, value: Any) -> list[Entity]:
        if not isinstance(value, list) or not all(isinstance(item, dict) for item in value):
            raise TypeError(
                f"Attribute {name} of Entity {self.type_name} expected to be a list of dictionaries."
            )
        return [Entity(item, name, parent=self, file_name=self.__file_name) for item in value]

    def __typed(self, name: str, value: Any, data_type: Any, can_be_str: bool) -> Any:
        if not is_instance_of(value, data_type, can_be_str=can_be_str):
            advice = f"write {value}.0" if data_type is float and type(value) is int else "text needs quotes"
            raise TypeError(
                f"Attribute '{name}' of Entity '{self.type_name}' expected to be of type '{data_type}', "
                f"got '{value}' ({type(value).__name__}); {advice}"
            )
        return value
