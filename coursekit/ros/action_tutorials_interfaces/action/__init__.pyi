# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing


class Fibonacci_Goal:
    def __init__(self, *, order: int = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def order(self) -> int: ...
    @order.setter
    def order(self, value: int) -> None: ...

class Fibonacci_Result:
    def __init__(self, *, sequence: Collection[int] = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def sequence(self) -> array[int]: ...
    @sequence.setter
    def sequence(self, value: Collection[int]) -> None: ...

class Fibonacci_Feedback:
    def __init__(self, *, partial_sequence: Collection[int] = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def partial_sequence(self) -> array[int]: ...
    @partial_sequence.setter
    def partial_sequence(self, value: Collection[int]) -> None: ...

class Fibonacci:
    Goal: TypeAlias = Fibonacci_Goal
    Result: TypeAlias = Fibonacci_Result
    Feedback: TypeAlias = Fibonacci_Feedback
    Impl: ClassVar[Any]
