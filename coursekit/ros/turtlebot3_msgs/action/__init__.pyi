# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing

import geometry_msgs.msg

class Patrol_Goal:
    def __init__(self, *, goal: geometry_msgs.msg.Vector3 = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def goal(self) -> geometry_msgs.msg.Vector3: ...
    @goal.setter
    def goal(self, value: geometry_msgs.msg.Vector3) -> None: ...

class Patrol_Result:
    def __init__(self, *, result: str = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def result(self) -> str: ...
    @result.setter
    def result(self, value: str) -> None: ...

class Patrol_Feedback:
    def __init__(self, *, state: str = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def state(self) -> str: ...
    @state.setter
    def state(self, value: str) -> None: ...

class Patrol:
    Goal: TypeAlias = Patrol_Goal
    Result: TypeAlias = Patrol_Result
    Feedback: TypeAlias = Patrol_Feedback
    Impl: ClassVar[Any]
