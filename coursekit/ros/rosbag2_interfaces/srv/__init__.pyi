# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing

import builtin_interfaces.msg

class Burst_Request:
    def __init__(self, *, num_messages: int = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def num_messages(self) -> int: ...
    @num_messages.setter
    def num_messages(self, value: int) -> None: ...

class Burst_Response:
    def __init__(self, *, actually_burst: int = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def actually_burst(self) -> int: ...
    @actually_burst.setter
    def actually_burst(self, value: int) -> None: ...

class Burst:
    Request: TypeAlias = Burst_Request
    Response: TypeAlias = Burst_Response

class GetRate_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetRate_Response:
    def __init__(self, *, rate: float = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def rate(self) -> float: ...
    @rate.setter
    def rate(self, value: float) -> None: ...

class GetRate:
    Request: TypeAlias = GetRate_Request
    Response: TypeAlias = GetRate_Response

class IsPaused_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class IsPaused_Response:
    def __init__(self, *, paused: bool = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def paused(self) -> bool: ...
    @paused.setter
    def paused(self, value: bool) -> None: ...

class IsPaused:
    Request: TypeAlias = IsPaused_Request
    Response: TypeAlias = IsPaused_Response

class Pause_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Pause_Response:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Pause:
    Request: TypeAlias = Pause_Request
    Response: TypeAlias = Pause_Response

class PlayNext_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class PlayNext_Response:
    def __init__(self, *, success: bool = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def success(self) -> bool: ...
    @success.setter
    def success(self, value: bool) -> None: ...

class PlayNext:
    Request: TypeAlias = PlayNext_Request
    Response: TypeAlias = PlayNext_Response

class Resume_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Resume_Response:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Resume:
    Request: TypeAlias = Resume_Request
    Response: TypeAlias = Resume_Response

class Seek_Request:
    def __init__(self, *, time: builtin_interfaces.msg.Time = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def time(self) -> builtin_interfaces.msg.Time: ...
    @time.setter
    def time(self, value: builtin_interfaces.msg.Time) -> None: ...

class Seek_Response:
    def __init__(self, *, success: bool = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def success(self) -> bool: ...
    @success.setter
    def success(self, value: bool) -> None: ...

class Seek:
    Request: TypeAlias = Seek_Request
    Response: TypeAlias = Seek_Response

class SetRate_Request:
    def __init__(self, *, rate: float = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def rate(self) -> float: ...
    @rate.setter
    def rate(self, value: float) -> None: ...

class SetRate_Response:
    def __init__(self, *, success: bool = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def success(self) -> bool: ...
    @success.setter
    def success(self, value: bool) -> None: ...

class SetRate:
    Request: TypeAlias = SetRate_Request
    Response: TypeAlias = SetRate_Response

class Snapshot_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Snapshot_Response:
    def __init__(self, *, success: bool = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def success(self) -> bool: ...
    @success.setter
    def success(self, value: bool) -> None: ...

class Snapshot:
    Request: TypeAlias = Snapshot_Request
    Response: TypeAlias = Snapshot_Response

class TogglePaused_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class TogglePaused_Response:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class TogglePaused:
    Request: TypeAlias = TogglePaused_Request
    Response: TypeAlias = TogglePaused_Response
