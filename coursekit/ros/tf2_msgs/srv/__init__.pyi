# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing


class FrameGraph_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class FrameGraph_Response:
    def __init__(self, *, frame_yaml: str = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def frame_yaml(self) -> str: ...
    @frame_yaml.setter
    def frame_yaml(self, value: str) -> None: ...

class FrameGraph:
    Request: TypeAlias = FrameGraph_Request
    Response: TypeAlias = FrameGraph_Response
