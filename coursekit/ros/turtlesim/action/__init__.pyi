# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing


class RotateAbsolute_Goal:
    def __init__(self, *, theta: float = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def theta(self) -> float: ...
    @theta.setter
    def theta(self, value: float) -> None: ...

class RotateAbsolute_Result:
    def __init__(self, *, delta: float = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def delta(self) -> float: ...
    @delta.setter
    def delta(self, value: float) -> None: ...

class RotateAbsolute_Feedback:
    def __init__(self, *, remaining: float = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def remaining(self) -> float: ...
    @remaining.setter
    def remaining(self, value: float) -> None: ...

class RotateAbsolute:
    Goal: TypeAlias = RotateAbsolute_Goal
    Result: TypeAlias = RotateAbsolute_Result
    Feedback: TypeAlias = RotateAbsolute_Feedback
    Impl: ClassVar[Any]
