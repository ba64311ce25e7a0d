# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing

import visualization_msgs.msg

class GetInteractiveMarkers_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetInteractiveMarkers_Response:
    def __init__(self, *, sequence_number: int = ..., markers: Collection[visualization_msgs.msg.InteractiveMarker] = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def sequence_number(self) -> int: ...
    @sequence_number.setter
    def sequence_number(self, value: int) -> None: ...
    @property
    def markers(self) -> list[visualization_msgs.msg.InteractiveMarker]: ...
    @markers.setter
    def markers(self, value: Collection[visualization_msgs.msg.InteractiveMarker]) -> None: ...

class GetInteractiveMarkers:
    Request: TypeAlias = GetInteractiveMarkers_Request
    Response: TypeAlias = GetInteractiveMarkers_Response
