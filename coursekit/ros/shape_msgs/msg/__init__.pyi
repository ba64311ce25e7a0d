# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing

import geometry_msgs.msg
import shape_msgs.msg

class Mesh:
    def __init__(self, *, triangles: Collection[shape_msgs.msg.MeshTriangle] = ..., vertices: Collection[geometry_msgs.msg.Point] = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def triangles(self) -> list[shape_msgs.msg.MeshTriangle]: ...
    @triangles.setter
    def triangles(self, value: Collection[shape_msgs.msg.MeshTriangle]) -> None: ...
    @property
    def vertices(self) -> list[geometry_msgs.msg.Point]: ...
    @vertices.setter
    def vertices(self, value: Collection[geometry_msgs.msg.Point]) -> None: ...

class MeshTriangle:
    def __init__(self, *, vertex_indices: Collection[int] | numpy.typing.NDArray[Any] = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def vertex_indices(self) -> numpy.typing.NDArray[numpy.uint32]: ...
    @vertex_indices.setter
    def vertex_indices(self, value: Collection[int] | numpy.typing.NDArray[Any]) -> None: ...

class Plane:
    def __init__(self, *, coef: Collection[float] | numpy.typing.NDArray[Any] = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def coef(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @coef.setter
    def coef(self, value: Collection[float] | numpy.typing.NDArray[Any]) -> None: ...

class SolidPrimitive:
    BOX: ClassVar[int]
    SPHERE: ClassVar[int]
    CYLINDER: ClassVar[int]
    CONE: ClassVar[int]
    PRISM: ClassVar[int]
    BOX_X: ClassVar[int]
    BOX_Y: ClassVar[int]
    BOX_Z: ClassVar[int]
    SPHERE_RADIUS: ClassVar[int]
    CYLINDER_HEIGHT: ClassVar[int]
    CYLINDER_RADIUS: ClassVar[int]
    CONE_HEIGHT: ClassVar[int]
    CONE_RADIUS: ClassVar[int]
    PRISM_HEIGHT: ClassVar[int]
    def __init__(self, *, type: int = ..., dimensions: Collection[float] = ..., polygon: geometry_msgs.msg.Polygon = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def type(self) -> int: ...
    @type.setter
    def type(self, value: int) -> None: ...
    @property
    def dimensions(self) -> array[float]: ...
    @dimensions.setter
    def dimensions(self, value: Collection[float]) -> None: ...
    @property
    def polygon(self) -> geometry_msgs.msg.Polygon: ...
    @polygon.setter
    def polygon(self, value: geometry_msgs.msg.Polygon) -> None: ...
