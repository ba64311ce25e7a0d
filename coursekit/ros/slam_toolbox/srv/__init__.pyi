# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing

import geometry_msgs.msg
import std_msgs.msg

class AddSubmap_Request:
    def __init__(self, *, filename: str = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def filename(self) -> str: ...
    @filename.setter
    def filename(self, value: str) -> None: ...

class AddSubmap_Response:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class AddSubmap:
    Request: TypeAlias = AddSubmap_Request
    Response: TypeAlias = AddSubmap_Response

class Clear_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Clear_Response:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Clear:
    Request: TypeAlias = Clear_Request
    Response: TypeAlias = Clear_Response

class ClearQueue_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class ClearQueue_Response:
    def __init__(self, *, status: bool = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def status(self) -> bool: ...
    @status.setter
    def status(self, value: bool) -> None: ...

class ClearQueue:
    Request: TypeAlias = ClearQueue_Request
    Response: TypeAlias = ClearQueue_Response

class DeserializePoseGraph_Request:
    UNSET: ClassVar[int]
    START_AT_FIRST_NODE: ClassVar[int]
    START_AT_GIVEN_POSE: ClassVar[int]
    LOCALIZE_AT_POSE: ClassVar[int]
    def __init__(self, *, filename: str = ..., match_type: int = ..., initial_pose: geometry_msgs.msg.Pose2D = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def filename(self) -> str: ...
    @filename.setter
    def filename(self, value: str) -> None: ...
    @property
    def match_type(self) -> int: ...
    @match_type.setter
    def match_type(self, value: int) -> None: ...
    @property
    def initial_pose(self) -> geometry_msgs.msg.Pose2D: ...
    @initial_pose.setter
    def initial_pose(self, value: geometry_msgs.msg.Pose2D) -> None: ...

class DeserializePoseGraph_Response:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class DeserializePoseGraph:
    Request: TypeAlias = DeserializePoseGraph_Request
    Response: TypeAlias = DeserializePoseGraph_Response

class LoopClosure_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class LoopClosure_Response:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class LoopClosure:
    Request: TypeAlias = LoopClosure_Request
    Response: TypeAlias = LoopClosure_Response

class MergeMaps_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class MergeMaps_Response:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class MergeMaps:
    Request: TypeAlias = MergeMaps_Request
    Response: TypeAlias = MergeMaps_Response

class Pause_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Pause_Response:
    def __init__(self, *, status: bool = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def status(self) -> bool: ...
    @status.setter
    def status(self, value: bool) -> None: ...

class Pause:
    Request: TypeAlias = Pause_Request
    Response: TypeAlias = Pause_Response

class Reset_Request:
    def __init__(self, *, pause_new_measurements: bool = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def pause_new_measurements(self) -> bool: ...
    @pause_new_measurements.setter
    def pause_new_measurements(self, value: bool) -> None: ...

class Reset_Response:
    RESULT_SUCCESS: ClassVar[int]
    def __init__(self, *, result: int = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def result(self) -> int: ...
    @result.setter
    def result(self, value: int) -> None: ...

class Reset:
    Request: TypeAlias = Reset_Request
    Response: TypeAlias = Reset_Response

class SaveMap_Request:
    def __init__(self, *, name: std_msgs.msg.String = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def name(self) -> std_msgs.msg.String: ...
    @name.setter
    def name(self, value: std_msgs.msg.String) -> None: ...

class SaveMap_Response:
    RESULT_SUCCESS: ClassVar[int]
    RESULT_NO_MAP_RECEIEVD: ClassVar[int]
    RESULT_UNDEFINED_FAILURE: ClassVar[int]
    def __init__(self, *, result: int = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def result(self) -> int: ...
    @result.setter
    def result(self, value: int) -> None: ...

class SaveMap:
    Request: TypeAlias = SaveMap_Request
    Response: TypeAlias = SaveMap_Response

class SerializePoseGraph_Request:
    def __init__(self, *, filename: str = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def filename(self) -> str: ...
    @filename.setter
    def filename(self, value: str) -> None: ...

class SerializePoseGraph_Response:
    RESULT_SUCCESS: ClassVar[int]
    RESULT_FAILED_TO_WRITE_FILE: ClassVar[int]
    def __init__(self, *, result: int = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def result(self) -> int: ...
    @result.setter
    def result(self, value: int) -> None: ...

class SerializePoseGraph:
    Request: TypeAlias = SerializePoseGraph_Request
    Response: TypeAlias = SerializePoseGraph_Response

class ToggleInteractive_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class ToggleInteractive_Response:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class ToggleInteractive:
    Request: TypeAlias = ToggleInteractive_Request
    Response: TypeAlias = ToggleInteractive_Response
