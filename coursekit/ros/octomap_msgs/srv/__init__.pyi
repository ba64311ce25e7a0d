# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing

import geometry_msgs.msg
import octomap_msgs.msg

class BoundingBoxQuery_Request:
    def __init__(self, *, min: geometry_msgs.msg.Point = ..., max: geometry_msgs.msg.Point = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def min(self) -> geometry_msgs.msg.Point: ...
    @min.setter
    def min(self, value: geometry_msgs.msg.Point) -> None: ...
    @property
    def max(self) -> geometry_msgs.msg.Point: ...
    @max.setter
    def max(self, value: geometry_msgs.msg.Point) -> None: ...

class BoundingBoxQuery_Response:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class BoundingBoxQuery:
    Request: TypeAlias = BoundingBoxQuery_Request
    Response: TypeAlias = BoundingBoxQuery_Response

class GetOctomap_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetOctomap_Response:
    def __init__(self, *, map: octomap_msgs.msg.Octomap = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def map(self) -> octomap_msgs.msg.Octomap: ...
    @map.setter
    def map(self, value: octomap_msgs.msg.Octomap) -> None: ...

class GetOctomap:
    Request: TypeAlias = GetOctomap_Request
    Response: TypeAlias = GetOctomap_Response
