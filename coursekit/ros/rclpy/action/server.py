"""Action servers. In ROS 2: rclpy.action.server."""

from __future__ import annotations

import threading
import traceback
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from action_msgs.msg import GoalInfo, GoalStatus, GoalStatusArray
from action_msgs.srv import CancelGoal

from coursekit.processes import session
from rclpy._one_type import check_action_type
from rclpy._parts_wait import PartsWait
from rclpy._rclpy_pybind11 import RCLError
from rclpy.action.defaults import (
    CancelResponse,
    GoalResponse,
    default_cancel_callback,
    default_goal_callback,
    default_handle_accepted_callback,
)
from rclpy.action.goal_handle import ServerGoalHandle
from rclpy.action.goal_state import TERMINAL, GoalEvent
from rclpy.action.names import action_names
from rclpy.action.to_cancel import goals_to_cancel
from rclpy.executors import await_or_execute
from rclpy.qos import QoSProfile, qos_profile_action_status_default, qos_profile_services_default
from rclpy.task import Future
from rclpy.type_support import check_for_type_support
from rclpy.waitable import NumberOfEntities

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.node import Node


class ActionServer(PartsWait):
    """Serves an action: three services and two topics below `<action_name>/_action/`.

    `execute_callback(goal_handle)` does the work and returns the action's Result. `goal_callback(goal)` accepts or
    rejects a goal, `handle_accepted_callback(goal_handle)` decides when to execute it, and
    `cancel_callback(goal_handle)` whether it may be cancelled. A result is kept for `result_timeout` seconds.

    >>> from example_interfaces.action import Fibonacci
    >>> def execute(goal_handle):
    ...     numbers = [0, 1]
    ...     for _ in range(goal_handle.request.order - 1):
    ...         numbers.append(numbers[-1] + numbers[-2])
    ...         goal_handle.publish_feedback(Fibonacci.Feedback(sequence=numbers))
    ...     goal_handle.succeed()
    ...     return Fibonacci.Result(sequence=numbers)
    >>> server = ActionServer(node, Fibonacci, "fibonacci", execute)
    >>> future = rclpy.action.ActionClient(node, Fibonacci, "fibonacci").send_goal_async(Fibonacci.Goal(order=5))
    >>> rclpy.spin_until_future_complete(node, future)
    >>> result = future.result().get_result_async()
    >>> rclpy.spin_until_future_complete(node, result)
    >>> list(result.result().result.sequence)
    [0, 1, 1, 2, 3, 5]
    """

    def __init__(
        self,
        node: Node,
        action_type: type[Any],
        action_name: str,
        execute_callback: Callable[[ServerGoalHandle], Any],
        *,
        callback_group: CallbackGroup | None = None,
        goal_callback: Callable[[Any], Any] = default_goal_callback,
        handle_accepted_callback: Callable[[ServerGoalHandle], Any] = default_handle_accepted_callback,
        cancel_callback: Callable[[ServerGoalHandle], Any] = default_cancel_callback,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_pub_qos_profile: QoSProfile = QoSProfile(depth=10),
        status_pub_qos_profile: QoSProfile = qos_profile_action_status_default,
        result_timeout: float = 900,
    ) -> None:
        group = node.default_callback_group if callback_group is None else callback_group
        super().__init__(group)
        self.register_handle_accepted_callback(handle_accepted_callback)
        self.register_goal_callback(goal_callback)
        self.register_cancel_callback(cancel_callback)
        self.register_execute_callback(execute_callback)
        check_for_type_support(action_type)
        self._node = node
        self._action_type = action_type
        self._result_timeout = result_timeout
        self._lock = threading.RLock()
        self._goal_handles: dict[bytes, ServerGoalHandle] = {}
        self._result_futures: dict[bytes, Future] = {}
        self._ended: dict[bytes, Any] = {}
        self._logger = node.get_logger().get_child("action_server")
        names, impl = action_names("server", action_name), action_type.Impl
        check_action_type(node.handle, "server", names.send_goal, impl.SendGoalService)
        self._feedback_publisher = node.create_publisher(
            impl.FeedbackMessage, names.feedback, feedback_pub_qos_profile, callback_group=group
        )
        self._status_publisher = node.create_publisher(
            GoalStatusArray, names.status, status_pub_qos_profile, callback_group=group
        )
        self._services: list[Any] = []
        self._serve(impl.SendGoalService, names.send_goal, self._goal_asked, goal_service_qos_profile)
        self._serve(CancelGoal, names.cancel_goal, self._cancel_asked, cancel_service_qos_profile)
        self._serve(impl.GetResultService, names.get_result, self._result_asked, result_service_qos_profile)

    def _serve(self, type_: Any, name: str, answer: Callable[..., Any], qos: QoSProfile) -> None:
        """Create a service; `answer(service, request, header)` may respond to a request at any time."""
        service: Any = self._node.create_service(
            type_, name, _unused, qos_profile=qos, callback_group=self.callback_group
        )
        service._answer = lambda request, header: answer(service, request, header)
        self._services.append(service)

    # -- goals

    async def _goal_asked(self, service: Any, request: Any, header: Any) -> None:
        handle = await self._accepted(request)
        response = self._action_type.Impl.SendGoalService.Response(accepted=handle is not None)
        if handle is not None:
            response.stamp = handle._goal_info.stamp
        service.send_response(response, header)
        if handle is not None:
            await await_or_execute(self._handle_accepted_callback, handle)

    async def _accepted(self, request: Any) -> ServerGoalHandle | None:
        """The handle of the goal, if its id is new and the goal callback accepts it."""
        key = bytes(request.goal_id.uuid)
        if key in self._goal_handles:
            return None
        answer = await await_or_execute(self._goal_callback, request.goal)
        if not isinstance(answer, GoalResponse):
            self._logger.warning("Goal request callback did not return a GoalResponse type. Rejecting goal.")
        if answer is not GoalResponse.ACCEPT:
            self._logger.debug(f"New goal rejected: {request.goal_id.uuid}")
            return None
        stamp = self._node.get_clock().now().to_msg()
        with self._lock:
            if key in self._goal_handles:
                return None
            handle = ServerGoalHandle(self, GoalInfo(goal_id=request.goal_id, stamp=stamp), request.goal)
            self._goal_handles[key] = handle
            self._result_futures[key] = Future()
        self._begin(handle)
        return handle

    def _begin(self, _handle: ServerGoalHandle) -> None:
        """Tell everyone of a goal that was just accepted."""
        self._publish_status()

    def notify_execute(
        self, goal_handle: ServerGoalHandle, execute_callback: Callable[[ServerGoalHandle], Any] | None
    ) -> None:
        """Run the callback (or the server's own) for the goal in the node's executor."""
        callback = self._execute_callback if execute_callback is None else execute_callback
        executor = self._node.executor
        if executor is None:
            import rclpy

            executor = rclpy.get_global_executor()
        executor.create_task(self._execute_goal, callback, goal_handle)

    async def _execute_goal(self, callback: Callable[[Any], Any], goal_handle: ServerGoalHandle) -> None:
        try:
            result = await await_or_execute(callback, goal_handle)
        except Exception as error:
            result = self._action_type.Result()
            self._logger.error(f"Error raised in execute callback: {error}")
            traceback.print_exc()
        uuid = goal_handle.goal_id.uuid
        if goal_handle.is_active:
            self._logger.warning(f"Goal state not set, assuming aborted. Goal ID: {uuid}")
            goal_handle.abort()
        response = self._action_type.Impl.GetResultService.Response()
        response.status = goal_handle.status
        if not isinstance(result, self._action_type.Result):
            expected = f"expected {self._action_type.Result.__name__}, got {type(result).__name__}"
            self._logger.error(f"The execute callback returned no result, sending an empty one: {expected}")
            result = self._action_type.Result()
        response.result = result
        future = self._result_futures.get(bytes(uuid))
        if future is not None:
            future.set_result(response)

    # -- cancelling and results

    async def _cancel_asked(self, service: Any, request: Any, header: Any) -> None:
        response = CancelGoal.Response()
        response.return_code, wanted = goals_to_cancel(request.goal_info, list(self._goal_handles.values()))
        for handle in wanted:
            answer = await await_or_execute(self._cancel_callback, handle)
            if answer is CancelResponse.ACCEPT and self._cancel(handle):
                response.goals_canceling.append(handle._goal_info)
        service.send_response(response, header)

    def _cancel(self, handle: ServerGoalHandle) -> bool:
        try:
            handle._update_state(GoalEvent.CANCEL_GOAL)
        except RCLError as error:
            self._logger.debug(f"Failed to cancel goal in cancel callback: {error}")
            return False
        return True

    def _result_asked(self, service: Any, request: Any, header: Any) -> None:
        future = self._result_futures.get(bytes(request.goal_id.uuid))
        if future is None:
            uuid = request.goal_id.uuid
            self._logger.warning(f"Sending result response for unknown or expired goal ID: {uuid}")
            unknown = self._action_type.Impl.GetResultService.Response()
            unknown.status = GoalStatus.STATUS_UNKNOWN
            service.send_response(unknown, header)
        else:
            future.add_done_callback(lambda done: service.send_response(done.result(), header))

    def notify_goal_done(self) -> None:
        """Schedule the removal of goals that have ended, `result_timeout` seconds from now."""
        if self._result_timeout < 0:
            return
        clock = session.current().clock
        for key, handle in list(self._goal_handles.items()):
            if handle.status in TERMINAL and key not in self._ended:
                when = clock.steady() + int(self._result_timeout * 1e9)
                self._ended[key] = clock.call_at(when, lambda key=key: self._forget(key))

    def _forget(self, key: bytes) -> None:
        with self._lock:
            self._ended.pop(key, None)
            self._result_futures.pop(key, None)
            handle = self._goal_handles.pop(key, None)
        if handle is not None:
            handle.destroy()

    # -- publishing

    def _publish_status(self) -> None:
        with self._lock:
            handles = list(self._goal_handles.values())
            statuses = [GoalStatus(goal_info=each._goal_info, status=each.status) for each in handles]
            self._status_publisher.publish(GoalStatusArray(status_list=statuses))

    def _publish_feedback(self, goal_id: Any, feedback: Any) -> None:
        message = self._action_type.Impl.FeedbackMessage(goal_id=goal_id, feedback=feedback)
        self._feedback_publisher.publish(message)

    @property
    def action_type(self) -> Any:
        """The action's class."""
        return self._action_type

    # -- callbacks may be replaced; None restores the default

    def register_handle_accepted_callback(self, handle_accepted_callback: Any) -> None:
        """Set the callback that decides when an accepted goal is executed."""
        self._handle_accepted_callback = handle_accepted_callback or default_handle_accepted_callback

    def register_goal_callback(self, goal_callback: Any) -> None:
        """Set the callback that accepts or rejects goals."""
        self._goal_callback = goal_callback or default_goal_callback

    def register_cancel_callback(self, cancel_callback: Any) -> None:
        """Set the callback that accepts or rejects requests to cancel."""
        self._cancel_callback = cancel_callback or default_cancel_callback

    def register_execute_callback(self, execute_callback: Any) -> None:
        """Set the callback that executes goals; TypeError if it is not callable."""
        if not callable(execute_callback):
            raise TypeError("Failed to register goal execution callback: not callable")
        self._execute_callback = execute_callback

    def get_num_entities(self) -> NumberOfEntities:
        """One timer, for expiring results, and three services."""
        return NumberOfEntities(num_timers=1, num_services=3)

    def destroy(self) -> None:
        """Stop serving. Executing goals continue, but their status, feedback and results are not sent."""
        for alarm in self._ended.values():
            alarm.cancel()
        self._ended.clear()
        for handle in self._goal_handles.values():
            handle.destroy()
        self._goal_handles.clear()
        while self._services:
            self._node.destroy_service(self._services.pop())
        self._node.destroy_publisher(self._feedback_publisher)
        self._node.destroy_publisher(self._status_publisher)


def _unused(request: Any, response: Any) -> Any:
    """A placeholder for the callback that a service requires; the action server responds instead."""
    return response
