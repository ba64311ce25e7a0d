"""Executes actions after a period of ROS time."""

from __future__ import annotations

import asyncio
from collections.abc import Iterable
from typing import Any

from launch.actions import TimerAction
from launch.frontend import expose_action
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities.type_utils import perform_typed_substitution

from ..ros_adapters import get_ros_node


@expose_action("ros_timer")
class ROSTimer(TimerAction):
    """Executes actions once after a period of ROS time: the time of /clock if use_sim_time was set before."""

    def __init__(
        self,
        *,
        period: float | SomeSubstitutionsType,
        actions: Iterable[LaunchDescriptionEntity],
        **kwargs: Any,
    ) -> None:
        super().__init__(period=period, actions=actions, **kwargs)
        self.__ros_timer: Any = None
        self.__cancelled = False

    def _start(self, context: LaunchContext) -> None:
        assert context.asyncio_loop is not None
        period = perform_typed_substitution(context, self.period, float)
        simulated = _wants_sim_time(context)
        # in the next loop iteration: a later setting outside groups then applies as well
        context.asyncio_loop.call_soon(lambda: self.__begin(context, period, simulated or _wants_sim_time(context)))

    def __begin(self, context: LaunchContext, period: float, simulated: bool) -> None:
        from rclpy.parameter import Parameter

        if self.__cancelled:
            return
        node = get_ros_node(context)
        node.set_parameters([Parameter("use_sim_time", value=simulated)])
        self.__ros_timer = node.create_timer(period, lambda: self.__on_timer(context), clock=node.get_clock())

    def __on_timer(self, context: LaunchContext) -> None:
        self.__ros_timer.cancel()
        loop: asyncio.AbstractEventLoop | None = context.asyncio_loop
        if loop is not None:
            loop.call_soon_threadsafe(self._fire, context)

    def cancel(self) -> None:
        """Cancel the timer."""
        self.__cancelled = True
        if self.__ros_timer is not None:
            self.__ros_timer.cancel()
        super().cancel()


def _wants_sim_time(context: LaunchContext) -> bool:
    settings: Any = context.launch_configurations.get("global_params", [])
    given: dict[str, Any] = dict(item for item in settings if isinstance(item, tuple))
    return bool(given.get("use_sim_time", False))


RosTimer = ROSTimer
