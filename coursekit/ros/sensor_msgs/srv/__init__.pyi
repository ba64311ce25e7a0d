# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing

import sensor_msgs.msg

class SetCameraInfo_Request:
    def __init__(self, *, camera_info: sensor_msgs.msg.CameraInfo = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def camera_info(self) -> sensor_msgs.msg.CameraInfo: ...
    @camera_info.setter
    def camera_info(self, value: sensor_msgs.msg.CameraInfo) -> None: ...

class SetCameraInfo_Response:
    def __init__(self, *, success: bool = ..., status_message: str = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def success(self) -> bool: ...
    @success.setter
    def success(self, value: bool) -> None: ...
    @property
    def status_message(self) -> str: ...
    @status_message.setter
    def status_message(self, value: str) -> None: ...

class SetCameraInfo:
    Request: TypeAlias = SetCameraInfo_Request
    Response: TypeAlias = SetCameraInfo_Response
