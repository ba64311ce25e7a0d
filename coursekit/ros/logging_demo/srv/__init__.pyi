# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing


class ConfigLogger_Request:
    def __init__(self, *, logger_name: str = ..., level: str = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def logger_name(self) -> str: ...
    @logger_name.setter
    def logger_name(self, value: str) -> None: ...
    @property
    def level(self) -> str: ...
    @level.setter
    def level(self, value: str) -> None: ...

class ConfigLogger_Response:
    def __init__(self, *, success: bool = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def success(self) -> bool: ...
    @success.setter
    def success(self, value: bool) -> None: ...

class ConfigLogger:
    Request: TypeAlias = ConfigLogger_Request
    Response: TypeAlias = ConfigLogger_Response
