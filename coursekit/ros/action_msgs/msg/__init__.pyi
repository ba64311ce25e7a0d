# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing

import action_msgs.msg
import builtin_interfaces.msg
import unique_identifier_msgs.msg

class GoalInfo:
    def __init__(self, *, goal_id: unique_identifier_msgs.msg.UUID = ..., stamp: builtin_interfaces.msg.Time = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def goal_id(self) -> unique_identifier_msgs.msg.UUID: ...
    @goal_id.setter
    def goal_id(self, value: unique_identifier_msgs.msg.UUID) -> None: ...
    @property
    def stamp(self) -> builtin_interfaces.msg.Time: ...
    @stamp.setter
    def stamp(self, value: builtin_interfaces.msg.Time) -> None: ...

class GoalStatus:
    STATUS_UNKNOWN: ClassVar[int]
    STATUS_ACCEPTED: ClassVar[int]
    STATUS_EXECUTING: ClassVar[int]
    STATUS_CANCELING: ClassVar[int]
    STATUS_SUCCEEDED: ClassVar[int]
    STATUS_CANCELED: ClassVar[int]
    STATUS_ABORTED: ClassVar[int]
    def __init__(self, *, goal_info: action_msgs.msg.GoalInfo = ..., status: int = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def goal_info(self) -> action_msgs.msg.GoalInfo: ...
    @goal_info.setter
    def goal_info(self, value: action_msgs.msg.GoalInfo) -> None: ...
    @property
    def status(self) -> int: ...
    @status.setter
    def status(self, value: int) -> None: ...

class GoalStatusArray:
    def __init__(self, *, status_list: Collection[action_msgs.msg.GoalStatus] = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def status_list(self) -> list[action_msgs.msg.GoalStatus]: ...
    @status_list.setter
    def status_list(self, value: Collection[action_msgs.msg.GoalStatus]) -> None: ...
