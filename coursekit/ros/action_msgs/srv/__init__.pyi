# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing

import action_msgs.msg

class CancelGoal_Request:
    def __init__(self, *, goal_info: action_msgs.msg.GoalInfo = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def goal_info(self) -> action_msgs.msg.GoalInfo: ...
    @goal_info.setter
    def goal_info(self, value: action_msgs.msg.GoalInfo) -> None: ...

class CancelGoal_Response:
    ERROR_NONE: ClassVar[int]
    ERROR_REJECTED: ClassVar[int]
    ERROR_UNKNOWN_GOAL_ID: ClassVar[int]
    ERROR_GOAL_TERMINATED: ClassVar[int]
    def __init__(self, *, return_code: int = ..., goals_canceling: Collection[action_msgs.msg.GoalInfo] = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def return_code(self) -> int: ...
    @return_code.setter
    def return_code(self, value: int) -> None: ...
    @property
    def goals_canceling(self) -> list[action_msgs.msg.GoalInfo]: ...
    @goals_canceling.setter
    def goals_canceling(self, value: Collection[action_msgs.msg.GoalInfo]) -> None: ...

class CancelGoal:
    Request: TypeAlias = CancelGoal_Request
    Response: TypeAlias = CancelGoal_Response
