# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing

import diagnostic_msgs.msg

class AddDiagnostics_Request:
    def __init__(self, *, load_namespace: str = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def load_namespace(self) -> str: ...
    @load_namespace.setter
    def load_namespace(self, value: str) -> None: ...

class AddDiagnostics_Response:
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

class AddDiagnostics:
    Request: TypeAlias = AddDiagnostics_Request
    Response: TypeAlias = AddDiagnostics_Response

class SelfTest_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class SelfTest_Response:
    def __init__(self, *, id: str = ..., passed: bytes = ..., status: Collection[diagnostic_msgs.msg.DiagnosticStatus] = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def id(self) -> str: ...
    @id.setter
    def id(self, value: str) -> None: ...
    @property
    def passed(self) -> bytes: ...
    @passed.setter
    def passed(self, value: bytes) -> None: ...
    @property
    def status(self) -> list[diagnostic_msgs.msg.DiagnosticStatus]: ...
    @status.setter
    def status(self, value: Collection[diagnostic_msgs.msg.DiagnosticStatus]) -> None: ...

class SelfTest:
    Request: TypeAlias = SelfTest_Request
    Response: TypeAlias = SelfTest_Response
