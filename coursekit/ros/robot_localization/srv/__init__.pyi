# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing

import builtin_interfaces.msg
import geometry_msgs.msg

class GetState_Request:
    def __init__(self, *, time_stamp: builtin_interfaces.msg.Time = ..., frame_id: str = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def time_stamp(self) -> builtin_interfaces.msg.Time: ...
    @time_stamp.setter
    def time_stamp(self, value: builtin_interfaces.msg.Time) -> None: ...
    @property
    def frame_id(self) -> str: ...
    @frame_id.setter
    def frame_id(self, value: str) -> None: ...

class GetState_Response:
    def __init__(self, *, state: Collection[float] | numpy.typing.NDArray[Any] = ..., covariance: Collection[float] | numpy.typing.NDArray[Any] = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def state(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @state.setter
    def state(self, value: Collection[float] | numpy.typing.NDArray[Any]) -> None: ...
    @property
    def covariance(self) -> numpy.typing.NDArray[numpy.float64]: ...
    @covariance.setter
    def covariance(self, value: Collection[float] | numpy.typing.NDArray[Any]) -> None: ...

class GetState:
    Request: TypeAlias = GetState_Request
    Response: TypeAlias = GetState_Response

class SetPose_Request:
    def __init__(self, *, pose: geometry_msgs.msg.PoseWithCovarianceStamped = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def pose(self) -> geometry_msgs.msg.PoseWithCovarianceStamped: ...
    @pose.setter
    def pose(self, value: geometry_msgs.msg.PoseWithCovarianceStamped) -> None: ...

class SetPose_Response:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SetPose:
    Request: TypeAlias = SetPose_Request
    Response: TypeAlias = SetPose_Response

class ToggleFilterProcessing_Request:
    def __init__(self, *, on: bool = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def on(self) -> bool: ...
    @on.setter
    def on(self, value: bool) -> None: ...

class ToggleFilterProcessing_Response:
    def __init__(self, *, status: bool = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def status(self) -> bool: ...
    @status.setter
    def status(self, value: bool) -> None: ...

class ToggleFilterProcessing:
    Request: TypeAlias = ToggleFilterProcessing_Request
    Response: TypeAlias = ToggleFilterProcessing_Response
