# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing


class Empty_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Empty_Response:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Empty:
    Request: TypeAlias = Empty_Request
    Response: TypeAlias = Empty_Response

class SetBool_Request:
    def __init__(self, *, data: bool = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def data(self) -> bool: ...
    @data.setter
    def data(self, value: bool) -> None: ...

class SetBool_Response:
    def __init__(self, *, success: bool = ..., message: str = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def success(self) -> bool: ...
    @success.setter
    def success(self, value: bool) -> None: ...
    @property
    def message(self) -> str: ...
    @message.setter
    def message(self, value: str) -> None: ...

class SetBool:
    Request: TypeAlias = SetBool_Request
    Response: TypeAlias = SetBool_Response

class Trigger_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class Trigger_Response:
    def __init__(self, *, success: bool = ..., message: str = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def success(self) -> bool: ...
    @success.setter
    def success(self, value: bool) -> None: ...
    @property
    def message(self) -> str: ...
    @message.setter
    def message(self, value: str) -> None: ...

class Trigger:
    Request: TypeAlias = Trigger_Request
    Response: TypeAlias = Trigger_Response
