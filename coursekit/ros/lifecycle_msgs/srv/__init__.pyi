# ruff: noqa
# fmt: off
# made by coursekit.interfaces.stubs from the definition files
from array import array
from collections.abc import Collection
from typing import Any, ClassVar, TypeAlias

import numpy
import numpy.typing

import lifecycle_msgs.msg

class ChangeState_Request:
    def __init__(self, *, transition: lifecycle_msgs.msg.Transition = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def transition(self) -> lifecycle_msgs.msg.Transition: ...
    @transition.setter
    def transition(self, value: lifecycle_msgs.msg.Transition) -> None: ...

class ChangeState_Response:
    def __init__(self, *, success: bool = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def success(self) -> bool: ...
    @success.setter
    def success(self, value: bool) -> None: ...

class ChangeState:
    Request: TypeAlias = ChangeState_Request
    Response: TypeAlias = ChangeState_Response

class GetAvailableStates_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetAvailableStates_Response:
    def __init__(self, *, available_states: Collection[lifecycle_msgs.msg.State] = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def available_states(self) -> list[lifecycle_msgs.msg.State]: ...
    @available_states.setter
    def available_states(self, value: Collection[lifecycle_msgs.msg.State]) -> None: ...

class GetAvailableStates:
    Request: TypeAlias = GetAvailableStates_Request
    Response: TypeAlias = GetAvailableStates_Response

class GetAvailableTransitions_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetAvailableTransitions_Response:
    def __init__(self, *, available_transitions: Collection[lifecycle_msgs.msg.TransitionDescription] = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def available_transitions(self) -> list[lifecycle_msgs.msg.TransitionDescription]: ...
    @available_transitions.setter
    def available_transitions(self, value: Collection[lifecycle_msgs.msg.TransitionDescription]) -> None: ...

class GetAvailableTransitions:
    Request: TypeAlias = GetAvailableTransitions_Request
    Response: TypeAlias = GetAvailableTransitions_Response

class GetState_Request:
    def __init__(self) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...

class GetState_Response:
    def __init__(self, *, current_state: lifecycle_msgs.msg.State = ...) -> None: ...
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]: ...
    @property
    def current_state(self) -> lifecycle_msgs.msg.State: ...
    @current_state.setter
    def current_state(self, value: lifecycle_msgs.msg.State) -> None: ...

class GetState:
    Request: TypeAlias = GetState_Request
    Response: TypeAlias = GetState_Response
