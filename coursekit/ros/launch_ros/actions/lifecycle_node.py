"""Starts a lifecycle node."""

from __future__ import annotations

from typing import Any, cast

from launch.event import Event
from launch.event_handler import EventHandler
from launch.frontend import expose_action
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.logging import get_logger
from launch.some_substitutions_type import SomeSubstitutionsType

from ..events.lifecycle import ChangeState, StateTransition
from ..ros_adapters import get_ros_node
from ..utilities.service_call import call_service
from .node import Node


@expose_action("lifecycle_node")
class LifecycleNode(Node):
    """Starts a lifecycle node, emits StateTransition when its state changes, and handles ChangeState."""

    def __init__(
        self, *, name: SomeSubstitutionsType, namespace: SomeSubstitutionsType, **kwargs: Any
    ) -> None:
        super().__init__(name=name, namespace=namespace, **kwargs)
        self.__client: Any = None
        self.__subscription: Any = None

    @property
    def is_lifecycle_node(self) -> bool:
        """Always True."""
        return True

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Start the node and subscribe to its transitions."""
        import lifecycle_msgs.msg
        import lifecycle_msgs.srv

        self._perform_substitutions(context)
        node = get_ros_node(context)
        self.__subscription = node.create_subscription(
            lifecycle_msgs.msg.TransitionEvent,
            f"{self.node_name}/transition_event",
            lambda msg: self.__on_transition(context, msg),
            10,
        )
        self.__client = node.create_client(lifecycle_msgs.srv.ChangeState, f"{self.node_name}/change_state")
        context.register_event_handler(
            EventHandler(matcher=self.__wants, entities=self.__change, _event_class=ChangeState)
        )
        return super().execute(context)

    def __wants(self, event: Event) -> bool:
        return isinstance(event, ChangeState) and event.lifecycle_node_matcher(self)

    def __on_transition(self, context: LaunchContext, msg: Any) -> None:
        event = StateTransition(action=self, msg=msg)
        if context.asyncio_loop is not None:
            context.asyncio_loop.call_soon_threadsafe(context.emit_event_sync, event)

    def __change(self, event: Event, context: LaunchContext) -> None:
        assert context.asyncio_loop is not None
        transition_id = cast(ChangeState, event).transition_id
        context.add_completion_future(
            context.asyncio_loop.run_in_executor(None, self.__call, transition_id, context)
        )

    def __call(self, transition_id: int, context: LaunchContext) -> None:
        """Request the transition from the node, in a separate execution context; a shutdown ends the wait."""
        from lifecycle_msgs.srv import ChangeState as ChangeStateService

        logger = get_logger("launch_ros.actions.lifecycle_node")
        request = ChangeStateService.Request()
        request.transition.id = transition_id
        answer = call_service(self.__client, request, context, logger)
        if answer is not None and not answer.success:
            logger.error(
                f"Failed to make transition '{ChangeState.valid_transitions[transition_id]}' "
                f"for LifecycleNode '{self.node_name}'"
            )
