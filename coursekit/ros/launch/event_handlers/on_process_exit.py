"""The handler for processes that end."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ..events.process import ProcessExited
from ..some_entities_type import SomeEntitiesType
from .on_action_event_base import OnActionEventBase

if TYPE_CHECKING:
    from ..actions.execute_local import ExecuteLocal


class OnProcessExit(OnActionEventBase):
    """Reacts when a process ends: the target's process, or any.

    >>> from launch.actions import ExecuteProcess, LogInfo, RegisterEventHandler
    >>> spawn = ExecuteProcess(cmd=["ros2", "run", "gazebo_ros", "spawn_entity.py"])
    >>> then = OnProcessExit(target_action=spawn, on_exit=[LogInfo(msg="the robot is there")])
    >>> RegisterEventHandler(then).event_handler is then
    True
    """

    def __init__(
        self,
        *,
        target_action: ExecuteLocal | Callable[[ExecuteLocal], bool] | None = None,
        on_exit: SomeEntitiesType | Callable[..., SomeEntitiesType | None] | None,
        **kwargs: Any,
    ) -> None:
        from ..actions.execute_local import ExecuteLocal

        super().__init__(
            action_matcher=target_action,  # type: ignore[arg-type]
            on_event=on_exit,
            target_event_cls=ProcessExited,
            target_action_cls=ExecuteLocal,
            **kwargs,
        )
